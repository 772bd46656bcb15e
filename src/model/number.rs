//! Number formatting for readers: few significant digits, no noise.

/// Formats with at most three significant digits: `0`, `0.5`, `12.3`, `1430`, `3.2e7`, `1e-6`.
pub(crate) fn short(x: f64) -> String {
    let magnitude = x.abs();
    if x == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e5).contains(&magnitude) {
        let text = format!("{x:.1e}");
        return text.replace(".0e", "e");
    }
    let digits_before = magnitude.log10().floor() as i32 + 1;
    let decimals = (3 - digits_before).clamp(0, 5) as usize;
    let text = format!("{x:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// Formats a power of ten: `10⁻⁶`, but `1` and `10`.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => {
            let raised = |c: char| match c {
                '-' => '⁻',
                digit => "⁰¹²³⁴⁵⁶⁷⁸⁹"
                    .chars()
                    .nth(digit.to_digit(10).unwrap_or(0) as usize)
                    .unwrap_or(digit),
            };
            format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
        }
    }
}

/// Formats an integer in groups of three digits: `1,234,567`.
pub(crate) fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (place, digit) in digits.char_indices() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Formats `value` with this number of significant digits and without trailing zeros; never `NaN`
/// or `inf`.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "beyond f64".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = digits.max(1);
    let scientific = format!("{:.*e}", digits - 1, value);
    let exponent: i32 =
        scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or_default();
    if (-5..digits.max(7) as i32).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        let fixed = format!("{value:.decimals$}");
        if fixed.contains('.') {
            return fixed.trim_end_matches('0').trim_end_matches('.').to_owned();
        }
        return fixed;
    }
    match scientific.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => {
            let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
            format!("{mantissa}e{exponent}")
        }
        _ => scientific,
    }
}

/// Formats like [`significant`], with the real minus sign.
pub(crate) fn written(value: f64, digits: usize) -> String {
    significant(value, digits).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::grouped;
    use super::short;

    #[test]
    fn groups_of_three() {
        for (n, text) in [(0, "0"), (999, "999"), (1000, "1,000"), (12_345_678, "12,345,678")] {
            assert_eq!(grouped(n), text);
        }
    }

    #[test]
    fn few_digits() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (0.5, "0.5"),
            (12.345, "12.3"),
            (9.9999, "10"),
            (1430.4, "1430"),
            (32_145_678.0, "3.2e7"),
            (1e-6, "1e-6"),
            (-0.25, "-0.25"),
            (0.001_234_56, "0.00123"),
            (5e-324, "4.9e-324"),
            (f64::MAX, "1.8e308"),
        ];
        for (x, text) in cases {
            assert_eq!(short(x), text, "{x:?}");
        }
    }
}
