//! A drawing as plain data: shapes and text on white. Drawn once, written as SVG and as PNG.

/// A colour, opaque sRGB.
pub(crate) type Ink = [u8; 3];

/// A place in points: x to the right, y down, from the left top corner.
pub(crate) type Place = [f64; 2];

/// What is drawn, from the back to the front.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Points.
    pub(crate) width: f64,
    /// Points.
    pub(crate) height: f64,
    pub(crate) shapes: Vec<Shape>,
}

/// One thing in a [`Figure`]; every length is in points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// A chain of straight lines.
    Line { points: Vec<Place>, color: Ink, width: f64, dashed: bool },
    /// A closed chain.
    Polygon { points: Vec<Place>, fill: Option<Ink>, stroke: Option<(Ink, f64)> },
    /// A circle's outline.
    Ring { center: Place, radius: f64, color: Ink, width: f64 },
    /// One line of text.
    Text { at: Place, align: Align, text: String, size: f64, bold: bool, color: Ink },
}

/// Which point of a text stands at its place; up and down it is the middle of a line always.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Middle,
    Right,
}

/// Dash and gap of a dashed line, in points.
pub(crate) const DASH: [f64; 2] = [7.0, 5.0];

impl Figure {
    /// Adds a straight line.
    pub(crate) fn line(&mut self, points: &[Place], color: Ink, width: f64) {
        self.shapes.push(Shape::Line { points: points.to_vec(), color, width, dashed: false });
    }

    /// Adds a rectangle, from its left top to its right bottom corner.
    pub(crate) fn rectangle(
        &mut self,
        [left, top]: Place,
        [right, bottom]: Place,
        fill: Option<Ink>,
        stroke: Option<(Ink, f64)>,
    ) {
        let points = vec![[left, top], [right, top], [right, bottom], [left, bottom]];
        self.shapes.push(Shape::Polygon { points, fill, stroke });
    }

    /// Adds plain text.
    pub(crate) fn text(&mut self, at: Place, align: Align, size: f64, color: Ink, text: String) {
        self.shapes.push(Shape::Text { at, align, text, size, bold: false, color });
    }

    /// Adds bold text.
    pub(crate) fn bold(&mut self, at: Place, align: Align, size: f64, color: Ink, text: String) {
        self.shapes.push(Shape::Text { at, align, text, size, bold: true, color });
    }
}
