//! Julia, without packages.

use super::language::Language;
use super::numbers::{Numbers, Precision};

pub(super) const LANGUAGE: Language = Language {
    name: "julia",
    label: "Julia",
    file: "camera.jl",
    precision: Precision::Double,
    write,
};

fn write(numbers: &Numbers) -> String {
    let Numbers { eye, u, v, w, width, height, distance, columns, rows } = numbers;
    format!(
        "\
const eye = [{eye}]
const U = [{u}]  # right
const V = [{v}]  # up in the image
const W = [{w}]  # backwards
const width, height, distance = {width}, {height}, {distance}  # of the viewport
const columns, rows = {columns}, {rows}  # of the image

\"Origin and direction of the view ray of row i and column j, from 0, row 0 on top.\"
function ray(i, j)
    u = width * ((j + 0.5) / columns - 0.5)
    v = height * (0.5 - (i + 0.5) / rows)
    return eye, u * U + v * V - distance * W
end

if abspath(PROGRAM_FILE) == @__FILE__
    println(ray(0, 0))
end
"
    )
}
