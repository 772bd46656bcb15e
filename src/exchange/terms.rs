//! How a format's conventions differ from those here.

use pinhole_core::{DVec3, Pixel};

use super::sheet::n;
use super::{Format, Subject};
use crate::letters::{bold, italic};

/// What an axis of a format's camera points along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "u, v, w of the camera, and their opposites")]
pub enum Axis {
    U,
    V,
    W,
    MinusU,
    MinusV,
    MinusW,
}

/// How a format counts pixels, and where it has their centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// x right, y down from the image's corner: centres at halves. As here.
    Corner,
    /// The same with centres at whole numbers.
    AtCentre,
    /// y up from the lower left corner, centres at halves.
    FromBottom,
    /// Rows and columns from 1.
    FromOne,
    /// As here, but the column comes first.
    ColumnFirst,
    /// From -1 to 1 across the image, y up.
    Device,
}

/// A format's conventions.
#[derive(Debug)]
pub struct Terms {
    /// What its camera's x, y and z point along.
    pub axes: [Axis; 3],
    /// What the camera is given by.
    pub given_by: &'static str,
    /// Where its pixels are.
    pub pixels: Pixels,
    /// How the field of view is given.
    pub view: &'static str,
    /// Its number for a camera.
    pub(super) field: fn(&Subject) -> String,
    /// What becomes of the viewport's distance.
    pub distance: &'static str,
    /// Which pixels it can have.
    pub shape: &'static str,
    /// What it reckons in.
    pub lengths: &'static str,
}

/// A line of the table: one thing, here and there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// What it is about.
    pub about: &'static str,
    /// How it is here.
    pub ours: String,
    /// How it is there.
    pub theirs: String,
    /// Whether a sign is turned.
    pub flipped: bool,
    /// Whether it is otherwise than here.
    pub differs: bool,
}

impl Axis {
    /// The letter with its sign.
    pub fn letter(self) -> String {
        let (sign, letter) = match self {
            Axis::U => ("", 'u'),
            Axis::V => ("", 'v'),
            Axis::W => ("", 'w'),
            Axis::MinusU => ("−", 'u'),
            Axis::MinusV => ("−", 'v'),
            Axis::MinusW => ("−", 'w'),
        };
        format!("{sign}{}", bold(letter))
    }

    /// Whether it is the opposite of u, v or w.
    pub fn is_flipped(self) -> bool {
        matches!(self, Axis::MinusU | Axis::MinusV | Axis::MinusW)
    }

    /// The vector, in coordinates (u, v, w).
    fn of_basis(self) -> DVec3 {
        match self {
            Axis::U => DVec3::X,
            Axis::V => DVec3::Y,
            Axis::W => DVec3::Z,
            Axis::MinusU => DVec3::NEG_X,
            Axis::MinusV => DVec3::NEG_Y,
            Axis::MinusW => DVec3::NEG_Z,
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Axis::U => "right",
            Axis::V => "up",
            Axis::W => "backwards",
            Axis::MinusU => "left",
            Axis::MinusV => "down",
            Axis::MinusW => "forwards",
        }
    }
}

impl Terms {
    pub(super) const OURS: [Axis; 3] = [Axis::U, Axis::V, Axis::W];

    /// Whether its camera's axes are right-handed.
    pub fn is_right_handed(&self) -> bool {
        let [x, y, z] = self.axes.map(Axis::of_basis);
        x.cross(y).dot(z) > 0.0
    }
}

impl Pixels {
    /// The rule, and which pixel (0, 0) is.
    fn rule(self) -> String {
        let (i, j) = (italic('i'), italic('j'));
        match self {
            Pixels::Corner => format!("x = {j} + ½, y = {i} + ½: from the upper left corner"),
            Pixels::AtCentre => format!("x = {j}, y = {i}: from the centre of the first pixel"),
            Pixels::FromBottom => {
                format!("x = {j} + ½, y = H − {i} − ½: from the lower left corner, up")
            }
            Pixels::FromOne => format!("{i} + 1, {j} + 1: counted from 1"),
            Pixels::ColumnFirst => format!("get_ray({j}, {i}): the column first"),
            Pixels::Device => {
                format!("x = (2{j} + 1) / W − 1, y = 1 − (2{i} + 1) / H: −1 to 1, up")
            }
        }
    }

    /// What it calls the centre of a pixel of an image of W x H.
    fn of(self, Pixel { row, column }: Pixel, [width, height]: [u32; 2]) -> String {
        let (i, j) = (f64::from(row), f64::from(column));
        let (w, h) = (f64::from(width), f64::from(height));
        let pair = |a: f64, b: f64| format!("({}, {})", n(a), n(b));
        match self {
            Pixels::Corner => pair(j + 0.5, i + 0.5),
            Pixels::AtCentre => pair(j, i),
            Pixels::FromBottom => pair(j + 0.5, h - i - 0.5),
            Pixels::FromOne => pair(i + 1.0, j + 1.0),
            Pixels::ColumnFirst => pair(j, i),
            Pixels::Device => {
                let short = |x: f64| (x * 1e4).round() / 1e4;
                pair(short((2.0 * j + 1.0 - w) / w), short((h - 2.0 * i - 1.0) / h))
            }
        }
    }

    fn flips(self) -> bool {
        matches!(self, Pixels::FromBottom | Pixels::Device)
    }
}

/// What the line on the field of view is about.
pub(crate) const FIELD_OF_VIEW: &str = "field of view";

/// The table for a camera: the format's terms beside those here. The pixel is what the numbers of the
/// line on pixels are about; numbers have that many significant digits.
pub fn rows(format: &Format, subject: &Subject, pixel: Pixel, digits: usize) -> Vec<Row> {
    let terms = &format.terms;
    let size = subject.size();
    let mut table = axes(terms, subject, digits);
    let hand = |right| if right { "right-handed" } else { "left-handed" };
    let mut line = |about, ours: String, theirs: String, flipped, differs| {
        table.push(Row { about, ours, theirs, flipped, differs });
    };
    let right_handed = terms.is_right_handed();
    line(
        "its axes are",
        hand(true).into(),
        hand(right_handed).into(),
        !right_handed,
        !right_handed,
    );
    let looks = |axis: Axis| match axis {
        Axis::MinusW => "along +z",
        _ => "along −z",
    };
    let forward = terms.axes[2] == Axis::MinusW;
    line("it looks", looks(Axis::W).into(), looks(terms.axes[2]).into(), forward, forward);
    let at_or = match subject.camera().orientation {
        pinhole_core::Orientation::At { .. } => "eye, at, up",
        pinhole_core::Orientation::View { .. } => "eye, view, up",
        pinhole_core::Orientation::Basis(_) => "eye and u, v, w",
    };
    line("given by", at_or.into(), terms.given_by.into(), false, true);
    let pixels = terms.pixels;
    let centre = |rule: Pixels| rule.rule();
    line(
        "centre of a pixel",
        centre(Pixels::Corner),
        centre(pixels),
        pixels.flips(),
        pixels != Pixels::Corner,
    );
    let spoken = format!("({}, {})", pixel.row, pixel.column);
    line(
        "in numbers",
        format!("row, column {spoken}, centre {}", Pixels::Corner.of(pixel, size)),
        pixels.of(pixel, size),
        pixels.flips(),
        pixels != Pixels::Corner,
    );
    let viewport = subject.viewport();
    line(
        FIELD_OF_VIEW,
        format!(
            "width {} × height {} at distance {}",
            n(viewport.width),
            n(viewport.height),
            n(viewport.distance)
        ),
        format!("{}: {}", terms.view, (terms.field)(subject)),
        false,
        true,
    );
    line("distance", "t = 1 is the viewport".into(), terms.distance.into(), false, true);
    line("pixels' shape", "any".into(), terms.shape.into(), false, !terms.shape.starts_with("any"));
    line("reckons in", "f64, exact where it matters".into(), terms.lengths.into(), false, false);
    table
}

/// The lines on the camera's axes, with their vectors.
fn axes(terms: &Terms, subject: &Subject, digits: usize) -> Vec<Row> {
    let basis = subject.resolve().basis();
    let text = |axis: Axis| {
        let v = basis.to_world_from_camera(axis.of_basis());
        // 0 has no sign to read.
        let [x, y, z] = (v + DVec3::ZERO).to_array().map(|x| crate::number::written(x, digits));
        format!("{} {} = ({x}, {y}, {z})", axis.meaning(), axis.letter())
    };
    let names = ["x of the camera", "y of the camera", "z of the camera"];
    let pairs = names.into_iter().zip(Terms::OURS.into_iter().zip(terms.axes));
    pairs
        .map(|(about, (ours, theirs))| Row {
            about,
            ours: text(ours),
            theirs: text(theirs),
            flipped: theirs.is_flipped(),
            differs: ours != theirs,
        })
        .collect()
}
