//! The bench as a picture: time against the number of objects, both logarithmic, a line a method.

use super::model::{Bench, Row};
use crate::chart::axis::{Decades, Tick};
use crate::chart::figure::{Align, Figure, Place, Shape};
use crate::chart::frame::{FRAME, Frame, GRID, MARGIN, SMALL, TEXT, WEAK, across, paragraph};
use crate::chart::marker::{Marker, Outline, marker};
use crate::model::number::short;

const WIDTH: f64 = 1280.0;
const PANEL: f64 = 560.0;

/// Room for the numbers left of the panel, and for the names right of it.
const NUMBERS: f64 = 76.0;
const NAMES: f64 = 300.0;

/// From one name to the next.
const LINE: f64 = 80.0;

/// How a method is drawn.
struct Look {
    method: &'static str,
    about: &'static str,
    marker: Marker,
    dashed: bool,
}

/// Colours after Okabe and Ito, "Color Universal Design" (2008), which readers who do not see red
/// or green can tell apart.
const LOOKS: [Look; 5] = [
    look("ladder", "every decision certified", [0x00; 3], Outline::Star, false),
    look("uncertified", "the ladder switched off", [0x00, 0x9e, 0x73], TRIANGLE, true),
    look("textbook", "plain loop over all spheres", [0xd5, 0x5e, 0x00], CIRCLE, false),
    look("textbook-bvh", "the same with a tree of boxes", [0x00, 0x72, 0xb2], SQUARE, false),
    look("stores", "only storing the result", [0xcc, 0x79, 0xa7], PENTAGON, true),
];

const TRIANGLE: Outline = marker([0; 3], 3, 0.0).outline;
const CIRCLE: Outline = marker([0; 3], 24, 0.0).outline;
const SQUARE: Outline = marker([0; 3], 4, 45.0).outline;
const PENTAGON: Outline = marker([0; 3], 5, 0.0).outline;

const fn look(
    method: &'static str,
    about: &'static str,
    color: [u8; 3],
    outline: Outline,
    dashed: bool,
) -> Look {
    Look { method, about, marker: Marker { color, outline }, dashed }
}

/// Draws a bench.
pub fn figure(bench: &Bench) -> Figure {
    let mut figure = Figure { width: WIDTH, ..Figure::default() };
    let what = "Time against the number of objects".to_owned();
    figure.bold([MARGIN, 40.0], Align::Left, 30.0, TEXT, what);
    let about = format!(
        "A frame from the camera to t as f32 and the object of every pixel: {}, threads: {}. Lower is \
         better.",
        scenes(bench),
        bench.threads
    );
    let top = paragraph(&mut figure, 80.0, 17.0, &about);
    figure.text([MARGIN, top + 8.0], Align::Left, 17.0, TEXT, "milliseconds a frame".to_owned());
    let (left, top) = (MARGIN + NUMBERS, top + 34.0);
    let frame = Frame { left, top, right: WIDTH - MARGIN - NAMES, bottom: top + PANEL };
    panel(&mut figure, frame, bench);
    names(&mut figure, [frame.right + 34.0, frame.top + 20.0], bench);
    let mut y = frame.bottom + 76.0;
    y = paragraph(&mut figure, y, 16.0, &format!("Processor: {}", bench.cpu));
    for line in &bench.left_out {
        y = paragraph(&mut figure, y, 16.0, &format!("Left out: {line}"));
    }
    figure.height = y - 8.0 + MARGIN;
    figure
}

/// The sizes of images, or the scene where there is only one.
fn scenes(bench: &Bench) -> String {
    let Some(first) = bench.rows.first() else { return "nothing measured".to_owned() };
    let size = first
        .image
        .map_or("".to_owned(), |image| format!("{} x {} pixels", image.width(), image.height()));
    match bench.rows.iter().all(|row| row.scene == first.scene) {
        true => format!("{}, {size}", first.scene),
        false => size,
    }
}

fn panel(figure: &mut Figure, frame: Frame, bench: &Bench) {
    let Frame { left, top, right, bottom } = frame;
    let counts = bench.rows.iter().map(|row| row.objects as f64);
    let objects = Decades::over(counts, [left + 18.0, right - 18.0], left + 18.0);
    let all_times = bench.rows.iter().map(|row| row.ms.median);
    let times = Decades::over(all_times, [bottom, top], bottom);
    across(figure, frame, objects.ticks(12), "objects in the scene");
    for Tick { at, text } in times.ticks(12) {
        figure.line(&[[left, at], [right, at]], GRID, 1.0);
        figure.text([left - 8.0, at], Align::Right, SMALL, TEXT, text);
    }
    figure.rectangle([left, top], [right, bottom], None, Some((FRAME, 1.5)));
    let place = |row: &Row| [objects.place(row.objects as f64), times.place(row.ms.median)];
    // The ladder last, on top of the others.
    for look in LOOKS.iter().rev() {
        let rows = bench.rows.iter().filter(|row| row.method == look.method);
        let points: Vec<Place> = rows.map(place).collect();
        let color = look.marker.color;
        for at in &points {
            look.marker.draw(figure, *at, false);
        }
        if points.len() > 1 {
            let line = Shape::Line { points, color, width: 2.5, dashed: look.dashed };
            figure.shapes.push(line);
        }
    }
}

/// Which mark is which method, and how its time compares with the ladder's.
fn names(figure: &mut Figure, [left, top]: Place, bench: &Bench) {
    let used = |look: &&Look| bench.rows.iter().any(|row| row.method == look.method);
    for (index, look) in LOOKS.iter().filter(used).enumerate() {
        let y = top + LINE * index as f64;
        let points = vec![[left - 16.0, y], [left + 16.0, y]];
        let color = look.marker.color;
        figure.shapes.push(Shape::Line { points, color, width: 2.5, dashed: look.dashed });
        look.marker.draw(figure, [left, y], false);
        let at = left + 28.0;
        figure.bold([at, y], Align::Left, 18.0, TEXT, look.method.to_owned());
        figure.text([at, y + 21.0], Align::Left, 15.0, WEAK, look.about.to_owned());
        if let Some(text) = compared(bench, look.method) {
            figure.text([at, y + 40.0], Align::Left, 15.0, WEAK, text);
        }
    }
}

/// From the least to the most, how many times as long as the ladder a method takes, or the ladder as
/// the method where that is quicker throughout.
fn compared(bench: &Bench, method: &str) -> Option<String> {
    if method == "ladder" {
        return None;
    }
    let rows = bench.rows.iter().filter(|row| row.method == method);
    let ratios = rows.filter_map(|row| Some(row.ms.median / bench.median(&row.scene, "ladder")?));
    let mut ratios: Vec<f64> = ratios.collect();
    ratios.sort_by(f64::total_cmp);
    let (least, most) = (*ratios.first()?, *ratios.last()?);
    let range = |least: f64, most: f64| match (short(least), short(most)) {
        (least, most) if least == most => least,
        (least, most) => format!("{least} to {most}"),
    };
    if most < 1.0 {
        return Some(format!("ladder takes {} times that", range(1.0 / most, 1.0 / least)));
    }
    Some(format!("takes {} times the ladder", range(least, most)))
}
