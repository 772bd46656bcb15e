//! Writes a figure as SVG, with embedded fonts that contain only the letters that occur. Strokes and
//! text are not converted to outlines.

use std::collections::{BTreeMap, BTreeSet};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use egui::{Color32, ColorImage};
use pinhole_core::Ellipse;
use pinhole_exchange::{images, is_hidden};

use super::{CasedText, FontName, LetterRun, Primitive, SANS, primitives};
use crate::export::{Figure, SphereEdges, to_png};
use crate::overlay::{Ink, Path, PathOutline};

/// Writes the whole file.
pub(in crate::export) fn write(figure: &Figure) -> Result<String, String> {
    let ([width, height], title) = (figure.size, escaped(&figure.title));
    let primitives = primitives(figure);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" fill=\"none\" \
         stroke-linejoin=\"round\" font-family=\"{SANS}\">\n<title>{title}</title>\n{}",
        style(&primitives)?
    );
    if let Some(ground) = figure.ground {
        let fill = paint("fill", ground);
        out += &format!("<rect width=\"{width}\" height=\"{height}\"{fill}/>\n");
    }
    if let Some(picture) = &figure.picture {
        out += &image(picture, figure.size, "")?;
    }
    if let SphereEdges { outlines, picture: Some(picture) } = &figure.spheres {
        let outlines: String = outlines.iter().map(ellipse).collect();
        out += &format!("<clipPath id=\"spheres\">{outlines}</clipPath>\n");
        out += &image(picture, figure.size, " clip-path=\"url(#spheres)\"")?;
    }
    for (k, primitive) in primitives.iter().enumerate() {
        out += &match primitive {
            Primitive::Path(path) => element(path),
            Primitive::Text(text) => written(text, k),
        };
    }
    Ok(out + "</svg>\n")
}

/// Writes the style sheet, in which each font that is used is embedded with the letters that occur.
fn style(primitives: &[Primitive]) -> Result<String, String> {
    let mut letters: BTreeMap<FontName, BTreeSet<char>> = BTreeMap::new();
    for primitive in primitives {
        let Primitive::Text(text) = primitive else { continue };
        for run in &text.runs {
            letters.entry(run.face).or_default().extend(run.text.chars());
        }
    }
    let rule = |(face, letters): (FontName, BTreeSet<char>)| {
        let font = STANDARD.encode(face.subset(&letters)?);
        let (family, weight) = (face.family(), if face.is_bold() { "bold" } else { "normal" });
        Ok(format!(
            "@font-face{{font-family:\"{family}\";font-weight:{weight};\
             src:url(data:font/ttf;base64,{font}) format(\"truetype\")}}\n"
        ))
    };
    let rules = letters.into_iter().map(rule).collect::<Result<String, String>>()?;
    Ok(if rules.is_empty() { rules } else { format!("<style>\n{rules}</style>\n") })
}

/// Writes an `image` element with the picture as PNG, and the request to display its pixels without
/// smoothing. `clip` is an attribute that clips it.
fn image(picture: &ColorImage, [width, height]: [usize; 2], clip: &str) -> Result<String, String> {
    let transparent = picture.pixels.iter().any(|pixel| pixel.a() < 255);
    let bytes = STANDARD.encode(to_png(picture.size, &picture.pixels, transparent)?);
    Ok(format!(
        "<image{clip} width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
         image-rendering=\"optimizeSpeed\" style=\"image-rendering:pixelated\" \
         xlink:href=\"data:image/png;base64,{bytes}\"/>\n"
    ))
}

fn ellipse(Ellipse { center, axes: [a, b] }: &Ellipse) -> String {
    let [x, y, rx, ry] = [center.x, center.y, a.length(), b.length()].map(|x| short(x as f32));
    let angle = a.y.atan2(a.x).to_degrees();
    format!(
        "<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{rx}\" ry=\"{ry}\" transform=\"rotate({angle:.3} {x} {y})\"/>"
    )
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
        PathOutline::Chain { points, closed } => {
            let name = if *closed { "polygon" } else { "polyline" };
            let points: Vec<String> =
                points.iter().map(|[x, y]| format!("{x:.2},{y:.2}")).collect();
            format!("<{name} points=\"{}\"{ink}/>\n", points.join(" "))
        }
        PathOutline::Circle { center: [x, y], radius } => {
            let (x, y, radius) = (short(*x), short(*y), short(*radius));
            format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"{ink}/>\n")
        }
    }
}

/// Writes a text. Its casing (the halo around its letters), if any, is written first, as a stroked
/// `use` of the same text, since not every program can stroke a text before it fills it.
fn written(text: &CasedText, number: usize) -> String {
    let color = text.runs.first().map_or(Color32::BLACK, |run| run.color);
    let run_fill =
        |run: &LetterRun| if run.color == color { String::new() } else { paint("fill", run.color) };
    let spans: String = text.runs.iter().map(|run| span(run, &run_fill(run))).collect();
    let fill = paint("fill", color);
    match text.halo {
        None => format!("<text xml:space=\"preserve\"{fill}>{spans}</text>\n"),
        Some((halo, reach)) => {
            let (fill_halo, stroke) = (paint("fill", halo), paint("stroke", halo));
            let width = short(2.0 * reach);
            format!(
                "<use xlink:href=\"#text{number}\"{fill_halo}{stroke} stroke-width=\"{width}\"/>\n\
                 <g{fill}><text id=\"text{number}\" xml:space=\"preserve\">{spans}</text></g>\n"
            )
        }
    }
}

fn span(run: &LetterRun, fill: &str) -> String {
    let weight = if run.face.is_bold() { " font-weight=\"bold\"" } else { "" };
    let slant = if run.slant == 0.0 { "" } else { " font-style=\"oblique\"" };
    let families = run.face.families();
    let families =
        if families == SANS { String::new() } else { format!(" font-family=\"{families}\"") };
    let ([x, y], size) = (run.at.map(short), short(run.size));
    let text = escaped(&run.text);
    format!(
        "<tspan x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{families}{weight}{slant}{fill}>{text}</tspan>"
    )
}

/// Formats a colour as the attribute `name` (`fill` or `stroke`), followed by an attribute for its
/// opacity if it is not opaque.
fn paint(name: &str, color: Color32) -> String {
    let [r, g, b, a] = color.to_srgba_unmultiplied();
    let opacity = match a {
        255 => String::new(),
        a => format!(" {name}-opacity=\"{}\"", short(f32::from(a) / 255.0)),
    };
    format!(" {name}=\"{}\"{opacity}", images::color_to_text([r, g, b]))
}

/// Rounds a number to three decimals.
fn short(x: f32) -> f64 {
    (f64::from(x) * 1000.0).round() / 1000.0 + 0.0
}

/// Escapes text for XML. Omits hidden characters, such as control characters, most of which XML
/// forbids.
fn escaped(text: &str) -> String {
    let shown: String = text.chars().filter(|c| !is_hidden(*c)).collect();
    let shown = shown.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    shown.replace('"', "&quot;")
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
