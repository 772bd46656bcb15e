//! Caches of the derivation and of the plot of f(p + t d), keyed by their inputs.

use std::sync::Arc;

use pinhole_core::{ResolvedCamera, Selection};
use pinhole_exchange::document::Document;
use pinhole_lecture::numbers::Rounding;

use crate::model::session::{Heights, ViewLayout};
use crate::view::derivation::{
    Derivation, DerivationInputs, DerivationSettings, NumberFormat, derivation,
};
use crate::view::derive::memo::Memo;
use crate::view::derive::{Derived, Inputs};
use crate::view::plot::{Curve, Named, Plot, Samples, curves, range, samples, shown, values};

/// Decimals of the derivation's numbers while presenting: few enough to be read from the back row.
const PRESENTED_DECIMALS: usize = 3;

/// The last derivation and its inputs.
#[derive(Debug, Default)]
pub(super) struct Derivations(Memo<(Document, DerivationSettings), Arc<Derivation>>);

impl Derivations {
    /// Returns the derivation, if the layout shows it.
    pub(super) fn get(
        &mut self,
        Inputs { document, session, sizes, .. }: Inputs<'_>,
        derived: &Derived,
    ) -> Option<Arc<Derivation>> {
        let layout = session.settings.layout;
        let is_solution =
            layout == ViewLayout::Exercises && sizes.world.is_some() && session.exercises.is_solved;
        if !layout.shows_derivation() && !is_solution {
            return None;
        }
        let settings = DerivationSettings {
            selection: session.shown_selection(),
            sections: session.sections,
            numbers: NumberFormat {
                rounding: match session.presenting {
                    Some(_) => Rounding::Decimals(PRESENTED_DECIMALS),
                    None => Rounding::Significant(session.settings.digits),
                },
                exact: session.settings.exact_forms,
                from_one: session.settings.count_from_one,
            },
            fault: derived.fault,
        };
        // The document is compared before it is cloned, because it can be large.
        let is_same = |(known, chosen): &(Document, DerivationSettings)| {
            *chosen == settings && known == document
        };
        if let Some(made) = self.0.known(is_same) {
            return Some(Arc::clone(made));
        }
        Some(self.0.get((document.clone(), settings), |_| {
            Arc::new(derivation(&DerivationInputs {
                document,
                resolved: derived.resolved.as_ref(),
                scene: derived.scene.as_deref(),
                inspection: derived.inspection.as_deref(),
                settings,
            }))
        }))
    }
}

/// The inputs of the curves: the camera, the objects by number, the ray, and the objects with a
/// curve.
type CurvesKey = (ResolvedCamera, u64, Selection, Vec<Named>);

/// A cache of the curves, their samples, and their values at the moving point.
#[derive(Debug, Default)]
pub(super) struct Plots {
    curves: Memo<CurvesKey, Arc<Vec<Curve>>>,
    samples: Memo<(u64, [f64; 2], Heights), Arc<Samples>>,
    ray_point_t: Memo<(u64, f64), Arc<Vec<f64>>>,
    /// Number of times that curves were made; it identifies the current ones.
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
