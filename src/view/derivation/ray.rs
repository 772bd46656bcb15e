//! Derivation of the view ray of a pixel or of a position (u, v).

use pinhole_core::{PixelOfUv, ResolvedCamera};
use pinhole_lecture::{PixelShares, RayDerivation};

use super::Line;
use super::names::{D, DISTANCE, P, T, U, V, W, equation, joined, minus};
use super::numbers::Numbers;
use crate::model::concept::Concept;
use crate::model::inspection::Inspection;
use crate::view::formula::{
    Formula, Operator, fraction, negative, norm, number, parentheses, row, tuple, word,
};

pub(super) fn lines(
    resolved: &ResolvedCamera,
    ray: &RayDerivation,
    inspection: &Inspection,
    numbers: Numbers,
) -> Vec<Line> {
    let mut lines = match &ray.shares {
        Some(shares) => of_pixel(resolved, shares, ray, numbers),
        None => vec![of_uv(resolved, ray, inspection, numbers)],
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
        let formula = equation(row([scalar, vector]), put_in);
        let line = Line::new(concept, row([formula, numbers.equals_vector(product)]));
        lines.push(match concept {
            Concept::AlongW => line.also(&[Concept::Distance]),
            _ => line,
        });
    }
    let sum = |[a, b, c]: [Formula; 3], sign| joined(joined(a, Operator::Plus, b), sign, c);
    let symbols =
        [(row([Formula::Scalar("u"), U])), row([Formula::Scalar("v"), V]), row([DISTANCE, W])];
    let put_in = [ray.along_u, ray.along_v, ray.along_w].map(|part| numbers.vector(part));
    let formula = equation(equation(D, sum(symbols, Operator::Minus)), sum(put_in, Operator::Plus));
    let direction = row([formula, numbers.equals_vector(ray.direction)]);
    lines.push(Line::new(Concept::Direction, direction));
    let length = row([norm(D), numbers.equals(ray.length)]);
    lines.push(Line::new(Concept::Direction, length).noted("how long a step of 𝑡 = 1 is"));
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
    shares: &PixelShares,
    ray: &RayDerivation,
    numbers: Numbers,
) -> Vec<Line> {
    let (i, j) = numbers.counted(shares.pixel);
    let position = |name, k: u32| equation(Formula::Scalar(name), number(&k.to_string()));
    let rows = row([word("row"), position("i", i), Operator::Comma.into()]);
    let pixel = row([rows, word("column"), position("j", j)]);
    let counted = if numbers.from_one { "counted from 1" } else { "counted from 0" };
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
        let formula = equation(equation(Formula::Scalar(name), symbols), put_in);
        Line::new(Concept::Pixel, row([formula, numbers.equals(value)]))
    };
    let (w, h) = (Formula::Scalar("W"), Formula::Scalar("H"));
    let (symbol_i, symbol_j) = (Formula::Scalar("i"), Formula::Scalar("j"));
    vec![
        Line::new(Concept::Pixel, pixel).noted(counted),
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

/// Returns the line of a given (u, v), with its position in the image.
fn of_uv(
    resolved: &ResolvedCamera,
    ray: &RayDerivation,
    inspection: &Inspection,
    numbers: Numbers,
) -> Line {
    let symbols = tuple([Formula::Scalar("u"), Formula::Scalar("v")]);
    let values = tuple([numbers.scalar(ray.uv.x), numbers.scalar(ray.uv.y)]);
    let note = match inspection.image_position {
        None => "outside the image".to_owned(),
        Some(position) if position.touching(resolved.image()).len() == 4 => {
            "the corner of four pixels, no pixel's centre".to_owned()
        }
        Some(PixelOfUv { column_edge: None, row_edge: None, pixel }) => {
            let (i, j) = numbers.counted(pixel);
            format!("in the pixel of row {i}, column {j}")
        }
        Some(_) => "on an edge between pixels".to_owned(),
    };
    Line::new(Concept::Pixel, equation(symbols, values)).noted(note)
}
