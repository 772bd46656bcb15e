//! The camera that a mistake makes.

use std::fmt;

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{
    Camera, CameraError, DVec2, DVec3, ImageSize, Orientation, Pixel, PosedCamera, Ray, RayError,
};

use super::Mistake;

/// How u, v and w are made, where not as they should be.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Construction {
    w: Option<WrongW>,
    u: Option<WrongU>,
    v: Option<WrongV>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum WrongW {
    /// `view/|view|`.
    AlongView,
    /// `-view`.
    NotNormalized,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum WrongU {
    /// `up x w`.
    NotNormalized,
    /// `w x up / |w x up|`.
    WCrossUp,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum WrongV {
    /// `u x w`.
    UCrossW,
    /// `up`.
    Up,
}

/// From a pixel to (u, v), where not as it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mapping {
    /// What is added to row and column: 0.5 is the pixel's centre.
    pub(super) half: f64,
    /// Rows grow upwards.
    pub(super) from_bottom: bool,
    /// u comes from the row, v from the column.
    pub(super) swapped: bool,
    /// The width stands for the height.
    width_for_height: bool,
}

/// Why there is no wrong camera to show.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoWrongCamera {
    /// The right camera sees nothing.
    Camera(CameraError),
    /// u, v and w are set by hand: no mistake can be made in finding them.
    GivenByHand(Mistake),
    /// The camera is given by view, and there is no at.
    NotGivenByAt,
    /// The wrong camera is the right one.
    ChangesNothing(Mistake),
    /// Both change the same stage.
    Conflict(Mistake, Mistake),
    /// Its numbers are beyond the range of `f64`.
    OutOfRange(Mistake),
}

impl fmt::Display for NoWrongCamera {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoWrongCamera::Camera(e) => e.fmt(f),
            NoWrongCamera::GivenByHand(_) => f.write_str(
                "𝐮, 𝐯, 𝐰 are set by hand here, so this mistake has no place: give the camera by \
                 view and up, or by at and up.",
            ),
            NoWrongCamera::NotGivenByAt => f.write_str(
                "The camera is given by view here, so there is no at − eye to mistake for 𝐰: give \
                 it by eye, at and up.",
            ),
            NoWrongCamera::ChangesNothing(mistake) => {
                write!(f, "This changes nothing here. {}", mistake.hint())
            }
            NoWrongCamera::Conflict(first, second) => {
                write!(f, "{} and {} cannot be made together", first.name(), second.name())
            }
            NoWrongCamera::OutOfRange(_) => {
                f.write_str("The wrong camera's numbers are beyond the range of f64.")
            }
        }
    }
}

impl std::error::Error for NoWrongCamera {}

/// A camera with a mistake, or several, on the way to its rays.
#[derive(Clone, Debug, PartialEq)]
pub struct WrongCamera {
    pub(super) right: PosedCamera,
    mistakes: Vec<Mistake>,
    pub(super) mapping: Mapping,
    distance_dropped: bool,
    /// u = scale.x U, v = scale.y V, w = scale.z W, of the right basis U, V, W.
    pub(super) scale: DVec3,
    /// v in the place of `scale.y V`.
    pub(super) up_as_v: Option<DVec3>,
    pub(super) view: DVec3,
    pub(super) up: DVec3,
}

/// How different a wrong camera's numbers have to be, relative to their size. A mistake of sign or
/// order changes them by as much as they are; a length that is 1 but for rounding is found within
/// 1e-15, and one that differs by less than this changes no pixel of any image.
const DIFFERENT: f64 = 1e-12;

impl WrongCamera {
    /// The camera with one mistake.
    ///
    /// # Errors
    /// Where the camera sees nothing, the mistake cannot be made with it, or changes nothing.
    pub fn new(camera: &Camera, mistake: Mistake) -> Result<WrongCamera, NoWrongCamera> {
        WrongCamera::with(camera, &[mistake])
    }

    /// The camera with several mistakes, each in another stage.
    ///
    /// # Errors
    /// As [`WrongCamera::new`]; also where two of them change the same stage. Where all together
    /// change nothing, the last one is named.
    pub fn with(camera: &Camera, mistakes: &[Mistake]) -> Result<WrongCamera, NoWrongCamera> {
        let wrong = WrongCamera::built(camera, mistakes)?;
        let last = mistakes.last().copied();
        if let Some(last) = last {
            if !wrong.is_finite() {
                return Err(NoWrongCamera::OutOfRange(last));
            }
            if wrong.is_right() {
                return Err(NoWrongCamera::ChangesNothing(last));
            }
        }
        Ok(wrong)
    }

    /// The camera without any mistake, to be checked as the wrong ones are.
    ///
    /// # Errors
    /// Where the camera sees nothing.
    pub fn right(camera: &Camera) -> Result<WrongCamera, CameraError> {
        let posed = camera.posed()?;
        Ok(WrongCamera {
            right: posed,
            mistakes: Vec::new(),
            mapping: Mapping::RIGHT,
            distance_dropped: false,
            scale: DVec3::ONE,
            up_as_v: None,
            view: camera.view(),
            up: camera.up(),
        })
    }

    fn built(camera: &Camera, mistakes: &[Mistake]) -> Result<WrongCamera, NoWrongCamera> {
        let mut wrong = WrongCamera::right(camera).map_err(NoWrongCamera::Camera)?;
        let mut construction = Construction::default();
        for &mistake in mistakes {
            let known = wrong.mistakes.iter().copied().find(|known| is_conflict(*known, mistake));
            if let Some(known) = known {
                return Err(NoWrongCamera::Conflict(known, mistake));
            }
            wrong.mistakes.push(mistake);
            if is_of_basis(mistake) && matches!(camera.orientation, Orientation::Basis(_)) {
                return Err(NoWrongCamera::GivenByHand(mistake));
            }
            let is_at = matches!(camera.orientation, Orientation::At { .. });
            if mistake == Mistake::WIsAtMinusEye && !is_at {
                return Err(NoWrongCamera::NotGivenByAt);
            }
            wrong.apply(&mut construction, mistake);
        }
        wrong.construct(construction);
        Ok(wrong)
    }

    fn apply(&mut self, construction: &mut Construction, mistake: Mistake) {
        match mistake {
            Mistake::WAsPrinted | Mistake::WIsAtMinusEye => {
                construction.w = Some(WrongW::AlongView);
            }
            Mistake::WNotNormalized => construction.w = Some(WrongW::NotNormalized),
            Mistake::NotNormalized => construction.u = Some(WrongU::NotNormalized),
            Mistake::UIsWCrossUp => construction.u = Some(WrongU::WCrossUp),
            Mistake::VIsUCrossW => construction.v = Some(WrongV::UCrossW),
            Mistake::UpAsV => construction.v = Some(WrongV::Up),
            Mistake::LeftHanded => {
                construction.u = Some(WrongU::WCrossUp);
                construction.v = Some(WrongV::UCrossW);
            }
            Mistake::DistanceDropped => self.distance_dropped = true,
            Mistake::PixelCorner => self.mapping.half = 0.0,
            Mistake::CountedFromOne => self.mapping.half = -0.5,
            Mistake::RowsFromBottom => self.mapping.from_bottom = true,
            Mistake::RowsColumnsSwapped => self.mapping.swapped = true,
            Mistake::AspectDropped => self.mapping.width_for_height = true,
        }
    }

    /// Every wrong vector is a multiple of the right one (but for up), so that none loses digits
    /// where up is close to the view.
    fn construct(&mut self, Construction { w, u, v }: Construction) {
        let w = match w {
            None => 1.0,
            Some(WrongW::AlongView) => -1.0,
            Some(WrongW::NotNormalized) => length(self.view),
        };
        let u = match u {
            None => w.signum(),
            Some(WrongU::WCrossUp) => -w.signum(),
            // |up x W|, in which no up is too long or too short.
            Some(WrongU::NotNormalized) => {
                let sine = unit(self.up).cross(self.right.basis().w).length();
                w * length(self.up) * sine
            }
        };
        let v = match v {
            Some(WrongV::UCrossW) => -(w * u),
            Some(WrongV::Up) => {
                self.up_as_v = Some(self.up);
                1.0
            }
            None => w * u,
        };
        self.scale = DVec3::new(u, v, w);
    }

    /// The mistakes made.
    pub fn mistakes(&self) -> &[Mistake] {
        &self.mistakes
    }

    /// The camera without them.
    pub fn right_camera(&self) -> &PosedCamera {
        &self.right
    }

    /// The wrong u; not always of length 1.
    pub fn u(&self) -> DVec3 {
        self.scale.x * self.right.basis().u
    }

    /// The wrong v; not always of length 1, nor at right angles to w.
    pub fn v(&self) -> DVec3 {
        self.up_as_v.unwrap_or(self.scale.y * self.right.basis().v)
    }

    /// The wrong w; not always of length 1, nor backwards.
    pub fn w(&self) -> DVec3 {
        self.scale.z * self.right.basis().w
    }

    /// Which of u, v and w are other vectors than the right ones, and not by rounding alone.
    pub fn wrong_vectors(&self) -> [bool; 3] {
        let right = self.right.basis();
        let is_wrong = |a: DVec3, b: DVec3| !is_near(a, b);
        [is_wrong(self.u(), right.u), is_wrong(self.v(), right.v), is_wrong(self.w(), right.w)]
    }

    /// The distance that the rays are made with.
    pub fn distance(&self) -> f64 {
        if self.distance_dropped { 1.0 } else { self.right.viewport().distance }
    }

    /// The viewport's height that (u, v) is made with.
    pub(super) fn height(&self) -> f64 {
        let viewport = self.right.viewport();
        if self.mapping.width_for_height { viewport.width } else { viewport.height }
    }

    /// W x H.
    pub fn image(&self) -> ImageSize {
        self.right.image()
    }

    /// (u, v) that the wrong camera takes for a pixel's.
    pub fn uv_of_pixel(&self, pixel: Pixel) -> DVec2 {
        self.uv_at(f64::from(pixel.row), f64::from(pixel.column))
    }

    pub(super) fn uv_at(&self, row: f64, column: f64) -> DVec2 {
        let Mapping { half, from_bottom, swapped, .. } = self.mapping;
        let (row, column) = if swapped { (column, row) } else { (row, column) };
        let (w, h) = (f64::from(self.image().width()), f64::from(self.image().height()));
        let side = if from_bottom { -1.0 } else { 1.0 };
        // As the right camera has it, with one rounding each.
        DVec2::new(
            self.right.viewport().width * ((2.0 * (column + half) - w) / (2.0 * w)),
            side * self.height() * ((h - 2.0 * (row + half)) / (2.0 * h)),
        )
    }

    /// `u*U + v*V - distance*W` of the wrong vectors.
    pub fn direction_at(&self, uv: DVec2) -> DVec3 {
        uv.x * self.u() + uv.y * self.v() - self.distance() * self.w()
    }

    /// The ray that the wrong camera sends through a pixel.
    ///
    /// # Errors
    /// Where its numbers are beyond the range of `f64`.
    pub fn ray(&self, pixel: Pixel) -> Result<Ray, RayError> {
        self.ray_at(self.uv_of_pixel(pixel))
    }

    /// The ray that the wrong camera sends through a (u, v).
    ///
    /// # Errors
    /// Where its numbers are beyond the range of `f64`.
    pub fn ray_at(&self, uv: DVec2) -> Result<Ray, RayError> {
        Ray::new(self.right.eye(), self.direction_at(uv))
    }

    /// Whether every pixel sees the same as in the other camera, whatever the numbers behind it.
    pub fn sees_the_same(&self, other: &WrongCamera) -> bool {
        let is_same = |pixel: Pixel| {
            let [a, b] = [self, other].map(|c| unit(c.direction_at(c.uv_of_pixel(pixel))));
            (a - b).length() <= DIFFERENT.sqrt()
        };
        self.right.eye() == other.right.eye()
            && self.image() == other.image()
            && corners(self.image()).into_iter().all(is_same)
    }

    fn is_finite(&self) -> bool {
        corners(self.image()).into_iter().all(|pixel| self.ray(pixel).is_ok())
    }

    /// Whether basis and rays are the right ones but for rounding.
    fn is_right(&self) -> bool {
        self.wrong_vectors() == [false; 3]
            && corners(self.image()).into_iter().all(|pixel| {
                let wrong = self.direction_at(self.uv_of_pixel(pixel));
                is_near(wrong, self.right.ray_of_pixel(pixel).direction)
            })
    }
}

fn is_near(a: DVec3, b: DVec3) -> bool {
    (a - b).length() <= DIFFERENT * length(b)
}

impl Mapping {
    pub(super) const RIGHT: Mapping =
        Mapping { half: 0.5, from_bottom: false, swapped: false, width_for_height: false };
}

/// Directions are linear in row and column: those of the four corners tell them all.
fn corners(image: ImageSize) -> [Pixel; 4] {
    let (last_row, last_column) = (image.height() - 1, image.width() - 1);
    [(0, 0), (0, last_column), (last_row, 0), (last_row, last_column)]
        .map(|(row, column)| Pixel { row, column })
}

/// What the stages are called that a mistake changes.
fn stages(mistake: Mistake) -> &'static [&'static str] {
    match mistake {
        Mistake::WAsPrinted | Mistake::WIsAtMinusEye | Mistake::WNotNormalized => &["w"],
        Mistake::NotNormalized | Mistake::UIsWCrossUp => &["u"],
        Mistake::VIsUCrossW | Mistake::UpAsV => &["v"],
        Mistake::LeftHanded => &["u", "v"],
        Mistake::DistanceDropped => &["distance"],
        Mistake::PixelCorner | Mistake::CountedFromOne => &["half"],
        Mistake::RowsFromBottom => &["side"],
        Mistake::RowsColumnsSwapped => &["order"],
        Mistake::AspectDropped => &["height"],
    }
}

fn is_conflict(a: Mistake, b: Mistake) -> bool {
    stages(a).iter().any(|stage| stages(b).contains(stage))
}

fn is_of_basis(mistake: Mistake) -> bool {
    stages(mistake).iter().any(|stage| ["u", "v", "w"].contains(stage))
}
