//! Names and values of handles, in words.

use pinhole_core::{DVec3, Object, Orientation, Selection};
use pinhole_exchange::document::Document;
use pinhole_lecture::numbers::written;

use crate::model::session::handles::{Corner, Handle, HandleValues};

/// Returns a handle's name: `eye`, `sphere 0 “ball”: radius`.
pub fn label(handle: Handle, document: &Document) -> String {
    let titled = |k: usize, what: &str| format!("{}: {what}", document.title_of(k));
    let name = match handle {
        Handle::Eye => "eye",
        Handle::At => match document.camera.orientation {
            Orientation::View { .. } => "view",
            _ => "at",
        },
        Handle::Up => "up",
        Handle::Roll => "roll around w",
        Handle::Dolly => "dolly along w",
        Handle::Corner(Corner { is_right, is_top }) => {
            let row = if is_top { "top" } else { "bottom" };
            let column = if is_right { "right" } else { "left" };
            return format!("viewport, {row} {column} corner");
        }
        Handle::Distance => "viewport's distance",
        Handle::Pixel => "selected pixel",
        Handle::Center(k) => return titled(k, "centre"),
        Handle::Radius(k) => return titled(k, "radius"),
        Handle::Point(k) => return titled(k, "point"),
        Handle::Normal(k) => return titled(k, "normal"),
    };
    name.to_owned()
}

/// Returns `(1, 0, −2.5)`, rounded to `digits` digits.
fn vector(v: DVec3, digits: usize) -> String {
    let [x, y, z] = v.to_array().map(|x| written(x, digits));
    format!("({x}, {y}, {z})")
}

/// Returns a handle's value: `eye = (1, 0, 0)`. Rows and columns are counted from 1 if `from_one`
/// is set.
pub fn value(handle: Handle, part: &HandleValues, digits: usize, from_one: bool) -> String {
    let camera = &part.camera;
    let number = |x: f64| written(x, digits);
    let named = |name: &str, v: DVec3| format!("{name} = {}", vector(v, digits));
    let at = match camera.orientation {
        Orientation::At { at, .. } => named("at", at),
        Orientation::View { view, .. } => named("view", view),
        Orientation::Basis(basis) => named("𝐰", basis.w),
    };
    let viewport = camera.viewport;
    match handle {
        Handle::Eye => named("eye", camera.eye),
        Handle::At => at,
        Handle::Up => named("up", camera.up()),
        Handle::Roll => match camera.orientation {
            Orientation::Basis(basis) => named("𝐯", basis.v),
            _ => named("up", camera.up()),
        },
        Handle::Dolly => match camera.orientation {
            Orientation::At { at, .. } => {
                let far = number(at.distance(camera.eye));
                format!("{}, {far} from at", named("eye", camera.eye))
            }
            _ => named("eye", camera.eye),
        },
        Handle::Corner(_) => {
            format!("width = {}, height = {}", number(viewport.width), number(viewport.height))
        }
        Handle::Distance => format!("distance = {}", number(viewport.distance)),
        Handle::Pixel => match part.selection {
            Selection::Pixel(pixel) => {
                let first = u32::from(from_one);
                format!("row {}, column {}", pixel.row + first, pixel.column + first)
            }
            Selection::Uv(uv) => format!("(u, v) = ({}, {})", number(uv.x), number(uv.y)),
        },
        Handle::Center(_) | Handle::Radius(_) | Handle::Point(_) | Handle::Normal(_) => {
            match (part.object, handle) {
                (Some((_, Object::Sphere(sphere))), Handle::Center(_)) => {
                    named("centre", sphere.center)
                }
                (Some((_, Object::Sphere(sphere))), _) => {
                    format!("radius = {}", number(sphere.radius))
                }
                (Some((_, Object::Plane(plane))), Handle::Point(_)) => named("point", plane.point),
                (Some((_, Object::Plane(plane))), _) => named("normal", plane.normal),
                (None, _) => String::new(),
            }
        }
    }
}
