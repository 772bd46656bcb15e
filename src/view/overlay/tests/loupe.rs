//! The loupe in the camera view.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, DVec2, PixelOfUv, Raster, Scene};

use super::*;

/// Returns the drawing of the loupe alone over a canonical camera of `pixels` x `pixels`.
fn drawing(uv: DVec2, pixels: u32, size: usize, count_from_one: bool) -> (Drawing, PixelOfUv) {
    let resolved =
        Camera { image: image(pixels, pixels), ..Camera::CANONICAL }.resolve().expect("a camera");
    let inspection = Inspection::new(&resolved, &Scene::default(), Selection::Uv(uv));
    let position = inspection.image_position.expect("a place in the image");
    let [rows, columns] = loupe_window(&position, resolved.image(), 9);
    let raster = Raster::part(rows, columns);
    let pixels = vec![Color32::GRAY; raster.len()];
    let picture = Picture { raster, image: resolved.image(), pixels };
    let loupe = Loupe { picture: picture.clone(), shown_pixels: 9, count_from_one };
    let view = CameraView {
        resolved,
        picture: Same(Arc::new(picture)),
        inspection: Some(Same(Arc::new(inspection))),
        size: [size, size],
        items: OverlayItems::NONE.with(Item::Loupe, true),
        scale: 1.0,
        style: Style::Light,
        highlighted: None,
        loupe: Some(Arc::new(loupe)),
        without_marks: false,
    };
    (view.drawing(None), position)
}

fn texts(drawing: &Drawing) -> Vec<&str> {
    drawing.labels.iter().map(|label| label.text.as_str()).collect()
}

/// Returns the corners of everything drawn except the line to the selected position.
fn corners(drawing: &Drawing) -> Vec<DVec2> {
    let marks = drawing.marks.iter().skip(1).flat_map(points);
    marks.map(|[x, y]| DVec2::new(x.into(), y.into())).collect()
}

#[test]
fn the_warm_up_s_place_is_the_corner_of_four_named_pixels() {
    let (drawing, _) = drawing(DVec2::new(0.2, -0.1), 400, 600, false);
    let said = ["row 239", "row 240", "279", "280", "column", "corner of 4 pixels"];
    assert_eq!(texts(&drawing), said);
    let (from_one, _) = self::drawing(DVec2::new(0.2, -0.1), 400, 600, true);
    assert_eq!(texts(&from_one)[..4], ["row 240", "row 241", "280", "281"]);
    // The cross is at the common corner of the four frames.
    let lines: Vec<_> = drawing.marks.iter().map(points).collect();
    let cross: Vec<_> = lines.iter().rev().take(2).collect();
    let middle = |line: &Vec<[f32; 2]>| {
        [0, 1].map(|k| 0.5 * (f64::from(line[0][k]) + f64::from(line[1][k])))
    };
    for line in cross {
        let [x, y] = middle(line);
        let frames = lines.iter().rev().skip(2).take(4);
        let at_corner = |frame: &Vec<[f32; 2]>| {
            let distance = |[u, v]: [f32; 2]| (f64::from(u) - x).hypot(f64::from(v) - y);
            frame.iter().map(|corner| distance(*corner)).fold(f64::INFINITY, f64::min)
        };
        assert!(frames.map(at_corner).all(|distance| distance < 0.05));
    }
}

#[test]
fn the_loupe_says_what_kind_of_place_it_is() {
    for (uv, said) in [
        (DVec2::new(0.2, -0.12), "between 2 pixels"),
        (DVec2::new(0.25, -0.15), "centre of a pixel"),
        (DVec2::new(0.23, -0.16), "inside a pixel"),
    ] {
        let (drawing, _) = drawing(uv, 10, 300, false);
        assert_eq!(texts(&drawing).last(), Some(&said), "{uv}");
    }
}

#[test]
fn the_loupe_is_in_the_view_and_not_over_the_place() {
    for (u, v) in [(0.2, -0.1), (0.0, 0.0), (-0.4, 0.4), (0.499, -0.499), (0.0, 0.45)] {
        for (pixels, size) in [(400, 320), (400, 900), (2000, 640)] {
            let (drawing, _) = drawing(DVec2::new(u, v), pixels, size, false);
            let corners = corners(&drawing);
            let (low, high) = corners
                .iter()
                .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), corner| {
                    (low.min(*corner), high.max(*corner))
                });
            let size = size as f64;
            assert!(low.min_element() >= 0.0 && high.max_element() <= size, "{low} {high}");
            let at = size * DVec2::new(0.5 + u, 0.5 - v);
            assert!(at.cmplt(low).any() || at.cmpgt(high).any(), "{at} in {low} {high}");
        }
    }
}

#[test]
fn at_the_image_s_border_there_are_fewer_pixels() {
    let (drawing, position) = drawing(DVec2::new(-0.5, 0.5), 400, 600, false);
    let [rows, columns] = loupe_window(&position, image(400, 400), 9);
    assert_eq!((rows, columns), (0..4, 0..4));
    assert_eq!(texts(&drawing)[..3], ["row 0", "0", "column"]);
}
