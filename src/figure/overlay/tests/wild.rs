//! Drawings stay within bounds whatever is typed into the fields.

use pinhole_core::{Basis, Camera, DVec2, DVec3, Orientation, Plane, Scene, Sphere, Viewport};
use proptest::prelude::*;

use super::*;

/// Returns a strategy for coordinates: of every magnitude, and ordinary ones.
fn wild() -> impl Strategy<Value = f64> {
    let any_size = (-1.0..1.0f64, -300..300i32).prop_map(|(m, e)| m * 10f64.powi(e));
    prop_oneof![4 => -8.0..8.0f64, 1 => any_size, 1 => Just(0.0)]
}

fn wild_vector() -> impl Strategy<Value = DVec3> {
    (wild(), wild(), wild()).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn wild_extent() -> impl Strategy<Value = f64> {
    let any_size = (-300..300i32).prop_map(|e| 10f64.powi(e));
    prop_oneof![4 => 0.1..4.0f64, 1 => any_size]
}

fn wild_camera() -> impl Strategy<Value = Camera> {
    let orientation = prop_oneof![
        (wild_vector(), wild_vector()).prop_map(|(at, up)| Orientation::At { at, up }),
        (wild_vector(), wild_vector()).prop_map(|(view, up)| Orientation::View { view, up }),
        Just(Orientation::Basis(Basis::CANONICAL)),
    ];
    let viewport = (wild_extent(), wild_extent(), wild_extent());
    (wild_vector(), orientation, viewport, 1..600u32, 1..600u32).prop_map(
        |(eye, orientation, (width, height, distance), w, h)| Camera {
            eye,
            orientation,
            viewport: Viewport { width, height, distance },
            image: image(w, h),
        },
    )
}

fn wild_scene() -> impl Strategy<Value = Scene> {
    let spheres = prop::collection::vec((wild_vector(), wild_extent()), 0..3);
    let planes = prop::collection::vec((wild_vector(), wild_vector()), 0..3);
    (spheres, planes).prop_map(|(spheres, planes)| {
        let spheres = spheres.into_iter().map(|(center, radius)| Sphere { center, radius });
        let planes = planes.into_iter().map(|(point, normal)| Plane { point, normal });
        let planes = planes.filter(|plane| plane.normal != DVec3::ZERO);
        Scene::new(spheres.collect(), planes.collect()).expect("a scene")
    })
}

fn check_drawing(drawing: &Drawing) {
    let size = DVec2::new(SIZE.0.into(), SIZE.1.into());
    for mark in &drawing.marks {
        for [x, y] in points(mark) {
            // Lines are cut a little beyond the border; arrowheads and discs extend a little farther.
            let inside = x.abs() < 3.0 * SIZE.0 as f32 && y.abs() < 3.0 * SIZE.1 as f32;
            assert!(x.is_finite() && y.is_finite() && inside, "{mark:?}");
        }
        let (Shape::Line { width: extent, .. } | Shape::Disc { radius: extent, .. }) = mark.shape
        else {
            continue;
        };
        assert!(extent.is_finite() && extent > 0.0 && extent < 20.0, "{mark:?}");
    }
    check_labels(drawing, size);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn wild_cameras_make_tame_drawings(
        camera in wild_camera(),
        scene in wild_scene(),
        turn in (-4.0..4.0f64, -2.0..2.0f64, 0.01..20.0f64),
    ) {
        let mut observer = Observer::frame_all(&drawn_of(&camera, &scene), ViewSize::of_aspect(4.0 / 3.0));
        observer.orbit(turn.0, turn.1);
        observer.zoom(observer.target(), turn.2, [1e-300, f64::MAX]);
        let stage = Stage::seen_by(camera, scene, observer);
        check_drawing(&stage.drawing());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn wild_cameras_are_painted(camera in wild_camera(), scene in wild_scene()) {
        let stage = Stage::new(camera, scene.spheres().to_vec(), scene.planes().to_vec());
        let mut dots = stage.dots();
        stage.painted(&stage.view(), &mut dots);
        prop_assert!(dots.iter().all(|dot| dot.is_opaque()));
    }
}
