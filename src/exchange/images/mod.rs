//! Reads and writes pictures as PNG, GIF and OpenEXR files, and colours as `#rrggbb`.

use pinhole_core::Rgb;

#[cfg(feature = "exr")]
pub mod exr;
pub mod gif;
pub mod png;

/// Parses `#rrggbb` or `#rgb`. Returns `None` for any other text.
pub fn parse_color(text: &str) -> Option<Rgb> {
    let digits = text.strip_prefix('#')?;
    if !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let number = u32::from_str_radix(digits, 16).ok()?;
    match digits.len() {
        6 => Some([(number >> 16) as u8, (number >> 8) as u8, number as u8]),
        3 => Some([8, 4, 0].map(|shift| 0x11 * (number >> shift & 0xf) as u8)),
        _ => None,
    }
}

/// Formats a colour as `#rrggbb`, in lowercase.
pub fn color_to_text([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_what_it_writes_and_the_short_form() {
        for color in [[0, 0, 0], [255, 255, 255], [0xe6, 0x9f, 0], [1, 2, 3]] {
            assert_eq!(parse_color(&color_to_text(color)), Some(color));
        }
        assert_eq!(parse_color("#E69F00"), Some([0xe6, 0x9f, 0]));
        assert_eq!(parse_color("#f08"), Some([0xff, 0, 0x88]));
    }

    #[test]
    fn refuses_everything_else() {
        for text in ["", "#", "e69f00", "#e69f0", "#e69f000", "#+69f00", "#gggggg", "red", "#é9f0"]
        {
            assert_eq!(parse_color(text), None, "{text}");
        }
    }
}
