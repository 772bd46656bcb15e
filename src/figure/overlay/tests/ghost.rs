//! The ghost, a camera that is compared with the edited one, in the world view.

use pinhole_core::{Basis, Orientation};

use super::*;
use crate::overlay::drawing::Shape;

#[test]
fn all_lines_of_the_ghost_are_dashed_and_its_names_have_primes() {
    let stage = Stage::new(Camera::CANONICAL, vec![sphere(0.0, 0.0, -5.0, 1.0)], Vec::new());
    let ghost =
        Camera { eye: DVec3::new(0.6, 0.4, 0.3), ..stage.camera }.resolve().expect("a camera");
    let ghost = GhostCamera::frozen(&ghost);
    let alone = stage.drawing();
    let both = stage.view_of(|figure| figure.ghost = Some(ghost)).drawing(stage.scene());
    let more: Vec<_> = both.marks.iter().filter(|mark| !alone.marks.contains(mark)).collect();
    let lines = more.iter().filter(|mark| match &mark.shape {
        // The thinnest ones lead to labels.
        Shape::Line { points, width } => points.len() == 2 && *width > 1.0,
        _ => false,
    });
    let (dashed, solid): (Vec<&&Mark>, Vec<&&Mark>) = lines.partition(|mark| mark.hidden);
    // Four edges, four sides and three arrows, each whole or split into parts.
    assert!(dashed.len() >= 11 && solid.is_empty(), "{} {}", dashed.len(), solid.len());
    let mut names = both.labels.iter().map(|label| label.text.as_str());
    assert!(names.any(|name| name.ends_with('′')));
}

#[test]
fn what_a_ghost_shares_with_the_camera_is_drawn_once() {
    let stage = Stage::new(Camera::CANONICAL, Vec::new(), Vec::new());
    let (u, w) = (DVec3::NEG_Z, DVec3::X);
    let turned = Orientation::Basis(Basis { u, v: DVec3::Y, w });
    let ghost = Camera { orientation: turned, ..stage.camera }.resolve().expect("a camera");
    let ghost = Some(GhostCamera::frozen(&ghost));
    let both = stage.view_of(|figure| figure.ghost = ghost).drawing(stage.scene());
    let names = both.labels.iter().map(|label| label.text.as_str());
    let primed: Vec<&str> = names.filter(|name| name.ends_with('′')).collect();
    assert_eq!(primed, ["u′", "w′"]);
}
