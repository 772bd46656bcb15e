//! The point that walks along the ray, in words: its coordinates, and which objects it is in or on.

use super::number;
use crate::model::inspection::Inspection;
use crate::view::plot::{Curve, Plot};

/// Returns the coordinates of the point at t, as a formula.
pub(super) fn point(inspection: &Inspection, t: f64, digits: usize) -> String {
    let [x, y, z] = inspection.ray.at(t).to_array().map(|x| number(x, digits));
    format!("p + t d = ({x}, {y}, {z})")
}

/// Returns which objects contain the point, and on which ones it is, by the values of f there.
pub(super) fn of(plot: &Plot, values: &[f64]) -> String {
    let titles = |belongs: &dyn Fn(&Curve, f64) -> bool| -> Vec<&str> {
        let curves = plot.curves.iter().zip(values).filter(|(curve, f)| belongs(curve, **f));
        curves.map(|(curve, _)| curve.named.title.as_str()).collect()
    };
    let inside = titles(&|curve, f| curve.is_inside(f)).join(", ");
    let on = titles(&|_, f| f == 0.0).join(", ");
    match (inside.is_empty(), on.is_empty()) {
        (true, true) => "outside all objects".to_owned(),
        (false, true) => format!("inside {inside}"),
        (true, false) => format!("on {on}"),
        (false, false) => format!("inside {inside}; on {on}"),
    }
}
