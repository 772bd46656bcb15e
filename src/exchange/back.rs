//! From what a format says to a camera here, and whether it came back as it went.

use std::path::Path;

use pinhole_core::{
    Basis, Camera, DVec3, ImageSize, ORTHONORMAL_TOLERANCE, Orientation, Pixel, Plane,
    ResolvedCamera, Sphere, Viewport, extent_of_fov, fov_of_extent,
};

use super::affine::Affine;
use super::sheet::n;
use super::{Format, Taken, Text, Written};
use crate::document::Item;
use crate::formats::FileError;

/// Where a camera stands and how it is turned, as read: right, up and backwards of any length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stance {
    pub(crate) eye: DVec3,
    pub(crate) right: DVec3,
    pub(crate) up: DVec3,
    pub(crate) backwards: DVec3,
}

impl Stance {
    /// Of a camera that looks along its own -z with y up, by its frame in the world.
    pub(crate) fn of(frame: &Affine) -> Stance {
        Stance { eye: frame.at, right: frame.x, up: frame.y, backwards: frame.z }
    }

    /// The orientation and the eye, and whether they had to be mirrored for the world to be
    /// right-handed: a note says so, and what else is in this world must be mirrored, too.
    ///
    /// # Errors
    /// As `orientation`.
    pub(crate) fn right_handed(
        &self,
        notes: &mut Vec<String>,
    ) -> Result<(Orientation, DVec3, bool), String> {
        let mirrored = Basis::is_left_handed(self.right, self.up, self.backwards);
        let stance = if mirrored { self.mirrored() } else { *self };
        let orientation = stance.orientation(notes)?;
        if mirrored {
            notes.push(MIRRORED.to_owned());
        }
        Ok((orientation, stance.eye, mirrored))
    }

    /// The orientation, and what had to be straightened.
    ///
    /// # Errors
    /// What is wrong with the three, as "up and backwards are parallel".
    pub(crate) fn orientation(&self, notes: &mut Vec<String>) -> Result<Orientation, String> {
        let [right, up, backwards] = [self.right, self.up, self.backwards].map(without_noise);
        if let Ok(basis) = Basis::by_hand(right, up, backwards) {
            return Ok(Orientation::Basis(basis));
        }
        let unit = [right, up, backwards].map(|v| v.try_normalize());
        let [Some(u), Some(v), Some(w)] = unit else {
            return Err("one of its axes is (0, 0, 0): it must be a rotation".to_owned());
        };
        let off = Basis::error_of(u, v, w);
        if off > 0.02 {
            return Err(format!(
                "its axes are off a right angle by up to {}: it must be a rotation, without shear",
                n((off * 1e4).round() / 1e4)
            ));
        }
        let basis = Basis::straightened(v, w).map_err(|error| error.to_string())?;
        if off > ORTHONORMAL_TOLERANCE {
            notes.push(format!(
                "its axes are off a right angle by {off:.0e}: w is as given, v and u straightened"
            ));
        }
        Ok(Orientation::Basis(basis))
    }
}

/// What is made of a mirrored camera: the picture stays, the world is seen in a mirror.
pub(crate) const MIRRORED: &str = "its world is left-handed, Pinhole's is right-handed: every z is \
                                   negated, so that the picture is the same";

/// A world with every z negated.
pub(crate) trait Mirrored {
    #[must_use]
    fn mirrored(self) -> Self;
}

impl Mirrored for DVec3 {
    fn mirrored(self) -> DVec3 {
        DVec3::new(self.x, self.y, 0.0 - self.z)
    }
}

impl Mirrored for Stance {
    fn mirrored(self) -> Stance {
        Stance {
            eye: self.eye.mirrored(),
            right: self.right.mirrored(),
            up: self.up.mirrored(),
            backwards: self.backwards.mirrored(),
        }
    }
}

impl Mirrored for Vec<Item<Sphere>> {
    fn mirrored(mut self) -> Self {
        for sphere in &mut self {
            sphere.shape.center = sphere.shape.center.mirrored();
        }
        self
    }
}

impl Mirrored for Vec<Item<Plane>> {
    fn mirrored(mut self) -> Self {
        for plane in &mut self {
            plane.shape.point = plane.shape.point.mirrored();
            plane.shape.normal = plane.shape.normal.mirrored();
        }
        self
    }
}

impl Taken {
    /// A camera without objects.
    pub(crate) fn camera(camera: Camera, notes: Vec<String>) -> Taken {
        Taken { camera, spheres: Vec::new(), planes: Vec::new(), notes }
    }
}

/// The width or height that is seen under this angle; of all that are, the one with fewest digits.
pub(crate) fn extent(degrees: f64, distance: f64) -> f64 {
    let near = extent_of_fov(degrees.to_radians(), distance);
    shortest_where(near, |x| fov_of_extent(x, distance).to_degrees() == degrees)
}

/// The number with fewest digits near `x` that still does what is asked; `x` where none does.
pub(crate) fn shortest_where(x: f64, fits: impl Fn(f64) -> bool) -> f64 {
    (0..17)
        .filter_map(|digits| format!("{x:.digits$e}").parse::<f64>().ok())
        .find(|x| fits(*x))
        .unwrap_or(x)
}

/// The number with fewest digits that is within the roundings from `x`.
pub(crate) fn settled(x: f64, roundings: f64) -> f64 {
    if x.abs() <= roundings {
        return 0.0;
    }
    shortest_where(x, |y| (y - x).abs() <= roundings)
}

/// `ratio` times as much, in as few digits as keep the ratio to its last one.
pub(crate) fn in_ratio(x: f64, ratio: f64) -> f64 {
    if ratio == 1.0 {
        return x;
    }
    shortest_where(x * ratio, |y| (y / x / ratio - 1.0).abs() <= 2.0 * f64::EPSILON)
}

/// The viewport at `distance` that is seen under this vertical angle and is `aspect` times as wide as
/// high.
pub(crate) fn upright(degrees: f64, aspect: f64, distance: f64) -> Viewport {
    let height = extent(degrees, distance);
    Viewport { width: in_ratio(height, aspect), height, distance }
}

/// An axis whose parts that are a rounding from -1, 0 or 1 of its length are just that.
fn without_noise(axis: DVec3) -> DVec3 {
    let roundings = 4.0 * f64::EPSILON;
    let length = axis.length();
    DVec3::from_array(axis.to_array().map(|x| match (x / length).round() * length {
        whole if (x - whole).abs() <= roundings * length => settled(x, roundings * length),
        _ => x,
    }))
}

/// Those of a text's objects that could be read; of the others a note says how many there are, and
/// what is wrong with the first: no object spoils the camera. After so many faults that the text is of
/// another kind, it is read no further: each one's line takes a pass over the text.
pub(crate) fn readable<T>(
    objects: impl IntoIterator<Item = Result<T, FileError>>,
    what: &str,
    notes: &mut Vec<String>,
) -> Vec<T> {
    const ENOUGH: usize = 100;
    let (mut read, mut faults) = (Vec::new(), Vec::new());
    for object in objects {
        match object {
            Ok(object) => read.push(object),
            Err(fault) => faults.push(fault),
        }
        if faults.len() == ENOUGH {
            notes.push(format!("what follows the first {ENOUGH} of {what} left out is not read"));
            break;
        }
    }
    if let Some(first) = faults.first() {
        let line = first.place.map(|place| format!("line {}: ", place.line));
        let line = line.unwrap_or_default();
        notes.push(format!("{} of {what} left out: {line}{}", faults.len(), first.problem));
    }
    read
}

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
pub(crate) fn image_of_aspect(
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
    notes.push(size_taken(&unsaid, image, " taken"));
    image
}

/// What is said of an image whose size is not given: what is not said, and why this size is taken.
pub(crate) fn size_taken(unsaid: &str, image: ImageSize, taken: &str) -> String {
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

/// Whether what was written, read again, sends out other rays; by how much.
pub(super) fn difference(
    format: &Format,
    written: &Written,
    resolved: &ResolvedCamera,
) -> Option<String> {
    const ENOUGH: f64 = 1e-9;
    let text = written.joined().text;
    let at_hand =
        Camera { viewport: *resolved.viewport(), image: resolved.image(), ..Camera::CANONICAL };
    let read = (format.read)(&Text { path: Path::new(""), text: &text }, &at_hand);
    let Some(back) = read.ok().and_then(|taken| taken.camera.resolve().ok()) else {
        return Some("its numbers make no camera any more when they are read again".to_owned());
    };
    let [height, width] = [resolved.image().height(), resolved.image().width()].map(|n| n - 1);
    let corners = [(0, 0), (0, width), (height, 0), (height, width)];
    let off = corners.map(|(row, column)| {
        let [a, b] = [resolved, &back].map(|camera| {
            let ray = camera.ray_of_pixel(Pixel { row, column });
            ray.direction / ray.direction.abs().max_element()
        });
        let turned = a.normalize().cross(b.normalize()).length();
        if a.dot(b) > 0.0 { turned } else { 2.0 }
    });
    let off = off.into_iter().fold(0.0, f64::max);
    (off > ENOUGH).then(|| {
        format!("its numbers keep this camera's rays to {off:.0e} of a right angle's sine only")
    })
}
