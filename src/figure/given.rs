//! The given numbers, which the user can edit: those of the scene file and the pixel or (u, v) of the
//! selected ray. All other numbers are calculated from them.

use std::ops::RangeInclusive;

use pinhole_core::{Camera, ImageSize, Object, Orientation, Selection};
use pinhole_exchange::document::Document;

/// A number that is given rather than calculated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Given {
    /// A coordinate of a vector or point: 0 is x, 1 is y, 2 is z.
    Coordinate(GivenVector, u8),
    /// The viewport's width.
    Width,
    /// The viewport's height.
    Height,
    /// The distance from the eye to the viewport.
    Distance,
    /// W, the image's width in pixels.
    ImageWidth,
    /// H, the image's height in pixels.
    ImageHeight,
    /// The selected pixel's row.
    Row,
    /// The selected pixel's column.
    Column,
    /// The selected position's u.
    PositionU,
    /// The selected position's v.
    PositionV,
    /// The radius of the sphere with this index among all objects.
    Radius(u32),
}

impl Given {
    /// Returns the index of the object to which the number belongs; `None` if it belongs to none.
    fn object(self) -> Option<u32> {
        match self {
            Given::Coordinate(
                GivenVector::Center(object)
                | GivenVector::Point(object)
                | GivenVector::Normal(object),
                _,
            )
            | Given::Radius(object) => Some(object),
            _ => None,
        }
    }
}

/// A vector or point that the user gives. The variants for objects hold the object's index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the lecture's own names")]
pub enum GivenVector {
    Eye,
    At,
    View,
    Up,
    /// The vector u of a basis that the user enters directly; `V` and `W` are v and w.
    U,
    V,
    W,
    Center(u32),
    Point(u32),
    Normal(u32),
}

impl GivenVector {
    /// Returns the vector's three coordinates.
    pub fn coordinates(self) -> [Given; 3] {
        [0, 1, 2].map(|axis| Given::Coordinate(self, axis))
    }

    fn name(self) -> &'static str {
        match self {
            GivenVector::Eye => "eye",
            GivenVector::At => "at",
            GivenVector::View => "view",
            GivenVector::Up => "up",
            GivenVector::U => "u",
            GivenVector::V => "v",
            GivenVector::W => "w",
            GivenVector::Center(_) => "centre",
            GivenVector::Point(_) => "point",
            GivenVector::Normal(_) => "normal",
        }
    }
}

/// The document and the selected ray, which together hold all numbers that the user gives.
#[derive(Clone, Copy, Debug)]
pub struct Givens<'a> {
    /// The document.
    pub document: &'a Document,
    /// The selected ray.
    pub selection: Selection,
    /// True if rows and columns are counted from 1.
    pub from_one: bool,
}

impl Givens<'_> {
    /// Returns the number as it is displayed: rows and columns are counted from 0 or 1 as set. Returns
    /// `None` if the number does not exist because the camera or the ray is specified by other quantities.
    pub fn value(&self, given: Given) -> Option<f64> {
        let (image, from) = (self.document.camera.image, f64::from(u8::from(self.from_one)));
        match (given, self.selection) {
            (Given::ImageWidth, _) => Some(image.width().into()),
            (Given::ImageHeight, _) => Some(image.height().into()),
            (Given::Row, Selection::Pixel(pixel)) => Some(f64::from(pixel.row) + from),
            (Given::Column, Selection::Pixel(pixel)) => Some(f64::from(pixel.column) + from),
            (given, mut selection) => {
                let mut camera = self.document.camera;
                let mut object = given.object().and_then(|k| self.document.object(k as usize));
                place(given, &mut camera, &mut object, &mut selection).copied()
            }
        }
    }

    /// Returns the range of a number that must be an integer; `None` if the number may be fractional.
    pub fn whole_range(&self, given: Given) -> Option<RangeInclusive<f64>> {
        let (image, from) = (self.document.camera.image, f64::from(u8::from(self.from_one)));
        match given {
            Given::ImageWidth | Given::ImageHeight => Some(1.0..=f64::from(ImageSize::MAX)),
            Given::Row => Some(from..=f64::from(image.height() - 1) + from),
            Given::Column => Some(from..=f64::from(image.width() - 1) + from),
            _ => None,
        }
    }

    /// Returns the number's name, such as `eye x` or `sphere 0 “ball” radius`.
    pub fn name(&self, given: Given) -> String {
        let name = match given {
            Given::Coordinate(vector, axis) => {
                &format!("{} {}", vector.name(), ["x", "y", "z"][usize::from(axis)])
            }
            Given::Width => "width",
            Given::Height => "height",
            Given::Distance => "distance",
            Given::ImageWidth => "W",
            Given::ImageHeight => "H",
            Given::Row => "row",
            Given::Column => "column",
            Given::PositionU => "uv u",
            Given::PositionV => "uv v",
            Given::Radius(_) => "radius",
        };
        match given.object() {
            Some(object) => format!("{} {name}", self.document.title_of(object as usize)),
            None => name.to_owned(),
        }
    }
}

/// Sets a given number to a value as it is displayed (rows and columns counted from 0 or 1 as set). Does
/// nothing if the number does not exist, or if it must be an integer and the value is fractional or out of
/// range.
pub fn set(
    given: Given,
    value: f64,
    document: &mut Document,
    selection: &mut Selection,
    from_one: bool,
) {
    let givens = Givens { document, selection: *selection, from_one };
    let fits = |range: RangeInclusive<f64>| range.contains(&value) && value.fract() == 0.0;
    if givens.value(given).is_none() || !givens.whole_range(given).is_none_or(fits) {
        return;
    }
    let index = |value: f64| value as u32 - u32::from(from_one);
    let image = &mut document.camera.image;
    match (given, &mut *selection) {
        (Given::ImageWidth, _) => {
            *image = ImageSize::new(value as u32, image.height()).unwrap_or(*image);
        }
        (Given::ImageHeight, _) => {
            *image = ImageSize::new(image.width(), value as u32).unwrap_or(*image);
        }
        (Given::Row, Selection::Pixel(pixel)) => pixel.row = index(value),
        (Given::Column, Selection::Pixel(pixel)) => pixel.column = index(value),
        _ => {
            let mut object = given.object().and_then(|k| document.object(k as usize));
            if let Some(place) = place(given, &mut document.camera, &mut object, selection) {
                *place = value;
            }
            if let (Some(k), Some(object)) = (given.object(), object) {
                document.set_object(k as usize, object);
            }
        }
    }
}

/// Returns a mutable reference to a given number that may be fractional; `None` if it does not exist or
/// must be an integer.
fn place<'a>(
    given: Given,
    camera: &'a mut Camera,
    object: &'a mut Option<Object>,
    selection: &'a mut Selection,
) -> Option<&'a mut f64> {
    let (viewport, orientation) = (&mut camera.viewport, &mut camera.orientation);
    let (vector, axis) = match (given, selection, object) {
        (Given::Width, ..) => return Some(&mut viewport.width),
        (Given::Height, ..) => return Some(&mut viewport.height),
        (Given::Distance, ..) => return Some(&mut viewport.distance),
        (Given::PositionU, Selection::Uv(uv), _) => return Some(&mut uv.x),
        (Given::PositionV, Selection::Uv(uv), _) => return Some(&mut uv.y),
        (Given::Radius(_), _, Some(Object::Sphere(sphere))) => return Some(&mut sphere.radius),
        (Given::Coordinate(vector, axis), _, object) => {
            let vector = match (vector, orientation, object) {
                (GivenVector::Eye, ..) => &mut camera.eye,
                (GivenVector::At, Orientation::At { at, .. }, _) => at,
                (GivenVector::View, Orientation::View { view, .. }, _) => view,
                (GivenVector::Up, Orientation::At { up, .. }, _) => up,
                (GivenVector::Up, Orientation::View { up, .. }, _) => up,
                (GivenVector::U, Orientation::Basis(basis), _) => &mut basis.u,
                (GivenVector::V, Orientation::Basis(basis), _) => &mut basis.v,
                (GivenVector::W, Orientation::Basis(basis), _) => &mut basis.w,
                (GivenVector::Center(_), _, Some(Object::Sphere(sphere))) => &mut sphere.center,
                (GivenVector::Point(_), _, Some(Object::Plane(plane))) => &mut plane.point,
                (GivenVector::Normal(_), _, Some(Object::Plane(plane))) => &mut plane.normal,
                _ => return None,
            };
            (vector, axis)
        }
        _ => return None,
    };
    Some(&mut vector[usize::from(axis)])
}

#[cfg(test)]
mod tests {
    use pinhole_core::{DVec2, OrientationKind, Pixel};
    use pinhole_exchange::scenes::SceneSource;

    use super::*;

    fn all() -> Vec<Given> {
        use GivenVector::{At, Center, Eye, Normal, Point, U, Up, V, View, W};
        let vectors = [Eye, At, View, Up, U, V, W, Center(1), Point(2), Normal(2)];
        let others = [
            Given::Width,
            Given::Height,
            Given::Distance,
            Given::ImageWidth,
            Given::ImageHeight,
            Given::Row,
            Given::Column,
            Given::PositionU,
            Given::PositionV,
            Given::Radius(0),
        ];
        vectors.into_iter().flat_map(GivenVector::coordinates).chain(others).collect()
    }

    #[test]
    fn a_number_that_is_set_changes_and_no_other_does() {
        let source = SceneSource::from_argument("canonical".as_ref()).expect("a scene");
        let canonical = source.load().expect("a document");
        let pixel = Selection::Pixel(Pixel { row: 3, column: 4 });
        let mut set_so_far = 0;
        for kind in [OrientationKind::At, OrientationKind::View, OrientationKind::Basis] {
            for selection in [pixel, Selection::Uv(DVec2::new(0.25, -0.125))] {
                for given in all() {
                    let mut document = canonical.clone();
                    document.camera = document.camera.given_by(kind).expect("a camera");
                    let mut selection = selection;
                    let values = |document: &Document, selection: Selection| {
                        let givens = Givens { document, selection, from_one: true };
                        all().into_iter().map(|given| givens.value(given)).collect::<Vec<_>>()
                    };
                    let before = values(&document, selection);
                    set(given, 7.0, &mut document, &mut selection, true);
                    let now = values(&document, selection);
                    for ((one, before), now) in all().into_iter().zip(before).zip(now) {
                        let expected = if one == given { before.map(|_| 7.0) } else { before };
                        assert_eq!(now, expected, "{one:?} after {given:?}");
                        set_so_far += usize::from(before != now);
                    }
                }
            }
        }
        assert!(set_so_far > 100, "{set_so_far}");
    }

    #[test]
    fn a_row_below_the_image_and_half_a_pixel_are_refused() {
        let source = SceneSource::from_argument("canonical".as_ref()).expect("a scene");
        let mut document = source.load().expect("a document");
        let mut selection = Selection::Pixel(Pixel { row: 3, column: 4 });
        for (given, value) in [(Given::Row, 400.0), (Given::Row, 0.5), (Given::ImageWidth, 0.0)] {
            let before = (document.clone(), selection);
            set(given, value, &mut document, &mut selection, false);
            assert_eq!((document.clone(), selection), before, "{given:?} {value}");
        }
    }
}
