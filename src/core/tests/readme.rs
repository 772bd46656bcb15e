//! The README's example prints what stands below it.

use pinhole_core::*;

#[test]
fn the_readme_shows_what_its_example_prints() {
    let ball = Sphere::new([0.0, 0.0, -5.0], 1.5).unwrap();
    let floor = Plane::new([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
    let scene = Scene::new(vec![ball], vec![floor]).unwrap();
    let camera = Camera { image: ImageSize::new(20, 10).unwrap(), ..Camera::CANONICAL };
    let camera = camera.resolve().unwrap();
    let raster = Raster::full(camera.image());
    let frame = trace(&scene, &camera, &raster, Outputs::default());
    let sign = |object: &u32| match *object {
        0 => 'o',
        NO_OBJECT => ' ',
        _ => '.',
    };
    let line = |row: &[u32]| row.iter().map(sign).collect::<String>();
    let found: Vec<_> = frame.object.chunks(20).map(line).collect();
    let shown = include_str!("../README.md").split_once("```text\n").unwrap().1;
    let shown: Vec<_> = shown.split_once("```").unwrap().0.lines().collect();
    assert_eq!(shown, found.iter().map(|line| line.trim_end()).collect::<Vec<_>>());
}
