//! Rust with glam.

use super::language::Language;
use super::numbers::{Numbers, Precision};

pub(super) const LANGUAGE: Language = Language {
    name: "glam",
    label: "Rust (glam)",
    file: "camera.rs",
    precision: Precision::Double,
    write,
};

fn write(numbers: &Numbers) -> String {
    let Numbers { eye, u, v, w, width, height, distance, columns, rows } = numbers;
    format!(
        "\
use glam::DVec3;

const EYE: DVec3 = DVec3::new({eye});
const U: DVec3 = DVec3::new({u}); // right
const V: DVec3 = DVec3::new({v}); // up in the image
const W: DVec3 = DVec3::new({w}); // backwards
const WIDTH: f64 = {width}; // of the viewport
const HEIGHT: f64 = {height};
const DISTANCE: f64 = {distance};
const COLUMNS: u32 = {columns}; // of the image
const ROWS: u32 = {rows};

/// Origin and direction of the view ray of row i and column j, from 0, row 0 on top.
fn ray(i: u32, j: u32) -> (DVec3, DVec3) {{
    let u = WIDTH * ((f64::from(j) + 0.5) / f64::from(COLUMNS) - 0.5);
    let v = HEIGHT * (0.5 - (f64::from(i) + 0.5) / f64::from(ROWS));
    (EYE, u * U + v * V - DISTANCE * W)
}}

fn main() {{
    println!(\"{{:?}}\", ray(0, 0));
}}
"
    )
}
