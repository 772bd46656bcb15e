//! The image of a text that gives its size, or the ratio of its sides, or neither.

use pinhole_core::ImageSize;

/// The image of `height` rows that has this ratio of width to height.
fn image_of_height(height: u32, aspect: f64) -> Option<ImageSize> {
    let width = (f64::from(height) * aspect).round();
    (1.0..=f64::from(ImageSize::MAX))
        .contains(&width)
        .then(|| ImageSize::new(width as u32, height).ok())?
}

/// An image near the one at hand whose sides have this ratio, so that its pixels are square: as high
/// or as wide, else by tens of pixels, else any. A ratio may have been rounded to a float.
fn image_in_ratio(at_hand: ImageSize, aspect: f64) -> Option<ImageSize> {
    let (w, h) = (at_hand.width(), at_hand.height());
    let by_height = |height: u32, off: f64| {
        image_of_height(height, aspect).filter(|image| (image.aspect() / aspect - 1.0).abs() <= off)
    };
    let are_tens =
        |image: &ImageSize| [image.width(), image.height()].iter().all(|n| n.is_multiple_of(10));
    [1e-12, 1e-6].into_iter().find_map(|off| {
        let as_wide = (f64::from(w) / aspect).round().clamp(1.0, f64::from(ImageSize::MAX)) as u32;
        let as_wide = || by_height(as_wide, off).filter(are_tens);
        let mut heights: Vec<u32> = (1..=h.saturating_mul(2)).collect();
        heights.sort_by_key(|height| height.abs_diff(h));
        let near = || heights.iter().filter_map(|height| by_height(*height, off));
        by_height(h, off)
            .or_else(as_wide)
            .or_else(|| near().find(are_tens))
            .or_else(|| near().next())
    })
}

/// The image where a format gives the ratio of its sides and no more: that at hand if it has this
/// ratio, else one near it.
pub(crate) fn image_of_ratio(
    at_hand: ImageSize,
    aspect: f64,
    program: &str,
    notes: &mut Vec<String>,
) -> ImageSize {
    let image = match (at_hand.aspect() - aspect).abs() <= 1e-9 * aspect {
        true => at_hand,
        false => image_in_ratio(at_hand, aspect)
            .or_else(|| image_of_height(at_hand.height(), aspect))
            .unwrap_or(at_hand),
    };
    let unsaid = format!("{program} does not say how many pixels there are");
    notes.push(size_note(&unsaid, image, " taken"));
    image
}

/// Returns the note on an image whose size is not given: what is not said, and why this size is taken.
pub(crate) fn size_note(unsaid: &str, image: ImageSize, taken: &str) -> String {
    format!("{unsaid}: {} × {}{taken}", image.width(), image.height())
}

/// The size of an image as read.
pub(crate) fn image_of(width: f64, height: f64) -> Result<ImageSize, String> {
    let whole = |x: f64| x.fract() == 0.0 && (1.0..=f64::from(ImageSize::MAX)).contains(&x);
    if !(whole(width) && whole(height)) {
        return Err(format!("it must be whole numbers from 1 to {}", ImageSize::MAX));
    }
    ImageSize::new(width as u32, height as u32).map_err(|error| error.to_string())
}
