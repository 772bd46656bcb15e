//! Numbers in sentences, exact where they are recognised.

use pinhole_core::shortest;

use crate::forms::NumberForm;
use crate::numbers::written;

/// `5√2`, `−1/√2`, `3/7`. Decimals stay decimals.
fn form(form: NumberForm) -> String {
    if form.decimals().is_some() {
        return number(form.value());
    }
    let (n, k, m) = (form.numerator(), form.root(), form.denominator());
    let sign = if n < 0 { "−" } else { "" };
    let above = match (n.unsigned_abs(), k) {
        (n, k) if k == 1 || form.is_root_below() => n.to_string(),
        (1, k) => format!("√{k}"),
        (n, k) => format!("{n}√{k}"),
    };
    match (form.is_root_below(), m) {
        (true, _) => format!("{sign}{above}/√{k}"),
        (false, 1) => format!("{sign}{above}"),
        (false, m) => format!("{sign}{above}/{m}"),
    }
}

/// The number as short as it can be, with the real minus.
pub(super) fn number(x: f64) -> String {
    shortest(x).replace('-', "−")
}

/// The largest number in a fraction or below a root that is still read at a glance.
const SHORT: u64 = 100;

/// For sentences: exact where it is short.
pub(super) fn short(x: f64) -> String {
    let is_short = |form: &NumberForm| match form.decimals() {
        Some(decimals) => decimals <= 5,
        None => [form.numerator().unsigned_abs(), form.root(), form.denominator()]
            .into_iter()
            .all(|n| n <= SHORT),
    };
    NumberForm::recognise(x).filter(is_short).map(form).unwrap_or_else(|| written(x, 5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_holds_no_long_fraction_or_root() {
        for (x, text) in [
            (50f64.sqrt(), "5√2"),
            (74f64.sqrt(), "√74"),
            (-1.0 / 3.0, "−1/3"),
            (-2.5, "−2.5"),
            (4241f64.sqrt() / 5.0, "13.025"),
            (101f64.sqrt(), "10.05"),
            (22.0 / 113.0, "0.19469"),
            (1.0 / 512.0, "0.0019531"),
            (250.0, "250"),
        ] {
            assert_eq!(short(x), text);
        }
    }
}
