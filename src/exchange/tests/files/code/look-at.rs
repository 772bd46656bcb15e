use glam::DVec3;

const EYE: DVec3 = DVec3::new(20.0, 4.0, 10.0);
const U: DVec3 = DVec3::new(0.5812381937190964, 0.0, -0.813733471206735); // right
const V: DVec3 = DVec3::new(-0.12463786013791102, 0.9882001768077231, -0.08902704295565073); // up in the image
const W: DVec3 = DVec3::new(0.8041315601208577, 0.1531679162134967, 0.5743796858006127); // backwards
const WIDTH: f64 = 1.0; // of the viewport
const HEIGHT: f64 = 1.0;
const DISTANCE: f64 = 1.0;
const COLUMNS: u32 = 400; // of the image
const ROWS: u32 = 400;

/// Origin and direction of the view ray of row i and column j, from 0, row 0 on top.
fn ray(i: u32, j: u32) -> (DVec3, DVec3) {
    let u = WIDTH * ((f64::from(j) + 0.5) / f64::from(COLUMNS) - 0.5);
    let v = HEIGHT * (0.5 - (f64::from(i) + 0.5) / f64::from(ROWS));
    (EYE, u * U + v * V - DISTANCE * W)
}

fn main() {
    println!("{:?}", ray(0, 0));
}
