//! Charts: lines, marks and text on white, in points. Drawn once, they become a [`Figure`] as everything
//! else does.

use egui::{Align, Align2, Color32, Context, FontFamily, FontId, pos2};

use super::figure::Figure;
use crate::view::headless::UiPass;
use crate::view::overlay::{Ink, Outline, Path};
use crate::view::typesetting::fonts;

/// A point of a chart: x to the right, y down, from the left top corner.
pub(crate) type Point = [f64; 2];

/// A chart that is being drawn, from the back to the front; text lies over all else. Every length is in
/// points.
#[derive(Debug, Default)]
pub(crate) struct Chart {
    pub(crate) width: f64,
    pub(crate) height: f64,
    paths: Vec<Path<'static>>,
    texts: Vec<(Point, Align, FontId, Color32, String)>,
}

/// Plain letters of a size.
pub(crate) fn plain(size: f64) -> FontId {
    FontId::new(size as f32, FontFamily::Proportional)
}

/// Bold letters of a size.
pub(crate) fn bold(size: f64) -> FontId {
    FontId::new(size as f32, fonts::bold())
}

/// Dash and gap of a dashed line.
const DASH: [f32; 2] = [7.0, 5.0];

impl Chart {
    /// Creates an empty chart.
    pub(crate) fn new(width: f64) -> Chart {
        Chart { width, ..Chart::default() }
    }

    /// Adds a chain of straight lines.
    pub(crate) fn line(&mut self, points: &[Point], color: Color32, width: f64) {
        self.stroke(chain(points, false), color, width, None);
    }

    /// Adds a dashed chain of straight lines.
    pub(crate) fn dashed(&mut self, points: &[Point], color: Color32, width: f64) {
        self.stroke(chain(points, false), color, width, Some(DASH));
    }

    /// Adds the outline of a polygon.
    pub(crate) fn outline(&mut self, corners: &[Point], color: Color32, width: f64) {
        self.stroke(chain(corners, true), color, width, None);
    }

    /// Adds a filled polygon.
    pub(crate) fn fill(&mut self, corners: &[Point], color: Color32) {
        self.paths.push(Path { outline: chain(corners, true), color, ink: Ink::Fill });
    }

    /// Adds the outline of a circle.
    pub(crate) fn ring(&mut self, [x, y]: Point, radius: f64, color: Color32, width: f64) {
        let outline = Outline::Circle { center: [x as f32, y as f32], radius: radius as f32 };
        self.stroke(outline, color, width, None);
    }

    fn stroke(
        &mut self,
        outline: Outline<'static>,
        color: Color32,
        width: f64,
        dash: Option<[f32; 2]>,
    ) {
        let ink = Ink::Stroke { width: width as f32, round: false, dash };
        self.paths.push(Path { outline, color, ink });
    }

    /// Adds a line of text, its middle at the height of the point.
    pub(crate) fn text(
        &mut self,
        at: Point,
        align: Align,
        font: FontId,
        color: Color32,
        text: impl Into<String>,
    ) {
        self.texts.push((at, align, font, color, text.into()));
    }

    /// The chart as a figure with so many dots to a point.
    pub(crate) fn into_figure(self, title: &str, scale: f32) -> Figure {
        let size = [self.width, self.height]
            .map(|points| (points * f64::from(scale)).ceil().max(1.0) as usize);
        let ctx = Context::default();
        fonts::install(&ctx);
        let drawn = UiPass::draw(&ctx, size, scale, |ui| {
            for ([x, y], align, font, color, text) in &self.texts {
                let (at, anchor) = (pos2(*x as f32, *y as f32), Align2([*align, Align::Center]));
                ui.painter().text(at, anchor, text, font.clone(), *color);
            }
        });
        Figure {
            title: title.to_owned(),
            size,
            ground: Some(Color32::WHITE),
            picture: None,
            paths: self.paths.into_iter().map(|path| path.scaled(scale)).collect(),
            drawn,
        }
    }
}

fn chain(points: &[Point], closed: bool) -> Outline<'static> {
    let points: Vec<[f32; 2]> = points.iter().map(|point| point.map(|x| x as f32)).collect();
    Outline::Chain { points: points.into(), closed }
}

#[cfg(all(test, feature = "figures"))]
mod tests {
    use super::super::figure::Format;
    use super::*;

    #[test]
    fn every_shape_is_an_element() {
        let mut chart = Chart { height: 20.0, ..Chart::new(30.0) };
        chart.line(&[[0.0, 1.0], [2.5, 3.0]], Color32::from_rgb(255, 0, 16), 2.0);
        chart.dashed(&[[0.0, 1.0], [2.5, 3.0]], Color32::BLACK, 1.0);
        chart.fill(&[[1.0, 2.0], [3.0, 2.0], [3.0, 4.0]], Color32::BLACK);
        chart.outline(&[[1.0, 2.0], [3.0, 2.0], [3.0, 4.0]], Color32::BLACK, 1.5);
        chart.ring([4.0, 4.0], 3.0, Color32::from_rgb(1, 2, 3), 1.0);
        chart.text([15.0, 10.0], Align::RIGHT, bold(10.0), Color32::BLACK, "ö");
        let svg = chart.into_figure("A chart", 2.0).to_file(Format::Svg).expect("a file");
        let svg = String::from_utf8(svg).expect("text");
        for part in [
            "width=\"60\" height=\"40\"",
            "<title>A chart</title>",
            "<polyline points=\"0.00,2.00 5.00,6.00\" stroke=\"#ff0010\" stroke-width=\"4\"/>",
            " stroke=\"#000000\" stroke-width=\"2\" stroke-dasharray=\"14 10\"/>",
            "<polygon points=\"2.00,4.00 6.00,4.00 6.00,8.00\" fill=\"#000000\"/>",
            "<polygon points=\"2.00,4.00 6.00,4.00 6.00,8.00\" stroke=\"#000000\" stroke-width=\"3\"/>",
            "<circle cx=\"8\" cy=\"8\" r=\"6\" stroke=\"#010203\" stroke-width=\"2\"/>",
            " font-size=\"20\" font-weight=\"bold\">ö</tspan></text>",
        ] {
            assert!(svg.contains(part), "{part} is not in {svg}");
        }
    }
}
