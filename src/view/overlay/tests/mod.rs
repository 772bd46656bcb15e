//! A stage for the overlay's tests: a world view with everything in it.

mod camera_view;
mod dots;
mod ghost;
mod highlighted;
mod loupe;
mod marks;
mod wild;

use egui::Color32;
use pinhole_core::{
    Camera, DVec2, DVec3, Frame, ImageSize, Outputs, Plane, Raster, ResolvedCamera, Rgb, Scene,
    Selection, Shade, Sphere, shade, trace_as,
};

pub(super) use super::*;
use crate::model::inspection::Inspection;
use crate::model::observer::{Observer, ViewSize, enclosing, traced_scene};
pub(super) use crate::model::overlay_items::{Item, OverlayItems};

/// A world view with everything in it.
struct Stage {
    camera: Camera,
    resolved: Option<ResolvedCamera>,
    scene: Scene,
    enclosing: Vec<u32>,
    observer: Observer,
    frame: Frame<f32>,
    picture: Option<Picture>,
    inspection: Option<Inspection>,
    items: OverlayItems,
}

static NO_HANDLES: Handles =
    Handles { marks: Vec::new(), stems: Vec::new(), guides: Vec::new(), arrow: None, up: None };

const SIZE: (u32, u32) = (240, 180);

fn opaque([r, g, b]: Rgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

fn color_of(index: u32) -> Rgb {
    pinhole_exchange::document::default_color(index as usize)
}

fn sphere(x: f64, y: f64, z: f64, radius: f64) -> Sphere {
    Sphere { center: DVec3::new(x, y, z), radius }
}

impl Stage {
    fn new(camera: Camera, spheres: Vec<Sphere>, planes: Vec<Plane>) -> Stage {
        let scene = Scene::new(spheres, planes).expect("a scene");
        let observer = Observer::frame_all(&camera, &scene, ViewSize::of_aspect(4.0 / 3.0));
        Stage::seen_by(camera, scene, observer)
    }

    fn seen_by(camera: Camera, scene: Scene, observer: Observer) -> Stage {
        let resolved = camera.resolve().ok();
        let seen_from = observer.camera(SIZE.0, SIZE.1).resolve().expect("observers have a basis");
        let enclosing = enclosing(&scene, camera.eye, seen_from.eye());
        let seen = traced_scene(&scene, &enclosing);
        let image = Raster::full(seen_from.image());
        let frame = trace_as(&seen, &seen_from, &image, Outputs::default());
        let picture = resolved.as_ref().map(|resolved| {
            let raster = Raster::shown_on(resolved.image(), 40, 40);
            let frame = trace_as::<f32>(&scene, resolved, &raster, Outputs::default());
            let pixels = shade(&frame, &scene, Shade::Lambert, color_of, opaque);
            Picture { raster, image: resolved.image(), pixels }
        });
        let inspection = resolved.as_ref().map(|resolved| {
            Inspection::new(resolved, &scene, Selection::Uv(DVec2::new(0.02, 0.01)))
        });
        let items = OverlayItems::default();
        Stage { camera, resolved, scene, enclosing, observer, frame, picture, inspection, items }
    }

    fn view(&self) -> WorldView<'_> {
        WorldView {
            camera: &self.camera,
            resolved: self.resolved.as_ref(),
            picture: self.picture.as_ref(),
            inspection: self.inspection.as_ref(),
            scene: &self.scene,
            enclosing: &self.enclosing,
            color_of: &color_of,
            observer: &self.observer,
            frame: &self.frame,
            items: self.items,
            scale: 1.0,
            style: Style::Light,
            highlighted: None,
            ray_point_t: None,
            handles: &NO_HANDLES,
            ghost: None,
            answer_marks: &[],
            is_clear: false,
            names_all: true,
        }
    }

    /// Returns the observer's picture with flat shading.
    fn dots(&self) -> Vec<Color32> {
        shade(&self.frame, &self.scene, Shade::Object, color_of, opaque)
    }

    fn resolve(&self) -> &ResolvedCamera {
        self.resolved.as_ref().expect("a camera with a basis")
    }

    fn to_screen(&self, point: DVec3) -> DVec2 {
        let [x, y] = world_position_of(&self.frame, point).expect("a point in sight");
        DVec2::new(x.into(), y.into())
    }
}

fn canonical() -> Stage {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
    Stage::new(Camera::CANONICAL, vec![sphere(0.0, 0.0, -5.0, 1.0)], vec![wall])
}

fn image(width: u32, height: u32) -> ImageSize {
    ImageSize::new(width, height).expect("an image size")
}

/// Returns an observer on the +x side, who sees -z to the right.
fn from_the_right(target: DVec3, distance: f64) -> Observer {
    Observer::new(target, std::f64::consts::FRAC_PI_2, 0.0, distance)
}

fn points(mark: &Mark) -> Vec<[f32; 2]> {
    match &mark.shape {
        Shape::Line { points, .. } | Shape::Polygon { points } => points.clone(),
        Shape::Disc { center, .. } => vec![*center],
    }
}

/// Checks that labels are inside the picture and do not overlap.
fn check_labels(drawing: &Drawing, size: DVec2) {
    let boxes: Vec<(DVec2, DVec2)> = drawing
        .labels
        .iter()
        .map(|label| {
            let pair = |[x, y]: [f32; 2]| DVec2::new(x.into(), y.into());
            (pair(label.position), pair(label.half_extent(drawing.scale)))
        })
        .collect();
    for (k, (center, half)) in boxes.iter().enumerate() {
        assert!((*center - *half).cmpge(DVec2::ZERO).all(), "{:?}", drawing.labels[k]);
        assert!((*center + *half).cmple(size).all(), "{:?}", drawing.labels[k]);
        for (other, other_half) in &boxes[..k] {
            let apart = (*center - *other).abs() - *half - *other_half;
            assert!(apart.max_element() > -1e-3, "{:?}", drawing.labels[k]);
        }
    }
}

/// Paints the world view over the observer's shaded picture.
fn painted(view: &WorldView, dots: &mut [Color32]) -> Drawing {
    let (traced, backdrop) = (dots.to_vec(), Backdrop::new(view));
    backdrop.paint(view.frame, dots);
    let painted = dots.to_vec();
    world(view, &backdrop, Below { traced: &traced, painted: &painted }, dots)
}
