use pinhole_core::*;
fn main() {
    let image = ImageSize::new(1024, 1024).unwrap();
    let orientation = Orientation::At { at: DVec3::new(0.1, 0.0, -5.0), up: DVec3::Y };
    let viewport = Viewport { width: 2.0, height: 2.0, distance: 1.0 };
    let camera =
        Camera { eye: DVec3::new(0.1, 0.05, 0.0), orientation, viewport, image }.posed().unwrap();
    let sphere = Sphere { center: DVec3::new(0.1, 0.0, -5.0), radius: 3.5 };
    let scene = Scene::new(vec![sphere], vec![]).unwrap();
    let raster = Raster::full(camera.image());
    rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(|| {
        let start = std::time::Instant::now();
        let f = trace_as::<f64>(&scene, &camera, &raster, Outputs::default());
        println!("{:?} {:?}", f.steps, start.elapsed());
    });
}
