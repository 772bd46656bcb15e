//! The stage of the overlay's tests: a world view with everything in it.

mod camera_view;
mod dots;
mod ghost;
mod ground;
mod highlighted;
mod loupe;
mod marks;
mod sight;
mod sphere_figure;
mod whiteboard;
mod wild;

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{
    Camera, DVec2, DVec3, Frame, ImageSize, NO_OBJECT, Outputs, Plane, Raster, ResolvedCamera, Rgb,
    Scene, Selection, Shade, Sphere, edge_blends, shade, trace_as,
};

pub(super) use super::*;
use crate::inspection::Inspection;
use crate::observer::{Observer, ViewSize, enclosing, traced_scene};
pub(super) use crate::overlay_items::{Item, OverlayItems};

/// A world view with everything in it.
struct Stage {
    camera: Camera,
    resolved: Option<ResolvedCamera>,
    scene: Scene,
    colors: Vec<Rgb>,
    enclosing: Arc<Vec<u32>>,
    observer: Observer,
    frame: Arc<Frame<f32>>,
    picture: Option<Arc<Picture>>,
    inspection: Option<Arc<Inspection>>,
    items: OverlayItems,
}

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
        let size = ViewSize::of_aspect(4.0 / 3.0);
        let observer = Observer::frame_all(&drawn_of(&camera, &scene), size);
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
            Arc::new(Picture { raster, image: resolved.image(), pixels })
        });
        let inspection = resolved.as_ref().map(|resolved| {
            let selection = Selection::Uv(DVec2::new(0.02, 0.01));
            Arc::new(Inspection::new(resolved, &scene, selection))
        });
        let items = OverlayItems::default();
        Stage {
            camera,
            resolved,
            colors: (0..scene.len() as u32).map(color_of).collect(),
            scene,
            enclosing: Arc::new(enclosing),
            observer,
            frame: Arc::new(frame),
            picture,
            inspection,
            items,
        }
    }

    fn view(&self) -> WorldView {
        let figure = Figure {
            inspection: self.inspection.clone().map(Same),
            items: self.items,
            ..Figure::new(self.camera, self.observer)
        };
        WorldView {
            figure,
            picture: self.picture.clone().map(Same),
            generations: [0; 2],
            enclosing: Arc::clone(&self.enclosing),
            frame: Same(Arc::clone(&self.frame)),
            handles: Vec::new(),
            first_number: 0,
            scale: 1.0,
            is_clear: false,
            covered: Vec::new(),
            without_marks: false,
        }
    }

    /// Returns the view with a change to what is drawn.
    fn view_of(&self, change: impl FnOnce(&mut Figure)) -> WorldView {
        let mut view = self.view();
        change(&mut view.figure);
        view
    }

    fn scene(&self) -> ColoredScene<'_> {
        ColoredScene { scene: &self.scene, colors: &self.colors }
    }

    fn drawing(&self) -> Drawing {
        self.view().drawing(self.scene())
    }

    /// Paints a world view over the observer's shaded picture.
    fn painted(&self, view: &WorldView, dots: &mut [Color32]) -> Drawing {
        let (traced, backdrop) = (dots.to_vec(), view.backdrop(self.scene()));
        let seen = traced_scene(&self.scene, &self.enclosing);
        let edges = &edge_blends(&view.frame, &seen)[..];
        backdrop.paint(&view.frame, edges, dots);
        let (traced, painted) = (&traced, &dots.to_vec());
        world(view, self.scene(), &backdrop, Below { traced, painted, edges }, dots)
    }

    /// Returns the observer's picture with flat shading.
    fn dots(&self) -> Vec<Color32> {
        shade(&self.frame, &self.scene, Shade::Object, color_of, opaque)
    }

    fn resolve(&self) -> &ResolvedCamera {
        self.resolved.as_ref().expect("a camera with a basis")
    }

    fn to_screen(&self, point: DVec3) -> DVec2 {
        world_position_of(self.frame.camera(), point).expect("a point in sight")
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

/// Returns a stage's drawing with checked labels. Its picture is small, and so are all lengths that are
/// measured in points.
fn small_drawing(stage: &Stage) -> Drawing {
    let drawing = WorldView { scale: 0.25, ..stage.view() }.drawing(stage.scene());
    check_labels(&drawing, DVec2::new(SIZE.0.into(), SIZE.1.into()));
    drawing
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
