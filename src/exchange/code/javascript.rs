//! JavaScript, without packages: in a page or in Node.

use super::language::Language;
use super::numbers::{Numbers, Precision};

pub(super) const LANGUAGE: Language = Language {
    name: "javascript",
    label: "JavaScript",
    file: "camera.js",
    precision: Precision::Double,
    write,
};

fn write(numbers: &Numbers) -> String {
    let Numbers { eye, u, v, w, width, height, distance, columns, rows } = numbers;
    format!(
        "\
const eye = [{eye}];
const U = [{u}]; // right
const V = [{v}]; // up in the image
const W = [{w}]; // backwards
const [width, height, distance] = [{width}, {height}, {distance}]; // of the viewport
const [columns, rows] = [{columns}, {rows}]; // of the image

// Origin and direction of the view ray of row i and column j, from 0, row 0 on top.
function ray(i, j) {{
  const u = width * ((j + 0.5) / columns - 0.5);
  const v = height * (0.5 - (i + 0.5) / rows);
  const direction = [0, 1, 2].map((k) => u * U[k] + v * V[k] - distance * W[k]);
  return [eye, direction];
}}

console.log(ray(0, 0));
"
    )
}
