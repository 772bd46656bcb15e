//! Prints what a frame costs, from one sphere to a million, and what was left out:
//! `cargo run --release -p pinhole-core --example timing`.
#![allow(clippy::print_stdout, reason = "this is where the times are shown")]

use std::error::Error;
use std::time::{Duration, Instant};

use pinhole_core::{Camera, Frame, ImageSize, Outputs, Raster, Scene, Sphere, trace_as};

/// Frames of which the median is taken.
const FRAMES: usize = 15;

fn main() -> Result<(), Box<dyn Error>> {
    let image = ImageSize::new(1280, 720)?;
    let camera = Camera { image, ..Camera::CANONICAL }.resolve()?;
    let raster = Raster::full(image);
    println!("  spheres  ms/frame  Mrays/s  beyond f64  in view  hidden");
    for count in [1, 100, 10_000, 1_000_000] {
        let scene = Scene::new(cloud(count)?, vec![])?;
        let mut frame = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
        let mut times: Vec<Duration> = Vec::with_capacity(FRAMES);
        for _ in 0..FRAMES {
            let start = Instant::now();
            frame = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
            times.push(start.elapsed());
        }
        times.sort();
        println!("{}", line(count, times[FRAMES / 2], &frame));
    }
    Ok(())
}

fn line(count: u32, time: Duration, frame: &Frame<f32>) -> String {
    let seconds = time.as_secs_f64();
    let rays = frame.raster().len() as f64;
    format!(
        "{count:9}  {:8.2}  {:7.0}  {:10}  {:7}  {:6}",
        1e3 * seconds,
        1e-6 * rays / seconds,
        frame.steps.beyond_f64(),
        frame.counts.in_view,
        frame.counts.hidden,
    )
}

/// Spheres spread evenly over a box in front of the camera, the smaller the more there are: the
/// points k * (a, b, c) mod 1 with a, b, c the powers of the plastic number's inverse in three
/// dimensions (Roberts, *The unreasonable effectiveness of quasirandom sequences*, 2018).
fn cloud(count: u32) -> Result<Vec<Sphere>, Box<dyn Error>> {
    let step = [0.819_172_513_396_164_5, 0.671_043_606_703_789_3, 0.549_700_477_901_970_4];
    let radius = 0.5 / f64::from(count).cbrt();
    let sphere = |k: u32| {
        let [x, y, z] = step.map(|step| (f64::from(k) * step).fract() - 0.5);
        Ok(Sphere::new([2.0 * x, 2.0 * y, -3.0 + 2.0 * z], radius)?)
    };
    (1..=count).map(sphere).collect()
}
