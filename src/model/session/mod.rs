//! How the document is looked at: what a scene file does not hold.

pub mod ghost;
pub mod hand;
mod names;
pub mod presenting;
mod splits;

use pinhole_core::methods::{Formula, Method, Precision};
use pinhole_core::steering::{CornerKeeps, DistanceKeeps, Keep};
use pinhole_core::{DVec2, ExactRay, ImageSize, Pixel, RayError, ResolvedCamera, Viewport};
use serde::{Deserialize, Serialize};

pub use names::{EyeKeeps, MethodName, ShadeName, ThemeName, ViewLayout};
pub use splits::{Split, Splits};

use crate::model::color_scheme::Scheme;
use crate::model::concept::{Concept, Hovered};
use crate::model::derivation_sections::DerivationSections;
use crate::model::lines::LinesLab;
use crate::model::observer::Observer;
use crate::model::overlay_items::OverlayItems;
use crate::model::practice::exercises::Exercises;
use crate::model::practice::mistakes_view::MistakesView;
use crate::model::practice::student_answers::StudentAnswers;
use crate::model::session::ghost::Ghost;
use crate::model::session::hand::Hand;
use crate::model::session::presenting::{Presenting, SMALLEST_TEXT};
use crate::model::translator::Translator;

/// Everything about the window that is not the document. Changing it never marks the document as
/// edited.
#[derive(Clone, Debug, PartialEq)]
pub struct Session {
    /// The ray that is looked at closely.
    pub selection: Selection,
    /// Who looks at the world view; `None` until it is framed for the first time.
    pub observer: Option<Observer>,
    /// The t of the point p + t d that walks along the selected ray; `None` where none does.
    pub ray_point_t: Option<f64>,
    /// How many pixels the camera's picture shows so far, row by row; all of them without a number.
    pub scanned_pixels: Option<u64>,
    /// The camera to compare with.
    pub ghost: Option<Ghost>,
    /// The lab of lines in two dimensions.
    pub lines: LinesLab,
    /// What the mouse or the keyboard points at just now.
    pub hovered: Option<Hovered>,
    /// What is lit while nothing is pointed at.
    pub highlighted: Option<Concept>,
    /// Which sections of the derivation are shown.
    pub sections: DerivationSections,
    /// The wrong camera beside the right one.
    pub mistakes_view: MistakesView,
    /// The exercise at hand, and what was answered.
    pub exercises: Exercises,
    /// A student's answers, to be graded.
    pub answers: Option<StudentAnswers>,
    /// Presenter mode, while it is on.
    pub presenting: Option<Presenting>,
    /// All but what is round the pointer is dimmed.
    pub spotlight: bool,
    /// What is taken in the hand, or could be.
    pub hand: Hand,
    /// What is chosen in the translator.
    pub translator: Translator,
    /// What is remembered across runs as it is.
    pub settings: Settings,
}

/// The selected ray: by pixel, or by (u, v) where it is no pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Selection {
    /// Through a pixel's centre.
    Pixel(Pixel),
    /// Through a position in the viewport.
    Uv(DVec2),
}

/// How many significant digits the readouts can have.
pub(crate) const DIGITS: (usize, usize) = (2, 17);

/// Zoom of the window, at least and at most.
pub(crate) const ZOOM: (f32, f32) = (0.5, 4.0);

/// Preferences, kept across runs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// Which views are shown.
    pub layout: ViewLayout,
    /// How the pictures are coloured.
    pub shade: ShadeName,
    /// What is drawn over the pictures.
    pub items: OverlayItems,
    /// Significant digits of the readouts.
    pub digits: usize,
    /// Rows and columns are shown counted from 1, as the course does.
    pub count_from_one: bool,
    /// Changing the viewport or image keeps the pixels' shape.
    pub keep_pixel_shape: bool,
    /// Changing distance, width or height takes the other two along: the picture stays.
    pub keep_picture: bool,
    /// What stays when the eye is moved in the world view.
    pub eye_keeps: EyeKeeps,
    /// The camera panel's part for teaching is unfolded.
    pub teaching: bool,
    /// Where the boundaries between the window's areas are.
    pub splits: Splits,
    /// In the plot of f(p + t d), values beyond 1 unit are compressed.
    pub plot_compressed: bool,
    /// What draws the camera's picture: the ladder, unless one wants to see what another does wrong.
    pub method: MethodName,
    /// The method of the error map.
    pub compared: MethodName,
    /// Dark, light, or what the system says.
    pub theme: ThemeName,
    /// The colours that things are told apart by.
    pub scheme: Scheme,
    /// Nothing moves by itself: no transitions, and what plays goes in steps.
    pub reduced_motion: bool,
    /// No text is smaller than this while presenting, in points of a window of 1024 × 768; in a
    /// larger one it is larger in proportion.
    pub smallest_text: f32,
    /// Zoom of the whole window.
    pub zoom: f32,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            layout: ViewLayout::Both,
            shade: ShadeName::Lambert,
            items: OverlayItems::default(),
            digits: 5,
            count_from_one: false,
            keep_pixel_shape: true,
            keep_picture: false,
            eye_keeps: EyeKeeps::At,
            teaching: false,
            splits: Splits::default(),
            plot_compressed: false,
            method: MethodName(Method::Ladder),
            compared: MethodName(Method::Known(Formula::Textbook, Precision::F32)),
            theme: ThemeName::System,
            scheme: Scheme::Standard,
            reduced_motion: false,
            smallest_text: SMALLEST_TEXT.usual,
            zoom: 1.0,
        }
    }
}

impl Settings {
    /// How the plot of f(p + t d) shows values.
    pub fn plot_heights(&self) -> Heights {
        if self.plot_compressed { Heights::Compressed } else { Heights::Even }
    }

    /// The same with every value in the range that the window works with; what is remembered comes
    /// from a file that anyone may have edited.
    #[must_use]
    pub fn in_range(mut self) -> Settings {
        let finite = |x: f32, otherwise: f32| if x.is_finite() { x } else { otherwise };
        let default = Settings::default();
        self.digits = self.digits.clamp(DIGITS.0, DIGITS.1);
        self.smallest_text = finite(self.smallest_text, default.smallest_text)
            .clamp(SMALLEST_TEXT.least, SMALLEST_TEXT.most);
        self.zoom = finite(self.zoom, default.zoom).clamp(ZOOM.0, ZOOM.1);
        self
    }
}

impl Default for Session {
    fn default() -> Self {
        Session {
            selection: Selection::Uv(DVec2::new(0.2, -0.1)),
            observer: None,
            ray_point_t: None,
            scanned_pixels: None,
            ghost: None,
            lines: LinesLab::default(),
            hovered: None,
            highlighted: None,
            sections: DerivationSections::default(),
            mistakes_view: MistakesView::default(),
            exercises: Exercises::default(),
            answers: None,
            presenting: None,
            spotlight: false,
            hand: Hand::default(),
            translator: Translator::default(),
            settings: Settings::default(),
        }
    }
}

impl Session {
    /// What both views and the derivation show lit.
    pub fn highlighted(&self) -> Option<Concept> {
        self.hovered.map(|hovered| hovered.concept).or(self.highlighted)
    }
}

impl Selection {
    /// Where the selected ray passes through the viewport.
    pub fn uv(self, camera: &ResolvedCamera) -> DVec2 {
        match self {
            Selection::Pixel(pixel) => camera.uv_of_pixel(pixel),
            Selection::Uv(uv) => uv,
        }
    }

    /// The selected view ray, with nothing of it rounded. A pixel must lie
    /// [inside](Selection::inside) the image.
    ///
    /// # Errors
    /// As [`ResolvedCamera::exact_ray_at`].
    pub fn exact_ray(self, camera: &ResolvedCamera) -> Result<ExactRay<'_>, RayError> {
        match self {
            Selection::Pixel(pixel) => Ok(camera.exact_ray(pixel)),
            Selection::Uv(uv) => camera.exact_ray_at(uv),
        }
    }

    /// The selection with a pixel moved back into an image that may have shrunk.
    pub fn inside(self, image: ImageSize) -> Selection {
        match self {
            Selection::Pixel(Pixel { row, column }) => Selection::Pixel(Pixel {
                row: row.min(image.height() - 1),
                column: column.min(image.width() - 1),
            }),
            uv => uv,
        }
    }

    /// The selection after the image has got another size: the pixel at the same place.
    pub fn in_another_image(self, before: ImageSize, now: ImageSize) -> Selection {
        let place = |k: u32, before: u32, now: u32| {
            let share = (f64::from(k) + 0.5) / f64::from(before);
            ((share * f64::from(now)) as u32).min(now - 1)
        };
        match self {
            Selection::Pixel(Pixel { row, column }) if before != now => Selection::Pixel(Pixel {
                row: place(row, before.height(), now.height()),
                column: place(column, before.width(), now.width()),
            }),
            same => same,
        }
    }

    /// The selection after the viewport was scaled: the same share of its width and height.
    pub fn in_another_viewport(self, before: Viewport, now: Viewport) -> Selection {
        match self {
            Selection::Uv(uv) if before != now => {
                let scaled = uv * DVec2::new(now.width, now.height)
                    / DVec2::new(before.width, before.height);
                Selection::Uv(if scaled.is_finite() { scaled } else { uv })
            }
            same => same,
        }
    }

    /// The neighbouring pixel that many rows down and columns right, as the arrow keys go; from a
    /// (u, v), the pixel it falls into first.
    pub fn stepped(self, camera: &ResolvedCamera, rows: i64, columns: i64) -> Selection {
        let Pixel { row, column } = match self {
            Selection::Pixel(pixel) => pixel,
            Selection::Uv(uv) => match camera.pixel_of_uv(uv) {
                Some(place) => return Selection::Pixel(place.pixel),
                None => return self,
            },
        };
        let step = |from: u32, by: i64, count: u32| {
            (i64::from(from) + by).clamp(0, i64::from(count) - 1) as u32
        };
        Selection::Pixel(Pixel {
            row: step(row, rows, camera.image().height()),
            column: step(column, columns, camera.image().width()),
        })
    }
}

/// How a value of f, in its curve's unit, becomes a height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heights {
    /// As it is: a plane's line is straight, a sphere's parabola is one.
    Even,
    /// As it is up to 1, compressed beyond: 1 more is 2.7 times as much. What is far is in sight, too.
    Compressed,
}

impl Heights {
    /// The height of a value; it has the value's sign.
    pub(crate) fn height(self, y: f64) -> f64 {
        match self {
            Heights::Compressed if y.abs() > 1.0 => (1.0 + y.abs().ln()).copysign(y),
            _ => y,
        }
    }
}

/// Returns what the settings keep fixed during drags. `other` is the modifier key that swaps what a
/// moved eye keeps.
pub fn keeps_of(settings: &Settings, other: bool) -> (Keep, CornerKeeps, DistanceKeeps) {
    let eye = if other { settings.eye_keeps.other() } else { settings.eye_keeps };
    let corner = if settings.keep_pixel_shape { CornerKeeps::Ratio } else { CornerKeeps::Nothing };
    let distance = if settings.keep_picture { DistanceKeeps::Picture } else { DistanceKeeps::Size };
    (eye.into(), corner, distance)
}
