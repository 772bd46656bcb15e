//! A cache of the plot of f(p + t d), keyed by its inputs.

use std::sync::Arc;

use pinhole_core::{ResolvedCamera, Selection};

use super::Derived;
use super::derived::Inputs;
use super::memo::Memo;
use crate::model::session::{Heights, ViewLayout};
use crate::view::plot::{Curve, Named, Plot, Samples, curves, range, samples, shown, values};

/// The inputs of the curves: the camera, the objects by number, the ray, and the objects with a
/// curve.
type Key = (ResolvedCamera, u64, Selection, Vec<Named>);

/// A cache of the curves, their samples, and their values at the moving point.
#[derive(Debug, Default)]
pub(super) struct Plots {
    curves: Memo<Key, Arc<Vec<Curve>>>,
    samples: Memo<(u64, [f64; 2], Heights), Arc<Samples>>,
    ray_point_t: Memo<(u64, f64), Arc<Vec<f64>>>,
    /// Number of times that curves were made, which distinguishes some from the next.
    made: u64,
}

impl Plots {
    /// Returns the plot, if the layout shows it and there is a ray.
    pub(super) fn get(
        &mut self,
        Inputs { document, session, sizes, .. }: Inputs<'_>,
        derived: &Derived,
        generation: u64,
    ) -> Option<Plot> {
        if session.settings.layout != ViewLayout::Plot {
            return None;
        }
        let scheme = sizes.style.scheme();
        let (resolved, scene) = (derived.resolved.as_ref()?, derived.scene.as_deref()?);
        let inspection = derived.inspection.as_deref()?;
        let selection = session.shown_selection().inside(resolved.image());
        let ray = selection.exact_ray(resolved).ok()?;
        let named = |object: u32| {
            let title = document.title_of(object as usize);
            let name = document.name_of(object).map_or_else(|| title.clone(), str::to_owned);
            let color = scheme.object(object, document.color_of(object));
            Named { object, title, name, color }
        };
        let named: Vec<Named> = shown(scene, inspection).into_iter().map(named).collect();
        let made = &mut self.made;
        let curves = self.curves.get((*resolved, generation, selection, named), |(.., named)| {
            *made += 1;
            Arc::new(curves(scene, &ray, named))
        });
        let range = range(&curves, session.ray_point_t);
        let ends = [*range.start(), *range.end()];
        let heights = session.settings.plot_heights();
        let samples = self.samples.get((*made, ends, heights), |_| {
            Arc::new(samples(&curves, scene, &ray, &range, heights))
        });
        let ray_point_t = session.ray_point_t.map(|t| {
            let make = |_: &_| Arc::new(values(&curves, scene, &ray, t));
            (t, self.ray_point_t.get((*made, t), make))
        });
        let left_out = scene.len() - curves.len();
        Some(Plot { curves, left_out, range, heights, samples, ray_point_t })
    }
}
