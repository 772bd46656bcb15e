//! The zoom.

use pinhole_core::steering::*;
use pinhole_core::*;

#[test]
fn a_zoom_opens_the_field_of_view() {
    let wide = Camera::CANONICAL.zoomed(2.0).unwrap();
    assert_eq!(wide.viewport, Viewport { width: 2.0, height: 2.0, distance: 1.0 });
    assert_eq!(wide.viewport.vertical_fov(), std::f64::consts::FRAC_PI_2);
    assert_eq!(Camera { viewport: Viewport::CANONICAL, ..wide }, Camera::CANONICAL);
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Camera::CANONICAL.zoomed(factor);
        assert!(matches!(refused, Err(SteerError::NotPositive { field: "factor", .. })));
    }
    assert!(matches!(wide.zoomed(1e308), Err(SteerError::Camera(CameraError::Viewport(_)))));
}
