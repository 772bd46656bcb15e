//! Functions of NumPy and of OpenCV that make matrices.

use super::MOST;
use super::Matrix;
use super::whole;
use crate::exchange::code::is_of_word;

/// What puts matrices together.
pub(super) const STACKS: [&str; 5] =
    ["hstack", "vstack", "row_stack", "column_stack", "concatenate"];

/// What stands before the name of a function or constant.
pub(super) const MODULES: [&str; 11] =
    ["np", "numpy", "cv", "cv2", "math", "std", "linalg", "Math", "Mat", "Matx33d", "Matx33f"];

/// Of numbers with digits behind the point.
pub(super) fn is_type(text: &str) -> bool {
    let text = text.strip_prefix("dtype").map_or(text, |text| text.trim_start_matches(['=', ' ']));
    let text = text.trim_matches(['"', '\'']);
    let short = text.rsplit(['.', ':']).next().unwrap_or_default();
    let floats =
        ["float", "double", "float32", "float64", "CV_64F", "CV_32F", "CV_64FC1", "CV_32FC1"];
    floats.contains(&short)
}

/// What a function makes of its arguments.
pub(super) fn made(name: &str, values: &[Matrix]) -> Option<Matrix> {
    let each = |of: fn(f64) -> f64| match values {
        [value] => Some(value.each(of)),
        _ => None,
    };
    let sizes = || -> Option<Vec<usize>> {
        values.iter().flat_map(|value| &value.numbers).map(|size| whole(*size)).collect()
    };
    let filled = |number: f64| {
        let sizes = sizes().filter(|sizes| sizes.iter().product::<usize>() <= MOST)?;
        let count = sizes.iter().product();
        Matrix::shaped(sizes, vec![number; count])
    };
    match (name, values) {
        (
            "array" | "asarray" | "matrix" | "asmatrix" | "mat" | "float32" | "float64" | "float"
            | "double" | "Matrix",
            [value],
        ) => Some(value.clone()),
        ("eye" | "identity", _) => match sizes()?[..] {
            [] => Matrix::eye(3),
            [n] => Matrix::eye(n),
            [n, m] if n == m => Matrix::eye(n),
            _ => None,
        },
        ("zeros", _) => filled(0.0),
        ("ones", _) => filled(1.0),
        ("diag", [value]) => value.is_vector().then(|| Matrix::diagonal(&value.numbers))?,
        ("deg2rad" | "radians", _) => each(f64::to_radians),
        ("rad2deg" | "degrees", _) => each(f64::to_degrees),
        ("sqrt", _) => each(f64::sqrt),
        ("sin", _) => each(f64::sin),
        ("cos", _) => each(f64::cos),
        ("tan", _) => each(f64::tan),
        ("atan" | "arctan", _) => each(f64::atan),
        ("Rodrigues", [value]) => value.rodrigues(),
        ("inv", [value]) => value.inverse(),
        ("transpose", [value]) => value.transposed(),
        ("dot" | "matmul", [a, b]) => a.product(b),
        ("Matx33d" | "Matx33f", _) if values.len() == 9 => {
            Matrix::of_list(values.to_vec())?.reshaped(&[3.0, 3.0])
        }
        (
            "Vec3d" | "Vec3f" | "Point3d" | "Point3f" | "Matx31d" | "Vector3d" | "Vector3",
            [x, y, z],
        ) => Matrix::of_list(vec![x.clone(), y.clone(), z.clone()]),
        _ => None,
    }
}

/// The number at which a text begins, such as `5`, `1e-3` or `0.5f`, and how long it is.
pub(super) fn number_at(text: &str) -> Option<(f64, usize)> {
    let mut end = text.len().min(60);
    let is_part = |at: usize, c: char| {
        let after_e = at > 0 && text[..at].ends_with(['e', 'E']);
        c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E') || (after_e && matches!(c, '+' | '-'))
    };
    if let Some((at, _)) = text.char_indices().take(60).find(|(at, c)| !is_part(*at, *c)) {
        end = at;
    }
    let number = text.get(..end)?.parse::<f64>().ok()?;
    let end = end + usize::from(text[end..].starts_with(['f', 'F']));
    let is_ended = |c: char| !is_of_word(c);
    text[end..].chars().next().is_none_or(is_ended).then_some((number, end))
}
