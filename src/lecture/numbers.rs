//! Numbers for readers: few significant digits, no noise.

/// Digits in groups of three: `1,234,567`.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (k, digit) in digits.char_indices() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The number to that many significant digits, trailing zeros dropped; never `NaN` or `inf`. Fewer
/// digits where they tell the number from all others: 0.1 at 17 digits is `0.1`.
pub fn significant(value: f64, digits: usize) -> String {
    // All numbers of 15 digits are told apart.
    let fewer = (15..digits).map(|digits| rounded(value, digits));
    let mut telling = fewer.filter(|text| text.parse() == Ok(value));
    telling.next().unwrap_or_else(|| rounded(value, digits))
}

fn rounded(value: f64, digits: usize) -> String {
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

/// [`significant`] digits with the real minus sign, as people write numbers.
pub fn written(value: f64, digits: usize) -> String {
    significant(value, digits).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::{grouped, significant};

    #[test]
    fn digits_that_say_nothing_more_are_left_out() {
        for (x, digits, text) in [
            (0.1, 17, "0.1"),
            (0.1, 16, "0.1"),
            (0.5_f64.sqrt(), 17, "0.7071067811865476"),
            (0.1 + 0.2, 17, "0.30000000000000004"),
            (0.1 + 0.2, 16, "0.3"),
            (1e22 / 3.0, 5, "3.3333e21"),
        ] {
            assert_eq!(significant(x, digits), text);
        }
    }

    #[test]
    fn groups_of_three() {
        for (n, text) in [(0, "0"), (999, "999"), (1000, "1,000"), (12_345_678, "12,345,678")] {
            assert_eq!(grouped(n), text);
        }
    }
}
