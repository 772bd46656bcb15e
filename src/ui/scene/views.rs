//! The two views: mouse and keyboard input, the display of the finished pictures, and presenter mode's
//! pen, which draws over the pictures.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::epaint::PathStroke;
use egui::text::LayoutJob;
use egui::{
    Align2, Area, Color32, CursorIcon, FontId, Galley, Label, Order, Pos2, Rect, Response,
    RichText, Sense, Ui, Vec2, pos2, vec2,
};
use pinhole_core::steering::Keep;
use pinhole_core::{DVec2, ImageSize, ResolvedCamera, Selection};
use pinhole_exchange::document::Document;
use pinhole_figure::overlay::{self, PointShown, Under};
use pinhole_figure::readings::ReadingValue;
use pinhole_figure::symbols::typeset_message;
use pinhole_figure::typesetting::notation::unbroken;
use pinhole_figure::typesetting::{labels, theme};
use pinhole_figure::{Concept, HoverSource, Hovered, Item, NumberStyle, Observer, ViewSize};
use pinhole_lecture::numbers::grouped;

use crate::model::interaction::{HANDLE_REACH, MARK_REACH, WHEEL_ZOOM};
use crate::model::session::presenting::{PEN_COLORS, Pen};
use crate::model::{Session, ViewLayout};
use crate::ui::action::{LookAction, Observe, Switch, request};
use crate::ui::commands_table::{self, When, instruction};
use crate::ui::scene::dragging::{dragged_ray_point, sphere_at};
use crate::ui::scene::view_rects::{STRIP, ViewRects, above, strip};
use crate::ui::scene::{gizmo, readouts};
use crate::ui::widgets::{ResponseExt as _, ViewTexture, inside, keep_arrows, may_explain};
use crate::view::derive::{Derived, FinishedView, ViewSizes};

/// Name of the world view, on the screen and for screen readers.
pub(crate) const WORLD: &str = "World view";
/// Name of the camera view.
pub(crate) const CAMERA: &str = "Camera view";

/// Returns the sizes of the two views, in physical pixels.
pub(crate) fn sizes(ui: &Ui, rects: &ViewRects) -> ViewSizes {
    ViewSizes {
        world: rects.world.map(|rect| physical(ui, rect)),
        camera: rects.camera.map(|rect| physical(ui, rect)),
        covered: covered_dots(ui, rects),
        scale: ui.ctx().pixels_per_point(),
        style: theme::style(ui),
        ..ViewSizes::default()
    }
}

/// Returns the rectangles that the camera view and the rest of the page cover of the world view, relative to
/// its top left corner.
fn covered(rects: &ViewRects, world: Rect) -> [Option<Rect>; 2] {
    let camera = rects.camera.filter(|_| !rects.has_world_inset());
    [camera, Some(rects.rest)].map(|rect| {
        let inside = rect?.intersect(world);
        inside.is_positive().then(|| inside.translate(-world.min.to_vec2()))
    })
}

/// Returns what covers the world view, its title and its gizmo included, in its physical pixels: left, top,
/// right and bottom.
fn covered_dots(ui: &Ui, rects: &ViewRects) -> [Option<[f32; 4]>; 4] {
    let scale = ui.ctx().pixels_per_point();
    let [camera, rest] = rects.world.map(|world| covered(rects, world)).unwrap_or_default();
    let title = rects.world.zip(rects.world_title);
    let title = title.map(|(world, title)| title.translate(-world.min.to_vec2()));
    let gizmo = rects.world.filter(|_| title.is_some());
    let gizmo =
        gizmo.and_then(|world| Some(gizmo::area(ui, world)?.translate(-world.min.to_vec2())));
    [camera, rest, title, gizmo].map(|rect| {
        let Rect { min, max } = rect? * scale;
        Some([min.x, min.y, max.x, max.y])
    })
}

/// Returns the size of the world view, and what covers it, in points.
pub(crate) fn world_size(rects: &ViewRects) -> Option<ViewSize> {
    let world = rects.world?;
    let area = |Rect { min, max }: Rect| [min.x, min.y, max.x, max.y].map(f64::from);
    let covered = covered(rects, world).map(|rect| rect.map(area));
    let size = ViewSize::new(world.width().into(), world.height().into());
    Some(ViewSize { covered, ..size })
}

/// Returns the size of an area in physical pixels.
pub(crate) fn physical(ui: &Ui, rect: Rect) -> [u32; 2] {
    let size = rect.size() * ui.ctx().pixels_per_point();
    let most = ui.input(|i| i.max_texture_side) as f32;
    [size.x.round().clamp(1.0, most) as u32, size.y.round().clamp(1.0, most) as u32]
}

/// Applies mouse and key input in the views. `second` is the name of the second picture. `shown` holds
/// the values of the last frame, to which the input refers.
pub(crate) fn inputs(
    ui: &mut Ui,
    rects: &ViewRects,
    second: &str,
    session: &mut Session,
    shown: &Derived,
) {
    let mut views = Vec::new();
    let mut areas = [(rects.world, WORLD), (rects.camera, CAMERA), (rects.second, second)];
    // What comes later is above.
    if rects.has_world_inset() {
        areas.swap(0, 1);
    }
    for (rect, name) in areas {
        let Some(rect) = rect else { continue };
        let response = view(ui, rect, name);
        // A double click may be on a handle.
        if let (WORLD, Some(observer)) = (name, &session.shown.observer) {
            frame_clicked(ui, &response, observer, shown);
        }
        if !session.live.handles.is_busy {
            view_input(ui, &response, name, session, shown);
        }
        views.push(response.id);
    }
    let focused = ui.memory(|memory| memory.focused());
    let meant = focused.or(if views.len() == 1 { Some(views[0]) } else { None });
    if views.is_empty() || focused.is_some_and(|id| !views.contains(&id)) {
        return;
    }
    let is_meant = |name: &str| meant == Some(ui.scope_id().with(name));
    let pressed = commands_table::pressed(ui.ctx(), |when| match when {
        When::View => true,
        When::WorldView => is_meant(WORLD),
        When::CameraView => is_meant(CAMERA),
        _ => false,
    });
    pressed.into_iter().for_each(|(_, action)| request(ui.ctx(), action));
}

/// Creates a view's area, which accepts clicks, drags and the focus.
pub(crate) fn view(ui: &Ui, rect: Rect, name: &str) -> Response {
    let response = ui.interact(rect, ui.scope_id().with(name), Sense::click_and_drag());
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    keep_arrows(&response, true, true);
    response.with_role(Role::Image).named(name)
}

/// Sets the description of a view for screen readers.
pub(crate) fn speak(ui: &Ui, name: &str, text: &str) {
    let id = ui.scope_id().with(name);
    ui.ctx().accesskit_node_builder(id, |node| node.set_description(text));
}

/// Returns the description of the selected ray for screen readers.
pub(crate) fn spoken(shown: &Derived, document: &Document, style: NumberStyle) -> String {
    if let Some(fault) = shown.fault {
        return typeset_message(fault);
    }
    let Some(inspection) = &shown.inspection else { return String::new() };
    let position = match inspection.pixel() {
        Some(pixel) => style.pixel(pixel),
        None => {
            let [u, v] = inspection.uv.to_array().map(|x| style.number(x));
            format!("u {u}, v {v}")
        }
    };
    match inspection.first_hit() {
        Some(hit) => {
            let object = document.title_of(hit.object as usize);
            let (t, point) = (style.equated(hit.t), ReadingValue::Vector(hit.point));
            format!("{position}: hits {object} at t {t}, point {}", style.equated_value(&point))
        }
        None => format!("{position}: hits nothing"),
    }
}

/// Returns the centre of the physical pixel under the mouse in a view, in physical pixels. A picture samples
/// each physical pixel at its centre.
fn dot_under(ui: &Ui, rect: Rect, pointer: Pos2) -> Vec2 {
    // Dividing a whole number by the zoom and multiplying the quotient by it may yield slightly less.
    const ROUNDING: Vec2 = Vec2::splat(1.0 / 64.0);
    let at = (pointer - rect.min) * ui.ctx().pixels_per_point();
    (at + ROUNDING).floor() + Vec2::splat(0.5)
}

/// Converts a position in the camera's picture, in physical pixels, to (u, v) in the viewport. The
/// picture is in `rect`.
fn uv_at(ui: &Ui, rect: Rect, resolved: &ResolvedCamera, at: Vec2) -> DVec2 {
    let size = (rect.size() * ui.ctx().pixels_per_point()).round();
    overlay::camera_uv_at(resolved, [size.x as usize, size.y as usize], at.into())
}

/// Returns, as a selection, the pixel under the pointer in the camera view or, in the world view, on the viewport.
fn pixel_under(ui: &Ui, view: &str, rect: Rect, at: Pos2, shown: &Derived) -> Option<Selection> {
    let resolved = shown.resolved.as_ref()?;
    let at = dot_under(ui, rect, at);
    let uv = match view {
        WORLD => overlay::pick(resolved, shown.world_frame.as_ref()?, at.into())?,
        _ => uv_at(ui, rect, resolved, at),
    };
    Some(Selection::Pixel(resolved.pixel_of_uv(uv)?.pixel))
}

/// Selects the pixel that is clicked or, in the camera view, dragged over. A drag in the world view moves the point
/// on the ray or the observer.
fn view_input(ui: &Ui, view: &Response, name: &str, session: &mut Session, shown: &Derived) {
    let is_dragged = name != WORLD && view.dragged_by(egui::PointerButton::Primary);
    let at = view.interact_pointer_pos().filter(|_| view.clicked() || is_dragged);
    let selected = at.and_then(|at| pixel_under(ui, name, view.rect, at, shown));
    session.shown.selection = selected.unwrap_or(session.shown.selection);
    if name != WORLD {
        return;
    }
    if let Some(t) = dragged_ray_point(ui, view, session.shown.ray_point_t, shown) {
        session.shown.ray_point_t = Some(t);
        return;
    }
    if let Some(observer) = &mut session.shown.observer {
        move_observer(ui, view, observer);
        zoom(ui, view, observer, shown);
    }
}

/// Moves the observer, the camera of the world view, with the mouse: drag to orbit, drag with Shift or another
/// button to pan.
fn move_observer(ui: &Ui, response: &Response, observer: &mut Observer) {
    let shift = ui.input(|i| i.modifiers.shift);
    let delta = response.drag_delta();
    let height = response.rect.height().max(1.0);
    let (dx, dy) = (f64::from(delta.x / height), f64::from(delta.y / height));
    if delta != Vec2::ZERO {
        if response.dragged_by(egui::PointerButton::Primary) && !shift {
            observer.orbit(dx, dy);
        } else {
            observer.pan(dx, dy);
        }
    }
}

/// Zooms to what is under the pointer by wheel or pinch.
fn zoom(ui: &Ui, response: &Response, observer: &Observer, shown: &Derived) {
    let factor = wheel_zoom(ui);
    if response.contains_pointer()
        && factor != 1.0
        && let Some(under) = under_pointer(ui, response, observer, shown)
    {
        request(ui.ctx(), Observe::ZoomTo(under, factor));
    }
}

/// Frames the sphere or the camera that was double-clicked, or everything.
fn frame_clicked(ui: &Ui, response: &Response, observer: &Observer, shown: &Derived) {
    if response.double_clicked()
        && let Some(under) = under_pointer(ui, response, observer, shown)
    {
        let framed = match under.of {
            Under::Camera => Observe::FrameCamera,
            Under::Sphere(sphere) => Observe::FrameSphere(sphere),
            Under::Ground => Observe::FrameAll,
        };
        request(ui.ctx(), framed);
    }
}

/// Returns the point of the world under the pointer.
fn under_pointer(
    ui: &Ui,
    response: &Response,
    observer: &Observer,
    shown: &Derived,
) -> Option<PointShown> {
    let frame = shown.world_frame.as_deref()?;
    let at = dot_under(ui, response.rect, ui.input(|i| i.pointer.latest_pos())?);
    let reach = HANDLE_REACH as f32 * ui.ctx().pixels_per_point();
    let (scene, camera) = (shown.scene.as_deref(), shown.resolved.as_ref());
    Some(overlay::point_at(scene, camera, frame, observer.target(), (at.into(), reach)))
}

/// Returns the factor by which wheel and pinch enlarge a view.
pub(crate) fn wheel_zoom(ui: &Ui) -> f64 {
    let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta(), i.zoom_delta()));
    f64::from(pinch) * f64::from(scroll.y * WHEEL_ZOOM).exp()
}

/// Maximum number of objects in a scene for which the camera view finds the object under the pointer.
const ASKED_OBJECTS: usize = 4096;

/// Returns the pointer's position if it hovers the view of this name.
fn pointer_in(ui: &Ui, name: &str) -> Option<Pos2> {
    let response = ui.ctx().read_response(ui.scope_id().with(name))?;
    response.hover_pos().filter(|_| response.hovered())
}

/// Returns what is under the mouse in a view: the concept of the nearest mark, or else the object. If a ray
/// follows the pointer, that ray's marks are ignored, because they are always under the pointer.
pub(crate) fn hovered(
    ui: &Ui,
    rects: &ViewRects,
    shown: &Derived,
    ray_follows: bool,
) -> Option<Hovered> {
    if ui.input(|i| i.pointer.any_down()) {
        return None;
    }
    let per_point = ui.ctx().pixels_per_point();
    let position = |rect: Rect, name| Some((pointer_in(ui, name)? - rect.min) * per_point);
    let mark = |view: &Option<FinishedView>, at: Vec2| {
        let follows =
            |concept| matches!(concept, Concept::Ray | Concept::Direction | Concept::Pixel);
        let marks = view.iter().flat_map(|shown| shown.marks.iter());
        let asked = marks.filter(|mark| !(ray_follows && mark.concept.is_some_and(follows)));
        overlay::concept_at(asked, at.into(), MARK_REACH * per_point)
    };
    let in_world = |rect| {
        let at = position(rect, WORLD)?;
        mark(&shown.world_view, at).or_else(|| sphere_at(shown, at).map(Concept::Object))
    };
    let in_camera = |rect| {
        let at = position(rect, CAMERA)?;
        mark(&shown.camera_view, at).or_else(|| object_in_picture(ui, shown, rect, at))
    };
    let concept = rects.world.and_then(in_world).or_else(|| rects.camera.and_then(in_camera))?;
    Some(Hovered { concept, by: HoverSource::View })
}

/// Returns the object at a position of the camera view. While presenting, ignores planes: the pointer often
/// rests on a floor or a wall, and highlighting it would dim everything else.
fn object_in_picture(ui: &Ui, shown: &Derived, rect: Rect, at: Vec2) -> Option<Concept> {
    let (resolved, scene) = (shown.resolved.as_ref()?, shown.scene.as_ref()?);
    if scene.len() > ASKED_OBJECTS {
        return None;
    }
    let ray = resolved.exact_ray_at(uv_at(ui, rect, resolved, at)).ok()?;
    let object = scene.first_hit_of(&ray)?.object;
    let is_ground = object as usize >= scene.spheres().len();
    let is_ignored = is_ground && theme::installed(ui.ctx()).presenting;
    (!is_ignored).then_some(Concept::Object(object))
}

/// Returns, as a selection, the pixel under the mouse, either in the camera view or on the viewport in the
/// world view.
pub(crate) fn pointed_ray(ui: &Ui, rects: &ViewRects, shown: &Derived) -> Option<Selection> {
    if shown.fault.is_some() || ui.input(|i| i.pointer.any_down()) {
        return None;
    }
    let at = |rect: Option<Rect>, view| Some((view, rect?, pointer_in(ui, view)?));
    let (view, rect, at) = at(rects.camera, CAMERA).or_else(|| at(rects.world, WORLD))?;
    pixel_under(ui, view, rect, at, shown)
}

/// Distance of a tooltip from the pointer, in points, so that it does not cover what the pointer is on.
const FROM_POINTER: f32 = 14.0;

/// Shows a tooltip with the numbers of the ray under the mouse, or else the name of the hovered concept.
pub(crate) fn show_pointed(ui: &Ui, session: &Session, shown: &Derived, document: &Document) {
    // The class watches a scan.
    if !may_explain(ui.ctx()) || session.live.scanned_pixels.is_some() {
        return;
    }
    let style = session.number_style();
    let words = match (session.live.hovered, &shown.inspection) {
        (Some(Hovered { by: HoverSource::Derivation | HoverSource::Numbers, .. }), _) => return,
        (
            None | Some(Hovered { concept: Concept::Object(_) | Concept::Pixel, .. }),
            Some(found),
        ) if session.live.pointed_ray.is_some() => readouts::ray_text(found, document, style),
        (Some(Hovered { concept, .. }), _) => {
            concept.description(|object| document.title_of(object as usize))
        }
        (None, _) => return,
    };
    let id = ui.scope_id().with("pointed");
    egui::Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), id, egui::PopupAnchor::Pointer)
        .gap(FROM_POINTER)
        .show(|ui| {
            let words = Label::new(RichText::new(words).size(15.0));
            ui.add(words.wrap_mode(egui::TextWrapMode::Extend))
        });
}

/// Width of a view, in points, below which its title omits the image's size and the button of `eye_keeps`.
const NARROW: f32 = 310.0;

/// Shows the titles above the views, each with a button that maximises the view.
pub(crate) fn strips(ui: &mut Ui, rects: &ViewRects, session: &Session, image: ImageSize) {
    let title = |ui: &mut Ui, rect: Rect, text: String, hint: &str, own: ViewLayout| {
        strip(ui, rect, |ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let alone = session.shown.setup.layout == own;
                let (label, to) =
                    if alone { ("Both views", ViewLayout::Both) } else { ("Maximise", own) };
                ui.small_button(label).asks(LookAction::Layout(to));
                if own == ViewLayout::World && rect.width() >= NARROW {
                    eye_keeps(ui, session.preferences.eye_keeps);
                }
                // The title gets the width that the buttons leave.
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    // A drag that begins on it moves the observer.
                    let title = Label::new(RichText::new(text).strong()).selectable(false);
                    ui.add(title.truncate()).on_hover_text(hint);
                });
            });
        });
    };
    if let Some(rect) = rects.world_title {
        let hint = "Drag: orbit. Shift+drag or right drag: pan. Wheel: zoom to what is there. Double click: frame it. F: show everything. Drag a \
                    handle to move it.";
        title(ui, rect, WORLD.to_owned(), hint, ViewLayout::World);
    }
    if let (Some(world), ViewLayout::Both) = (rects.world, session.shown.setup.layout) {
        let foot = world.with_min_y(world.bottom() - STRIP);
        let shows_all = session.shown.setup.items.shows(Item::ViewAndUp);
        let dragged = if shows_all { "eye, at or up" } else { "eye" };
        let hint = instruction(ui.ctx(), &format!("Drag {dragged}. Click a pixel."));
        let label = Label::new(RichText::new(hint).weak()).selectable(false);
        strip(ui, foot, |ui| drop(ui.add(label)));
    }
    if let Some(rect) = rects.camera_area {
        let text = match rect.width() < NARROW {
            true => CAMERA.to_owned(),
            false => {
                let [width, height] = [image.width(), image.height()].map(|n| grouped(n.into()));
                format!("{CAMERA}, {width} × {height} pixels")
            }
        };
        let hint = "Click: select a pixel. Right drag: look around. Middle drag or Shift+right drag: orbit \
                    around at. Wheel: enlarge pixels. Ctrl+wheel: field of view.";
        title(ui, above(rect), text, hint, ViewLayout::Camera);
    }
}

/// Shows a button that says whether an eye moved in the world view keeps looking at *at* or keeps its view
/// direction. A click switches between the two.
fn eye_keeps(ui: &mut Ui, keeps: Keep) {
    let text = if keeps == Keep::At { "Eye orbits at" } else { "Eye travels" };
    let hint = "Eye orbits at: a moved eye keeps looking at the same point. Eye travels: it keeps its view \
                direction. Alt switches while dragging.";
    let button = ui.small_button(text).on_hover_text(hint);
    button.asks(LookAction::Toggle(Switch::EyeTravels));
}

/// Shows a view's finished picture with its labels.
pub(crate) fn show(
    ui: &Ui,
    rect: Rect,
    shown: &FinishedView,
    texture: &mut ViewTexture,
    dimmed: bool,
) {
    let tint = if dimmed { Color32::from_gray(130) } else { Color32::WHITE };
    let texture = texture.upload(ui.ctx(), &shown.image);
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter_at(rect).image(texture, rect, whole, tint);
    if !dimmed {
        let painter = ui.painter_at(rect);
        let per_point = ui.ctx().pixels_per_point();
        for label in shown.labels.iter() {
            labels::write_label(&painter, rect.min, per_point, label);
        }
    }
}

/// Draws the frame of a picture that is an inset of another one.
pub(crate) fn frame_inset(ui: &Ui, rect: Rect) {
    let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
    let (frame, fill) = (rect.expand(4.0), ui.visuals().panel_fill);
    ui.painter().rect(frame, 4.0, fill, stroke, egui::StrokeKind::Inside);
}

/// Size of the text of a badge on a picture, in points.
const MARK: f32 = 15.0;

/// Writes black text on amber in the lower right corner of a picture.
pub(crate) fn badge(ui: &mut Ui, rect: Rect, text: &str) {
    let font = FontId::proportional(MARK);
    let most = (rect.width() - 16.0).max(20.0);
    let galley = ui.painter().layout(text.to_owned(), font, Color32::BLACK, most);
    let band = Align2::RIGHT_BOTTOM.align_size_within_rect(galley.size() + vec2(16.0, 8.0), rect);
    ui.painter_at(rect).rect_filled(band, 0.0, Color32::from_rgb(0xff, 0xc8, 0x3d));
    inside(ui, band.shrink2(vec2(8.0, 4.0)), |ui| {
        ui.label(RichText::new(text).size(MARK).color(Color32::BLACK));
    });
}

/// Maximum distance of a reason's text from the edges of its band, in points.
const REASON_MARGIN: f32 = 16.0;

/// Writes the reason why a picture is out of date across that picture, shortened if it is too long for it.
pub(crate) fn reason(ui: &mut Ui, rect: Rect, text: &str) {
    let usual = if theme::installed(ui.ctx()).presenting { 24.0 } else { 17.0 };
    let side = REASON_MARGIN.min(0.1 * rect.width());
    let width = (rect.width() - 2.0 * side).max(1.0);
    let galley = |size: f32| {
        let font = FontId::proportional(size);
        let row = ui.fonts_mut(|fonts| fonts.row_height(&font));
        let mut job = LayoutJob::simple(unbroken(text), font, Color32::WHITE, width);
        job.halign = egui::Align::Center;
        job.wrap.max_rows = ((rect.height() - REASON_MARGIN) / row).max(1.0) as usize;
        ui.painter().layout_job(job)
    };
    // The largest size at which all of the text fits.
    let sizes = [usual, 0.8 * usual, 0.6 * usual].map(galley);
    let has_room = |galley: &&Arc<Galley>| !galley.elided;
    let galley = sizes.iter().find(has_room).unwrap_or(&sizes[2]).clone();
    let height = (galley.size().y + 40.0).min(rect.height());
    let band = Rect::from_center_size(rect.center(), vec2(rect.width(), height));
    ui.painter().rect_filled(band, 0.0, Color32::from_rgb(0x7a, 0x14, 0x00));
    let position = Rect::from_center_size(band.center(), vec2(width, galley.size().y));
    let response = ui.put(position, Label::new(galley));
    // Screen readers get the text without the non-breaking spaces.
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(text));
}

/// Name of the area that the pen draws on, for screen readers.
const PEN: &str = "Pen";
/// Width of the pen's line, in points.
const PEN_LINE: f32 = 3.0;
/// Width of the casing around the line, in points.
const PEN_CASING: f32 = 5.0;
/// Radius of the pen's pointer, in points.
const PEN_POINTER: f32 = 5.0;
/// Colours of the pen on dark and on light ground, which occur nowhere else in the views.
const PEN_INKS: [[Color32; PEN_COLORS]; 2] = [
    [
        Color32::from_rgb(0xff, 0xe6, 0x00),
        Color32::from_rgb(0xff, 0x3b, 0x30),
        Color32::from_rgb(0x00, 0xe5, 0xff),
    ],
    [
        Color32::from_rgb(0x10, 0x10, 0x18),
        Color32::from_rgb(0xb0, 0x00, 0x10),
        Color32::from_rgb(0x00, 0x38, 0xa8),
    ],
];

/// Draws with presenter mode's pen on `area`, everything below the lesson's text. The pen's pointer is large
/// enough to be seen from the back row of a classroom.
pub(crate) fn pen(ui: &Ui, area: Rect, pen: &mut Pen) {
    let id = ui.scope_id().with(PEN);
    let layer = Area::new(id).order(Order::Foreground).fixed_pos(area.min).constrain(false);
    let (inks, casing) = match ui.visuals().dark_mode {
        true => (PEN_INKS[0], Color32::BLACK),
        false => (PEN_INKS[1], Color32::WHITE),
    };
    layer.show(ui.ctx(), |ui| {
        let (_, response) = ui.allocate_exact_size(area.size(), Sense::drag());
        let response = response.named(PEN).on_hover_cursor(CursorIcon::Crosshair);
        let share = |at: Pos2| ((at - area.min) / area.size().max(Vec2::splat(1.0))).into();
        let at = response.interact_pointer_pos();
        if let (true, Some(from)) =
            (response.drag_started(), ui.input(|i| i.pointer.press_origin()))
        {
            pen.press(share(from));
        }
        if let (true, Some(at)) = (response.dragged(), at) {
            pen.draw_to(share(at));
        }
        for stroke in &pen.strokes {
            let at = |&[x, y]: &[f32; 2]| area.min + vec2(x, y) * area.size();
            let points: Vec<Pos2> = stroke.points.iter().map(at).collect();
            let ink = inks[stroke.color % PEN_COLORS];
            for (width, color) in [(PEN_CASING, casing), (PEN_LINE, ink)] {
                ui.painter().line(points.clone(), PathStroke::new(width, color));
            }
        }
        if let Some(at) = at.or(response.hover_pos()) {
            let edge = (PEN_CASING - PEN_LINE, casing);
            ui.painter().circle(at, PEN_POINTER, inks[pen.color % PEN_COLORS], edge);
        }
    });
}
