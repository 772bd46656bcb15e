//! A figure as it is ordered, by the command or in the window's dialog: what it shows, how large it is,
//! and what the file holds.

use std::path::Path;

use pinhole_core::ImageSize;
use pinhole_exchange::document::Document;

use super::figure::{Figure, Format, Look};
use super::panes;
use super::views::{View, of_view};
use crate::model::session::{Session, ViewLayout};
use crate::view::derivation::{Derivation, Markup, Section};
use crate::view::derive::{Deriver, ViewSizes};
use crate::view::overlay::Style;

/// The subject of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The scene with the camera in it.
    World,
    /// The camera's picture.
    Camera,
    /// The derivation of every number.
    Derivation,
    /// The lab of lines: the plane, and one line put into the other.
    Lines,
}

impl Subject {
    /// All of them.
    pub const ALL: [Subject; 4] =
        [Subject::World, Subject::Camera, Subject::Derivation, Subject::Lines];

    /// Returns its title.
    pub fn title(self) -> &'static str {
        match self {
            Subject::World => "World view",
            Subject::Camera => "Camera view",
            Subject::Derivation => "Derivation",
            Subject::Lines => "Lines",
        }
    }

    /// Returns its name in one word, as the command line has it.
    pub fn name(self) -> &'static str {
        match self {
            Subject::World => "world",
            Subject::Camera => "camera",
            Subject::Derivation => "derivation",
            Subject::Lines => "lines",
        }
    }
}

/// The content of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// A figure.
    Figure(Format),
    /// The derivation as text.
    Text(Markup),
}

impl Content {
    /// The content that the ending of a file's name asks for.
    ///
    /// # Errors
    /// Returns an error, as a sentence with the known endings, if the ending is unknown.
    pub fn for_path(subject: Subject, path: &Path) -> Result<Content, String> {
        let mut known: Vec<(&str, Content)> =
            Format::ALL.map(|format| (format.ending(), Content::Figure(format))).into();
        let mut formats = "SVG, PDF or PNG";
        if subject == Subject::Derivation {
            known.extend([
                ("tex", Content::Text(Markup::Latex)),
                ("md", Content::Text(Markup::Markdown)),
            ]);
            formats = "SVG, PDF, PNG, LaTeX or Markdown";
        }
        let is =
            |ending: &str| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
        if let Some((_, content)) = known.iter().find(|(ending, _)| is(ending)) {
            return Ok(*content);
        }
        let named =
            |(ending, _): &(&str, Content)| path.with_extension(ending).display().to_string();
        let mut named: Vec<String> = known.iter().map(named).collect();
        let last = named.pop().unwrap_or_default();
        Err(format!("writes {formats}: not {} but {} or {last}", path.display(), named.join(", ")))
    }
}

/// A figure that is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// The subject.
    pub subject: Subject,
    /// Width and height in dots; a derivation is as high as its lines.
    pub size: [u32; 2],
    /// Width and height in points: how much of the plane there is room for, where lines are broken, and how
    /// large letters are.
    pub points: [f32; 2],
    /// The colours.
    pub style: Style,
    /// Leaves the background out.
    pub transparent: bool,
}

impl Order {
    /// Dots per point: as many as have room for all points.
    fn scale(&self) -> f32 {
        let [across, down] = [0, 1].map(|k| self.size[k] as f32 / self.points[k].max(1.0));
        if self.subject == Subject::Derivation { across } else { across.min(down) }
    }

    /// The figure, of the document as the session looks at it.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if there is no such figure.
    pub fn figure(
        &self,
        document: &Document,
        session: &Session,
        is_folded: impl Fn(&Section) -> bool,
    ) -> Result<Figure, String> {
        let scale = self.scale();
        let look = Look { scale, style: self.style, transparent: self.transparent };
        let of_view = |view| {
            let [width, height] = self.size;
            let size = ImageSize::new(width, height).map_err(|error| error.to_string())?;
            of_view(document, session, view, size, look).map_err(|fault| fault.to_string())
        };
        match self.subject {
            Subject::World => of_view(View::World),
            Subject::Camera => of_view(View::Camera),
            Subject::Derivation => Ok(panes::derivation(
                &derivation_of(document, session),
                self.points[0],
                look,
                is_folded,
            )),
            Subject::Lines => {
                let points = self.size.map(|dots| dots as f32 / scale);
                Ok(panes::lines(&session.lines, session.settings.digits, points, look))
            }
        }
    }
}

/// The derivation of the document, whatever the layout shows.
pub fn derivation_of(document: &Document, session: &Session) -> Derivation {
    let mut session = session.clone();
    session.settings.layout = ViewLayout::Derivation;
    let derived = Deriver::default().derive(document, &session, &ViewSizes::default());
    derived.derivation.map(|derivation| (*derivation).clone()).unwrap_or_default()
}
