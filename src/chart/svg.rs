//! A figure as SVG, text as text.

use std::fmt::Write as _;

use super::figure::{Align, DASH, Figure, Shape};
use pinhole_exchange::images::svg::{SANS, chain, escaped, hex};

/// From the middle of a line of text down to its baseline, as a share of the font's size: half the
/// height of a digit.
const BASELINE: f64 = 0.36;

impl Figure {
    /// The whole file.
    pub fn to_svg(&self) -> String {
        let (width, height) = (self.width, self.height);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" fill=\"none\" \
             font-family=\"{SANS}\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        );
        for shape in &self.shapes {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "{}", element(shape));
        }
        out.push_str("</svg>\n");
        out
    }
}

fn element(shape: &Shape) -> String {
    match shape {
        Shape::Line { points, color, width, dashed } => {
            let dash = if *dashed {
                format!(" stroke-dasharray=\"{} {}\"", DASH[0], DASH[1])
            } else {
                String::new()
            };
            let (points, color) = (chain(points, 1), hex(*color));
            format!(
                "<polyline points=\"{points}\" stroke=\"{color}\" stroke-width=\"{width}\"{dash}/>"
            )
        }
        Shape::Polygon { points, fill, stroke } => {
            let fill = fill.map(|fill| format!(" fill=\"{}\"", hex(fill))).unwrap_or_default();
            let stroke = stroke
                .map(|(color, width)| {
                    format!(" stroke=\"{}\" stroke-width=\"{width}\"", hex(color))
                })
                .unwrap_or_default();
            format!("<polygon points=\"{}\"{fill}{stroke}/>", chain(points, 1))
        }
        Shape::Ring { center: [x, y], radius, color, width } => format!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" stroke=\"{}\" \
             stroke-width=\"{width}\"/>",
            hex(*color)
        ),
        Shape::Text { at: [x, y], align, text, size, bold, color } => {
            let anchor = match align {
                Align::Left => "start",
                Align::Middle => "middle",
                Align::Right => "end",
            };
            let weight = if *bold { " font-weight=\"bold\"" } else { "" };
            format!(
                "<text x=\"{x:.1}\" y=\"{:.1}\" font-size=\"{size}\" text-anchor=\"{anchor}\"\
                 {weight} fill=\"{}\">{}</text>",
                y + BASELINE * size,
                hex(*color),
                escaped(text)
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_is_an_element() {
        let mut figure = Figure { width: 30.0, height: 20.0, shapes: Vec::new() };
        figure.line(&[[0.0, 1.0], [2.5, 3.0]], [255, 0, 16], 2.0);
        figure.rectangle([1.0, 2.0], [3.0, 4.0], Some([0, 0, 0]), None);
        figure.text([5.0, 10.0], Align::Right, 10.0, [0, 0, 0], "ö".to_owned());
        figure.shapes.push(Shape::Ring {
            center: [4.0, 4.0],
            radius: 3.0,
            color: [1, 2, 3],
            width: 1.0,
        });
        let svg = figure.to_svg();
        for part in [
            "<polyline points=\"0.0,1.0 2.5,3.0\" stroke=\"#ff0010\" stroke-width=\"2\"/>",
            "<polygon points=\"1.0,2.0 3.0,2.0 3.0,4.0 1.0,4.0\" fill=\"#000000\"/>",
            "<text x=\"5.0\" y=\"13.6\" font-size=\"10\" text-anchor=\"end\" fill=\"#000000\">ö</text>",
            "<circle cx=\"4.0\" cy=\"4.0\" r=\"3\" stroke=\"#010203\" stroke-width=\"1\"/>",
        ] {
            assert!(svg.contains(part), "{part} is not in {svg}");
        }
    }
}
