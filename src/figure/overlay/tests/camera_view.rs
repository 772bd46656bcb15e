//! The camera view.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, DVec2, Raster, Scene, Viewport};

use super::*;

#[test]
fn pixel_edges_in_the_camera_view_lie_where_colours_change() {
    let stage = canonical();
    let resolved = Camera { image: image(5, 3), ..Camera::CANONICAL }.resolve().expect("a camera");
    let pixels = (0..15).map(|k| Color32::from_gray(100 + 10 * k)).collect();
    let picture =
        Picture { raster: Raster::full(resolved.image()), image: resolved.image(), pixels };
    let size = [63, 40];
    let inspection = None;
    let view = CameraView {
        resolved,
        picture: Same(Arc::new(picture)),
        inspection,
        size,
        items: OverlayItems::NONE,
        first_number: 0,
        scale: 1.0,
        style: Style::Light,
        highlighted: None,
        loupe: None,
        without_marks: false,
    };
    let mut plain = vec![Color32::BLACK; 63 * 40];
    camera(&view, None, &mut plain);
    let mut lined = plain.clone();
    camera(&CameraView { items: stage.items.with(Item::Marks, false), ..view }, None, &mut lined);
    for (k, (plain_dot, lined_dot)) in plain.iter().zip(&lined).enumerate() {
        let (row, column) = (k / 63, k % 63);
        let new_column = column > 0 && plain[k] != plain[k - 1];
        let new_row = row > 0 && plain[k] != plain[k - 63];
        assert_eq!(plain_dot != lined_dot, new_column || new_row, "{row} {column}");
    }
}

#[test]
fn a_corner_of_four_pixels_has_four_frames_and_a_cross() {
    let resolved =
        Camera { image: image(10, 10), ..Camera::CANONICAL }.resolve().expect("a camera");
    let picture = Arc::new(Picture {
        raster: Raster::full(resolved.image()),
        image: resolved.image(),
        pixels: vec![Color32::GRAY; 100],
    });
    let frames_and_crosses = |uv: DVec2| {
        let inspection = Inspection::new(&resolved, &Scene::default(), Selection::Uv(uv));
        let view = CameraView {
            resolved,
            picture: Same(Arc::clone(&picture)),
            inspection: Some(Same(Arc::new(inspection))),
            size: [300, 300],
            items: OverlayItems::NONE.with(Item::Ray, true),
            first_number: 0,
            scale: 1.0,
            style: Style::Dark,
            highlighted: None,
            loupe: None,
            without_marks: false,
        };
        let lines: Vec<_> = view.drawing(None).marks.iter().map(points).collect();
        let is_diagonal = |line: &[[f32; 2]]| (0..2).all(|k| line[0][k] != line[1][k]);
        let frames = lines.iter().filter(|line| line.len() == 5).count();
        [frames, lines.iter().filter(|line| line.len() == 2 && is_diagonal(line)).count()]
    };
    assert_eq!(frames_and_crosses(DVec2::new(0.2, -0.1)), [4, 2]);
    assert_eq!(frames_and_crosses(DVec2::new(0.2, -0.15)), [2, 2]);
    assert_eq!(frames_and_crosses(DVec2::new(0.25, -0.15)), [1, 0]);
}

#[test]
fn camera_view_places_and_uv_are_inverses() {
    let viewport = Viewport { width: 3.0, height: 2.0, distance: 1.0 };
    let resolved = Camera { viewport, ..Camera::CANONICAL }.resolve().expect("a camera");
    let size = [600, 300];
    assert_eq!(camera_uv_at(&resolved, size, [0.0, 0.0]), DVec2::new(-1.5, 1.0));
    assert_eq!(camera_uv_at(&resolved, size, [450.0, 300.0]), DVec2::new(0.75, -1.0));
    for uv in [DVec2::ZERO, DVec2::new(-1.2, 0.7), DVec2::new(1.5, -1.0)] {
        let back = camera_uv_at(&resolved, size, dot(position_of(&resolved, size, uv)));
        assert!(back.distance(uv) < 1e-6);
    }
}

#[test]
fn rows_and_columns_are_numbered_in_the_first_pixels() {
    let resolved = Camera { image: image(4, 4), ..Camera::CANONICAL }.resolve().expect("a camera");
    let (raster, pixels) = (Raster::full(resolved.image()), vec![Color32::GRAY; 16]);
    let picture = Picture { raster, image: resolved.image(), pixels };
    let view = CameraView {
        resolved,
        picture: Same(Arc::new(picture)),
        inspection: None,
        size: [200, 200],
        items: OverlayItems::NONE.with(Item::PixelNumbers, true).with(Item::Labels, true),
        first_number: 1,
        scale: 1.0,
        style: Style::Light,
        highlighted: None,
        loupe: None,
        without_marks: false,
    };
    let labels = view.drawing(None).labels;
    let texts: Vec<&str> = labels.iter().map(|label| label.text.as_str()).collect();
    // Both numbers of the first pixel are at its middle, so it has one.
    assert_eq!(texts, ["1", "2", "3", "4", "2", "3", "4", "W = 4", "H = 4"]);
    for (k, label) in labels[..4].iter().enumerate() {
        assert_eq!(label.position, [50.0 * (k as f32 + 0.5), 25.0], "{}", label.text);
    }
}
