//! The views and their caches: the world view (the observer's picture with the camera drawn in it), the
//! camera view, the derivation, and the plot of f(p + t d).
//!
//! The camera's own picture is lit from its eye, so a sphere is brightest in its middle and looks flat.
//! The observer's picture is lit from above the observer's left shoulder, as in a printed figure. There
//! are no shadows: the light passes through other objects, and it also reaches around each sphere. The
//! borders of its objects are smooth; the camera's picture keeps its pixels, which are the subject.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{
    DVec3, EdgeBlend, Frame, NO_OBJECT, Outputs, Pixel, ResolvedCamera, Rgb, Scene, Shade,
    edge_blends, lambert,
};
use pinhole_exchange::document::Document;
use pinhole_figure::derivation::sections::{DerivationSections, Formulas};
use pinhole_figure::derivation::{
    Derivation, DerivationInputs, DerivationSettings, NumberFormat, derivation,
};
use pinhole_figure::observer::enclosing;
use pinhole_figure::overlay::{
    self, Backdrop, Below, CameraView, ColoredScene, Figure, Same, WorldView,
};
use pinhole_figure::{Concept, EquationStep};
use pinhole_lecture::exercises::Given;
use rayon::prelude::*;

use crate::features::handles;
use crate::features::handles::placed::HandleInputs;
use crate::features::plot::curves::{Named, Plot, shown};
use crate::model::session::ViewLayout;
use crate::view::adaptive_resolution::Subsampling;
use crate::view::derive::{
    Derived, Enclosing, FinishedView, GoodPicture, GoodWorld, Inputs, LastView, Memo, Objects,
    Purpose, Spares, WorkKind, ghost_camera, highlighted, opaque, repainted, trace_picture,
    watched,
};

/// A cache of the world view and of the pictures over which it is drawn.
#[derive(Debug, Default)]
pub(super) struct WorldViews {
    pub(super) pictures: WorldPictures,
    view: LastView<WorldView>,
}

impl WorldViews {
    /// Returns two pictures: the observer's picture of the scene, and the world view, which is a copy of it
    /// with the camera drawn in it. There, the camera's viewport shows the camera's own picture. Returns
    /// `None` if the world view is not shown or cannot be drawn.
    pub(super) fn get(
        &mut self,
        derived: &Derived,
        inputs: Inputs<'_>,
        objects: &mut Objects,
        last_good: Option<&GoodPicture>,
    ) -> Option<(Arc<WorldPicture>, FinishedView)> {
        let Inputs { session, sizes, watch, .. } = inputs;
        let (size, good) = (sizes.world?, objects.good()?.clone());
        let observer_camera = session.shown.observer?.camera(size[0], size[1]).resolve().ok()?;
        let WorldViews { pictures, view } = self;
        let world = pictures.get(inputs, objects, observer_camera)?;
        let shown = described(derived, inputs, &good, &world, last_good)?;
        let scene = ColoredScene { scene: &good.scene, colors: &good.colors };
        let view = view.get(shown, size, sizes.style, watch, |view, pixels| {
            let backdrop = view.backdrop(scene);
            let key = (Same(Arc::clone(&world)), backdrop.clone());
            let painted = pictures.backdrop.get(key, |(world, backdrop)| {
                watched(watch, WorkKind::Overlay, || {
                    let mut dots = pictures.painted.take(|_| true).unwrap_or_default();
                    dots.clone_from(&world.pixels);
                    backdrop.paint(&world.frame, &world.edges, &mut dots);
                    Arc::new(dots)
                })
            });
            pictures.painted.keep(&painted);
            let WorldPicture { pixels: traced, edges, .. } = &*world;
            let below = Below { traced, painted: &painted, edges };
            overlay::world(view, scene, &backdrop, below, pixels)
        });
        Some((world, view))
    }
}

/// Returns everything on which the world view's marks depend.
fn described(
    derived: &Derived,
    inputs: Inputs<'_>,
    good: &GoodWorld,
    world: &WorldPicture,
    last_good: Option<&GoodPicture>,
) -> Option<WorldView> {
    let Inputs { document, session, sizes, .. } = inputs;
    let observer = session.shown.observer?;
    let placing = HandleInputs {
        document,
        session,
        resolved: derived.resolved.as_ref(),
        selection: session.shown_selection(),
        observer: world.frame.camera(),
        scale: sizes.scale,
    };
    let picture = last_good.filter(|_| derived.fault.is_none()).map(|good| &good.picture);
    let without_marks = sizes.purpose != Purpose::Window;
    let spoken = session.shown.spoken.as_ref();
    let speaks_of_normal = spoken.map(|spoken| spoken.contains(&Concept::Normal));
    let handles = handles::placed::drawn(&placing);
    let figure = Figure {
        resolved: derived.resolved,
        inspection: derived.inspection.clone().map(Same),
        ray_point_t: session.shown.ray_point_t,
        ghost: ghost_camera(inputs, derived),
        answers: Arc::clone(&derived.answer_marks),
        items: session.shown.setup.items,
        highlighted: highlighted(inputs),
        names_all: spoken.is_some() || without_marks,
        shows_normal: session.highlighted() == Some(Concept::Normal)
            || speaks_of_normal.unwrap_or(without_marks),
        is_directed: session.live.directed.is_some(),
        up: handles.up,
        style: sizes.style,
        ..Figure::new(document.camera, observer)
    };
    Some(WorldView {
        figure,
        picture: picture.cloned().map(Same),
        generations: [good.generation, good.palette],
        enclosing: Arc::clone(&world.enclosing),
        frame: Same(Arc::clone(&world.frame)),
        handles: handles.marks,
        first_number: u32::from(session.shown.setup.count_from_one),
        scale: sizes.scale,
        is_clear: sizes.purpose.is_clear(),
        covered: sizes.covered.into_iter().flatten().collect(),
        without_marks,
    })
}

/// Returns the inputs of the camera view of a picture, without a highlighted concept and without the loupe.
pub(super) fn camera_view(
    Inputs { session, sizes, .. }: Inputs<'_>,
    good: &GoodPicture,
    size: [u32; 2],
) -> CameraView {
    CameraView {
        resolved: good.resolved,
        picture: Same(Arc::clone(&good.picture)),
        inspection: Some(Same(Arc::clone(&good.inspection))),
        size: size.map(|n| n as usize),
        items: session.shown.setup.items,
        first_number: u32::from(session.shown.setup.count_from_one),
        scale: sizes.scale,
        style: sizes.style,
        highlighted: None,
        loupe: None,
        without_marks: sizes.purpose != Purpose::Window,
    }
}

/// The observer's picture of the scene.
#[derive(Debug)]
pub(super) struct WorldPicture {
    /// The traced frame, in which the overlay looks up the object and its `t` at each pixel.
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) pixels: Vec<Color32>,
    /// The borders between the objects; none if the picture is subsampled.
    edges: Vec<EdgeBlend>,
    pub(super) enclosing: Enclosing,
    /// The picture's subsampling.
    pub(super) subsampling: Subsampling,
}

/// The inputs of a trace: the observer, the generation number of the objects, and the spheres that are left
/// out for the observer.
type WorldTraceKey = (ResolvedCamera, u64, Enclosing);

/// A cache of the observer's pictures.
#[derive(Debug, Default)]
pub(super) struct WorldPictures {
    enclosing: Memo<(u64, DVec3, DVec3), Enclosing>,
    fineness: Memo<WorldTraceKey, Subsampling>,
    /// The last frame, which can be recoloured without tracing.
    frame: Memo<(WorldTraceKey, Subsampling), Arc<Frame<f32>>>,
    /// The last picture. The last part of its key is the generation number of the colours.
    picture: Memo<(WorldTraceKey, Subsampling, u64), Arc<WorldPicture>>,
    shown: Spares<WorldPicture, 2>,
    /// The last picture with a backdrop painted over it.
    backdrop: Memo<(Same<WorldPicture>, Backdrop), Arc<Vec<Color32>>>,
    painted: Spares<Vec<Color32>, 2>,
    /// Number of pictures of the observer traced so far.
    pub(super) traced: u64,
}

impl WorldPictures {
    /// Returns the observer's picture of the last valid scene, without the spheres that would hide the
    /// camera; `None` if there was no valid scene yet.
    pub(super) fn get(
        &mut self,
        Inputs { document, sizes, watch, .. }: Inputs<'_>,
        objects: &mut Objects,
        observer: ResolvedCamera,
    ) -> Option<Arc<WorldPicture>> {
        let (good, eye) = (objects.good()?.clone(), document.camera.eye);
        let enclosing = self.enclosing.get((good.generation, eye, observer.eye()), |_| {
            Arc::new(enclosing(&good.scene, eye, observer.eye()))
        });
        let scene = objects.observed(&enclosing)?;
        let color_of = |i: u32| good.colors[i as usize];
        let colors = (Shade::Object, color_of);
        let trace_key = (observer, good.generation, enclosing);
        let subsampling = self.fineness.at_most(trace_key.clone(), sizes.subsampling);
        let picture =
            self.picture.get((trace_key, subsampling, good.palette), |(trace_key, ..)| {
                let mut fresh = None;
                let frame = self.frame.get((trace_key.clone(), subsampling), |_| {
                    self.traced += 1;
                    let old = self.shown.take(|_| true);
                    let spare =
                        old.and_then(|old| Arc::into_inner(old.frame).zip(Some(old.pixels)));
                    let image = observer.image();
                    let raster = subsampling.raster(image, [image.width(), image.height()]);
                    let (outputs, memory) = (Outputs::default(), (spare, watch));
                    let mut traced =
                        trace_picture(&scene, &observer, &raster, outputs, colors, memory);
                    watched(watch, WorkKind::Trace, || {
                        paint_key_light(&traced.0, &scene, color_of, &mut traced.1);
                    });
                    if subsampling == Subsampling::NONE {
                        fresh = Some(traced.1);
                        return Arc::new(traced.0);
                    }
                    // The overlay looks up the object at every screen pixel, so the frame must have a value for
                    // each of them.
                    fresh = Some(raster.spread(image, &traced.1));
                    Arc::new(traced.0.spread())
                });
                let pixels = fresh.unwrap_or_else(|| {
                    let mut pixels = repainted(&frame, &scene, colors, watch);
                    paint_key_light(&frame, &scene, color_of, &mut pixels);
                    pixels
                });
                let enclosing = Arc::clone(&trace_key.2);
                let edges = match subsampling {
                    Subsampling::NONE => {
                        watched(watch, WorkKind::Trace, || edge_blends(&frame, &scene))
                    }
                    _ => Vec::new(),
                };
                Arc::new(WorldPicture { frame, pixels, edges, enclosing, subsampling })
            });
        self.shown.keep(&picture);
        Some(picture)
    }
}

/// Direction towards the light, in the observer's u, v, w.
const TOWARD: DVec3 = DVec3::new(-0.45, 0.65, 0.61);

/// Fraction of the light that comes from the observer's eye.
const FROM_EYE: f64 = 0.3;

/// Shades the spheres of a frame with the observer's light. All other pixels keep their colours.
pub(super) fn paint_key_light(
    frame: &Frame<f32>,
    scene: &Scene,
    color_of: impl Fn(u32) -> Rgb + Sync,
    pixels: &mut [Color32],
) {
    let (camera, raster) = (frame.camera(), frame.raster());
    let width = raster.columns().len();
    if width == 0 || pixels.len() != frame.t.len() || frame.object.len() != frame.t.len() {
        return;
    }
    let toward = camera.basis().to_world_from_camera(TOWARD).normalize();
    pixels.par_chunks_mut(width).enumerate().for_each(|(index, pixels)| {
        let part = index * width..(index + 1) * width;
        let trace_key = frame.object[part.clone()].iter().zip(&frame.t[part]).zip(raster.columns());
        for (pixel, ((object, t), column)) in pixels.iter_mut().zip(trace_key) {
            if *object == NO_OBJECT {
                continue;
            }
            let position = Pixel { row: raster.rows()[index], column: *column };
            if let Some(sphere) = scene.spheres().get(*object as usize) {
                let light = light_on(camera, position, f64::from(*t), sphere.center, toward);
                *pixel = opaque(lambert(color_of(*object), light));
            }
        }
    });
}

/// Returns the brightness, from 0 to 1, of the point where a pixel's ray meets a sphere at `t`. `toward` is
/// the unit vector towards the light.
fn light_on(camera: &ResolvedCamera, pixel: Pixel, t: f64, center: DVec3, toward: DVec3) -> f64 {
    let ray = camera.ray_of_pixel(pixel);
    let out = (ray.at(t) - center).normalize_or_zero();
    let facing = -out.dot(ray.direction.normalize_or_zero());
    // If the eye is inside the sphere, it sees the inner side of the surface, whose normal points to the
    // centre.
    let wrapped = 0.5 + 0.5 * facing.signum() * out.dot(toward);
    (FROM_EYE * facing.abs() + (1.0 - FROM_EYE) * wrapped).clamp(0.0, 1.0)
}

/// The inputs of a derivation: the document, the settings, and the lines to which it is reduced.
type DerivationKey = (Document, DerivationSettings, Option<Formulas>);

/// The last derivation.
pub(super) type LastDerivation = Memo<DerivationKey, Arc<Derivation>>;

/// Returns the derivation; `None` if the layout does not show it.
pub(super) fn derived_lines(
    last: &mut LastDerivation,
    Inputs { document, session, .. }: Inputs<'_>,
    derived: &Derived,
) -> Option<Arc<Derivation>> {
    let only = session.shown.formulas.clone();
    if !session.shown.setup.layout.shows_derivation() && only.is_none() {
        return None;
    }
    let settings = DerivationSettings {
        selection: session.shown_selection(),
        sections: match only {
            Some(_) => DerivationSections::default(),
            None => session.shown.sections,
        },
        numbers: NumberFormat {
            rounding: session.number_style().rounding(),
            exact: session.preferences.exact_forms,
            from_one: session.shown.setup.count_from_one,
        },
        fault: derived.fault,
        t: match session.exercises.question().given {
            Given::PointAt { t, .. } if matches!(only, Some(Formulas::Solution(_))) => Some(t),
            _ => None,
        },
        by_coordinate: only.iter().flat_map(Formulas::concepts).any(|concept| {
            matches!(concept, Concept::Equation { step: EquationStep::Coordinate, .. })
        }),
    };
    Some(last.get((document.clone(), settings, only), |(document, settings, only)| {
        let whole = derivation(&DerivationInputs {
            document,
            resolved: derived.resolved.as_ref(),
            scene: derived.scene.as_deref(),
            inspection: derived.inspection.as_deref(),
            settings: *settings,
        });
        Arc::new(match only {
            Some(Formulas::About(concepts)) => whole.reduced_to(concepts),
            Some(Formulas::Solution(concepts)) => whole.solution(concepts),
            Some(Formulas::Recap) => whole.recap(),
            None => whole,
        })
    }))
}

/// Returns the plot; `None` if the layout does not show it or there is no ray.
pub(super) fn plot(
    Inputs { document, session, sizes, .. }: Inputs<'_>,
    derived: &Derived,
) -> Option<Plot> {
    if session.shown.setup.layout != ViewLayout::Plot {
        return None;
    }
    let scheme = sizes.style.scheme();
    let (resolved, scene) = (derived.resolved.as_ref()?, derived.scene.as_deref()?);
    let inspection = derived.inspection.as_deref()?;
    let ray = session.shown_selection().inside(resolved.image()).exact_ray(resolved).ok()?;
    let named = shown(scene, inspection).into_iter().map(|object| Named {
        object,
        title: document.title_of(object as usize),
        name: document.label_of(object as usize),
        color: opaque(scheme.object(object, document.color_of(object))),
    });
    Some(Plot::new(scene, &ray, named, session.shown.ray_point_t))
}

#[cfg(test)]
mod tests {
    use pinhole_core::{Camera, Outputs, Raster, Sphere, trace_as};

    use super::*;

    #[test]
    fn a_ball_is_lighter_above_on_the_left_and_nowhere_black() {
        let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.5 };
        let scene = Scene::new(vec![ball], vec![]).expect("a scene");
        let camera = Camera::CANONICAL.resolve().expect("a camera");
        let raster = Raster::full(camera.image());
        let frame = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
        let mut pixels = vec![Color32::BLACK; raster.len()];
        paint_key_light(&frame, &scene, |_| [200; 3], &mut pixels);
        let at = |u: f64, v: f64| {
            let (row, column) = ((0.5 - v) * 400.0, (0.5 + u) * 400.0);
            pixels[row as usize * 400 + column as usize].r()
        };
        assert!(at(-0.12, 0.15) > at(0.0, 0.0) && at(0.0, 0.0) > at(0.15, -0.18));
        assert!(at(0.15, -0.18) > 60);
        assert_eq!(at(0.45, 0.45), 0, "beside it");
    }
}
