//! Smooth borders where the panes that stand for planes cut into spheres.

use pinhole_core::{DVec2, EdgeBlend, covered};
use rayon::prelude::*;

use super::{HALF, Layers, PlanePatch};

impl Layers<'_> {
    /// Finds the borders where panes cut into spheres, and how much of each pixel there belongs to either side.
    pub(super) fn cuts(&self) -> Vec<EdgeBlend> {
        let patches = self.backdrop.patches.iter().filter(|patch| !patch.cut.is_empty());
        let rows = |patch| {
            let rows = (0..self.height).into_par_iter();
            rows.flat_map_iter(move |row| self.cuts_in_row(patch, row)).collect::<Vec<_>>()
        };
        patches.flat_map(rows).collect()
    }

    fn cuts_in_row<'s>(
        &'s self,
        patch: &'s PlanePatch,
        row: usize,
    ) -> impl Iterator<Item = EdgeBlend> + 's {
        let columns = patch.flat.span(row as f64 + 0.5, self.width, HALF);
        columns.filter_map(move |column| {
            let pixel = row * self.width + column;
            let object = self.frame.object[pixel];
            // The distance in t by which the pane is nearer than the object.
            let gap = |column: usize, row: usize| {
                let is_inside = column < self.width && row < self.height;
                let pixel = is_inside.then(|| row * self.width + column)?;
                if self.frame.object[pixel] != object {
                    return None;
                }
                let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                Some(f64::from(self.frame.t[pixel]) - patch.flat.at(at, HALF)?.t)
            };
            if patch.cut.binary_search(&object).is_err() {
                return None;
            }
            let own = gap(column, row)?;
            let (left, above) = (column.wrapping_sub(1), row.wrapping_sub(1));
            let around = [(left, row), (column + 1, row), (column, above), (column, row + 1)];
            let gaps = around.map(|(column, row)| gap(column, row));
            let is_other = |gap: &Option<f64>| gap.is_some_and(|gap| (gap < 0.0) != (own < 0.0));
            let (column, row) = around[gaps.iter().position(is_other)?];
            let slope = |before: Option<f64>, after: Option<f64>| match (before, after) {
                (Some(before), Some(after)) => 0.5 * (after - before),
                (before, after) => after.or(before).map_or(0.0, |gap| gap - own),
            };
            let slopes = [slope(gaps[0], gaps[1]), slope(gaps[2], gaps[3])];
            let share = covered(own.abs(), slopes).max(0.5) as f32;
            let from = (row * self.width + column) as u32;
            Some(EdgeBlend { pixel: pixel as u32, from, share })
        })
    }
}

#[cfg(test)]
mod tests {
    use egui::Color32;
    use pinhole_core::{
        Camera, DVec3, ImageSize, Outputs, Raster, Scene, Sphere, edge_blends, trace_as,
    };

    use super::*;
    use crate::view::overlay::{Backdrop, Flat, Grid, Screen};

    const SIZE: u32 = 90;
    /// Pixels of the fine picture per pixel of the other, along each axis.
    const FINE: u32 = 8;

    /// Returns a white ball that a black pane cuts into, in a picture of this size.
    fn cut_ball(size: u32, cut: Vec<u32>) -> Vec<Color32> {
        let image = ImageSize::new(size, size).expect("a size");
        let camera = Camera { image, ..Camera::CANONICAL }.resolve().expect("a camera");
        let ball = Sphere { center: DVec3::new(0.2, 0.1, -4.0), radius: 1.2 };
        let scene = Scene::new(vec![ball], vec![]).expect("a scene");
        let frame = trace_as(&scene, &camera, &Raster::full(image), Outputs::default());
        let rays = Screen::new(&camera, 1.0, 1.0).pixel_rays();
        let (a, b) = (DVec3::new(20.0, 0.0, 6.0), DVec3::new(0.0, 20.0, 0.0));
        let patch = PlanePatch {
            flat: Flat::new(&rays, DVec3::new(0.0, 0.0, -3.4), a, b).expect("a plane"),
            color: Color32::BLACK,
            grid_color: Color32::BLACK,
            opacity: 1.0,
            grid: Grid::new(DVec2::splat(1.0), DVec2::splat(0.5), 1.0),
            cut,
        };
        let backdrop = Backdrop { patches: vec![patch], ..Backdrop::default() };
        let mut dots = vec![Color32::WHITE; (size * size) as usize];
        backdrop.paint(&frame, &edge_blends(&frame, &scene), &mut dots);
        dots
    }

    #[test]
    fn the_border_where_a_pane_cuts_a_ball_is_smooth() {
        let fine = cut_ball(SIZE * FINE, vec![]);
        let (width, step) = (SIZE as usize, FINE as usize);
        let mean = |pixel: usize| {
            let (row, column) = (pixel / width * step, pixel % width * step);
            let row = |k: usize| &fine[(row + k) * width * step + column..][..step];
            let sum: f32 = (0..step).flat_map(row).map(|dot| f32::from(dot.r())).sum();
            sum / (255.0 * (step * step) as f32)
        };
        let error = |dots: &[Color32]| -> f32 {
            let of = |(pixel, dot): (usize, &Color32)| f32::from(dot.r()) / 255.0 - mean(pixel);
            dots.iter().enumerate().map(of).map(f32::abs).sum()
        };
        let [rough, smooth] = [vec![], vec![0]].map(|cut| error(&cut_ball(SIZE, cut)));
        assert!(rough > 5.0 && smooth < 0.3 * rough, "{rough} {smooth}");
    }
}
