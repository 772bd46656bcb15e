//! Formats numbers for display: with few significant digits, without rounding noise, with a typographic
//! minus sign (−). Counts from 10,000 on have their digits in groups; coordinates and numbers that may be
//! typed have not, because a comma separates coordinates. Numbers that are typed, copied or saved have an
//! ASCII minus (-).

use pinhole_core::shortest;

use crate::forms::NumberForm;

/// Formats a count for reading, from 10,000 on with its digits in groups of three: `9999`, `1,234,567`.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    if n < 10_000 {
        return digits;
    }
    let mut text = String::new();
    for (k, digit) in digits.char_indices() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Formats a number with this many significant digits, without trailing zeros, or with fewer digits if
/// they identify the number uniquely: 0.1 with 17 digits is `0.1`. The result is never `NaN` or `inf`.
pub fn significant(value: f64, digits: usize) -> String {
    // Different decimals of at most 15 digits are always different as `f64`.
    let fewer = (15..digits).map(|digits| rounded(value, digits));
    let mut telling = fewer.filter(|text| text.parse() == Ok(value));
    telling.next().unwrap_or_else(|| rounded(value, digits))
}

fn rounded(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return BEYOND.to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = digits.max(1);
    let value = untied(value, digits as i32);
    let scientific = format!("{:.*e}", digits - 1, value);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let power: i32 = exponent.parse().unwrap_or_default();
    if (-5..digits.max(7) as i32).contains(&power) {
        let decimals = (digits as i32 - 1 - power).max(0) as usize;
        return trimmed(&format!("{value:.decimals$}")).to_owned();
    }
    format!("{}e{exponent}", trimmed(mantissa))
}

/// Prepares a number for rounding to this many significant digits. If its shortest decimal is a tie, as
/// 0.21375 is with four digits, returns a number next to it that is farther from zero, so that the tie is
/// rounded as by hand: to 0.2138. The `f64` itself may lie on either side of the tie.
fn untied(value: f64, digits: i32) -> f64 {
    let shortest = format!("{value:e}");
    let (mantissa, exponent) = shortest.split_once('e').unwrap_or((&shortest, "0"));
    let count = mantissa.chars().filter(char::is_ascii_digit).count() as i32;
    let farther = mantissa.strip_suffix('5').filter(|_| count == digits + 1);
    let farther = farther.and_then(|rest| format!("{rest}6e{exponent}").parse().ok());
    farther.unwrap_or(value)
}

/// Formats a number with this many decimals; ties are rounded away from zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    let power = value.abs().log10().floor();
    let value = untied(value, (power + 1.0) as i32 + decimals as i32);
    format!("{value:.decimals$}")
}

/// Returns the text of a number without the zeros at the end of its decimals.
fn trimmed(text: &str) -> &str {
    let is_whole = !text.contains('.');
    if is_whole { text } else { text.trim_end_matches('0').trim_end_matches('.') }
}

/// Formats a number with this many [`significant`] digits and a typographic minus sign.
pub fn written(value: f64, digits: usize) -> String {
    significant(value, digits).replace('-', "−")
}

/// Formats a number as the right side of an equation: `= 0.5`, but `≈ 0.33333` if digits are left out.
pub fn equated(x: f64, digits: usize) -> String {
    format!("{} {}", Rounding::Significant(digits).relation(&[x]), written(x, digits))
}

/// Formats coordinates as the right side of an equation: `= (0.2, −0.1)`, `≈ (0.33333, 1)`.
pub fn equated_tuple(coordinates: &[f64], digits: usize) -> String {
    let relation = Rounding::Significant(digits).relation(coordinates);
    let texts: Vec<String> = coordinates.iter().map(|x| written(*x, digits)).collect();
    format!("{relation} ({})", texts.join(", "))
}

/// Formats a sum of products as it is written by hand: without terms whose factor is 0, and without a
/// factor of 1. For example, the factors 2, −1, 1 of ` x`, ` y` and an empty name give `2 x − y + 1`.
pub fn sum<'a>(
    terms: impl IntoIterator<Item = (f64, &'a str)>,
    number: impl Fn(f64) -> String,
) -> String {
    let mut text = String::new();
    for (factor, name) in terms.into_iter().filter(|(factor, _)| *factor != 0.0) {
        text.push_str(match (factor < 0.0, text.is_empty()) {
            (false, true) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (true, false) => " − ",
        });
        match number(factor.abs()) {
            one if one == "1" && !name.is_empty() => text.push_str(name.trim_start()),
            size => text.extend([&size, name]),
        }
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// The text for a number that is not finite.
const BEYOND: &str = "beyond f64";

/// Formats a number with all its digits, for display.
pub fn written_whole(x: f64) -> String {
    if x.is_finite() { shortest(x).replace('-', "−") } else { BEYOND.to_owned() }
}

/// Maximum number of decimals with which a number is displayed exactly, as in −0.00125.
const WHOLE: usize = 5;
/// Number of significant digits with which a calculated number is displayed without visible rounding
/// errors.
const TELLING: usize = 12;
/// Maximum number of significant digits of a decimal that is taken to be exact; a longer one is taken to be
/// rounded. About one in a thousand random numbers has so few digits by chance.
const EXACT_DIGITS: usize = 12;

/// How displayed numbers are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To this many significant digits.
    Significant(usize),
    /// To this many decimals. Small numbers get more, for two significant digits, and a number that has
    /// at most five decimals keeps them all.
    Decimals(usize),
}

impl Rounding {
    /// Formats the number, without trailing zeros.
    pub fn text(self, x: f64) -> String {
        match self {
            Rounding::Significant(digits) => significant(x, digits),
            Rounding::Decimals(decimals) => {
                let whole = significant(x, TELLING);
                let places = whole.split_once('.').map_or(0, |(_, places)| places.len());
                if x != 0.0 && places <= WHOLE && !whole.contains('e') {
                    return whole;
                }
                let before = x.abs().log10().floor() + 1.0;
                let digits = (before + decimals as f64).clamp(2.0, 17.0);
                significant(x, if x == 0.0 { 2 } else { digits as usize })
            }
        }
    }

    /// Returns true if the displayed decimal is the number's exact value, disregarding rounding errors in
    /// the number itself.
    pub fn is_exact(self, x: f64) -> bool {
        let digits = self.text(x);
        let shown = digits.parse();
        let recognised = || NumberForm::recognise(x).filter(|form| form.decimals().is_some());
        (shown == Ok(x) && significant_digits(&digits) <= EXACT_DIGITS)
            || recognised().is_some_and(|form| shown == Ok(form.value()))
    }

    /// Returns the sign to write before numbers: `=` if all of them are displayed exactly, otherwise `≈`.
    pub fn relation(self, shown: &[f64]) -> char {
        if shown.iter().all(|x| self.is_exact(*x)) { '=' } else { '≈' }
    }
}

/// Returns the number of significant digits in the text of a number.
fn significant_digits(text: &str) -> usize {
    let mantissa = text.split('e').next().unwrap_or_default();
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_matches('0').len()
}

/// Formats an amount with at most three significant digits, and a whole number up to 99,999 with all of
/// them: `0`, `0.5`, `12.3`, `1430`, `54,845`, `3.2e7`, `1e−6`. Coordinates, whose digits have no groups,
/// are formatted by [`written`].
pub fn short(x: f64) -> String {
    short_plain(x).replace('-', "−")
}

/// Formats a number as [`short`] does, but with an ASCII minus, for the command line and its files.
pub fn short_plain(x: f64) -> String {
    let magnitude = x.abs();
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return BEYOND.to_owned();
    }
    if !(1e-3..1e5).contains(&magnitude) {
        let text = format!("{:.1e}", untied(x, 2));
        return text.replace(".0e", "e");
    }
    if magnitude.round() >= 1e4 {
        let sign = if x < 0.0 { "-" } else { "" };
        return format!("{sign}{}", grouped(magnitude.round() as u64));
    }
    let digits_before = magnitude.log10().floor() as i32 + 1;
    let decimals = (3 - digits_before).clamp(0, 5) as usize;
    trimmed(&fixed(x, decimals)).to_owned()
}

/// Formats a power of ten, for example `10⁻⁶`. The powers 0 and 1 become `1` and `10`.
pub fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => {
            let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
            format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
        }
    }
}

/// The digits as superscripts.
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Formats the fraction `count / all` in per cent: `33 %`, `0.4 %`. A fraction other than 0 and 1 is
/// never written as 0 % or 100 %.
pub fn percent(count: usize, all: usize) -> String {
    let percent = 100.0 * count as f64 / all.max(1) as f64;
    match percent {
        _ if count == 0 => "0 %".to_owned(),
        _ if count == all => "100 %".to_owned(),
        few if few < 0.1 => "less than 0.1 %".to_owned(),
        few if few < 9.95 => format!("{} %", fixed(few, 1)),
        many if many > 99.0 => "more than 99 %".to_owned(),
        some => format!("{} %", fixed(some, 0)),
    }
}

/// Maximum integer in a fraction, or under a root, that is still easy to read.
const SHORT: u64 = 100;

/// Formats a number for use in a sentence: in its exact form, such as `√3/2`, if that is short,
/// otherwise in decimals.
pub(crate) fn exact_if_short(x: f64) -> String {
    let is_short = |form: &NumberForm| match form.decimals() {
        Some(decimals) => decimals <= 5,
        None => [form.numerator.unsigned_abs(), form.root, form.denominator]
            .into_iter()
            .all(|n| n <= SHORT),
    };
    match NumberForm::recognise(x).filter(is_short) {
        // A decimal number is not written as a fraction.
        Some(form) if form.decimals().is_some() => written_whole(form.value()),
        Some(form) => form.to_string(),
        None => written(x, 5),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn ties_are_rounded_away_from_zero() {
        for (x, digits, text) in [
            (-0.21375, 4, "-0.2138"),
            (0.11875, 4, "0.1188"),
            (0.11865, 4, "0.1187"),
            (0.118_649_999, 4, "0.1186"),
            (2.5, 1, "3"),
            (9.9995, 4, "10"),
            (1.000_000_5e9, 7, "1.000001e9"),
        ] {
            assert_eq!(significant(x, digits), text);
        }
        assert_eq!([short(0.125 + 1.0), short(999.5), short(1.25e-6)], ["1.13", "1000", "1.3e−6"]);
        assert_eq!([fixed(0.5, 0), fixed(-26.565, 2), fixed(0.0, 1)], ["1", "-26.57", "0.0"]);
        assert_eq!(percent(1, 8), "13 %");
    }

    #[test]
    fn a_rounded_number_is_not_equal() {
        for (x, text) in [
            (0.5, "= 0.5"),
            (0.1 + 0.2, "= 0.3"),
            (5.0 * 2f64.sqrt(), "≈ 7.0711"),
            (-0.21375, "= −0.21375"),
            (0.123_456, "≈ 0.12346"),
            (1.0 / 3.0, "≈ 0.33333"),
        ] {
            assert_eq!(equated(x, 5), text);
        }
        assert_eq!(equated(0.5_f64.sqrt(), 17), "≈ 0.7071067811865476");
        assert_eq!(equated_tuple(&[0.2, -1.0], 5), "= (0.2, −1)");
        assert_eq!(equated_tuple(&[0.2, 0.7_f64.sqrt()], 5), "≈ (0.2, 0.83666)");
    }

    #[test]
    fn a_sum_is_written_as_by_hand() {
        let sum = |a, b, c| sum([(a, " x"), (b, " y"), (c, "")], written_whole);
        assert_eq!(sum(1.0, 1.0, -2.0), "x + y − 2");
        assert_eq!(sum(-1.0, 0.0, 1.0), "−x + 1");
        assert_eq!(sum(2.0, -0.5, 0.0), "2 x − 0.5 y");
        assert_eq!(sum(0.0, 0.0, -1.0), "−1");
        assert_eq!(sum(0.0, -0.0, 0.0), "0");
    }

    #[test]
    fn groups_of_three() {
        for (n, text) in
            [(0, "0"), (999, "999"), (9999, "9999"), (10_000, "10,000"), (12_345_678, "12,345,678")]
        {
            assert_eq!(grouped(n), text);
        }
    }

    #[test]
    fn three_decimals() {
        let cases = [
            (0.0, "0"),
            (26.115_129, "26.115"),
            (-0.804_128_7, "-0.804"),
            (-0.804_13, "-0.80413"),
            (1e5 / 3.0, "33333.333"),
            (0.001_25, "0.00125"),
            (0.75 - 0.498_75, "0.25125"),
            (0.001_254_3, "0.0013"),
            (-0.000_726_55, "-0.00073"),
            (2.0, "2"),
            (9.999_961, "10"),
            (f64::INFINITY, "beyond f64"),
        ];
        for (x, text) in cases {
            assert_eq!(Rounding::Decimals(3).text(x), text, "{x:?}");
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
            (9999.6, "10,000"),
            (-54_845.5, "−54,846"),
            (32_145_678.0, "3.2e7"),
            (f64::INFINITY, "beyond f64"),
            (1e-6, "1e−6"),
            (-0.25, "−0.25"),
            (0.001_234_56, "0.00123"),
            (5e-324, "4.9e−324"),
            (f64::MAX, "1.8e308"),
        ];
        for (x, text) in cases {
            assert_eq!(short(x), text, "{x:?}");
        }
    }

    #[test]
    fn a_share_is_told_in_per_cent_and_never_as_none_or_all_of_what_is_neither() {
        let told = [(0, 9), (9, 9), (1, 90_000), (1, 3), (1, 25), (89_999, 90_000), (0, 0)];
        let told = told.map(|(count, all)| percent(count, all));
        let expected =
            ["0 %", "100 %", "less than 0.1 %", "33 %", "4.0 %", "more than 99 %", "0 %"];
        assert_eq!(told, expected);
    }

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
            assert_eq!(exact_if_short(x), text);
        }
    }
}
