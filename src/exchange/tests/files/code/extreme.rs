use glam::DVec3;

const EYE: DVec3 = DVec3::new(1e16, -0.1, 0.3333333333333333);
const U: DVec3 = DVec3::new(0.9486832980505138, 0.0, 0.31622776601683794); // right
const V: DVec3 = DVec3::new(-1.999999999999996e-8, 0.999999999999998, 5.999999999999988e-8); // up in the image
const W: DVec3 = DVec3::new(-0.3162277660168373, -6.324555320336745e-8, 0.9486832980505119); // backwards
const WIDTH: f64 = 1e-12; // of the viewport
const HEIGHT: f64 = 2.5e-13;
const DISTANCE: f64 = 7e20;
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
