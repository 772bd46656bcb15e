//! Writes a document as the text of a scene file.

use std::path::Path;

use pinhole_core::{Basis, Camera, DVec3, Orientation, Plane, Sphere};

use super::{VERSION, edit, note_to_block, read};
use crate::document::{Document, Item, StoredObserver};
use crate::error::is_hidden;
use crate::images;

/// Returns the text of a scene file. Where values have not changed, the comments and layout of a
/// previous text are kept.
///
/// The text reads back to the same document, bit for bit in every number.
pub fn to_text(document: &Document, previous: Option<&str>) -> String {
    let plain = fresh(document);
    let edited = previous.and_then(|previous| edit::edited(document, previous));
    // TOML allows many layouts. If one of them cannot be kept, it is better to lose it than to write a
    // wrong value.
    let reads_back = |text: &String| {
        read::document(text, Path::new(""), None, false).is_ok_and(|read| fresh(&read) == plain)
    };
    let kept = edited.filter(reads_back);
    kept.unwrap_or(plain)
}

/// Returns the text of a new scene file. Documents that are equal bit for bit have equal texts.
pub(super) fn fresh(document: &Document) -> String {
    let mut text = note_to_block(&document.note);
    if !text.is_empty() {
        text.push('\n');
    }
    text.push_str(&format!("pinhole = {VERSION}\n"));
    if let Some(csv) = &document.csv_spheres {
        text.push_str(&format!("spheres = {}\n", string(&csv.path)));
    }
    let Camera { viewport, image, .. } = &document.camera;
    text.push_str(&format!("\n[camera]\n{}", camera_fields(&document.camera)));
    text.push_str(&format!(
        "\n[viewport]\nwidth = {}\nheight = {}\ndistance = {}\n",
        number(viewport.width),
        number(viewport.height),
        number(viewport.distance)
    ));
    text.push_str(&format!("\n[image]\nwidth = {}\nheight = {}\n", image.width(), image.height()));
    if let Some(observer) = &document.observer {
        let fields = observer_fields(observer).join("\n");
        text.push_str(&format!("\n[observer]\n{fields}\n"));
    }
    for item in document.spheres.iter() {
        let Sphere { center, radius } = item.shape;
        let shape = format!("center = {}\nradius = {}\n", vector(center), number(radius));
        text.push_str(&format!("\n[[sphere]]\n{}", fields(item, shape)));
    }
    for item in document.planes.iter() {
        let Plane { point, normal } = item.shape;
        let shape = format!("point = {}\nnormal = {}\n", vector(point), vector(normal));
        text.push_str(&format!("\n[[plane]]\n{}", fields(item, shape)));
    }
    text
}

fn camera_fields(camera: &Camera) -> String {
    let way = match camera.orientation {
        Orientation::At { at, up } => format!("at = {}\nup = {}\n", vector(at), vector(up)),
        Orientation::View { view, up } => format!("view = {}\nup = {}\n", vector(view), vector(up)),
        Orientation::Basis(Basis { u, v, w }) => {
            format!("basis = {{ u = {}, v = {}, w = {} }}\n", vector(u), vector(v), vector(w))
        }
    };
    format!("eye = {}\n{way}", vector(camera.eye))
}

/// Returns the fields of an observer, as both scene files and lesson files write them.
pub fn observer_fields(observer: &StoredObserver) -> [String; 4] {
    let StoredObserver { target, azimuth, elevation, distance } = *observer;
    let field = |name: &str, x: f64| format!("{name} = {}", number(x));
    [
        format!("target = {}", vector(target)),
        field("azimuth", azimuth),
        field("elevation", elevation),
        field("distance", distance),
    ]
}

fn fields<S>(item: &Item<S>, shape: String) -> String {
    let name = item.name.as_ref().map(|name| format!("name = {}\n", string(name)));
    let color = item.color.map(|rgb| format!("color = \"{}\"\n", images::color_to_text(rgb)));
    [name, Some(shape), color].into_iter().flatten().collect()
}

fn vector(v: DVec3) -> String {
    format!("[{}, {}, {}]", number(v.x), number(v.y), number(v.z))
}

/// Formats a number as the shortest TOML float that reads back to the same `f64`, including the sign of
/// zero.
fn number(x: f64) -> String {
    let text = format!("{x:?}");
    // Rust writes NaN in a way that is not TOML.
    if x.is_nan() { "nan".to_owned() } else { text }
}

/// Formats a text as a basic TOML string on one line, as which JSON's strings are valid.
fn string(text: &str) -> String {
    let shown = |c: char| match is_hidden(c) {
        true => format!("\\u{:04x}", u32::from(c)),
        false => c.to_string(),
    };
    serde_json::Value::from(text).to_string().chars().map(shown).collect()
}
