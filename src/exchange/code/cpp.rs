//! C++ with GLM.

use super::language::Language;
use super::numbers::{Numbers, Precision};

pub(super) const LANGUAGE: Language = Language {
    name: "glm",
    label: "C++ (GLM)",
    file: "camera.cpp",
    precision: Precision::Double,
    write,
};

fn write(numbers: &Numbers) -> String {
    let Numbers { eye, u, v, w, width, height, distance, columns, rows } = numbers;
    format!(
        "\
#include <cstdio>
#include <glm/glm.hpp>

const glm::dvec3 eye({eye});
const glm::dvec3 U({u}); // right
const glm::dvec3 V({v}); // up in the image
const glm::dvec3 W({w}); // backwards
const double width = {width}, height = {height}, distance = {distance}; // of the viewport
const int columns = {columns}, rows = {rows}; // of the image

struct Ray {{
    glm::dvec3 origin, direction;
}};

// The view ray of row i and column j, from 0, row 0 on top.
Ray ray(int i, int j) {{
    double u = width * ((j + 0.5) / columns - 0.5);
    double v = height * (0.5 - (i + 0.5) / rows);
    return {{eye, u * U + v * V - distance * W}};
}}

int main() {{
    glm::dvec3 d = ray(0, 0).direction;
    std::printf(\"%.17g %.17g %.17g\\n\", d.x, d.y, d.z);
}}
"
    )
}
