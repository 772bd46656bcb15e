//! Prints the view ray of every pixel and its first hit as CSV:
//! `cargo run --release -p pinhole-core --example rays_to_csv > rays.csv`.
#![allow(clippy::print_stdout, reason = "this is where the table goes")]

use std::error::Error;

use pinhole_core::{Basis, Camera, ImageSize, Orientation, Pixel, Scene, Sphere, shortest};

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene::new(vec![Sphere::new([-1.0, 0.0, -5.0], 3.0)?], vec![])?;
    let (eye, at, up) = ([20.0, 4.0, 10.0], [-1.0, 0.0, -5.0], [0.0, 1.0, 0.0]);
    let camera = Camera {
        eye: eye.into(),
        orientation: Orientation::At { at: at.into(), up: up.into() },
        image: ImageSize::new(16, 16)?,
        ..Camera::CANONICAL
    };
    let resolved = camera.resolve()?;
    assert_eq!(*resolved.basis(), Basis::from_eye_at_up(eye.into(), at.into(), up.into())?);
    println!("row,column,ox,oy,oz,dx,dy,dz,object,t,px,py,pz");
    for row in 0..resolved.image().height() {
        for column in 0..resolved.image().width() {
            let pixel = Pixel { row, column };
            // The ray is printed rounded; the hit is that of the exact ray.
            let ray = resolved.ray_of_pixel(pixel);
            let hit = scene.first_hit_of(&resolved.exact_ray(pixel));
            let numbers = [ray.origin, ray.direction].map(|v| v.to_array().map(shortest).join(","));
            let met = hit.map_or(",,,,".to_owned(), |hit| {
                let point = hit.point.to_array().map(shortest).join(",");
                format!("{},{},{point}", hit.object, shortest(hit.t))
            });
            println!("{row},{column},{},{met}", numbers.join(","));
        }
    }
    Ok(())
}
