//! The loupe in the camera view.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, DVec2, PixelOfUv, Raster, Scene};

use super::*;
use crate::Concept;

/// Number of pixels that the loupe shows across and down.
fn shown() -> u32 {
    5
}

/// Returns the drawing of the loupe alone over a canonical camera of `pixels` x `pixels`.
fn drawing(uv: DVec2, pixels: u32, size: usize, count_from_one: bool) -> (Drawing, PixelOfUv) {
    let (view, position) = view(uv, pixels, size, count_from_one);
    (view.drawing(None), position)
}

fn view(uv: DVec2, pixels: u32, size: usize, count_from_one: bool) -> (CameraView, PixelOfUv) {
    let resolved =
        Camera { image: image(pixels, pixels), ..Camera::CANONICAL }.resolve().expect("a camera");
    let inspection = Inspection::new(&resolved, &Scene::default(), Selection::Uv(uv));
    let position = inspection.image_position.expect("a place in the image");
    let [rows, columns] = loupe_window(&position, resolved.image(), shown());
    let raster = Raster::part(rows, columns);
    let pixels = vec![Color32::GRAY; raster.len()];
    let picture = Picture { raster, image: resolved.image(), pixels };
    let loupe = Loupe { picture: picture.clone(), shown_pixels: shown(), count_from_one };
    let view = CameraView {
        resolved,
        picture: Same(Arc::new(picture)),
        inspection: Some(Same(Arc::new(inspection))),
        size: [size, size],
        items: OverlayItems::NONE.with(Item::Loupe, true),
        first_number: 0,
        scale: 1.0,
        style: Style::Light,
        highlighted: None,
        loupe: Some(Arc::new(loupe)),
        without_marks: false,
    };
    (view, position)
}

/// Returns the smallest rectangle that contains these points.
fn around(points: impl IntoIterator<Item = DVec2>) -> [DVec2; 2] {
    points.into_iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], point| {
        [low.min(point), high.max(point)]
    })
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
    // The cross is at the common corner of the four pixels, in the middle of the frame around them.
    let lines: Vec<_> = drawing.marks.iter().rev().take(3).map(points).collect();
    let middle = |line: &Vec<[f32; 2]>| {
        let [low, high] = around(line.iter().map(|[x, y]| DVec2::new((*x).into(), (*y).into())));
        0.5 * (low + high)
    };
    let [down, across, frame] = [0, 1, 2].map(|k| middle(&lines[k]));
    assert!(down.distance(frame) < 0.05 && across.distance(frame) < 0.05);
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
    let [rows, columns] = loupe_window(&position, image(400, 400), shown());
    assert_eq!((rows, columns), (0..2, 0..2));
    assert_eq!(texts(&drawing)[..3], ["row 0", "0", "column"]);
}

/// Returns the smallest rectangle around the marked pixels in the loupe.
fn marked_pixels(drawing: &Drawing) -> [DVec2; 2] {
    let marks = drawing.marks.iter().filter(|mark| mark.concept == Some(Concept::Pixel));
    around(marks.flat_map(points).map(|[x, y]| DVec2::new(x.into(), y.into())))
}

#[test]
fn the_four_pixels_are_large_and_the_mark_leaves_them_in_sight() {
    let (view, _) = view(DVec2::new(0.2, -0.1), 400, 600, false);
    let mut dots = vec![Color32::TRANSPARENT; 600 * 600];
    let drawing = camera(&view, None, &mut dots);
    let [low, high] = marked_pixels(&drawing);
    assert!((0.5 * (high - low)).min_element() >= 50.0, "{low} {high}");
    let (low, high) = (low.as_uvec2(), high.as_uvec2());
    let inside: Vec<_> = (low.y..high.y)
        .flat_map(|y| &dots[(600 * y + low.x) as usize..(600 * y + high.x) as usize])
        .collect();
    let seen = inside.iter().filter(|dot| ***dot == Color32::GRAY).count();
    assert!(seen as f64 > 0.8 * inside.len() as f64, "{seen} of {}", inside.len());
}

#[test]
fn the_loupe_is_where_it_hides_least() {
    let uv = DVec2::new(0.2, -0.1);
    let (mut view, _) = view(uv, 400, 600, false);
    let place = |view: &CameraView| {
        let [low, high] = around(corners(&view.drawing(None)));
        [low.x + high.x > 600.0, low.y + high.y > 600.0]
    };
    assert_eq!(place(&view), [false, false], "the corner farthest from the selected position");
    // A ball in the upper left quarter of the picture.
    let image = view.resolved.image();
    let color = |k: u32| {
        let at = DVec2::new((k % 400).into(), (k / 400).into());
        if at.distance(DVec2::new(120.0, 120.0)) < 60.0 { Color32::RED } else { Color32::GRAY }
    };
    let pixels = (0..400 * 400).map(color).collect();
    view.picture = Same(Arc::new(Picture { raster: Raster::full(image), image, pixels }));
    assert_ne!(place(&view), [false, false]);
}
