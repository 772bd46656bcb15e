//! The dialog that exports a figure: it asks for the content, the size and the file.

use std::path::Path;

use egui::{Checkbox, DragValue, Grid, RichText, Ui};
use pinhole_figure::Scheme;
use pinhole_figure::overlay::Style;
use pinhole_figure::typesetting::theme::error_color;

use crate::features::export::animation::{Frames, check_animation_path};
use crate::features::export::order::{Content, FigureSubject, Order};
use crate::features::play::state::Kind;
use crate::ui::action::{Action, FigureAction};
use crate::ui::widgets::ResponseExt as _;
use crate::ui::widgets::path_field::{FileQuestion, PathField};

/// Maximum side of a figure, in pixels.
const LARGEST: u32 = 16_384;

/// Maximum number of frames of an animation.
const MOST_FRAMES: u32 = 9999;

/// A figure's subject with its size on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OnScreen {
    pub(crate) subject: FigureSubject,
    /// Width and height in points.
    pub(crate) points: [f32; 2],
    /// Pixels per point.
    pub(crate) scale: f32,
}

impl OnScreen {
    pub(crate) fn dots(self) -> [u32; 2] {
        self.points.map(|n| ((n * self.scale).round() as u32).clamp(1, LARGEST))
    }

    /// Returns the request for a figure of this size in pixels. Its scale is the largest at which the subject
    /// fits; a derivation only needs to fit in width.
    pub(crate) fn order(self, size: [u32; 2], style: Style, transparent: bool) -> Order {
        let [across, down] = [0, 1].map(|k| size[k] as f32 / self.points[k].max(1.0));
        let scale =
            if self.subject == FigureSubject::Derivation { across } else { across.min(down) };
        Order { subject: self.subject, size, scale, style, transparent }
    }
}

/// The fields of the dialog.
#[derive(Default)]
pub(crate) struct ExportForm {
    pub(crate) field: PathField,
    subjects: Vec<OnScreen>,
    chosen: usize,
    size: [u32; 2],
    style: Style,
    transparent: bool,
    /// The kind and the frames of an animation; with `None`, a single figure is exported.
    animation: Option<(Kind, Frames)>,
    /// The error in the path.
    problem: Option<String>,
}

const FIGURE: FileQuestion = FileQuestion {
    title: "Export a figure",
    endings: &["svg", "pdf", "png", "tex", "md"],
    hint: "path of an .svg, .pdf or .png file",
    writes: Some("svg"),
};
const ANIMATION: FileQuestion = FileQuestion {
    title: "Export the animation",
    endings: &["gif"],
    hint: "path of a .gif file",
    writes: Some("gif"),
};

impl ExportForm {
    /// Creates the form, with a path near the scene's file and the first subject chosen.
    pub(crate) fn new(scene: Option<&Path>, subjects: Vec<OnScreen>, style: Style) -> ExportForm {
        let name = subjects.first().map_or("figure", |first| first.subject.name());
        let field = PathField::new(FIGURE, scene, &format!("{name}.svg"));
        ExportForm {
            field,
            size: subjects.first().map_or([1, 1], |first| first.dots()),
            subjects,
            style,
            ..ExportForm::default()
        }
    }

    /// Turns the form into one for an animation of this kind, with as many frames as its whole duration
    /// needs.
    pub(crate) fn animated(mut self, kind: Kind) -> ExportForm {
        self.animation = Some((kind, Frames::new(kind, Frames::PER_SECOND)));
        self.field.question = ANIMATION;
        if let Some(folder) = self.field.text.strip_suffix("world.svg") {
            self.field.text = format!("{folder}{}.gif", kind.name());
        }
        self
    }

    /// Shows the form. Returns the export once it is confirmed.
    pub(crate) fn ui(&mut self, ui: &mut Ui, close: &mut bool) -> Option<Action> {
        ui.heading(self.field.question.title);
        let shown = self.subject(ui)?;
        Grid::new("export").num_columns(2).show(ui, |ui| {
            self.looks(ui, shown);
            if let Some((_, frames)) = &mut self.animation {
                let count = DragValue::new(&mut frames.count).range(1..=MOST_FRAMES);
                number(ui, "frames", "frames", count);
                let most = Frames::MOST_PER_SECOND;
                let rate = DragValue::new(&mut frames.per_second).range(1..=most);
                number(ui, "per second", "frames per second", rate);
            }
        });
        let typed = self.field.text.clone();
        let path = self.field.ui(ui, close);
        if self.field.text != typed || self.field.request().is_some() {
            self.problem = None;
        }
        let export = path.and_then(|path| {
            let order = shown.order(self.size, self.style, self.transparent);
            let (content, export) = match self.animation {
                Some((_, frames)) => (
                    check_animation_path(&path),
                    FigureAction::ExportAnimation(order, frames, path),
                ),
                None => (
                    Content::for_path(shown.subject, &path).map(drop),
                    FigureAction::Export(order, path),
                ),
            };
            self.problem = content.err().map(|problem| format!("Export {problem}"));
            self.problem.is_none().then_some(export.into())
        });
        if let Some(problem) = &self.problem {
            ui.label(RichText::new(problem).color(error_color(ui)));
        }
        export
    }

    /// Shows the choice of the figure's subject.
    fn subject(&mut self, ui: &mut Ui) -> Option<OnScreen> {
        ui.horizontal_wrapped(|ui| {
            for (k, shown) in self.subjects.iter().enumerate() {
                if ui.radio(self.chosen == k, shown.subject.title()).clicked() && self.chosen != k {
                    // A file name that was not edited follows the subject.
                    let before = self.subjects[self.chosen].subject.name();
                    let path = Path::new(&self.field.text);
                    if let (Some(stem), Some(ending)) = (path.file_stem(), path.extension())
                        && stem == before
                    {
                        let name = Path::new(shown.subject.name()).with_extension(ending);
                        self.field.text = path.with_file_name(name).display().to_string();
                    }
                    (self.chosen, self.size) = (k, shown.dots());
                }
            }
        });
        self.subjects.get(self.chosen).copied()
    }

    fn looks(&mut self, ui: &mut Ui, shown: OnScreen) {
        let dots = |value| DragValue::new(value).range(1..=LARGEST).suffix(" pixels");
        let [across, down] = shown.points;
        let follow =
            |dots: u32, ratio: f32| ((dots as f32 * ratio).round() as u32).clamp(1, LARGEST);
        let [width, height] = &mut self.size;
        let is_wider = number(ui, "width", "figure width", dots(width));
        if shown.subject == FigureSubject::Derivation {
            ui.label("height");
            ui.weak("fits its lines");
            ui.end_row();
        } else {
            let is_higher = number(ui, "height", "figure height", dots(height));
            // The camera's figure keeps its aspect ratio, so that its pixels keep their shape.
            match (shown.subject, is_wider, is_higher) {
                (FigureSubject::Camera, true, _) => *height = follow(*width, down / across),
                (FigureSubject::Camera, _, true) => *width = follow(*height, across / down),
                _ => {}
            }
        }
        ui.label("colours");
        ui.horizontal(|ui| {
            let scheme = self.style.scheme();
            ui.radio_value(&mut self.style, Style::new(scheme, false), "light");
            ui.radio_value(&mut self.style, Style::new(scheme, true), "dark");
        });
        ui.end_row();
        ui.label("");
        ui.vertical(|ui| {
            let dark = self.style.is_dark();
            for scheme in Scheme::ALL {
                ui.radio_value(&mut self.style, Style::new(scheme, dark), scheme.label());
            }
        });
        ui.end_row();
        // GIF has no partial transparency.
        if self.animation.is_none() {
            ui.label("background");
            ui.add(Checkbox::new(&mut self.transparent, "transparent"));
            ui.end_row();
        }
    }
}

/// Shows a row with a field for a number. Returns true if the number changed.
fn number(ui: &mut Ui, label: &str, name: &str, field: DragValue) -> bool {
    ui.label(label);
    let response = ui.add(field).named(name);
    ui.end_row();
    response.changed()
}
