//! Prints a shaded picture to the terminal: `cargo run --release -p pinhole-core --example terminal`.
#![allow(clippy::print_stdout, reason = "this is where the picture is shown")]

use std::error::Error;

use pinhole_core::{
    BACKGROUND, Camera, Depth, ImageSize, Orientation, Outputs, Paint, Plane, Raster, Rgb, Scene,
    Shade, Sphere, Viewport, trace_painted,
};

/// Characters from dark to light.
const TONES: &[u8] = b" .:-=+*#%@";

fn main() -> Result<(), Box<dyn Error>> {
    let spheres = vec![
        Sphere::new([0.0, 1.0, 0.0], 1.0)?,
        Sphere::new([-1.6, 0.6, 0.8], 0.6)?,
        Sphere::new([1.3, 0.4, 1.2], 0.4)?,
    ];
    let floor = Plane::new([0.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
    let scene = Scene::new(spheres, vec![floor])?;
    // A character is about twice as high as wide, so the image has half as many rows as the viewport's
    // shape suggests.
    let camera = Camera {
        eye: [0.0, 2.2, 6.0].into(),
        orientation: Orientation::At { at: [0.0, 0.7, 0.0].into(), up: [0.0, 1.0, 0.0].into() },
        viewport: Viewport { width: 1.6, height: 0.9, distance: 2.0 },
        image: ImageSize::new(96, 27)?,
    };
    print!("{}", picture::<f32>(&scene, &camera)?);
    Ok(())
}

fn picture<T: Depth>(scene: &Scene, camera: &Camera) -> Result<String, Box<dyn Error>> {
    let camera = camera.resolve()?;
    let raster = Raster::full(camera.image());
    let paint = Paint {
        shade: Shade::Lambert,
        color_of: |object| if object < 3 { [255; 3] } else { [120; 3] },
        to_pixel: tone,
    };
    let mut tones = vec![b' '; raster.len()];
    trace_painted::<T, u8>(scene, &camera, &raster, Outputs::NONE, &paint, &mut tones);
    let mut text = String::new();
    for row in tones.chunks(raster.columns().len()) {
        text.push_str(str::from_utf8(row)?.trim_end());
        text.push('\n');
    }
    Ok(text)
}

fn tone(color: Rgb) -> u8 {
    if color == BACKGROUND {
        return b' ';
    }
    TONES[usize::from(color[1]) * (TONES.len() - 1) / 255]
}
