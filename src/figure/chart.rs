//! Charts: scales along the edges, grid lines with their numbers, and curves that are clipped at the
//! chart's edge. Everything is drawn with an egui painter, so the window and the exported figures share
//! this code.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2};

use pinhole_lecture::numbers::{power_of_ten, short, written};

use crate::typesetting::theme::STACKED;

/// Maps values to positions along an edge of a chart, in points. The positions may increase or decrease.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    is_logarithmic: bool,
    /// The values at the start and at the end of the edge; on a logarithmic scale, their decimal
    /// logarithms.
    range: [f64; 2],
    edge: [f32; 2],
}

/// A round value on a scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The value.
    pub value: f64,
    /// Its position along the edge, in points.
    pub at: f32,
    /// The value as it is written.
    pub text: String,
}

impl Scale {
    /// Creates a linear scale.
    pub fn even(range: [f64; 2], edge: [f32; 2]) -> Scale {
        Scale { is_logarithmic: false, range, edge }
    }

    /// Creates a logarithmic scale over whole decades that includes all positive values.
    pub fn decades(values: impl Iterator<Item = f64>, edge: [f32; 2]) -> Scale {
        let [low, high] = exponents(values).unwrap_or([-1.0, 0.0]);
        let low = low.floor();
        Scale { is_logarithmic: true, range: [low, high.ceil().max(low + 1.0)], edge }
    }

    /// Creates a logarithmic scale that extends slightly beyond the smallest and the largest positive
    /// value.
    pub fn close(values: impl Iterator<Item = f64>, edge: [f32; 2]) -> Scale {
        let [low, high] = exponents(values).unwrap_or([0.0, 1.0]);
        let margin = (0.06 * (high - low)).max(0.12);
        Scale { is_logarithmic: true, range: [low - margin, high + margin], edge }
    }

    /// Returns the position of a value.
    pub fn position(&self, value: f64) -> f32 {
        self.place(if self.is_logarithmic { value.log10() } else { value })
    }

    /// Returns the position of a value. On a logarithmic scale, `value` must be the value's decimal
    /// logarithm.
    fn place(&self, value: f64) -> f32 {
        let ([low, high], [from, to]) = (self.range, self.edge);
        // All positions far outside the chart look the same, and clamping keeps them in the range of `f32`.
        let share = ((value - low) / (high - low)).clamp(-1e4, 1e4);
        from + share as f32 * (to - from)
    }

    /// Returns the value at a position of a linear scale.
    pub fn value_at(&self, position: f32) -> f64 {
        let ([low, high], [from, to]) = (self.range, self.edge);
        low + f64::from(position - from) / f64::from(to - from) * (high - low)
    }

    /// Returns true if a value lies between the two ends of the scale.
    pub fn contains(&self, value: f64) -> bool {
        let value = if self.is_logarithmic { value.log10() } else { value };
        (self.range[0]..=self.range[1]).contains(&value)
    }

    /// Returns the length in points of an interval of length 1; on a logarithmic scale, of one decade.
    pub fn unit(&self) -> f64 {
        f64::from((self.edge[1] - self.edge[0]).abs()) / (self.range[1] - self.range[0])
    }

    /// Returns ticks at round values that are at least `gap` points apart.
    pub fn ticks(&self, gap: f32) -> Vec<Tick> {
        let least = f64::from(gap) / self.unit();
        if self.is_logarithmic { self.powers(least) } else { self.multiples(least) }
    }

    fn multiples(&self, least: f64) -> Vec<Tick> {
        let step = round_step(least);
        let [low, high] = self.range.map(|end| end / step);
        let values = (low.ceil() as i64..=high.floor() as i64).map(|k| k as f64 * step);
        let tick = |value| Tick { value, at: self.place(value), text: written(value + 0.0, 5) };
        values.map(tick).collect()
    }

    /// Returns ticks at powers of ten and, if there is room, at round numbers between them.
    fn powers(&self, least: f64) -> Vec<Tick> {
        const DIGITS: [&[f64]; 3] = [&[1.0, 2.0, 3.0, 5.0, 7.0], &[1.0, 2.0, 5.0], &[1.0, 3.0]];
        let closest = |digits: &[f64]| {
            let next = digits[1..].iter().chain(&[10.0]);
            next.zip(digits).map(|(high, low)| (high / low).log10()).fold(1.0, f64::min)
        };
        let digits = DIGITS.into_iter().find(|digits| closest(digits) >= least);
        let [low, high] = self.range;
        // Exponents are multiples of the step, so that 10^0 = 1 has a tick if it is in range.
        let step = least.ceil().max(1.0) as i32;
        let mut ticks = Vec::new();
        let decades = low.floor() as i32..=high.ceil() as i32;
        for exponent in decades.filter(|exponent| exponent.rem_euclid(step) == 0) {
            for digit in digits.unwrap_or(&[1.0]) {
                let power = f64::from(exponent) + digit.log10();
                if (low..=high).contains(&power) {
                    let value = digit * 10_f64.powi(exponent);
                    let text = if digits.is_some() { short(value) } else { power_of_ten(exponent) };
                    ticks.push(Tick { value, at: self.place(power), text });
                }
            }
        }
        ticks
    }
}

/// Returns the decimal logarithms of the smallest and the largest positive, finite value; `None` if
/// there is no such value.
fn exponents(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let positive = values.filter(|value| *value > 0.0 && value.is_finite()).map(f64::log10);
    positive.map(|x| [x, x]).reduce(|[low, high], [x, _]| [low.min(x), high.max(x)])
}

/// Returns the smallest number that is 1, 2 or 5 times a power of ten and not less than `least`.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|s| *s >= least).unwrap_or(power)
}

/// The look of grid lines and of their numbers.
#[derive(Clone, Copy, Debug)]
pub struct GridInk {
    /// The colour of the lines.
    pub line: Color32,
    /// The colour of the numbers.
    pub text: Color32,
    /// Size of the numbers, in points.
    pub size: f32,
}

/// Draws a vertical line at each tick, with its number below the chart. Omits a number that would touch
/// the previous one or extend too far beyond the right edge.
pub fn columns(painter: &Painter, rect: Rect, ticks: &[Tick], ink: GridInk) {
    let gap = ink.size - 8.0;
    let mut free = rect.left() - 2.0 * gap;
    for Tick { at, text, .. } in ticks {
        painter.vline(*at, rect.y_range(), (1.0, ink.line));
        let font = FontId::proportional(ink.size);
        let galley = painter.layout_no_wrap(text.clone(), font, ink.text);
        let half = 0.5 * galley.size().x;
        if at - half >= free && at + half <= rect.right() + gap {
            painter.galley(pos2(at - half, rect.bottom() + 3.0), galley, ink.text);
            free = at + half + gap;
        }
    }
}

/// Draws a horizontal line at each tick.
pub fn rows(painter: &Painter, rect: Rect, ticks: &[Tick], color: Color32) {
    for tick in ticks {
        painter.hline(rect.x_range(), tick.at, (1.0, color));
    }
}

/// Writes the numbers of the ticks to the left of the chart.
pub fn row_numbers(painter: &Painter, left: f32, ticks: &[Tick], ink: GridInk) {
    for Tick { at, text, .. } in ticks {
        let font = FontId::proportional(ink.size);
        painter.text(pos2(left - 6.0, *at), Align2::RIGHT_CENTER, text, font, ink.text);
    }
}

/// Returns two parts of an area: that of a chart, and that of the words to its right, which are at most this wide, in
/// points and as a fraction of the whole. In a narrow area, the words are below the chart.
pub fn beside(area: Rect, (points, share): (f32, f32)) -> (Rect, Rect) {
    if area.width() < STACKED {
        return area.split_top_bottom_at_y(area.center().y);
    }
    let (left, right) = area.split_left_right_at_x(area.right() - points.min(share * area.width()));
    (left.with_max_x(left.right() - GAP), right)
}

/// Space between a chart and the words to its right, in points.
const GAP: f32 = 10.0;

/// The dash and gap that stand for a solid line.
pub const SOLID: [f32; 2] = [0.0; 2];

/// Draws a polyline with the given dash and gap, in points. [`SOLID`] draws it without gaps.
pub fn line(painter: &Painter, points: &[Pos2], stroke: impl Into<Stroke>, [dash, gap]: [f32; 2]) {
    if dash > 0.0 {
        painter.extend(Shape::dashed_line(points, stroke, dash, gap));
    } else {
        painter.line(points.to_vec(), stroke.into());
    }
}

/// Draws an arrowhead; `forwards` is its direction and its length.
pub fn arrowhead(painter: &Painter, tip: Pos2, forwards: Vec2, color: Color32) {
    let (back, side) = (tip - forwards, 0.5 * forwards.rot90());
    let corners = vec![tip, back + side, back - side];
    painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
}

/// Returns the parts of a polyline that lie inside a rectangle, each as a polyline.
pub fn parts_inside(rect: Rect, points: &[Pos2]) -> Vec<Vec<Pos2>> {
    let mut parts: Vec<Vec<Pos2>> = Vec::new();
    for pair in points.windows(2) {
        let Some([from, to]) = clipped(rect, pair[0], pair[1]) else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// Returns the part of a straight line inside a rectangle, or `None` if it lies outside (Liang and
/// Barsky, "A New Concept and Method for Line Clipping", 1984).
fn clipped(rect: Rect, from: Pos2, to: Pos2) -> Option<[Pos2; 2]> {
    let along = to - from;
    let (mut first, mut last) = (0.0_f32, 1.0_f32);
    for axis in 0..2 {
        let edges = [rect.min[axis], rect.max[axis]];
        if along[axis] == 0.0 {
            if !(edges[0]..=edges[1]).contains(&from[axis]) {
                return None;
            }
            continue;
        }
        let [a, b] = edges.map(|edge| (edge - from[axis]) / along[axis]);
        (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
    }
    let end = if last < 1.0 { from + last * along } else { to };
    (first < last).then(|| [from + first * along, end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|tick| tick.text.as_str()).collect()
    }

    #[test]
    fn steps_are_round() {
        for (least, step) in [(0.7, 1.0), (1.1, 2.0), (3.0, 5.0), (5.1, 10.0), (0.013, 0.02)] {
            assert!((round_step(least) / step - 1.0).abs() < 1e-12);
        }
        let scale = Scale::even([-1.0, 7.0], [0.0, 400.0]);
        assert_eq!(texts(&scale.ticks(62.0)), ["0", "2", "4", "6"]);
        assert_eq!((scale.position(3.0), scale.value_at(200.0)), (200.0, 3.0));
    }

    #[test]
    fn decades_hold_all_values() {
        let scale = Scale::decades([0.0, 0.5, 3e4].into_iter(), [600.0, 0.0]);
        assert_eq!([0.1, 100.0, 1e5].map(|value| scale.position(value)), [600.0, 300.0, 0.0]);
        assert!(scale.contains(1.0) && !scale.contains(0.0) && !scale.contains(2e5));
        assert_eq!(texts(&scale.ticks(60.0)), ["10⁻¹", "1", "10", "10²", "10³", "10⁴", "10⁵"]);
        assert_eq!(texts(&scale.ticks(250.0)), ["1", "10³"]);
    }

    #[test]
    fn no_value_or_a_single_one_still_makes_a_scale() {
        for values in [vec![], vec![0.0], vec![1.0], vec![f64::MAX], vec![5e-324]] {
            for make in [Scale::decades, Scale::close] {
                let scale = make(values.iter().copied(), [0.0, 100.0]);
                assert!(scale.range[1] > scale.range[0]);
                assert!(values.iter().all(|value| scale.position(*value).is_finite()));
                assert!(scale.ticks(20.0).len() <= 6);
            }
        }
    }

    #[test]
    fn powers_have_a_few_numbers_between_them() {
        let scale = |low: f64, high: f64| Scale::close([low, high].into_iter(), [0.0, 250.0]);
        assert_eq!(texts(&scale(3.9, 41.0).ticks(25.0)), ["3", "5", "7", "10", "20", "30", "50"]);
        assert_eq!(texts(&scale(0.4, 3000.0).ticks(40.0)), ["1", "10", "10²", "10³"]);
        assert!(scale(9.0, 9.1).ticks(40.0).len() >= 2);
    }

    #[test]
    fn a_chain_is_cut_at_the_edges() {
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(10.0, 10.0));
        let chain = [pos2(-5.0, 5.0), pos2(5.0, 5.0), pos2(5.0, 25.0), pos2(9.0, 5.0)];
        let parts = [
            vec![pos2(0.0, 5.0), pos2(5.0, 5.0), pos2(5.0, 10.0)],
            vec![pos2(8.0, 10.0), pos2(9.0, 5.0)],
        ];
        assert_eq!(parts_inside(rect, &chain), parts);
        assert!(parts_inside(rect, &[pos2(-1.0, 0.0), pos2(-1.0, 9.0)]).is_empty());
    }
}
