//! A figure as SVG: strokes as strokes, text as text, with the letters that it needs as fonts in it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use egui::Color32;
use pinhole_exchange::images::png;
use pinhole_exchange::is_hidden;

use super::primitive::{Page, Picture, Primitive, Run, Text};
use super::subset::subset;
use super::typeface::{Face, SANS};
use crate::view::overlay::{Ink, Outline, Path};

/// The whole file.
pub(in crate::figures) fn write(page: &Page) -> Result<String, String> {
    let ([width, height], title) = (page.size, escaped(page.title));
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" fill=\"none\" \
         stroke-linejoin=\"round\" font-family=\"{SANS}\">\n<title>{title}</title>\n"
    );
    out.push_str(&style(&page.primitives)?);
    if let Some(ground) = page.ground {
        // Writing to a string cannot fail.
        let _ =
            writeln!(out, "<rect width=\"{width}\" height=\"{height}\"{}/>", paint("fill", ground));
    }
    for (k, primitive) in page.primitives.iter().enumerate() {
        match primitive {
            Primitive::Picture(picture) => out.push_str(&image(picture, page.size)?),
            Primitive::Path(path) => out.push_str(&element(path)),
            Primitive::Text(text) => out.push_str(&written(text, k)),
        }
        out.push('\n');
    }
    out.push_str("</svg>\n");
    Ok(out)
}

/// The fonts, each with the letters that are there.
fn style(primitives: &[Primitive]) -> Result<String, String> {
    let mut letters: BTreeMap<Face, BTreeSet<char>> = BTreeMap::new();
    let texts = primitives.iter().filter_map(|primitive| match primitive {
        Primitive::Text(text) => Some(&text.runs),
        _ => None,
    });
    for run in texts.flatten() {
        letters.entry(run.face).or_default().extend(run.text.chars());
    }
    if letters.is_empty() {
        return Ok(String::new());
    }
    let mut out = "<style>\n".to_owned();
    for (face, letters) in letters {
        let font = STANDARD.encode(subset(face, &letters)?);
        let (family, weight) = (face.family(), if face.is_bold() { "bold" } else { "normal" });
        let _ = writeln!(
            out,
            "@font-face{{font-family:\"{family}\";font-weight:{weight};\
             src:url(data:font/ttf;base64,{font}) format(\"truetype\")}}"
        );
    }
    out.push_str("</style>\n");
    Ok(out)
}

/// The picture's own pixels, which nobody is to smooth.
fn image(picture: &Picture, [width, height]: [usize; 2]) -> Result<String, String> {
    let pixels: Vec<[u8; 4]> = picture.pixels.iter().map(Color32::to_srgba_unmultiplied).collect();
    let [columns, rows] = picture.size.map(|n| n as u32);
    let mut bytes = Vec::new();
    let is_opaque = pixels.iter().all(|pixel| pixel[3] == 255);
    let encode = if is_opaque { png::encode } else { png::encode_transparent };
    encode(&mut bytes, columns, rows, &pixels).map_err(|error| error.to_string())?;
    let bytes = STANDARD.encode(bytes);
    Ok(format!(
        "<image width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
         image-rendering=\"optimizeSpeed\" style=\"image-rendering:pixelated\" \
         xlink:href=\"data:image/png;base64,{bytes}\"/>"
    ))
}

fn element(Path { outline, color, ink }: &Path) -> String {
    let ink = match ink {
        Ink::Fill => paint("fill", *color),
        Ink::Stroke { width, round, dash } => {
            let cap = if *round { " stroke-linecap=\"round\"" } else { "" };
            let dash = dash.map_or(String::new(), |[dash, gap]| {
                format!(" stroke-dasharray=\"{} {}\"", short(dash), short(gap))
            });
            format!("{} stroke-width=\"{}\"{cap}{dash}", paint("stroke", *color), short(*width))
        }
    };
    match outline {
        Outline::Chain { points, closed } => {
            let name = if *closed { "polygon" } else { "polyline" };
            format!("<{name} points=\"{}\"{ink}/>", chain(points))
        }
        Outline::Circle { center: [x, y], radius } => {
            let (x, y, radius) = (short(*x), short(*y), short(*radius));
            format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"{ink}/>")
        }
    }
}

/// Text once, and before it, where it has a casing, the same strokes of it in the casing's colour: not
/// every program knows how to stroke text before it fills it.
fn written(text: &Text, number: usize) -> String {
    let color = text.runs.first().map_or(Color32::BLACK, |run| run.color);
    let own = |run: &Run| if run.color == color { String::new() } else { paint("fill", run.color) };
    let spans: String = text.runs.iter().map(|run| span(run, &own(run))).collect();
    let fill = paint("fill", color);
    match text.halo {
        None => format!("<text xml:space=\"preserve\"{fill}>{spans}</text>"),
        Some((halo, reach)) => {
            let (fill_halo, stroke) = (paint("fill", halo), paint("stroke", halo));
            let width = short(2.0 * reach);
            format!(
                "<use xlink:href=\"#text{number}\"{fill_halo}{stroke} stroke-width=\"{width}\"/>\n\
                 <g{fill}><text id=\"text{number}\" xml:space=\"preserve\">{spans}</text></g>"
            )
        }
    }
}

fn span(run: &Run, fill: &str) -> String {
    let Run { face, size, at: [x, y], slant, .. } = run;
    let weight = if face.is_bold() { " font-weight=\"bold\"" } else { "" };
    let slant = if *slant == 0.0 { "" } else { " font-style=\"oblique\"" };
    let families = face.families();
    let families =
        if families == SANS { String::new() } else { format!(" font-family=\"{families}\"") };
    format!(
        "<tspan x=\"{}\" y=\"{}\" font-size=\"{}\"{families}{weight}{slant}{fill}>{}</tspan>",
        short(*x),
        short(*y),
        short(*size),
        escaped(&run.text)
    )
}

/// A colour as an attribute.
fn paint(name: &str, color: Color32) -> String {
    let [r, g, b, a] = color.to_srgba_unmultiplied();
    let opacity = match a {
        255 => String::new(),
        a => format!(" {name}-opacity=\"{}\"", short(f32::from(a) / 255.0)),
    };
    format!(" {name}=\"{}\"{opacity}", hex([r, g, b]))
}

/// A number with three decimals at most.
fn short(x: f32) -> f64 {
    (f64::from(x) * 1000.0).round() / 1000.0 + 0.0
}

/// An opaque colour.
fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Points with two decimals.
fn chain(points: &[[f32; 2]]) -> String {
    let mut out = String::new();
    for [x, y] in points {
        let before = if out.is_empty() { "" } else { " " };
        // Writing to a string cannot fail.
        let _ = write!(out, "{before}{x:.2},{y:.2}");
    }
    out
}

/// Text that XML may hold: what marks it up is spelled out, and what is hidden, which it may mostly not
/// hold at all, is left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if is_hidden(c) => {}
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped() {
        assert_eq!(
            escaped("a < b & c > \"d\"\u{0}\n\u{202e}\u{fffe}"),
            "a &lt; b &amp; c &gt; &quot;d&quot;"
        );
    }
}
