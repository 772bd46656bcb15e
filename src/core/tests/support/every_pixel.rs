//! Checks that every pixel of a frame is right. Where plain `f64` with error bounds is inconclusive,
//! the arbitrary-precision reference decides, or this crate's exact ray in a scene of only the objects
//! in question.

use std::collections::BTreeMap;
use std::ops::Range;

use pinhole_core::*;
use pinhole_reference as reference;
use rayon::prelude::*;

use super::meeting::{Meeting, Seen};

/// Maximum number of a frame's inconclusive pixels that the reference decides; exact rays decide the
/// others.
const BY_REFERENCE: usize = 200;

/// The numbers of pixels and objects that a check of a frame has examined.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Checked {
    pub(crate) pixels: usize,
    /// Pixels that hit something.
    pub(crate) hits: usize,
    /// Objects that are seen.
    pub(crate) objects: usize,
    /// Pixels that `f64` could not decide.
    pub(crate) doubtful: usize,
    /// Pixels that the reference decided.
    pub(crate) by_reference: usize,
}

/// A frame to be checked, with the values that its pixels share.
struct Checker<'a> {
    scene: &'a Scene,
    camera: &'a Camera,
    resolved: ResolvedCamera,
    frame: &'a Frame<f32>,
    seen: Vec<Seen>,
    /// For each column, the part of the direction that its pixels share. The direction of a pixel is
    /// this plus `down` of its row.
    across: Vec<DVec3>,
    down: Vec<DVec3>,
    /// For each pixel, an interval that certainly contains the true `t` of the object that it shows.
    own: Vec<[f64; 2]>,
}

/// A pixel's index, and the index of an object that the pixel should perhaps show.
type Candidate = (usize, u32);

/// The wrong pixels, each with a description of the error.
type Faults = BTreeMap<usize, String>;

/// Asserts that every pixel of a frame shows the object that its ray hits first, with `t` within an ulp
/// of `f32`.
#[track_caller]
pub(crate) fn every_pixel_is_right(
    name: &str,
    scene: &Scene,
    camera: &Camera,
    frame: &Frame<f32>,
) -> Checked {
    match check(scene, camera, frame) {
        Ok(checked) => checked,
        Err(faults) => {
            let shown: Vec<&str> = faults.values().take(10).map(String::as_str).collect();
            panic!("{name}: {} pixels are wrong:\n{}", faults.len(), shown.join("\n"))
        }
    }
}

/// Checks a frame. Returns the wrong pixels as an error.
pub(crate) fn check(scene: &Scene, camera: &Camera, frame: &Frame<f32>) -> Result<Checked, Faults> {
    let mut faults = Faults::new();
    let mut checker = Checker::new(scene, camera, frame);
    let mut candidates = checker.find_own(&mut faults);
    candidates.extend(checker.find_others(&mut faults));
    candidates.retain(|(pixel, _)| !faults.contains_key(pixel));
    candidates.par_sort_unstable();
    let pixels: Vec<&[Candidate]> = candidates.chunk_by(|a, b| a.0 == b.0).collect();
    let every = pixels.len().div_ceil(BY_REFERENCE).max(1);
    let wrong = pixels.par_iter().enumerate().filter_map(|(count, candidates)| {
        let pixel = candidates[0].0;
        Some((pixel, checker.decide(pixel, candidates, count % every == 0)?))
    });
    faults.extend(wrong.collect::<Vec<_>>());
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut shown: Vec<u32> =
        frame.object.iter().copied().filter(|index| *index != NO_OBJECT).collect();
    let hits = shown.len();
    shown.sort_unstable();
    shown.dedup();
    Ok(Checked {
        pixels: frame.object.len(),
        hits,
        objects: shown.len(),
        doubtful: pixels.len(),
        by_reference: pixels.len().div_ceil(every),
    })
}

impl<'a> Checker<'a> {
    fn new(scene: &'a Scene, camera: &'a Camera, frame: &'a Frame<f32>) -> Checker<'a> {
        let resolved = camera.resolve().unwrap();
        let (basis, Viewport { width, height, distance }) = (resolved.basis(), camera.viewport);
        let (columns, rows) = (f64::from(camera.image.width()), f64::from(camera.image.height()));
        let across = |column: &u32| {
            let u = width * (2.0 * f64::from(*column) + 1.0 - columns) / (2.0 * columns);
            u * basis.u
        };
        let down = |row: &u32| {
            let v = height * (rows - 2.0 * f64::from(*row) - 1.0) / (2.0 * rows);
            v * basis.v - distance * basis.w
        };
        Checker {
            scene,
            camera,
            resolved,
            frame,
            seen: scene.objects().map(|object| Seen::new(&object, camera.eye)).collect(),
            across: frame.raster().columns().iter().map(across).collect(),
            down: frame.raster().rows().iter().map(down).collect(),
            own: Vec::new(),
        }
    }

    fn direction(&self, pixel: usize) -> DVec3 {
        self.across[pixel % self.across.len()] + self.down[pixel / self.across.len()]
    }

    fn describe(&self, pixel: usize) -> String {
        let pixel = self.frame.at(pixel / self.across.len(), pixel % self.across.len());
        let object = pixel.object.map_or("nothing".to_owned(), |index| format!("object {index}"));
        let Pixel { row, column } = pixel.pixel;
        format!("row {row}, column {column}: {object} at t = {:?}", pixel.t)
    }

    /// Fills in `own`, for each pixel the interval of `t` of the object that it shows. Adds wrong
    /// pixels to `faults`, and returns those for which `f64` is inconclusive.
    fn find_own(&mut self, faults: &mut Faults) -> Vec<Candidate> {
        let of_pixel = |pixel: usize| {
            let (t, object) = (self.frame.t[pixel], self.frame.object[pixel]);
            if object == NO_OBJECT {
                return if t == f32::INFINITY { Own::Sure([f64::INFINITY; 2]) } else { Own::Wrong };
            }
            if !t.is_finite() {
                return Own::Wrong;
            }
            match self.seen[object as usize].meeting(self.direction(pixel)) {
                Meeting::None => Own::Wrong,
                Meeting::Unknown => Own::InDoubt,
                Meeting::At(low, high) => {
                    // The smaller spacing next to a power of two.
                    let ulp = f64::from(t) - f64::from(t.next_down());
                    let off = [low, high].map(|true_t| (f64::from(t) - true_t).abs() / ulp);
                    let (least, most) = (off[0].min(off[1]), off[0].max(off[1]));
                    if most <= 0.99 {
                        Own::Sure([low, high])
                    } else if least > 2.01 + (high - low) / ulp {
                        Own::Wrong
                    } else {
                        Own::InDoubt
                    }
                }
            }
        };
        let found: Vec<Own> = (0..self.frame.object.len()).into_par_iter().map(of_pixel).collect();
        let mut in_doubt = Vec::new();
        for (pixel, own) in found.into_iter().enumerate() {
            let t = f64::from(self.frame.t[pixel]);
            let near = match own {
                Own::Sure(near) => near,
                Own::InDoubt => {
                    in_doubt.push((pixel, self.frame.object[pixel]));
                    // If the object is right, its t is within about an ulp of the shown one.
                    [t * (1.0 - 1e-6), t * (1.0 + 1e-6)]
                }
                Own::Wrong => {
                    faults.insert(pixel, format!("{}, which is not there", self.describe(pixel)));
                    [0.0; 2]
                }
            };
            self.own.push(near);
        }
        in_doubt
    }

    /// Finds the objects that pixels should perhaps show instead of the one that they show. Adds those
    /// pixels to `faults` for which this is certain.
    fn find_others(&self, faults: &mut Faults) -> Vec<Candidate> {
        let found = (0..self.seen.len() as u32).into_par_iter().map(|index| {
            let (mut candidates, mut nearer) = (Vec::new(), Vec::new());
            self.look_for(index, &mut candidates, &mut nearer);
            (candidates, nearer)
        });
        let (candidates, nearer) = found.reduce(Default::default, |mut a, mut b| {
            a.0.append(&mut b.0);
            a.1.append(&mut b.1);
            a
        });
        for (pixel, index) in nearer {
            let text = format!("{}, but object {index} is surely nearer", self.describe(pixel));
            faults.entry(pixel).or_insert(text);
        }
        candidates
    }

    /// Finds the pixels in which the object with this index may be (added to `candidates`), or
    /// certainly is (added to `nearer`), in front of the object that the pixel shows.
    fn look_for(&self, index: u32, candidates: &mut Vec<Candidate>, nearer: &mut Vec<Candidate>) {
        let seen = &self.seen[index as usize];
        let spheres = self.scene.spheres();
        let own = spheres.get(index as usize);
        let (rows, columns) = self.extent(seen);
        let nearest = match seen {
            Seen::Sphere(sphere) => {
                sphere.least_depth(self.resolved.basis()) / self.camera.viewport.distance
            }
            Seen::Plane(..) => 0.0,
        };
        for row in rows {
            for column in columns.clone() {
                let pixel = row * self.across.len() + column;
                let [own_low, own_high] = self.own[pixel];
                let shown = self.frame.object[pixel];
                if nearest > own_high || shown == index {
                    continue;
                }
                let meeting = seen.meeting(self.across[column] + self.down[row]);
                match meeting {
                    Meeting::None => {}
                    Meeting::At(low, _) if low > own_high => {}
                    Meeting::At(_, high) if high < own_low => nearer.push((pixel, index)),
                    _ if own.is_some() && own == spheres.get(shown as usize) => {
                        // Of identical spheres, the first one must be shown.
                        if index < shown {
                            nearer.push((pixel, index));
                        }
                    }
                    _ => candidates.push((pixel, index)),
                }
            }
        }
    }

    /// Returns ranges of the raster's rows and columns outside of which an object is certainly not
    /// visible.
    fn extent(&self, seen: &Seen) -> (Range<usize>, Range<usize>) {
        let whole = (0..self.down.len(), 0..self.across.len());
        let Seen::Sphere(sphere) = seen else { return whole };
        let [x, y] = sphere.slopes(self.resolved.basis());
        let Viewport { width, height, distance } = self.camera.viewport;
        let (columns, rows) =
            (f64::from(self.camera.image.width()), f64::from(self.camera.image.height()));
        let between = |cells: &[u32], low: f64, high: f64| {
            // The margin also has a relative part, for positions far outside the image.
            let from =
                cells.partition_point(|cell| f64::from(*cell) < low - 1.0 - 1e-9 * low.abs());
            let to =
                cells.partition_point(|cell| f64::from(*cell) <= high + 1.0 + 1e-9 * high.abs());
            from..to.max(from)
        };
        let column = |x: f64| (x * distance / width + 0.5) * columns - 0.5;
        let row = |y: f64| (0.5 - y * distance / height) * rows - 0.5;
        let raster = self.frame.raster();
        (
            between(raster.rows(), row(y[1]), row(y[0])),
            between(raster.columns(), column(x[0]), column(x[1])),
        )
    }

    /// Decides exactly which of the shown object and the candidates a pixel should show. Returns a
    /// description of the error, if the pixel is wrong.
    fn decide(&self, pixel: usize, candidates: &[Candidate], by_reference: bool) -> Option<String> {
        let (shown, found) = (self.frame.object[pixel], self.frame.t[pixel]);
        let mut objects: Vec<u32> = candidates.iter().map(|(_, index)| *index).collect();
        objects.extend((shown != NO_OBJECT).then_some(shown));
        objects.sort_unstable();
        objects.dedup();
        let position = self.frame.at(pixel / self.across.len(), pixel % self.across.len()).pixel;
        let (first, ulps) = if by_reference {
            self.by_reference(&objects, position, found)
        } else {
            self.by_exact_ray(&objects, position, found)
        };
        let first = first.map_or(NO_OBJECT, |position| objects[position]);
        if first == shown && ulps <= 1.0 {
            return None;
        }
        let truth = if first == NO_OBJECT { "nothing".to_owned() } else { first.to_string() };
        Some(format!("{}, {ulps} ulp off; right is {truth}", self.describe(pixel)))
    }

    /// Returns the position in `objects` of the one that the reference finds to be hit first, and the
    /// error of `t` in ulps of `f32`.
    fn by_reference(&self, objects: &[u32], position: Pixel, t: f32) -> (Option<usize>, f64) {
        let objects: Vec<reference::Object> =
            objects.iter().map(|index| as_reference(self.scene.object(*index).unwrap())).collect();
        let camera = camera_as_reference(self.camera);
        let view = camera.prepare(&objects).ok();
        let hit = view.and_then(|view| view.first_hit_of_pixel(position.row, position.column));
        let ulps = hit.as_ref().filter(|_| t.is_finite()).map_or(0.0, |hit| hit.t.ulps_from_f32(t));
        (hit.map(|hit| hit.object), ulps)
    }

    fn by_exact_ray(&self, objects: &[u32], position: Pixel, t: f32) -> (Option<usize>, f64) {
        // Spheres have lower indices than planes, so the order of the objects does not change.
        let (mut spheres, mut planes) = (Vec::new(), Vec::new());
        for index in objects {
            match self.scene.object(*index).unwrap() {
                Object::Sphere(sphere) => spheres.push(sphere),
                Object::Plane(plane) => planes.push(plane),
            }
        }
        let few = Scene::new(spheres, planes).unwrap();
        let hit = few.first_hit_of(&self.resolved.exact_ray(position));
        let ulps = hit.map_or(0.0, |hit| {
            let rounded = hit.t as f32;
            let is_near = [rounded.next_down(), rounded, rounded.next_up()].contains(&t);
            let ulp = f64::from(rounded.next_up()) - f64::from(rounded);
            let off = (f64::from(t) - hit.t).abs() / ulp;
            if is_near { off.min(1.0) } else { off }
        });
        (hit.map(|hit| hit.object as usize), ulps)
    }
}

/// The result of checking, in `f64` with error bounds, the object that a pixel shows.
enum Own {
    /// The ray hits the object, the shown `t` is right, and the true `t` lies between these numbers.
    /// Both are infinite if the pixel shows no object.
    Sure([f64; 2]),
    /// The error bounds are too large to decide.
    InDoubt,
    /// The ray misses the object, or the shown `t` is wrong.
    Wrong,
}

fn as_reference(object: Object) -> reference::Object {
    match object {
        Object::Sphere(Sphere { center, radius }) => {
            reference::Object::Sphere { center: center.to_array(), radius }
        }
        Object::Plane(Plane { point, normal }) => {
            reference::Object::Plane { point: point.to_array(), normal: normal.to_array() }
        }
    }
}

fn camera_as_reference(camera: &Camera) -> reference::Camera {
    let orientation = match camera.orientation {
        Orientation::At { at, up } => {
            reference::Orientation::At { at: at.to_array(), up: up.to_array() }
        }
        Orientation::View { view, up } => {
            reference::Orientation::View { view: view.to_array(), up: up.to_array() }
        }
        Orientation::Basis(Basis { u, v, w }) => {
            let [u, v, w] = [u, v, w].map(|axis| axis.to_array());
            reference::Orientation::Basis { u, v, w }
        }
    };
    let Viewport { width, height, distance } = camera.viewport;
    let (columns, rows) = (camera.image.width(), camera.image.height());
    let eye = camera.eye.to_array();
    reference::Camera { eye, orientation, width, height, distance, columns, rows }
}
