//! Scenes of many spheres that are hard to draw without an error.

use pinhole_core::*;

use crate::common::{Numbers, plane, sphere, vec3};

/// A scene with its name and its camera, and the minimum number of objects that its picture shows.
pub(crate) struct Crowd {
    pub(crate) name: &'static str,
    pub(crate) scene: Scene,
    pub(crate) camera: Camera,
    pub(crate) objects: usize,
}

impl Crowd {
    pub(crate) fn new(name: &'static str, spheres: Vec<Sphere>, camera: Camera) -> Crowd {
        let scene = Scene::new(spheres, vec![]).unwrap();
        Crowd { name, scene, camera, objects: 2 }
    }

    pub(crate) fn with_planes(self, planes: Vec<Plane>) -> Crowd {
        let scene = Scene::new(self.scene.spheres().to_vec(), planes).unwrap();
        Crowd { scene, ..self }
    }

    /// Returns the crowd with another minimum number of visible objects.
    pub(crate) fn showing(self, objects: usize) -> Crowd {
        Crowd { objects, ..self }
    }

    pub(crate) fn trace(&self) -> Frame<f32> {
        let resolved = self.camera.resolve().unwrap();
        trace_as(&self.scene, &resolved, &Raster::full(self.camera.image), Outputs::default())
    }
}

/// Returns a camera at the origin that looks along -z, with a viewport of this size at distance 1.
pub(crate) fn ahead(viewport: [f64; 2], image: [u32; 2]) -> Camera {
    Camera {
        viewport: Viewport { width: viewport[0], height: viewport[1], distance: 1.0 },
        image: ImageSize::new(image[0], image[1]).unwrap(),
        ..Camera::CANONICAL
    }
}

/// Returns a camera with a vertical field of view of 53 degrees and square pixels. Neither side of the
/// image is a multiple of a SIMD vector's length.
pub(crate) fn ordinary() -> Camera {
    ahead([16.0 / 9.0, 1.0], [323, 181])
}

/// Returns the height in the world of a pixel of [`ordinary`] at this depth.
fn pixel_at(depth: f64) -> f64 {
    depth / 181.0
}

/// Returns a random point in or slightly outside of the view of [`ordinary`].
fn point_ahead(numbers: &mut Numbers) -> DVec3 {
    let z = numbers.between(4.0, 12.0);
    vec3(numbers.between(-0.95, 0.95) * z, numbers.between(-0.55, 0.55) * z, -z)
}

/// Returns spheres in front of [`ordinary`] whose radii in its picture are evenly distributed between
/// two numbers of pixels.
pub(crate) fn of_pixels(count: usize, radii: [f64; 2], seed: u64) -> Vec<Sphere> {
    let mut numbers = Numbers(seed);
    let one = |_| {
        let center = point_ahead(&mut numbers);
        Sphere { center, radius: numbers.between(radii[0], radii[1]) * pixel_at(-center.z) }
    };
    (0..count).map(one).collect()
}

fn six_decades() -> Vec<Sphere> {
    let mut numbers = Numbers(3);
    let one = |_| {
        let center = point_ahead(&mut numbers);
        Sphere { center, radius: 10_f64.powf(numbers.between(-6.0, 0.0)) }
    };
    (0..5000).map(one).collect()
}

fn cloud(count: usize) -> Vec<Sphere> {
    let mut numbers = Numbers(4);
    let one = |_| Sphere { center: numbers.point(8.0), radius: numbers.between(0.02, 0.2) };
    (0..count).map(one).collect()
}

fn around_the_eye(first: bool) -> Vec<Sphere> {
    let mut spheres = of_pixels(1000, [1.0, 6.0], 5);
    spheres.insert(if first { 0 } else { 700 }, sphere([0.0, 0.0, -3.0], 9.0));
    spheres
}

/// Returns spheres of about a pixel's size, all of which cover the centre of the same pixel.
fn one_pixel() -> Vec<Sphere> {
    let camera = ordinary().resolve().unwrap();
    let direction = camera.ray_of_pixel(Pixel { row: 70, column: 200 }).direction;
    let mut numbers = Numbers(6);
    let one = |_| {
        let depth = numbers.between(4.0, 12.0);
        let off =
            pixel_at(depth) * vec3(numbers.between(-0.3, 0.3), numbers.between(-0.3, 0.3), 0.0);
        let radius = numbers.between(0.6, 1.2) * pixel_at(depth);
        Sphere { center: depth * direction + off, radius }
    };
    (0..5000).map(one).collect()
}

/// Returns a planet under the eye, and pebbles that touch it from above.
fn planet() -> Vec<Sphere> {
    const RADIUS: f64 = 6.4e6;
    const EYE: f64 = 1.7;
    let mut numbers = Numbers(7);
    let middle = vec3(0.0, -RADIUS - EYE, 0.0);
    let mut spheres = vec![Sphere { center: middle, radius: RADIUS }];
    spheres.extend((0..1000).map(|_| {
        let (x, z) = (numbers.between(-30.0, 30.0), numbers.between(-60.0, -2.0));
        let radius = numbers.between(0.01, 0.2);
        let up = vec3(x, (RADIUS * RADIUS - x * x - z * z).sqrt(), z) / RADIUS;
        Sphere { center: middle + (RADIUS + radius) * up, radius }
    }));
    spheres
}

/// Returns spheres to the sides of the eye, each of which crosses the plane through the eye and reaches
/// into the view.
fn eye_plane() -> Vec<Sphere> {
    let mut numbers = Numbers(8);
    let one = |_| {
        let (sin, cos) = numbers.between(0.0, std::f64::consts::TAU).sin_cos();
        let away = numbers.between(2.0, 40.0);
        let radius = away * numbers.between(0.7, 0.99);
        Sphere { center: vec3(away * cos, away * sin, radius * numbers.between(-0.5, 0.1)), radius }
    };
    (0..300).map(one).collect()
}

/// Returns spheres at the picture's four edges and corners, some of them large.
fn on_the_sides() -> Vec<Sphere> {
    let mut numbers = Numbers(9);
    let one = |k: usize| {
        let z = numbers.between(3.0, 9.0);
        let (along, off) = (numbers.between(-1.05, 1.05), numbers.between(0.98, 1.02));
        let (x, y) = [(along, off), (off, along), (along, -off), (-off, along)][k % 4];
        let radius = z * 10_f64.powf(numbers.between(-3.0, -0.7));
        Sphere { center: vec3(8.0 / 9.0 * x * z, 0.5 * y * z, -z), radius }
    };
    (0..600).map(one).collect()
}

/// Returns spheres that all occur twice, in opposite orders, with slightly smaller ones of the same
/// centres between them.
fn twice() -> Vec<Sphere> {
    let own = of_pixels(200, [2.0, 12.0], 10);
    let smaller = own.iter().map(|own| Sphere { radius: 0.999 * own.radius, ..*own });
    let hardly = own.iter().map(|own| Sphere { radius: own.radius.next_down(), ..*own });
    own.iter().rev().copied().chain(smaller).chain(hardly).chain(own.iter().copied()).collect()
}

/// Returns unit spheres on a lattice with integer coordinates, each of which touches its neighbours.
fn lattice() -> Vec<Sphere> {
    let layer = |k: i32| (-5..=5).flat_map(move |i| (-4..=4).map(move |j| (i, j, k)));
    let center = |(i, j, k): (i32, i32, i32)| [2 * i, 2 * j, -12 - 2 * k].map(f64::from);
    (0..4).flat_map(layer).map(|cell| sphere(center(cell), 1.0)).collect()
}

/// Returns a camera whose pixels have a size of exactly 1/16 at distance 1, with one of them in the
/// middle of the picture.
fn sixteenths() -> Camera {
    ahead([101.0 / 16.0, 75.0 / 16.0], [101, 75])
}

/// Returns spheres that touch the plane z = -16 in points through which pixels' rays pass.
fn on_a_plane() -> Crowd {
    let center = |k: i32| [3 * (k % 20 - 10), 3 * (k / 20 - 8), -17].map(f64::from);
    let spheres = (0..320).map(|k| sphere(center(k), 1.0)).collect();
    let wall = plane([0.0, 0.0, -16.0], [0.0, 0.0, 1.0]);
    let behind = plane([1.0, 2.0, -18.0], [0.0, 0.0, -3.0]);
    Crowd::new("ties with a plane", spheres, sixteenths()).with_planes(vec![behind, wall])
}

/// Returns spheres around (0, 0, -5 k) with radius 3 k, which have the same outline: a circle with a
/// radius of exactly 25 pixels, which passes exactly through pixel centres, such as (7, 24), (15, 20)
/// and (25, 0) relative to the middle.
fn one_outline(count: usize) -> Crowd {
    let camera = Camera {
        viewport: Viewport { width: 183.0, height: 177.0, distance: 100.0 },
        ..ahead([1.0, 1.0], [61, 59])
    };
    let one = |k: usize| {
        let k = ((k * 37) % count + 1) as f64;
        sphere([0.0, 0.0, -5.0 * k], 3.0 * k)
    };
    let spheres = (0..count).map(one).collect();
    let name = if count < 256 { "outlines through pixels, few" } else { "outlines through pixels" };
    Crowd::new(name, spheres, camera).showing(1)
}

/// Returns spheres whose outlines exactly touch a row of pixel centres from below and another one from
/// above.
fn tangent_to_rows() -> Vec<Sphere> {
    // Seen from the side, the line through the eye with slope 3/4 (12 pixels of 1/16) touches the
    // circle around (0, -5 k) with radius 3 k, wherever the sphere is along the rows.
    (0..300)
        .map(|k| {
            let (x, k) = (f64::from(k % 25 - 12), 1.0 + f64::from(k % 7));
            sphere([5.0 * k * x / 16.0, 0.0, -5.0 * k], 3.0 * k)
        })
        .collect()
}

/// Returns a camera whose pixels are far from square, and spheres a few rows high away from the middle,
/// whose outlines are oblique ellipses.
fn leaning(name: &'static str, viewport: [f64; 2], image: [u32; 2], count: usize) -> Crowd {
    let camera = ahead(viewport, image);
    let per_row = viewport[1] / f64::from(image[1]);
    let mut numbers = Numbers(11);
    let one = |_| {
        let (x, y) = (numbers.between(-0.5, 0.5), numbers.between(-0.5, 0.5));
        let slopes = vec3(x * viewport[0], y * viewport[1], -1.0);
        let z = numbers.between(5.0, 50.0);
        Sphere { center: z * slopes, radius: z * per_row * numbers.between(0.05, 1.5) }
    };
    Crowd::new(name, (0..count).map(one).collect(), camera)
}

/// Returns one visible sphere whose outline is so oblique that it contains the centre of pixel (42, 3),
/// passes between pixel centres in the next two rows, and contains that of pixel (45, 4). The other
/// spheres are larger and behind the eye, so it is drawn alone in its SIMD vector.
fn between_rows() -> Crowd {
    let own = sphere([-28.0, 21.0, -8.0], 0.171875);
    let behind = (0..255).map(|k| sphere([0.0, 0.0, 10.0 + f64::from(k)], 1.0));
    let spheres = std::iter::once(own).chain(behind).collect();
    Crowd::new("between rows", spheres, ahead([8.0, 8.0], [64, 256])).showing(1)
}

/// Returns a wide-angle camera, and spheres on all sides of it.
fn wide_angle(name: &'static str, width: f64, count: usize) -> Crowd {
    let camera = ahead([width, 0.6 * width], [161, 97]);
    let mut numbers = Numbers(12);
    let one = |_| {
        let center = numbers.point(10.0);
        Sphere { center, radius: 10_f64.powf(numbers.between(-2.0, -0.3)) }
    };
    Crowd::new(name, (0..count).map(one).collect(), camera)
}

/// Returns a crowd that is moved and turned together with its camera, whose basis is given by hand.
fn by_hand(name: &'static str, basis: Basis, offset: DVec3) -> Crowd {
    let mut spheres = of_pixels(700, [0.3, 9.0], 13);
    for sphere in &mut spheres {
        let q = sphere.center;
        sphere.center = q.x * basis.u + q.y * basis.v + q.z * basis.w + offset;
    }
    let camera = Camera { eye: offset, orientation: Orientation::Basis(basis), ..ordinary() };
    Crowd::new(name, spheres, camera).showing(100)
}

/// Returns crowds whose cameras have bases given by hand: exactly orthonormal, rounded, or with a
/// deviation from orthonormal that is still allowed.
fn bases() -> Vec<Crowd> {
    let turned = Basis { u: DVec3::Y, v: DVec3::Z, w: DVec3::X };
    let exact = Basis { u: vec3(0.6, 0.0, -0.8), v: DVec3::Y, w: vec3(0.8, 0.0, 0.6) };
    let found = Basis::from_view_up(vec3(0.3, -0.4, -1.0), vec3(0.1, 1.0, 0.2)).unwrap();
    let off = |by: f64| Basis { u: found.u + by * found.w, v: (1.0 + by) * found.v, ..found };
    let far = vec3(1e6, -2e5, 3e6);
    vec![
        by_hand("a basis of axes", turned, DVec3::ZERO),
        by_hand("a basis of decimals", exact, far),
        by_hand("a rounded basis", found, vec3(1e9, 1e9, -1e9)),
        by_hand("a basis that is off by 1e-14", off(1e-14), DVec3::ZERO),
        by_hand("a basis that is off by 1e-10", off(1e-10), far),
    ]
}

/// Returns all crowds of this module.
pub(crate) fn all() -> Vec<Crowd> {
    let mut behind_one = of_pixels(5000, [1.0, 20.0], 2);
    behind_one.push(sphere([0.0, 0.0, -2.0], 1.5));
    let many = |radii, seed| of_pixels(5000, radii, seed);
    let crowd = |name, spheres| Crowd::new(name, spheres, ordinary());
    let line = |name, image| {
        Crowd::new(name, of_pixels(20_000, [0.05, 2.0], 14), ahead([16.0 / 9.0, 1.0], image))
    };
    let mut all = vec![
        crowd("overdraw", many([6.0, 12.0], 1)).showing(100),
        crowd("behind one", behind_one).showing(1),
        crowd("tinier than a pixel", of_pixels(100_000, [0.05, 0.3], 15)).showing(1000),
        crowd("about a pixel", of_pixels(30_000, [0.3, 1.2], 16)).showing(1000),
        crowd("about four rows", many([1.6, 2.4], 17)).showing(1000),
        crowd("six decades", six_decades()),
        crowd("in a cloud", cloud(3000)).showing(100),
        crowd("in one of many", around_the_eye(false)).showing(100),
        crowd("in the first of many", around_the_eye(true)).showing(100),
        crowd("all on one pixel", one_pixel()),
        crowd("a planet with pebbles", planet()).showing(100),
        crowd("across the eye's plane", eye_plane()),
        crowd("on the picture's sides", on_the_sides()).showing(100),
        crowd("each twice", twice()).showing(50),
        crowd("255 spheres", of_pixels(255, [0.5, 20.0], 18)).showing(50),
        crowd("256 spheres", of_pixels(256, [0.5, 20.0], 18)).showing(50),
        crowd("257 spheres", of_pixels(257, [0.5, 20.0], 18)).showing(50),
        crowd("39,900 spheres", of_pixels(39_900, [0.5, 3.0], 19)).showing(1000),
        crowd("45,000 spheres", of_pixels(45_000, [0.5, 3.0], 19)).showing(1000),
        crowd("narrow and wide", many([20.0, 90.0], 20)),
        line("one column", [1, 16_384]).showing(50),
        line("one row", [16_384, 1]).showing(100),
        Crowd::new("touching", lattice(), sixteenths()).showing(50),
        on_a_plane().showing(100),
        one_outline(255),
        one_outline(300),
        Crowd::new("tangent to rows", tangent_to_rows(), sixteenths()),
        leaning("leaning", [20.0, 4.0], [83, 181], 3000).showing(100),
        leaning("leaning, few in a block", [20.0, 4.0], [83, 181], 256),
        leaning("leaning the other way", [4.0, 20.0], [323, 61], 3000).showing(100),
        between_rows(),
        wide_angle("20 wide at distance 1", 20.0, 3000).showing(100),
        wide_angle("20 wide, few", 20.0, 200),
        wide_angle("1000 wide", 1000.0, 3000),
        crowd("with planes", many([1.0, 8.0], 21))
            .with_planes(vec![
                plane([0.0, -1.5, 0.0], [0.0, 1.0, 0.1]),
                plane([0.0, 0.0, -9.0], [0.2, 0.1, 1.0]),
            ])
            .showing(100),
    ];
    all.extend(bases());
    all
}
