//! Paints filled outlines by the exact area that they cover of each dot, row by row: a mark costs
//! about what its dots cost. A dot's coverage is the sum of the signed areas between the outline's
//! edges and the dot's right side (Karl Guttag's and Raph Levien's *accumulation buffer*; FreeType's
//! smooth rasteriser sums the same areas), at most 1: an outline that overlaps itself in one sense
//! of rotation is filled once.

use std::ops::Range;

use egui::Color32;
use tiny_skia_path::{Path, PathSegment, Point};

use crate::view::overlay::space::layers::mix;

/// Greatest distance, in dots, of a curve from the chain of lines that stands for it.
const FLATNESS: f32 = 0.02;

/// Share of a dot below which it is not covered: less than half a step of a colour.
const NOTHING: f32 = 0.0019;

/// A straight edge from its upper to its lower end, in dots.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Edge {
    top: f32,
    bottom: f32,
    /// x at the top.
    x: f32,
    /// Change of x a row.
    slope: f32,
    /// 1 where the outline goes down, -1 where it goes up.
    sense: f32,
}

/// A filled outline, to be painted in bands of rows.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Filled {
    /// From the top down.
    edges: Vec<Edge>,
    /// Rows that it may cover a part of.
    rows: Range<usize>,
    color: Color32,
    /// Opacity, 0 to 1.
    opacity: f32,
}

/// Memory that the bands of one picture share.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    active: Vec<Edge>,
    /// Change of the covered area from dot to dot.
    area: Vec<f32>,
}

impl Filled {
    /// Prepares an outline for a picture of `width` dots a row; `None` if it covers nothing of it.
    pub(super) fn new(path: &Path, color: Color32, [width, height]: [usize; 2]) -> Option<Filled> {
        let mut edges = Edges { width: width as f32, height: height as f32, found: Vec::new() };
        edges.follow(path);
        let mut edges = edges.found;
        edges.sort_unstable_by(|a, b| a.top.total_cmp(&b.top));
        let bottom = edges.iter().map(|edge| edge.bottom).fold(0.0, f32::max);
        let rows = edges.first()?.top as usize..bottom.ceil() as usize;
        let [r, g, b, a] = color.to_srgba_unmultiplied();
        let (color, opacity) = (Color32::from_rgb(r, g, b), f32::from(a) / 255.0);
        Some(Filled { edges, rows, color, opacity })
    }

    /// Paints it into the dots of a band of rows that starts at row `top`.
    pub(super) fn paint(
        &self,
        top: usize,
        width: usize,
        dots: &mut [Color32],
        scratch: &mut Scratch,
    ) {
        let rows = self.rows.start.max(top)..self.rows.end.min(top + dots.len() / width);
        let Scratch { active, area } = scratch;
        active.clear();
        area.resize(width + 2, 0.0);
        let mut coming = self.edges.iter().peekable();
        for row in rows {
            let (above, below) = (row as f32, (row + 1) as f32);
            active.retain(|edge| edge.bottom > above);
            while let Some(edge) = coming.next_if(|edge| edge.top < below) {
                if edge.bottom > above {
                    active.push(*edge);
                }
            }
            let mut touched = width..0;
            for edge in &*active {
                let dots = edge.add_to(area, above, below);
                touched = touched.start.min(dots.start)..touched.end.max(dots.end);
            }
            if !touched.is_empty() {
                let dots = &mut dots[(row - top) * width..][..width];
                self.paint_row(dots, area, touched);
            }
        }
    }

    /// Paints the dots of a row from the first that an edge touches, and clears the area for the next
    /// row.
    fn paint_row(&self, dots: &mut [Color32], area: &mut [f32], touched: Range<usize>) {
        let mut covered = 0.0_f32;
        let changes = area[touched.clone()].iter();
        for (change, dot) in changes.zip(dots.iter_mut().skip(touched.start)) {
            covered += change;
            *dot = self.over(*dot, covered);
        }
        // Edges to the right of the picture are left out: what they would close goes on to its end.
        if covered.abs() > NOTHING {
            let rest = dots.iter_mut().skip(touched.end);
            rest.for_each(|dot| *dot = self.over(*dot, covered));
        }
        area[touched].fill(0.0);
    }

    fn over(&self, below: Color32, covered: f32) -> Color32 {
        let share = covered.abs().min(1.0) * self.opacity;
        match share {
            share if share > 1.0 - NOTHING => self.color,
            share if share > NOTHING => mix(below, self.color, share),
            _ => below,
        }
    }
}

impl Edge {
    /// Adds the areas to the right of the part of it between two rows' borders, and returns the
    /// dots that it touches.
    fn add_to(&self, area: &mut [f32], above: f32, below: f32) -> Range<usize> {
        let (from, to) = (self.top.max(above), self.bottom.min(below));
        let (a, b) =
            (self.x + (from - self.top) * self.slope, self.x + (to - self.top) * self.slope);
        let (left, right) = if a < b { (a, b) } else { (b, a) };
        let (left, right) = (left.max(0.0), right.max(0.0).min((area.len() - 2) as f32));
        let left = left.min(right);
        let height = self.sense * (to - from);
        let first = left as usize;
        let last = (right as usize).max(first);
        if first == last {
            // The mean distance from the dot's left side is what is missing of its area.
            let missing = 0.5 * (left + right) - first as f32;
            area[first] += height * (1.0 - missing);
            area[first + 1] += height * missing;
            return first..first + 2;
        }
        // Share of the edge's height in a dot that it crosses from side to side.
        let crossed = height / (right - left);
        let mut done = 0.0;
        for column in first..=last {
            let x = [left.max(column as f32), right.min((column + 1) as f32)];
            let part = crossed * (x[1] - x[0]);
            let missing = 0.5 * (x[0] + x[1]) - column as f32;
            area[column] += part * (1.0 - missing);
            area[column + 1] += part * missing;
            done += part;
        }
        // What rounding has left over belongs to the dots on the right.
        area[last + 1] += height - done;
        first..last + 2
    }
}

/// The edges of an outline within a picture.
struct Edges {
    width: f32,
    height: f32,
    found: Vec<Edge>,
}

impl Edges {
    fn follow(&mut self, path: &Path) {
        let (mut start, mut last) = (Point::zero(), Point::zero());
        for segment in path.segments() {
            let end = match segment {
                PathSegment::MoveTo(point) => {
                    self.line(last, start);
                    start = point;
                    point
                }
                PathSegment::LineTo(point) => {
                    self.line(last, point);
                    point
                }
                PathSegment::QuadTo(control, point) => {
                    self.quadratic(last, control, point);
                    point
                }
                PathSegment::CubicTo(first, second, point) => {
                    self.cubic([last, first, second, point]);
                    point
                }
                PathSegment::Close => {
                    self.line(last, start);
                    start
                }
            };
            last = end;
        }
        self.line(last, start);
    }

    /// Adds a quadratic Bézier curve. A chain of n lines is at most |a - 2b + c| / (4 n^2) away.
    fn quadratic(&mut self, a: Point, b: Point, c: Point) {
        let bend = a - b - (b - c);
        let count = (bend.length() / (4.0 * FLATNESS)).sqrt().ceil().clamp(1.0, 64.0);
        let mut last = a;
        for k in 1..=count as u32 {
            let s = k as f32 / count;
            let next = lerp(lerp(a, b, s), lerp(b, c, s), s);
            self.line(last, next);
            last = next;
        }
    }

    /// Adds a cubic Bézier curve, of which the outlines here have none that bends much.
    fn cubic(&mut self, [a, b, c, d]: [Point; 4]) {
        let mut last = a;
        for k in 1..=16 {
            let s = k as f32 / 16.0;
            let middle = lerp(b, c, s);
            let (from, to) = (lerp(a, b, s), lerp(c, d, s));
            let next = lerp(lerp(from, middle, s), lerp(middle, to, s), s);
            self.line(last, next);
            last = next;
        }
    }

    /// Adds the part of a line within the rows. What is left of the picture counts on its border,
    /// so that it covers as much of the row; what is right of it covers nothing.
    fn line(&mut self, from: Point, to: Point) {
        let (sense, upper, lower) = if from.y < to.y { (1.0, from, to) } else { (-1.0, to, from) };
        if !(lower.y > 0.0 && upper.y < self.height && upper.y < lower.y) {
            return;
        }
        let slope = (lower.x - upper.x) / (lower.y - upper.y);
        let x_at = |y: f32| upper.x + (y - upper.y) * slope;
        let (top, bottom) = (upper.y.max(0.0), lower.y.min(self.height));
        // The heights at which it crosses the two borders part it into at most three.
        let crossing = |x: f32| (upper.y + (x - upper.x) / slope).clamp(top, bottom);
        let mut cuts = [top, bottom, bottom, bottom];
        if slope != 0.0 {
            let (left, right) = (crossing(0.0), crossing(self.width));
            cuts = [top, left.min(right), left.max(right), bottom];
        }
        for cut in cuts.windows(2) {
            let [top, bottom] = [cut[0], cut[1]];
            let middle = x_at(0.5 * (top + bottom));
            if !(top < bottom && middle < self.width) {
                continue;
            }
            let inside = middle > 0.0;
            let (x, slope) = if inside { (x_at(top), slope) } else { (0.0, 0.0) };
            self.found.push(Edge { top, bottom, x, slope, sense });
        }
    }
}

fn lerp(a: Point, b: Point, s: f32) -> Point {
    Point { x: a.x + s * (b.x - a.x), y: a.y + s * (b.y - a.y) }
}

#[cfg(test)]
mod tests {
    use tiny_skia_path::{PathBuilder, Stroke};

    use super::*;

    const SIZE: [usize; 2] = [40, 30];

    /// Paints white on black and returns the shares covered.
    fn covered(path: &Path) -> Vec<f32> {
        let mut dots = vec![Color32::BLACK; SIZE[0] * SIZE[1]];
        let mut scratch = Scratch::default();
        if let Some(filled) = Filled::new(path, Color32::WHITE, SIZE) {
            for (band, dots) in dots.chunks_mut(7 * SIZE[0]).enumerate() {
                filled.paint(7 * band, SIZE[0], dots, &mut scratch);
            }
        }
        dots.into_iter().map(|dot| f32::from(dot.r()) / 255.0).collect()
    }

    fn polygon(points: &[[f32; 2]]) -> Path {
        let mut path = PathBuilder::new();
        path.move_to(points[0][0], points[0][1]);
        points[1..].iter().for_each(|[x, y]| path.line_to(*x, *y));
        path.close();
        path.finish().expect("a polygon")
    }

    /// The share of a dot by 32 x 32 samples, inside by the winding number.
    fn sampled(points: &[[f32; 2]], column: usize, row: usize) -> f32 {
        let inside = |x: f32, y: f32| {
            let mut winding = 0;
            for (k, [x0, y0]) in points.iter().enumerate() {
                let [x1, y1] = points[(k + 1) % points.len()];
                if (*y0 <= y) != (y1 <= y) && x0 + (y - y0) / (y1 - y0) * (x1 - x0) > x {
                    winding += if y1 > *y0 { 1 } else { -1 };
                }
            }
            winding != 0
        };
        let offset = |k: usize| (k as f32 + 0.5) / 32.0;
        let samples = (0..1024)
            .filter(|k| inside(column as f32 + offset(k % 32), row as f32 + offset(k / 32)));
        samples.count() as f32 / 1024.0
    }

    #[test]
    fn each_dot_is_covered_by_the_polygons_area_in_it() {
        let polygons: [&[[f32; 2]]; 6] = [
            &[[3.2, 2.7], [30.4, 9.1], [12.8, 25.6]],
            &[[1.0, 1.0], [39.0, 1.3], [39.0, 2.9], [1.0, 2.6]],
            &[[10.3, -20.0], [11.1, -20.0], [14.9, 50.0], [14.1, 50.0]],
            &[[-200.0, 8.2], [300.0, 11.7], [300.0, 13.1], [-200.0, 9.6]],
            &[[-30.0, 29.9], [20.0, -40.0], [70.0, 29.9]],
            &[[5.0, 5.0], [5.0, 20.0], [25.0, 20.0], [25.0, 5.0]],
        ];
        for points in polygons {
            let found = covered(&polygon(points));
            for (k, found) in found.iter().enumerate() {
                let expected = sampled(points, k % SIZE[0], k / SIZE[0]);
                assert!((found - expected).abs() < 0.025, "{points:?}, {k}: {found} {expected}");
            }
        }
    }

    #[test]
    fn a_strokes_overlaps_are_painted_once() {
        let chain = polygon(&[[8.0, 8.0], [30.0, 8.0], [30.0, 22.0], [8.0, 22.0]]);
        let stroke = Stroke { width: 4.0, ..Stroke::default() };
        let found = covered(&chain.stroke(&stroke, 1.0).expect("a stroke"));
        let at = |x: usize, y: usize| found[y * SIZE[0] + x];
        assert_eq!([at(8, 7), at(20, 8), at(29, 21), at(8, 15)], [1.0; 4]);
        assert_eq!([at(20, 15), at(2, 2), at(35, 15)], [0.0; 3], "inside and beside it");
    }

    #[test]
    fn a_circle_covers_its_area() {
        let circle = PathBuilder::from_circle(20.0, 15.0, 9.3).expect("a circle");
        let area: f32 = covered(&circle).iter().sum();
        assert!((area - std::f32::consts::PI * 9.3 * 9.3).abs() < 1.0, "{area}");
    }

    #[test]
    fn what_lies_beside_the_picture_leaves_it_alone() {
        for [x, y] in [[-100.0, 10.0], [100.0, 10.0], [10.0, -100.0], [10.0, 100.0]] {
            let path = polygon(&[[x, y], [x + 9.0, y], [x + 9.0, y + 9.0]]);
            assert!(covered(&path).iter().all(|share| *share == 0.0), "{x} {y}");
        }
    }
}
