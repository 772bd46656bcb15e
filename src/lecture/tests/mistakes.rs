//! Tests of the cameras that result from classic mistakes, against numbers calculated by hand, and of
//! the checks that find the mistakes.

use std::f64::consts::FRAC_1_SQRT_2 as S;

use pinhole_core::*;
use pinhole_lecture::mistakes::{Check, Mistake, Value, Vote, WrongCamera, WrongPicture};
use proptest::prelude::*;

fn vec3(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

#[track_caller]
fn assert_near(a: DVec3, b: DVec3) {
    assert!((a - b).length() <= 1e-14 * b.length().max(1.0), "{a} is not {b}");
}

/// Returns the camera of the lecture's exercise, with eye (20, 4, 10), at (-1, 0, -5), up (0, 1, 0): u
/// = (5, 0, -7)/sqrt 74, w = (21, 4, 15)/sqrt 682.
fn exercise() -> Camera {
    let (eye, at) = (vec3(20.0, 4.0, 10.0), vec3(-1.0, 0.0, -5.0));
    Camera { eye, orientation: Orientation::At { at, up: DVec3::Y }, ..Camera::CANONICAL }
}

fn exercise_basis() -> Basis {
    let u = vec3(5.0, 0.0, -7.0) / 74f64.sqrt();
    let w = vec3(21.0, 4.0, 15.0) / 682f64.sqrt();
    Basis { u, v: w.cross(u), w }
}

/// Returns a camera without special values, so that every mistake changes its numbers.
fn general() -> Camera {
    Camera {
        eye: vec3(1.0, 2.0, 3.0),
        orientation: Orientation::At { at: vec3(-2.0, 0.5, -4.0), up: vec3(0.5, 2.0, 0.25) },
        viewport: Viewport { width: 1.5, height: 1.0, distance: 2.0 },
        image: ImageSize::new(30, 20).unwrap(),
    }
}

fn failing(camera: &WrongCamera) -> Vec<Check> {
    camera.checks().into_iter().filter(|c| !c.passes).map(|c| c.check).collect()
}

fn wrong(camera: &Camera, mistake: Mistake) -> WrongCamera {
    WrongCamera::new(camera, mistake).unwrap()
}

#[test]
fn as_printed_is_orthonormal_right_handed_and_looks_backwards() {
    let Basis { u, v, w } = exercise_basis();
    for mistake in [Mistake::WAsPrinted, Mistake::WIsAtMinusEye] {
        let camera = wrong(&exercise(), mistake);
        assert_near(camera.u(), -u);
        assert_near(camera.v(), v);
        assert_near(camera.w(), -w);
        assert_eq!(failing(&camera), [Check::LooksForwards]);
        let Value::Number(x) = camera.check(Check::LooksForwards).value else { panic!() };
        assert!((x - 1.0).abs() < 1e-15, "w . view / |view| = {x}, and is -1 of a right camera");
    }
}

#[test]
fn the_construction_mistakes_have_the_vectors_found_by_hand() {
    let Basis { u, v, w } = exercise_basis();
    // |up x w| is the sine of the angle between up and w: sqrt 666 / sqrt 682. |view| is sqrt 682.
    let (sine, far) = ((666.0f64 / 682.0).sqrt(), 682f64.sqrt());
    for (mistake, wu, wv, ww) in [
        (Mistake::VIsUCrossW, u, -v, w),
        (Mistake::UIsWCrossUp, -u, -v, w),
        (Mistake::LeftHanded, -u, v, w),
        (Mistake::NotNormalized, sine * u, sine * v, w),
        (Mistake::WNotNormalized, u, far * v, far * w),
        (Mistake::UpAsV, u, DVec3::Y, w),
    ] {
        let camera = wrong(&exercise(), mistake);
        assert_near(camera.u(), wu);
        assert_near(camera.v(), wv);
        let is_wrong = [wu != u, wv != v, ww != w];
        assert_eq!(camera.wrong_vectors(), is_wrong, "{mistake}");
        assert!((camera.w() - ww).length() < 1e-13 * ww.length(), "{mistake}");
        let uv = DVec2::new(0.2, -0.1);
        assert_near(camera.direction_at(uv) / far, (0.2 * wu - 0.1 * wv - ww) / far);
    }
}

#[test]
fn the_lectures_view_down_as_printed() {
    // View (0, -1, 0), up (1, 1, 0): right is u = (0, 0, 1), v = (1, 0, 0), w = (0, 1, 0).
    let (view, up) = (DVec3::NEG_Y, vec3(1.0, 1.0, 0.0));
    let camera = Camera { orientation: Orientation::View { view, up }, ..Camera::CANONICAL };
    let printed = wrong(&camera, Mistake::WAsPrinted);
    assert_near(printed.u(), vec3(0.0, 0.0, -1.0));
    assert_near(printed.v(), vec3(1.0, 0.0, 0.0));
    assert_near(printed.w(), vec3(0.0, -1.0, 0.0));
    // up x w = (1, 1, 0) x (0, 1, 0) = (0, 0, 1): it is a unit vector even without normalization.
    let none = WrongCamera::new(&camera, Mistake::NotNormalized);
    assert!(none.unwrap_err().starts_with("This changes nothing here. "));
    assert_eq!(wrong(&camera, Mistake::UpAsV).v(), up);
    let none = WrongCamera::new(&camera, Mistake::WIsAtMinusEye);
    assert!(none.unwrap_err().starts_with("The camera is given by view here"));
}

#[test]
fn the_mapping_mistakes_have_the_uv_found_by_hand() {
    // Row 99, column 199 of 400 x 400: (u, v) = (-1/800, 201/800).
    let pixel = Pixel { row: 99, column: 199 };
    let wide = Viewport { width: 2.0, ..Viewport::CANONICAL };
    for (mistake, viewport, u, v) in [
        (Mistake::PixelCorner, Viewport::CANONICAL, -2.0 / 800.0, 202.0 / 800.0),
        (Mistake::CountedFromOne, Viewport::CANONICAL, -3.0 / 800.0, 203.0 / 800.0),
        (Mistake::RowsFromBottom, Viewport::CANONICAL, -1.0 / 800.0, -201.0 / 800.0),
        (Mistake::RowsColumnsSwapped, Viewport::CANONICAL, -201.0 / 800.0, 1.0 / 800.0),
        (Mistake::AspectDropped, wide, -2.0 / 800.0, 402.0 / 800.0),
    ] {
        let camera = wrong(&Camera { viewport, ..Camera::CANONICAL }, mistake);
        let uv = camera.uv_of_pixel(pixel);
        assert!((uv - DVec2::new(u, v)).length() < 1e-15, "{mistake}: {uv}");
        assert_near(camera.ray(pixel).unwrap().direction, vec3(u, v, -1.0));
    }
    let viewport = Viewport { distance: 2.0, ..Viewport::CANONICAL };
    let camera = wrong(&Camera { viewport, ..Camera::CANONICAL }, Mistake::DistanceDropped);
    assert_eq!(camera.ray_at(DVec2::new(0.2, -0.1)).unwrap().direction, vec3(0.2, -0.1, -1.0));
}

#[test]
fn what_changes_nothing_says_so_and_what_to_change() {
    let mut nothing: Vec<&str> = Vec::new();
    for &mistake in Mistake::GALLERY {
        if let Err(why) = WrongCamera::new(&Camera::CANONICAL, mistake) {
            assert_eq!(why, format!("This changes nothing here. {}", mistake.hint()));
            nothing.push(mistake.id());
        }
    }
    let known =
        ["not-normalized", "w-not-normalized", "distance-dropped", "up-as-v", "aspect-dropped"];
    assert_eq!(nothing, known);
    let basis = Basis { u: vec3(S, 0.0, -S), v: DVec3::Y, w: vec3(S, 0.0, S) };
    let by_hand = Camera { orientation: Orientation::Basis(basis), ..Camera::CANONICAL };
    let given = WrongCamera::new(&by_hand, Mistake::WAsPrinted);
    assert!(given.unwrap_err().contains("are set by hand here"));
    assert!(WrongCamera::new(&by_hand, Mistake::PixelCorner).is_ok());
    let none = Camera { eye: DVec3::NEG_Z, ..Camera::CANONICAL };
    let why = WrongCamera::new(&none, Mistake::WAsPrinted).unwrap_err();
    assert!(why.starts_with("eye and at are the same point"), "{why}");
}

#[test]
fn each_mistake_is_found_by_its_own_checks_and_no_other() {
    let found_by: [(Mistake, &[Check]); 14] = [
        (Mistake::WAsPrinted, &[Check::LooksForwards]),
        (Mistake::VIsUCrossW, &[Check::RightHanded, Check::UpIsUp]),
        (Mistake::NotNormalized, &[Check::LengthU, Check::LengthV]),
        (Mistake::UpAsV, &[Check::LengthV, Check::VDotW]),
        (Mistake::DistanceDropped, &[Check::ViewportAtDistance]),
        (Mistake::PixelCorner, &[Check::CornersBalance]),
        (Mistake::RowsFromBottom, &[Check::TopLeft, Check::StepDown]),
        (Mistake::RowsColumnsSwapped, &[Check::StepRight, Check::StepDown, Check::CornersBalance]),
        (Mistake::CountedFromOne, &[Check::CornersBalance]),
        (Mistake::AspectDropped, &[Check::StepDown]),
        (Mistake::LeftHanded, &[Check::RightHanded]),
        (Mistake::WIsAtMinusEye, &[Check::LooksForwards]),
        (Mistake::WNotNormalized, &[Check::LengthV, Check::LengthW, Check::ViewportAtDistance]),
        (Mistake::UIsWCrossUp, &[Check::UpIsUp]),
    ];
    for (mistake, checks) in found_by {
        assert_eq!(failing(&wrong(&general(), mistake)), checks, "{mistake}");
    }
    assert!(Mistake::GALLERY.iter().all(|m| found_by.iter().any(|(mistake, _)| mistake == m)));
}

#[test]
fn some_mistakes_are_told_apart_by_no_picture() {
    let camera = general();
    let (last_row, last_column) = (camera.image.height() - 1, camera.image.width() - 1);
    // Directions are linear in row and column.
    let corners = [(0, 0), (0, last_column), (last_row, 0), (last_row, last_column)];
    let same = |a, b| {
        let (a, b) = (wrong(&camera, a), wrong(&camera, b));
        corners.into_iter().all(|(row, column)| {
            let pixel = Pixel { row, column };
            let [a, b] = [&a, &b].map(|c| c.ray(pixel).unwrap().direction.normalize());
            (a - b).length() <= 1e-6
        })
    };
    assert!(same(Mistake::WAsPrinted, Mistake::WIsAtMinusEye));
    assert!(same(Mistake::VIsUCrossW, Mistake::RowsFromBottom));
    let pairs =
        Mistake::GALLERY.iter().flat_map(|&a| Mistake::GALLERY.iter().map(move |&b| (a, b)));
    assert_eq!(pairs.filter(|(a, b)| a < b && same(*a, *b)).count(), 2);
}

fn balls() -> Scene {
    let ball = |x, y, z, radius| Sphere { center: vec3(x, y, z), radius };
    let spheres = vec![
        ball(-2.0, 0.5, -4.0, 1.2),
        ball(-0.2, 2.3, -0.5, 0.5),
        ball(-1.5, -0.8, -1.0, 0.8),
        ball(4.0, 4.0, 9.0, 2.0),
    ];
    let floor = Plane { point: vec3(0.0, -1.5, 0.0), normal: DVec3::Y };
    Scene::new(spheres, vec![floor]).unwrap()
}

/// Checks each pixel of the wrong picture against the first hit of the ray that the wrong camera has
/// for it.
fn assert_picture(scene: &Scene, right: &Camera, mistake: Mistake, raster: &Raster) {
    let camera = &wrong(right, mistake);
    let picture = WrongPicture::trace(scene, camera, raster).unwrap();
    let mut differing = 0;
    let (mut index, mut hits) = (0, 0);
    for &row in raster.rows() {
        for &column in raster.columns() {
            let hit = scene.first_hit(&camera.ray(Pixel { row, column }).unwrap());
            let object = hit.map_or(NO_OBJECT, |hit| hit.object);
            differing += usize::from(object != picture.object[index]);
            if let (Some(hit), true) = (hit, object == picture.object[index]) {
                hits += 1;
                let off = (hit.t - f64::from(picture.t[index])).abs();
                // At an outline, the last digit of a direction changes t by far more.
                assert!(off <= 1e-6 * hit.t, "{mistake}: {row}, {column}");
            }
            index += 1;
        }
    }
    assert!(differing <= 2, "{mistake}: {differing} pixels are not their rays'");
    assert!(hits > 0);
}

#[test]
fn the_picture_is_what_the_wrong_rays_meet() {
    let scene = balls();
    let tall = Camera { image: ImageSize::new(16, 27).unwrap(), ..general() };
    for camera in [general(), tall] {
        let rasters = [Raster::full(camera.image), Raster::shown_on(camera.image, 11, 13)];
        for &mistake in Mistake::GALLERY {
            for raster in &rasters {
                assert_picture(&scene, &camera, mistake, raster);
            }
        }
    }
}

/// The images are so wide or tall that, where a mistake exchanges rows and columns, a picture is traced
/// as part of a far larger image, which may exceed the maximum image size.
#[test]
fn the_largest_images_have_wrong_pictures_too() {
    let scene = balls();
    for (width, height) in [(400, 9000), (16_384, 40), (1, 16_384)] {
        let image = ImageSize::new(width, height).unwrap();
        let camera = Camera { image, ..general() };
        let raster = Raster::shown_on(image, 61, 67);
        for &mistake in Mistake::GALLERY {
            let wrong = wrong(&camera, mistake);
            let picture = WrongPicture::trace(&scene, &wrong, &raster).unwrap();
            let mut pixels = raster
                .rows()
                .iter()
                .flat_map(|&row| raster.columns().iter().map(move |&column| Pixel { row, column }));
            let ray_meets = |pixel: Pixel| {
                scene.first_hit(&wrong.ray(pixel).unwrap()).map_or(NO_OBJECT, |hit| hit.object)
            };
            let is_other = |object: &&u32| pixels.next().map(ray_meets) != Some(**object);
            let differing = picture.object.iter().filter(is_other).count();
            assert!(differing <= 2, "{width} x {height}, {mistake}: {differing}");
        }
    }
}

#[test]
fn a_wrong_picture_is_coloured_as_a_right_one_is() {
    let (scene, camera) = (balls(), general());
    let raster = Raster::full(camera.image);
    let color_of = |i: u32| [50 * i as u8, 200, 255 - 40 * i as u8];
    // Half a turn, so that row and column count from the opposite end of the right picture.
    let turned = wrong(&camera, Mistake::UIsWCrossUp);
    let picture = WrongPicture::trace(&scene, &turned, &raster).unwrap();
    let right = trace(&scene, &camera.resolve().unwrap(), &raster, Outputs::default());
    for mode in Shade::ALL {
        let mut pixels = picture.shaded(&scene, mode, color_of, |rgb| rgb);
        pixels.reverse();
        let known = shade(&right, &scene, mode, color_of, |rgb| rgb);
        let near = |(a, b): (&Rgb, &Rgb)| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= 1);
        assert!(pixels.iter().zip(&known).all(near), "{mode:?}");
    }
    let same = picture.object.iter().zip(&right.object).filter(|(a, b)| a != b).count();
    assert!(same > 0 && same < raster.len(), "{same}");
}

fn coordinate() -> impl Strategy<Value = f64> {
    -10.0..10.0
}

fn point() -> impl Strategy<Value = DVec3> {
    (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| vec3(x, y, z))
}

proptest! {
    #[test]
    fn a_right_camera_passes_every_check(
        eye in point(), at in point(), up in point(),
        (width, height, distance) in (0.01..10.0, 0.01..10.0, 0.01..10.0),
        (columns, rows) in (1..2000u32, 1..2000u32),
    ) {
        let camera = Camera {
            eye,
            orientation: Orientation::At { at, up },
            viewport: Viewport { width, height, distance },
            image: ImageSize::new(columns, rows).unwrap(),
        };
        prop_assume!(camera.up_angle().is_ok_and(|angle| angle.conditioning < 1e6));
        let right = WrongCamera::right(&camera).unwrap();
        prop_assert_eq!(failing(&right), Vec::<Check>::new());
        prop_assert_eq!(right.wrong_vectors(), [false; 3]);
        for check in [Check::UDotV, Check::VDotW, Check::WDotU] {
            prop_assert_eq!(right.check(check).value, Value::Number(0.0), "no rounding is shown");
        }
        prop_assert_eq!(right.check(Check::CornersBalance).value, Value::Uv(DVec2::ZERO));
        let pixel = Pixel { row: rows / 2, column: columns / 3 };
        let known = camera.resolve().unwrap().ray_of_pixel(pixel).direction;
        prop_assert!((right.ray(pixel).unwrap().direction - known).length() < 1e-14 * known.length());
    }

    #[test]
    fn what_a_mistake_changes_some_check_finds(
        eye in point(), at in point(), up in point(), distance in 0.1..5.0,
    ) {
        let viewport = Viewport { width: 1.5, height: 1.0, distance };
        let image = ImageSize::new(30, 20).unwrap();
        let camera = Camera { eye, orientation: Orientation::At { at, up }, viewport, image };
        prop_assume!(camera.up_angle().is_ok_and(|angle| angle.conditioning < 1e3));
        for &mistake in Mistake::GALLERY {
            if let Ok(wrong) = WrongCamera::new(&camera, mistake) {
                prop_assert_ne!(failing(&wrong), Vec::<Check>::new(), "{}", mistake);
            }
        }
    }
}

#[test]
fn the_table_has_what_each_mistake_is_asked_for() {
    let mut ids = Vec::new();
    for &mistake in Mistake::ALL {
        ids.push(mistake.id());
        let texts = [mistake.name(), mistake.formula(), mistake.shows(), mistake.hint()];
        let is_described = texts.iter().all(|text| !text.is_empty());
        assert_eq!(mistake.is_in_gallery(), is_described, "{mistake}");
        assert!(
            is_described || !mistake.advice().is_empty() || !mistake.exercise_feedback().is_empty()
        );
    }
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), Mistake::ALL.len());
    let mut named = Mistake::GRADED.iter().chain(Mistake::ALONE);
    assert!(named.all(|mistake| !mistake.advice().is_empty()));
    // These ids may appear in the output of `pinhole check --json`, so they must not change.
    let graded: Vec<_> = Mistake::GRADED.iter().map(|mistake| mistake.id()).collect();
    let known = "w-as-printed v-is-u-cross-w not-normalized up-as-v distance-dropped pixel-corner \
                 rows-from-bottom rows-columns-swapped counted-from-one aspect-dropped left-handed \
                 single-precision b-for-half-b far-root negative-t t-for-distance last-object";
    let alone: Vec<_> = Mistake::ALONE.iter().map(|mistake| mistake.id()).collect();
    assert_eq!(
        alone.join(" "),
        "sign-of-b center-left-out origin-left-out radius-not-squared root-left-out \
         viewport-swapped viewport-scaled eye-in-direction"
    );
    assert_eq!(graded, known.split_whitespace().collect::<Vec<_>>());
}

/// Returns the object seen in each pixel of the camera's image.
fn seen_by(scene: &Scene, wrong: &WrongCamera) -> Vec<u32> {
    let raster = Raster::shown_on(wrong.image(), 72, 72);
    WrongPicture::trace(scene, wrong, &raster).unwrap().object
}

#[test]
fn the_options_of_a_vote_look_different_and_its_seed_gives_them_again() {
    let camera = general();
    let resolved = camera.resolve().unwrap();
    let balls = [([-1.0, 1.0, -2.0], 0.7), ([-3.5, 0.6, -4.5], 1.2), ([0.5, 1.2, -1.0], 0.4)];
    let spheres = balls.map(|(center, radius)| Sphere::new(center, radius).unwrap());
    let scene = Scene::new(spheres.to_vec(), Vec::new()).unwrap();
    let (mut last, mut rights, mut letters) = (None, Vec::new(), [false; 4]);
    for seed in 0..40 {
        let vote = Vote::new(&camera, &resolved, &scene, seed).unwrap();
        assert_eq!(Some(&vote), Vote::new(&camera, &resolved, &scene, seed).as_ref());
        assert_eq!(vote.options.len(), 4);
        assert_ne!(Some(vote.mistake()), last, "the same one twice");
        last = Some(vote.mistake());
        rights.extend(last);
        letters[vote.right] = true;
        let pictures: Vec<Vec<u32>> = vote
            .options
            .iter()
            .map(|mistake| seen_by(&scene, &WrongCamera::new(&camera, *mistake).unwrap()))
            .collect();
        for (k, a) in pictures.iter().enumerate() {
            for b in &pictures[k + 1..] {
                let differing = a.iter().zip(b).filter(|(a, b)| a != b).count();
                assert!(100 * differing >= a.len(), "{:?}: {differing}", vote.options);
            }
        }
    }
    assert_eq!(letters, [true; 4], "every letter is right at some time");
    rights.sort_unstable();
    rights.dedup();
    assert!(rights.len() > 4, "{rights:?}");
    assert_eq!(Vote::new(&camera, &resolved, &Scene::default(), 1), None);
}
