//! Python with NumPy.

use super::language::Language;
use super::numbers::{Numbers, Precision};

pub(super) const LANGUAGE: Language = Language {
    name: "numpy",
    label: "Python + NumPy",
    file: "camera.py",
    precision: Precision::Double,
    write,
};

fn write(numbers: &Numbers) -> String {
    let Numbers { eye, u, v, w, width, height, distance, columns, rows } = numbers;
    format!(
        "\
import numpy as np

eye = np.array([{eye}])
U = np.array([{u}])  # right
V = np.array([{v}])  # up in the image
W = np.array([{w}])  # backwards
width, height, distance = {width}, {height}, {distance}  # of the viewport
columns, rows = {columns}, {rows}  # of the image


def ray(i, j):
    \"\"\"Origin and direction of the view ray of row i and column j, from 0, row 0 on top.\"\"\"
    u = width * ((j + 0.5) / columns - 0.5)
    v = height * (0.5 - (i + 0.5) / rows)
    return eye, u * U + v * V - distance * W


if __name__ == \"__main__\":
    print(ray(0, 0))
"
    )
}
