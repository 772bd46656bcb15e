//! Numbers as text, for error messages and readouts.

use glam::DVec3;

/// The shortest decimal that reads back to the same `f64`: `1`, `0.1`, `1e300`.
///
/// Unlike `{}` it never prints hundreds of zeros, unlike `{:?}` it prints no trailing `.0`, and
/// negative zero, which no reader needs to know of, is `0`.
pub fn shortest(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{x:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// A point or direction as `(1, 2, 3)`.
pub fn triple(p: DVec3) -> String {
    format!("({}, {}, {})", shortest(p.x), shortest(p.y), shortest(p.z))
}
