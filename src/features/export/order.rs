//! A request for a figure, made by a command or in the window's dialog: what it shows, its size, and
//! the kind of file.

use std::path::Path;
use std::sync::Arc;

use egui::{Color32, ColorImage, Context, Pos2, Rect, Theme, vec2};
use pinhole_exchange::document::Document;
use pinhole_exchange::limits;
use pinhole_figure::Fault;
use pinhole_figure::derivation::{Derivation, Markup};
use pinhole_figure::export::{Figure, FigureFormat};
use pinhole_figure::headless::UiPass;
use pinhole_figure::overlay::{Drawing, Style};
use pinhole_figure::typesetting::{derivation, labels, theme};

use crate::features::lines;
use crate::model::{Session, ViewLayout};
use crate::view::derive::{Deriver, Purpose, ViewSizes};

/// Margin on each side of the derivation, in points.
pub const MARGIN: f32 = 12.0;

/// Height in points of the page on which a derivation is laid out; more than any derivation needs.
const UNLIMITED: f32 = 1e6;

/// Pixels of a fine picture for each dot of the figure on one side: 300 an inch, where the figure has 96.
const FINE: f32 = 300.0 / 96.0;

/// Maximum side of a fine picture, in pixels, so that it stays small enough for a file.
const LARGEST: f32 = 8192.0;

pinhole_core::texts! {
    /// The subject of a figure.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum FigureSubject[2];
    {
        /// Returns the title of the subject's view.
        title,
        /// Returns the subject's name on the command line.
        name,
    }
    /// The world view: the scene with the camera in it, as seen by an observer outside.
    World: "World view", "world";
    /// The camera's picture.
    Camera: "Camera view", "camera";
    /// The derivation of every number.
    Derivation: "Derivation", "derivation";
    /// The lines lab: two lines in the plane, one implicit and one parametric, and the substitution
    /// that intersects them.
    Lines: "Lines", "lines";
}

/// The kind of content in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// A figure.
    Figure(FigureFormat),
    /// The derivation as text.
    Text(Markup),
}

/// The file extensions, and what a file with each of them contains. The last two are only available for
/// a derivation.
const CONTENTS: [(&str, Content); 5] = [
    ("svg", Content::Figure(FigureFormat::Svg)),
    ("pdf", Content::Figure(FigureFormat::Pdf)),
    ("png", Content::Figure(FigureFormat::Png)),
    ("tex", Content::Text(Markup::Latex)),
    ("md", Content::Text(Markup::Markdown)),
];

impl Content {
    /// Returns what a file with this name is to contain, according to its extension.
    ///
    /// If the extension is unknown, returns an error, as a sentence that lists the known ones.
    pub fn for_path(subject: FigureSubject, path: &Path) -> Result<Content, String> {
        let (contents, formats) = match subject {
            FigureSubject::Derivation => (&CONTENTS[..], "SVG, PDF, PNG, LaTeX or Markdown"),
            _ => (&CONTENTS[..3], "SVG, PDF or PNG"),
        };
        by_ending(path, contents, formats)
    }
}

/// Returns the choice that the extension of a file's name stands for. `formats` are the choices in words.
///
/// If the extension is unknown, returns an error, as a sentence that lists the known ones.
pub fn by_ending<T: Copy>(path: &Path, choices: &[(&str, T)], formats: &str) -> Result<T, String> {
    let is = |ending: &str| path.extension().is_some_and(|end| end.eq_ignore_ascii_case(ending));
    if let Some((_, choice)) = choices.iter().find(|(ending, _)| is(ending)) {
        return Ok(*choice);
    }
    let named = |(ending, _): &(&str, T)| path.with_extension(ending).display().to_string();
    let mut named: Vec<String> = choices.iter().map(named).collect();
    let last = named.pop().unwrap_or_default();
    Err(format!("writes {formats}: not {} but {} or {last}", path.display(), named.join(", ")))
}

/// A request for a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// The subject.
    pub subject: FigureSubject,
    /// Width and height in dots. A derivation ignores the height, and is as high as its lines.
    pub size: [u32; 2],
    /// Number of dots per point, which determines the size of strokes and letters.
    pub scale: f32,
    /// The colours.
    pub style: Style,
    /// True if the background is transparent.
    pub transparent: bool,
}

impl Order {
    /// Draws the figure of a document. The session provides what the document does not contain: the
    /// selected ray, the choice of overlays, and the observer of the world view.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if there is nothing to draw.
    pub fn figure(&self, document: &Document, session: &Session) -> Result<Figure, String> {
        match self.subject {
            FigureSubject::World | FigureSubject::Camera => {
                /// Bytes of memory for a pixel: its hit, its colour, and its copies on the way to a file.
                const PIXEL: u64 = 24;
                let [width, height] = self.size;
                let bytes = PIXEL * u64::from(width) * u64::from(height);
                limits::memory(&format!("a figure of {width} x {height} pixels"), bytes)?;
                self.view(document, session).map_err(|fault| fault.to_string())
            }
            FigureSubject::Derivation => Ok(self.derivation(&derivation_of(document, session))),
            FigureSubject::Lines => {
                let points = self.size.map(|dots| dots as f32 / self.scale);
                let page = Rect::from_min_size(Pos2::ZERO, points.into());
                let drawn = UiPass::draw(&self.context(), self.dots(), self.scale, |ui| {
                    lines::view::draw(ui, page, &session.shown.lines, session.shown.setup.digits);
                });
                Ok(self.with_background(self.dots(), self.style.colors().background, drawn))
            }
        }
    }

    /// Draws the figure for a file of this format. In a vector format, a world view's picture is as fine as print
    /// needs. The strokes and the text, which lie over the picture, are as without it. The camera view's picture
    /// is, too: its pixels are what it shows.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if there is nothing to draw.
    pub fn figure_as(
        &self,
        format: FigureFormat,
        document: &Document,
        session: &Session,
    ) -> Result<Figure, String> {
        let mut figure = self.figure(document, session)?;
        if self.subject != FigureSubject::World || format == FigureFormat::Png {
            return Ok(figure);
        }
        let longer = self.size[0].max(self.size[1]) as f32;
        let finer = FINE.min(LARGEST / longer).max(1.0);
        let size = self.size.map(|dots| (dots as f32 * finer).round() as u32);
        let fine = Order { size, scale: self.scale * finer, ..*self };
        figure.refine(fine.view(document, session).map_err(|fault| fault.to_string())?);
        Ok(figure)
    }

    fn view(&self, document: &Document, session: &Session) -> Result<Figure, Fault> {
        let Order { scale, style, .. } = *self;
        let is_world = self.subject == FigureSubject::World;
        let sizes = ViewSizes {
            world: is_world.then_some(self.size),
            camera: (!is_world).then_some(self.size),
            scale,
            style,
            purpose: Purpose::Figure { clear: self.transparent },
            ..ViewSizes::default()
        };
        let derived = Deriver::default().derive(document, session, &sizes);
        // The world view can be drawn even if the camera has no basis.
        if let Some(fault) = derived.fault.filter(|f| !is_world || matches!(f, Fault::Scene(_))) {
            return Err(fault);
        }
        let shown = if is_world { derived.world_view } else { derived.camera_view };
        let drawing = shown.as_ref().map_or_else(Drawing::default, |shown| Drawing {
            scale,
            marks: shown.marks.to_vec(),
            labels: shown.labels.to_vec(),
            ..Drawing::default()
        });
        let ctx = Context::default();
        theme::install_base(&ctx);
        let drawn = UiPass::draw(&ctx, self.dots(), scale, |ui| {
            for label in &drawing.labels {
                labels::write_label(ui.painter(), Pos2::ZERO, scale, label);
            }
        });
        let has_dots =
            |image: &ColorImage| image.pixels.iter().any(|dot| *dot != Color32::TRANSPARENT);
        let outlines = shown.as_ref().map_or_else(Vec::new, |shown| shown.spheres.to_vec());
        let picture = shown.map(|shown| Arc::unwrap_or_clone(shown.image)).filter(has_dots);
        let figure = self.with_background(self.dots(), style.colors().background, drawn);
        Ok(figure.with_view(picture, outlines, drawing.paths().collect()))
    }

    fn derivation(&self, shown: &Derivation) -> Figure {
        let width = self.size[0] as f32 / self.scale;
        let column = vec2((width - 2.0 * MARGIN).max(60.0), UNLIMITED);
        let column = Rect::from_min_size(Pos2::new(MARGIN, MARGIN), column);
        let draw = |ctx: &Context, size| {
            let mut height = 0.0;
            let drawn = UiPass::draw(ctx, size, self.scale, |ui| {
                height = derivation::draw(ui, shown, column);
            });
            (drawn, height + 2.0 * MARGIN)
        };
        // The first pass only measures the height.
        let (_, height) = draw(&self.context(), [1, 1]);
        let size = [self.dots()[0], (height * self.scale).round().max(1.0) as usize];
        let ctx = self.context();
        let (drawn, _) = draw(&ctx, size);
        self.with_background(size, ctx.global_style().visuals.panel_fill, drawn)
    }

    fn dots(&self) -> [usize; 2] {
        self.size.map(|n| n as usize)
    }

    /// Creates an egui context in which text looks the same as in the window.
    fn context(&self) -> Context {
        let ctx = Context::default();
        theme::install_fonts(&ctx);
        theme::install(&ctx, theme::Look { scheme: self.style.scheme(), ..theme::Look::default() });
        ctx.set_theme(if self.style.is_dark() { Theme::Dark } else { Theme::Light });
        ctx
    }

    /// Creates a figure with these shapes and texts over a background.
    fn with_background(&self, size: [usize; 2], background: Color32, drawn: UiPass) -> Figure {
        let ground = (!self.transparent).then_some(background);
        Figure::plain(self.subject.title(), size, ground, drawn)
    }
}

/// Returns the number of dots per point for a figure of this width and height in dots that is made
/// without a window. The shorter side gets 720 points, or as many points as dots if it has fewer.
pub fn scale_of([width, height]: [u32; 2]) -> f32 {
    (width.min(height) as f32 / 720.0).max(1.0)
}

/// Returns the derivation of a document's camera and ray, even if the session's layout of views does
/// not include it.
pub fn derivation_of(document: &Document, session: &Session) -> Derivation {
    let mut session = session.clone();
    session.shown.setup.layout = ViewLayout::Derivation;
    let derived = Deriver::default().derive(document, &session, &ViewSizes::default());
    derived.derivation.map(|derivation| (*derivation).clone()).unwrap_or_default()
}
