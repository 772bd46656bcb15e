//! Tests of steering the camera by drags: each drag gives either a valid camera whose v has turned by
//! no more than the drag, or a typed error.

mod moves;
mod pointer;
mod poles;
mod single_parameter;
mod snap;
mod turns;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use pinhole_core::*;
use proptest::prelude::*;

fn vec3(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// Generates unit vectors, evenly distributed over all directions.
fn direction() -> impl Strategy<Value = DVec3> {
    (-1.0..1.0_f64, 0.0..TAU).prop_map(|(z, azimuth)| {
        let across = (1.0 - z * z).sqrt();
        vec3(across * azimuth.cos(), across * azimuth.sin(), z)
    })
}

/// Generates angles between up or -up and the view, half of them evenly distributed on a logarithmic
/// scale down to 1e-9.
fn gap() -> impl Strategy<Value = f64> {
    prop_oneof![1e-3..FRAC_PI_2, (-9.0..0.0_f64).prop_map(|power| 10_f64.powf(power))]
}

/// Generates cameras given by at, by view, or by hand. Eye and at are 1e-6 to 1e9 apart, and 0.1 to
/// 1000 times as far from the origin. Up has any length, and may be nearly parallel or opposite to the
/// view.
fn any_camera() -> impl Strategy<Value = Camera> {
    let aim = (direction(), direction(), gap(), any::<bool>());
    let sizes = (-6.0..9.0_f64, -1.0..3.0_f64, -6.0..6.0_f64, direction());
    (aim, sizes, 0..3_usize).prop_filter_map(
        "a basis",
        |((view, side, gap, is_behind), (size, out, length, position), kind)| {
            let across = (side - side.dot(view) * view).try_normalize()?;
            let pole = if is_behind { -view } else { view };
            let up = 10_f64.powf(length) * (gap.cos() * pole + gap.sin() * across);
            let size = 10_f64.powf(size);
            let eye = size * 10_f64.powf(out) * position;
            let orientation = Orientation::View { view: size * view, up };
            let viewport = Viewport { width: 0.4 * size, height: 0.3 * size, distance: size };
            let camera = Camera { eye, orientation, viewport, ..Camera::CANONICAL };
            let kinds = [OrientationKind::At, OrientationKind::View, OrientationKind::Basis];
            camera.given_by(kinds[kind]).ok().filter(|camera| camera.basis().is_ok())
        },
    )
}

/// Generates those cameras of [`any_camera`] for which [`is_calm`] is true.
fn calm_camera() -> impl Strategy<Value = Camera> {
    any_camera().prop_filter("calm", is_calm)
}

/// Returns the point around which a camera orbits: at, or what view or a basis set by hand lead to.
fn pivot(camera: &Camera) -> DVec3 {
    match camera.orientation {
        Orientation::At { at, .. } => at,
        Orientation::View { view, .. } => camera.eye + view,
        Orientation::Basis(basis) => camera.eye - camera.viewport.distance * basis.w,
    }
}

/// Returns true if rounding errors are far below the tolerances of the tests of drags: eye and at are
/// not much closer to each other than to the origin, and up is not nearly parallel to the view.
fn is_calm(camera: &Camera) -> bool {
    let reach = camera.eye.distance(pivot(camera));
    camera.eye.length() < 100.0 * reach
        && camera.up_angle().is_ok_and(|up| up.conditioning < 1000.0)
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    let (a, b) = (a.normalize(), b.normalize());
    a.cross(b).length().atan2(a.dot(b))
}

fn v_turn(a: &Camera, b: &Camera) -> f64 {
    angle(a.basis().unwrap().v, b.basis().unwrap().v)
}

/// Returns the angle between the views of two cameras.
fn view_turn(a: &Camera, b: &Camera) -> f64 {
    angle(a.basis().unwrap().w, b.basis().unwrap().w)
}

/// Returns the angle between the view and up or -up, whichever is smaller.
fn pole_gap(camera: &Camera) -> f64 {
    let angle = camera.up_angle().unwrap().angle;
    angle.min(PI - angle)
}

fn assert_valid(camera: &Camera) {
    let Basis { u, v, w } = camera.basis().unwrap();
    for (a, b) in [(u, v), (v, w), (w, u)] {
        assert!(a.dot(b).abs() < 1e-15, "{camera:?}");
        assert!((a.length() - 1.0).abs() < 1e-15, "{camera:?}");
    }
    assert!((u.cross(v) - w).length() < 1e-15, "{camera:?}");
    assert!(w.dot(camera.view().normalize()) < -1.0 + 1e-15, "{camera:?}");
}

fn given_up(camera: &Camera) -> Option<DVec3> {
    match camera.orientation {
        Orientation::At { up, .. } | Orientation::View { up, .. } => Some(up),
        Orientation::Basis(_) => None,
    }
}
