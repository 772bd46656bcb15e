//! Derivation of the view ray of a pixel or of a position (u, v).

use pinhole_core::{Camera, Pixel, ResolvedCamera, Selection, Viewport};
use pinhole_lecture::RayDerivation;

use super::Line;
use super::names::{D, DISTANCE, P, T, U, V, W, equation, joined, minus};
use super::numbers::Numbers;
use crate::model::concept::Concept;
use crate::model::given::Given;
use crate::model::inspection::Inspection;
use crate::view::formula::{
    Formula, Operator, fraction, negative, norm, number, parentheses, row, tuple, word,
};

/// Returns the lines of the given numbers that the ray is worked out from. They stand there without
/// a ray, too, so that whoever has dragged one of them too far can drag it back.
pub(super) fn givens(
    camera: &Camera,
    selection: Selection,
    note: Option<&str>,
    numbers: Numbers,
) -> Vec<Line> {
    let scalar = |name, as_given, value: f64| {
        equation(Formula::Scalar(name), numbers.given(as_given, value))
    };
    let Viewport { width, height, distance, .. } = camera.viewport;
    let distance = Line::new(Concept::Distance, scalar("distance", Given::Distance, distance));
    match selection {
        Selection::Uv(uv) => {
            let symbols = tuple([Formula::Scalar("u"), Formula::Scalar("v")]);
            let values = [(Given::PositionU, uv.x), (Given::PositionV, uv.y)];
            let values = tuple(values.map(|(as_given, x)| numbers.given(as_given, x)));
            let position = Line::new(Concept::Pixel, equation(symbols, values));
            vec![distance, position.noted(note.unwrap_or_default())]
        }
        Selection::Pixel(pixel) => {
            let (i, j) = numbers.counted(pixel);
            let list = |[a, b]: [Formula; 2]| row([a, Operator::Comma.into(), b]);
            let size = |name, as_given, count: u32| scalar(name, as_given, count.into());
            let index = |name: &str, letter, as_given, k: u32| {
                row([word(name), scalar(letter, as_given, k.into())])
            };
            let viewport =
                [scalar("width", Given::Width, width), scalar("height", Given::Height, height)];
            let (columns, rows) = (camera.image.width(), camera.image.height());
            let image =
                [size("W", Given::ImageWidth, columns), size("H", Given::ImageHeight, rows)];
            let pixel = [index("row", "i", Given::Row, i), index("column", "j", Given::Column, j)];
            let counted = if numbers.from_one { "counted from 1" } else { "counted from 0" };
            vec![
                Line::new(Concept::Viewport, list(viewport)),
                Line::new(Concept::Viewport, list(image)).noted("pixels"),
                distance,
                Line::new(Concept::Pixel, list(pixel)).noted(counted),
            ]
        }
    }
}

pub(super) fn lines(
    camera: &Camera,
    resolved: &ResolvedCamera,
    ray: &RayDerivation,
    inspection: &Inspection,
    numbers: Numbers,
) -> Vec<Line> {
    let mut lines = match ray.pixel {
        Some(pixel) => {
            let given = givens(camera, Selection::Pixel(pixel), None, numbers);
            given.into_iter().chain(of_pixel(resolved, pixel, ray, numbers)).collect()
        }
        None => {
            let note = position_note(resolved, inspection, numbers);
            givens(camera, Selection::Uv(ray.uv), Some(&note), numbers)
        }
    };
    let (viewport, basis) = (resolved.viewport(), resolved.basis());
    let distance = negative(DISTANCE);
    let minus_distance = -viewport.distance;
    let parts = [
        (Concept::AlongU, Formula::Scalar("u"), U, ray.uv.x, basis.u, ray.along_u),
        (Concept::AlongV, Formula::Scalar("v"), V, ray.uv.y, basis.v, ray.along_v),
        (Concept::AlongW, distance, W, minus_distance, basis.w, ray.along_w),
    ];
    for (concept, scalar, vector, factor, value, product) in parts {
        let put_in = row([numbers.scalar(factor), numbers.vector(value)]);
        let sides = [row([scalar, vector]), put_in];
        let line = Line::chain(concept, sides, numbers.equals_vector(product));
        lines.push(match concept {
            Concept::AlongW => line.also(&[Concept::Distance]),
            _ => line,
        });
    }
    let sum = |[a, b, c]: [Formula; 3], sign| joined(joined(a, Operator::Plus, b), sign, c);
    let symbols =
        [(row([Formula::Scalar("u"), U])), row([Formula::Scalar("v"), V]), row([DISTANCE, W])];
    let put_in = [ray.along_u, ray.along_v, ray.along_w].map(|part| numbers.vector(part));
    let sides = [D, sum(symbols, Operator::Minus), sum(put_in, Operator::Plus)];
    lines.push(Line::chain(Concept::Direction, sides, numbers.equals_vector(ray.direction)));
    let length = Line::chain(Concept::Direction, [norm(D)], numbers.equals(ray.length));
    lines.push(length.noted("how long a step of 𝑡 = 1 is"));
    let put_in = along(numbers.vector(ray.origin), T, numbers.vector(ray.direction));
    let formula = equation(along(P, T, D), put_in);
    lines.push(Line::new(Concept::Ray, formula).noted("𝐩 = eye; 𝑡 = 1 is on the viewport"));
    lines
}

/// Returns `p + t d`.
pub(super) fn along(p: Formula, t: Formula, d: Formula) -> Formula {
    joined(p, Operator::Plus, row([t, d]))
}

/// Derives u and v from the shares of the image's width and height.
fn of_pixel(
    resolved: &ResolvedCamera,
    pixel: Pixel,
    ray: &RayDerivation,
    numbers: Numbers,
) -> Vec<Line> {
    let (i, j) = numbers.counted(pixel);
    let half = || number("0.5");
    // The pixel's centre lies half a pixel after its edge, or half a pixel before the next pixel's
    // edge.
    let sign = if numbers.from_one { Operator::Minus } else { Operator::Plus };
    let share = |k: Formula, count: Formula| fraction(joined(k, sign, half()), count);
    let (viewport, image) = (resolved.viewport(), resolved.image());
    let across = |k, count| parentheses(minus(share(k, count), half()));
    let down = |k, count| parentheses(minus(half(), share(k, count)));
    let whole = |n: u32| number(&n.to_string());
    let line = |name, extent, symbols, size, put_in, value| {
        let symbols = row([Formula::Scalar(extent), symbols]);
        let put_in = row([numbers.scalar(size), put_in]);
        Line::chain(Concept::Pixel, [Formula::Scalar(name), symbols, put_in], numbers.equals(value))
    };
    let (w, h) = (Formula::Scalar("W"), Formula::Scalar("H"));
    let (symbol_i, symbol_j) = (Formula::Scalar("i"), Formula::Scalar("j"));
    vec![
        line(
            "u",
            "width",
            across(symbol_j, w),
            viewport.width,
            across(whole(j), whole(image.width())),
            ray.uv.x,
        ),
        line(
            "v",
            "height",
            down(symbol_i, h),
            viewport.height,
            down(whole(i), whole(image.height())),
            ray.uv.y,
        ),
    ]
}

/// Returns the note on a given (u, v): its position in the image.
fn position_note(resolved: &ResolvedCamera, inspection: &Inspection, numbers: Numbers) -> String {
    match inspection.image_position {
        None => "outside the image".to_owned(),
        Some(position) if position.touching(resolved.image()).len() == 4 => {
            "the corner of four pixels, no pixel's centre".to_owned()
        }
        Some(position) => match position.only_pixel() {
            Some(pixel) => {
                let (i, j) = numbers.counted(pixel);
                format!("in the pixel of row {i}, column {j}")
            }
            None => "on an edge between pixels".to_owned(),
        },
    }
}
