//! The table of conventions: a camera as it is given here and in another program.

use pinhole_core::{DVec3, Pixel};
use pinhole_exchange::format::{Axis, Conventions, ExportScene, Format, PixelConvention};

use crate::model::letters::{bold, italic};
use crate::model::number::written_whole;

/// A row of the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Name of the convention.
    pub about: &'static str,
    /// Its form here.
    pub ours: String,
    /// Its form there.
    pub theirs: String,
    /// True where a sign is turned.
    pub flipped: bool,
    /// True where it differs from here.
    pub differs: bool,
}

/// Returns an axis as a bold letter with its sign.
fn letter(axis: Axis) -> String {
    axis.name.chars().map(bold).collect()
}

/// Returns the rule by which pixels are counted, and the centre of a pixel of an image of W x H in
/// numbers.
fn counted(
    pixels: PixelConvention,
    Pixel { row, column }: Pixel,
    [width, height]: [u32; 2],
) -> [String; 2] {
    let (i, j) = (italic('i'), italic('j'));
    let (y, x) = (f64::from(row), f64::from(column));
    let (w, h) = (f64::from(width), f64::from(height));
    let pair = |a: f64, b: f64| format!("({}, {})", written_whole(a), written_whole(b));
    match pixels {
        PixelConvention::Corner => [
            format!("x = {j} + ½, y = {i} + ½: from the upper left corner"),
            pair(x + 0.5, y + 0.5),
        ],
        PixelConvention::AtCentre => {
            [format!("x = {j}, y = {i}: from the centre of the first pixel"), pair(x, y)]
        }
        PixelConvention::FromBottom => [
            format!("x = {j} + ½, y = H − {i} − ½: from the lower left corner, up"),
            pair(x + 0.5, h - y - 0.5),
        ],
        PixelConvention::FromOne => {
            [format!("{i} + 1, {j} + 1: counted from 1"), pair(y + 1.0, x + 1.0)]
        }
        PixelConvention::ColumnFirst => {
            [format!("get_ray({j}, {i}): the column first"), pair(x, y)]
        }
        PixelConvention::Device => {
            let short = |x: f64| (x * 1e4).round() / 1e4;
            [
                format!("x = (2{j} + 1) / W − 1, y = 1 − (2{i} + 1) / H: −1 to 1, up"),
                pair(short((2.0 * x + 1.0 - w) / w), short((h - 2.0 * y - 1.0) / h)),
            ]
        }
    }
}

fn flips(pixels: PixelConvention) -> bool {
    matches!(pixels, PixelConvention::FromBottom | PixelConvention::Device)
}

/// Name of the row on the field of view.
pub(crate) const FIELD_OF_VIEW: &str = "field of view";

/// Returns the table for a camera: the format's conventions beside those here. The row on pixels has the
/// numbers of `pixel`; `digits` is the number of significant digits.
pub fn rows(format: &Format, subject: &ExportScene, pixel: Pixel, digits: usize) -> Vec<Row> {
    let conventions = &format.conventions;
    let image = subject.resolve().image();
    let size = [image.width(), image.height()];
    let mut table = axes(conventions, subject, digits);
    let hand = |right| if right { "right-handed" } else { "left-handed" };
    let mut line = |about, ours: String, theirs: String, flipped, differs| {
        table.push(Row { about, ours, theirs, flipped, differs });
    };
    let right_handed = conventions.is_right_handed();
    line(
        "its axes are",
        hand(true).into(),
        hand(right_handed).into(),
        !right_handed,
        !right_handed,
    );
    let looks = |axis: Axis| if axis == Axis::MINUS_W { "along +z" } else { "along −z" };
    let forward = conventions.axes[2] == Axis::MINUS_W;
    line("it looks", looks(Axis::W).into(), looks(conventions.axes[2]).into(), forward, forward);
    let at_or = match subject.document.camera.orientation {
        pinhole_core::Orientation::At { .. } => "eye, at, up",
        pinhole_core::Orientation::View { .. } => "eye, view, up",
        pinhole_core::Orientation::Basis(_) => "eye and u, v, w",
    };
    line("given by", at_or.into(), conventions.given_by.into(), false, true);
    let pixels = conventions.pixels;
    let [our_rule, our_centre] = counted(PixelConvention::Corner, pixel, size);
    let [their_rule, their_centre] = counted(pixels, pixel, size);
    let (flipped, differs) = (flips(pixels), pixels != PixelConvention::Corner);
    line("centre of a pixel", our_rule, their_rule, flipped, differs);
    let ours = format!("row, column ({}, {}), centre {our_centre}", pixel.row, pixel.column);
    line("in numbers", ours, their_centre, flipped, differs);
    let viewport = subject.resolve().viewport();
    line(
        FIELD_OF_VIEW,
        format!(
            "width {} × height {} at distance {}",
            written_whole(viewport.width),
            written_whole(viewport.height),
            written_whole(viewport.distance)
        ),
        format!("{}: {}", conventions.view, conventions.field_of_view(subject)),
        false,
        true,
    );
    line("distance", "t = 1 is the viewport".into(), conventions.distance.into(), false, true);
    line(
        "pixels' shape",
        "any".into(),
        conventions.shape.into(),
        false,
        !conventions.shape.starts_with("any"),
    );
    line(
        "computes in",
        "f64, exact where it matters".into(),
        conventions.lengths.into(),
        false,
        false,
    );
    table
}

/// Returns the rows on the camera's axes, with their vectors.
fn axes(conventions: &Conventions, subject: &ExportScene, digits: usize) -> Vec<Row> {
    let basis = subject.resolve().basis();
    let text = |axis: Axis| {
        let v = basis.to_world_from_camera(axis.direction);
        // 0 has no sign to read.
        let [x, y, z] =
            (v + DVec3::ZERO).to_array().map(|x| crate::model::number::written(x, digits));
        format!("{} {} = ({x}, {y}, {z})", axis.meaning, letter(axis))
    };
    let names = ["x of the camera", "y of the camera", "z of the camera"];
    let pairs = names.into_iter().zip(Conventions::OURS.into_iter().zip(conventions.axes));
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
