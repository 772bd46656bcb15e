//! QR codes: black on white with the quiet zone around them, as SVG, PNG, pixels, or text for a terminal.

use egui::{Color32, ColorImage};
use qrcodegen::{QrCode as Encoded, QrCodeEcc};

use crate::export::to_png;

/// The width of the quiet zone, in modules, as the standard (ISO/IEC 18004) asks for.
const QUIET: i32 = 4;

/// The size that a PNG has at least, in pixels.
const PNG: usize = 1024;

/// A QR code.
#[derive(Clone, Debug)]
pub struct QrCode {
    /// The number of modules from side to side, with the quiet zone.
    side: usize,
    /// For each module, row by row from the top, true if it is black.
    black: Vec<bool>,
}

impl QrCode {
    /// Encodes a text in the smallest code that holds it, with as much correction as that code has room for.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the text is too long.
    pub fn of(text: &str) -> Result<QrCode, String> {
        let code = Encoded::encode_text(text, QrCodeEcc::Low).map_err(|_| {
            // At the lowest level of correction, L.
            format!(
                "The link has {} bytes, and a QR code holds 2953: copy the link, or save a page",
                text.len()
            )
        })?;
        let side = code.size() + 2 * QUIET;
        let black = |k: i32| code.get_module(k % side - QUIET, k / side - QUIET);
        Ok(QrCode { side: side as usize, black: (0..side * side).map(black).collect() })
    }

    /// Returns the picture with `scale` pixels a module.
    pub fn image(&self, scale: usize) -> ColorImage {
        let side = self.side * scale;
        let color = |k: usize| {
            let module = (k / side / scale) * self.side + k % side / scale;
            if self.black[module] { Color32::BLACK } else { Color32::WHITE }
        };
        ColorImage::new([side; 2], (0..side * side).map(color).collect())
    }

    /// Encodes the picture as PNG.
    ///
    /// # Errors
    /// Returns an error if it cannot be encoded.
    pub fn to_png(&self) -> Result<Vec<u8>, String> {
        let image = self.image(PNG.div_ceil(self.side));
        to_png(image.size, &image.pixels, false)
    }

    /// Returns the code as SVG, in which a module is a unit.
    pub fn to_svg(&self) -> String {
        let mut path = String::new();
        for (y, row) in self.black.chunks(self.side).enumerate() {
            let mut x = 0;
            for run in row.chunk_by(|a, b| a == b) {
                if run[0] {
                    let width = run.len();
                    path.push_str(&format!("M{x} {y}h{width}v1h-{width}z"));
                }
                x += run.len();
            }
        }
        let side = self.side;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {side} {side}\" \
             shape-rendering=\"crispEdges\">\n<rect width=\"{side}\" height=\"{side}\" \
             fill=\"#fff\"/>\n<path d=\"{path}\"/>\n</svg>\n"
        )
    }

    /// Returns the code as text in black on white, with two modules above each other in a character.
    pub fn to_terminal(&self) -> String {
        let rows: Vec<&[bool]> = self.black.chunks(self.side).collect();
        let line = |pair: &[&[bool]]| {
            let below = |x: usize| pair.get(1).is_some_and(|row| row[x]);
            let half = |x: usize| usize::from(pair[0][x]) + 2 * usize::from(below(x));
            let blocks = (0..self.side).map(|x| [' ', '▀', '▄', '█'][half(x)]);
            format!("\x1b[30;107m{}\x1b[0m\n", blocks.collect::<String>())
        };
        rows.chunks(2).map(line).collect()
    }
}
