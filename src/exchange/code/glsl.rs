//! GLSL: a fragment shader that shows each pixel's direction as a colour.

use super::language::Language;
use super::numbers::{Numbers, Precision};

pub(super) const LANGUAGE: Language = Language {
    name: "glsl",
    label: "GLSL",
    file: "camera.frag",
    precision: Precision::Single,
    write,
};

fn write(numbers: &Numbers) -> String {
    let Numbers { eye, u, v, w, width, height, distance, columns, rows } = numbers;
    format!(
        "\
#version 330 core
out vec4 color;

const vec3 eye = vec3({eye});
const vec3 U = vec3({u}); // right
const vec3 V = vec3({v}); // up in the image
const vec3 W = vec3({w}); // backwards
const float width = {width}, height = {height}; // of the viewport
const float d = {distance}; // its distance; the word itself is a function here
const int columns = {columns}, rows = {rows}; // of the image

struct Ray {{
    vec3 origin, direction;
}};

// The view ray of row i and column j, from 0, row 0 on top.
Ray ray(int i, int j) {{
    float u = width * ((float(j) + 0.5) / float(columns) - 0.5);
    float v = height * (0.5 - (float(i) + 0.5) / float(rows));
    return Ray(eye, u * U + v * V - d * W);
}}

void main() {{
    int i = rows - 1 - int(gl_FragCoord.y); // OpenGL counts rows from below
    int j = int(gl_FragCoord.x);
    color = vec4(0.5 + 0.5 * normalize(ray(i, j).direction), 1.0);
}}
"
    )
}
