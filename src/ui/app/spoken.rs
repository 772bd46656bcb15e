//! The window's contents in words, for a host that shows screen readers no widgets.

use std::sync::Arc;

use crate::model::files::title_of;
use crate::model::readings::{Reading, of_basis};
use crate::model::{Fault, Inspection, NumberStyle, Settings, StepId};
use crate::ui::app::App;
use crate::ui::scene::views;
use crate::view::typesetting::notation::{plain, without_marks};

/// What the words depend on.
#[derive(PartialEq)]
pub struct SpokenAbout {
    title: String,
    step: Option<StepId>,
    is_asking: bool,
    settings: Settings,
    fault: Option<Fault>,
    inspection: Option<Arc<Inspection>>,
}

impl App {
    /// Returns what [`spoken`](App::spoken) depends on.
    pub fn spoken_about(&self) -> SpokenAbout {
        let (session, derived) = (&self.scene.session, &self.views.derived);
        SpokenAbout {
            title: title_of(self.scene.open.origin()),
            step: self.lesson().map(|lesson| lesson.id()),
            is_asking: session.is_asking,
            settings: session.settings,
            fault: derived.fault,
            inspection: derived.inspection.clone(),
        }
    }

    /// Returns the window's title, the text of the lesson's step, and the numbers of the selected ray, a line
    /// each. Numbers are left out while a question is open, because they may answer it.
    pub fn spoken(&self) -> String {
        let (open, session, derived) = (&self.scene.open, &self.scene.session, &self.views.derived);
        let mut lines = vec![title_of(open.origin())];
        if let Some(step) = self.lesson().map(|lesson| lesson.step()) {
            lines.push(without_marks(&step.text));
            if let Some(question) = &step.question {
                let said = if session.is_asking { &question.ask } else { &question.answer };
                lines.push(without_marks(said));
            }
        }
        if session.is_asking {
            return lines.join("\n");
        }
        lines.push(views::spoken(derived));
        let style = NumberStyle::new(&session.settings);
        let line = |reading: &Reading| {
            format!("{} {}", plain(reading.long_name), style.equated_value(&reading.value))
        };
        if let Some(resolved) = &derived.resolved {
            lines.extend(of_basis(resolved, None).iter().map(line));
            let inspection = derived.inspection.iter();
            lines.extend(
                inspection.flat_map(|seen| seen.ray_readings(resolved.image())).map(|r| line(&r)),
            );
        }
        lines.join("\n")
    }
}
