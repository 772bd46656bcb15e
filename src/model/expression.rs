//! Arithmetic in number fields: `sqrt(2)/2`, `1/3`, `2*pi`.

use exmex::{Express, FlatEx, FloatOpsFactory, MatchLiteral, literal_matcher_from_pattern};

// exmex's own pattern for numbers has no exponent.
literal_matcher_from_pattern!(NumberLiteral, r"^(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?");

/// Evaluates the text of a number field: a number, or arithmetic with `+ - * / ^`, brackets,
/// functions such as `sqrt`, `sin`, `cos` and `tan`, and `pi`. Accepts the signs that people paste
/// (`−`, `×`, `·`, `√`, `π`) too.
///
/// # Errors
/// Returns a sentence for the person who typed the text if its value is not a finite number.
pub fn evaluate(text: &str) -> Result<f64, String> {
    let typed = text.trim();
    let plain: String = typed
        .chars()
        .map(|c| match c {
            '−' => '-',
            '×' | '·' => '*',
            other => other,
        })
        .collect::<String>()
        .replace('√', "sqrt")
        .replace("pi", "π")
        .replace('²', "^2")
        .replace('³', "^3");
    if plain.is_empty() {
        return Err("type a number, such as 0.5, 1/3 or sqrt(2)/2".to_owned());
    }
    // A plain number first: this keeps every digit and accepts exponents such as `1e-300`.
    let value = match plain.parse::<f64>() {
        Ok(value) => value,
        Err(_) => FlatEx::<f64, FloatOpsFactory<f64>, NumberLiteral>::parse(&plain)
            .and_then(|expression| expression.eval(&[]))
            .map_err(|_| format!("“{typed}” is not a number: try 0.5, 1/3 or sqrt(2)/2"))?,
    };
    if value.is_finite() { Ok(value) } else { Err(format!("“{typed}” is not a finite number")) }
}

#[cfg(test)]
mod tests {
    use super::evaluate;

    #[test]
    fn numbers_keep_every_digit() {
        for x in [0.1, -2.5, 1e-300, 1.797e308, 5e-324, 0.7123456789012345, -0.0] {
            assert_eq!(evaluate(&format!("{x:?}")), Ok(x));
        }
    }

    #[test]
    fn arithmetic_is_what_one_expects() {
        let cases = [
            ("sqrt(2)/2", 2f64.sqrt() / 2.0),
            ("1/3", 1.0 / 3.0),
            ("-1/sqrt(2)", -1.0 / 2f64.sqrt()),
            ("−√(2)/2", -(2f64.sqrt()) / 2.0),
            ("2*pi", std::f64::consts::TAU),
            ("(1+2)*3", 9.0),
            ("2^10", 1024.0),
            ("1e3+1", 1001.0),
            ("1e-3*2", 0.002),
            ("tan(0.5)", 0.5f64.tan()),
            (" 7 ", 7.0),
        ];
        for (text, value) in cases {
            assert_eq!(evaluate(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_told() {
        for text in [
            "", "abc", "1/", "sqrt(", "1,5", "x+1", "1/0", "0/0", "sqrt(-1)", "1e999", "nan", "inf",
        ] {
            assert!(evaluate(text).is_err(), "{text}: {:?}", evaluate(text));
        }
    }
}
