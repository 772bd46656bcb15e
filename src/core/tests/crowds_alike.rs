//! Tests that frames of many spheres are bit for bit the same whatever the number of threads, the SIMD
//! level, and the part of the image that is traced.

use pinhole_core::*;

use crate::common::Numbers;
use crate::common::levels::levels;
use crate::support::crowds;
use crate::support::crowds::{Crowd, of_pixels, ordinary};

/// Pools of 1, 2 and 3 threads.
fn pools() -> Vec<(usize, rayon::ThreadPool)> {
    let pool = |count| rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
    [1, 2, 3].map(|count| (count, pool(count))).into()
}

/// Returns a description of the first pixel in which two frames differ; `None` if there is none.
fn difference(a: &Frame<f32>, b: &Frame<f32>) -> Option<String> {
    let bits =
        |frame: &Frame<f32>, offset: usize| (frame.object[offset], frame.t[offset].to_bits());
    let offset = (0..a.t.len()).find(|offset| bits(a, *offset) != bits(b, *offset))?;
    let columns = a.raster().columns().len();
    let pixel = |frame: &Frame<f32>| frame.at(offset / columns, offset % columns);
    Some(format!("{:?} and {:?}", pixel(a), pixel(b)))
}

/// Describes where a crowd's frames, for any of the levels and thread counts, differ from that of one
/// thread on the lowest level.
fn differences(
    crowd: &Crowd,
    levels: &[(&str, Level)],
    pools: &[(usize, rayon::ThreadPool)],
) -> Vec<String> {
    let camera = crowd.camera.resolve().unwrap();
    let raster = Raster::full(crowd.camera.image);
    // Each has a scene of its own, so that its index is made by its own pool.
    let frame = |level, pool: &rayon::ThreadPool| {
        let scene =
            Scene::new(crowd.scene.spheres().to_vec(), crowd.scene.planes().to_vec()).unwrap();
        pool.install(|| {
            trace_at_level::<f32>(level, &scene, &camera, &raster, Outputs::default(), |_| ())
        })
    };
    let first = frame(levels[0].1, &pools[0].1);
    let mut found = Vec::new();
    for (name, level) in levels {
        let mut known = None;
        for (threads, pool) in pools {
            let other = frame(*level, pool);
            let with = format!("{}, {name}, {threads} threads", crowd.name);
            if let Some(difference) = difference(&first, &other) {
                found.push(format!("{with}: {difference}"));
            }
            // The counts may differ between levels: with longer SIMD vectors, more spheres are drawn at
            // a time, so that other ones are found to be hidden.
            let own = (other.steps, other.counts);
            let known = *known.get_or_insert(own);
            if own != known {
                found.push(format!("{with}: {own:?} and {known:?}"));
            }
        }
    }
    found
}

#[track_caller]
fn assert_none(found: &[String]) {
    assert!(found.is_empty(), "{} differ:\n{}", found.len(), found.join("\n"));
}

#[test]
fn crowds_are_the_same_bits_for_any_threads_and_level() {
    let (levels, pools) = (levels(), pools());
    let mut found = Vec::new();
    for count in [1, 10, 300, 50_000] {
        let radii = [0.3, 60.0 / (count as f64).sqrt() + 1.0];
        let crowd = Crowd::new("many", of_pixels(count, radii, 31), ordinary());
        found.extend(differences(&crowd, &levels, &pools));
    }
    assert_none(&found);
}

#[test]
fn hard_crowds_are_the_same_bits_for_any_threads_and_level() {
    let (levels, pools) = (levels(), pools());
    let mut found = Vec::new();
    for crowd in crowds::all() {
        // Every level by one thread, and every thread count on the best level.
        found.extend(differences(&crowd, &levels, &pools[..1]));
        found.extend(differences(&crowd, &levels[levels.len() - 1..], &pools));
    }
    assert_none(&found);
}

/// Describes the first pixel of a part of the image that differs from the same pixel of the whole
/// picture; `None` if there is none.
fn differing(crowd: &Crowd, whole: &Frame<f32>, raster: &Raster) -> Option<String> {
    let camera = crowd.camera.resolve().unwrap();
    let part = trace_as::<f32>(&crowd.scene, &camera, raster, Outputs::default());
    for row in 0..raster.rows().len() {
        for column in 0..raster.columns().len() {
            let own = part.at(row, column);
            let same = whole.at(own.pixel.row as usize, own.pixel.column as usize);
            if (own.object, own.t.to_bits()) != (same.object, same.t.to_bits()) {
                return Some(format!("{}: {own:?} and {same:?}", crowd.name));
            }
        }
    }
    None
}

#[test]
fn parts_of_pictures_are_the_same_bits_as_the_whole() {
    let mut found = Vec::new();
    for crowd in crowds::all() {
        let image = crowd.camera.image;
        let whole = crowd.trace();
        for (columns, rows) in [(image.width(), 41), (47, image.height()), (59, 33), (7, 3)] {
            let raster = Raster::shown_on(image, columns, rows);
            found.extend(differing(&crowd, &whole, &raster));
        }
        for k in 0..5 {
            let (row, column) = (k * image.height() / 5, (5 - k) * (image.width() - 1) / 5);
            let raster = Raster::part(row..row + 1, column..column + 1);
            found.extend(differing(&crowd, &whole, &raster));
        }
    }
    assert_none(&found);
}

#[test]
fn traced_again_into_the_same_frame_is_the_same_as_anew() {
    let mut frame: Option<Frame<f32>> = None;
    for crowd in crowds::all().iter().filter(|crowd| crowd.camera.image == ordinary().image) {
        let camera = crowd.camera.resolve().unwrap();
        let fresh = crowd.trace();
        let again = frame.get_or_insert_with(|| fresh.clone());
        retrace(again, &crowd.scene, &camera);
        assert_eq!(difference(&fresh, again), None, "{}", crowd.name);
    }
}

#[test]
fn a_crowd_with_spheres_replaced_is_the_same_as_made_anew() {
    for count in [255, 257, 5000] {
        replace_spheres(count, 1.0);
    }
}

/// At these distances, some spheres that are small compared with their distance cannot be drawn by the
/// code for small spheres.
#[test]
fn a_far_crowd_with_spheres_replaced_is_the_same_as_made_anew() {
    for scale in [1e11, 3e11, 1e12] {
        replace_spheres(5000, scale);
    }
}

/// Replaces spheres of a crowd one by one, and compares the frames with those of a new scene. The crowd
/// is `scale` times as large and far away as usual.
fn replace_spheres(count: usize, scale: f64) {
    let mut numbers = Numbers(41);
    let of_size =
        |sphere: &Sphere| Sphere { center: scale * sphere.center, radius: scale * sphere.radius };
    let spheres = of_pixels(count, [0.5, 8.0], 42).iter().map(of_size).collect();
    let mut crowd = Crowd::new("replaced", spheres, ordinary());
    let mut spheres = crowd.scene.spheres().to_vec();
    let mut before = crowd.trace();
    for step in 0..40 {
        let index = numbers.between(0.0, count as f64) as usize;
        // Nearer or farther, smaller or larger, or behind the eye and back again.
        let center = match step % 4 {
            0 => -spheres[index].center,
            _ => numbers.between(0.5, 1.5) * spheres[index].center,
        };
        let radius = scale * 10_f64.powf(numbers.between(-3.0, 0.3));
        spheres[index] = Sphere { center, radius };
        crowd.scene.replace(index as u32, Object::Sphere(spheres[index])).unwrap();
        if step % 8 == 7 {
            let kept = crowd.trace();
            let anew = Crowd::new("anew", spheres.clone(), crowd.camera).trace();
            assert_eq!(difference(&kept, &anew), None, "{count}, step {step}");
            assert!(difference(&kept, &before).is_some(), "{count}, step {step}");
            before = kept;
        }
    }
}
