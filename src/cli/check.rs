//! `pinhole check`: grades a student's answers, and names the mistake that explains them.

use std::fmt::Write as _;
use std::io::BufWriter;
use std::path::Path;

use pinhole_core::{ImageSize, Scene};
use pinhole_exchange::images::png;
use pinhole_exchange::{Document, FileError, answers, atomic};
use pinhole_lecture::Mistake;
use pinhole_lecture::grading::{AnswerKind, AnswerValue, Grade, Graded, Truth, Worst, grade};
use serde_json::{Value, json};

use super::check_class;
use super::console::{
    CommandError, is_standard, named, read, refused, scene_fault, to_json, to_stdout,
};
use super::load::{files_of, load, pose, refuse_overwriting, refuse_reading_twice};
use crate::cli::arguments::CheckArguments;

/// What is printed, and the exit status: an error unless all judged answers agree.
pub(super) type CheckOutcome = (String, Result<(), CommandError>);

/// Runs `pinhole check`. If the scene or another input cannot be read, the exit status is not that of wrong
/// answers, because the student is not to blame.
pub(super) fn run(arguments: &CheckArguments) -> Result<(), CommandError> {
    let checked = match (&arguments.codes, &arguments.scene, &arguments.answers) {
        (Some(codes), ..) => check_class::of_codes(codes, arguments.json),
        (None, Some(scene), Some(answers)) => of_answers(arguments, scene, answers),
        // clap refuses it before.
        _ => refused("give a SCENE and --answers, or --codes"),
    };
    let (text, status) = checked.map_err(unreadable)?;
    match to_stdout(|out| out.write_all(text.as_bytes())) {
        // The exit status reports the grade, even if nobody reads the output.
        Ok(()) | Err(CommandError::ReaderGone) => status,
        Err(error) => Err(unreadable(error)),
    }
}

/// Returns the status of judged answers that all agree, or that do not.
pub(super) fn status(all_agree: bool) -> Result<(), CommandError> {
    if all_agree { Ok(()) } else { Err(CommandError::Disagrees) }
}

fn unreadable(error: CommandError) -> CommandError {
    match error {
        CommandError::Input(message) => CommandError::Unreadable(message),
        other => other,
    }
}

/// Grades a student's answers, or those of a class in a folder.
fn of_answers(
    arguments: &CheckArguments,
    scene_path: &Path,
    answers_path: &Path,
) -> Result<CheckOutcome, CommandError> {
    if let Some(map) = &arguments.map {
        named(map, "png", "--map writes PNG")?;
        atomic::check(map)?;
    }
    refuse_reading_twice(scene_path, ("--answers", answers_path))?;
    if arguments.map.as_deref().is_some_and(is_standard) {
        return refused("--map needs a file: the grade goes to standard output");
    }
    let task = Task::read(arguments, scene_path)?;
    if answers_path.is_dir() {
        if arguments.map.is_some() {
            return refused("--map shows one student's answers, and --answers is a folder");
        }
        return check_class::of_folder(&task, answers_path, arguments);
    }
    if arguments.csv {
        return refused("--csv has a row for each student: --answers must be a folder");
    }
    let mut inputs = files_of(scene_path, &task.document);
    inputs.push(answers_path.to_owned());
    refuse_overwriting(&inputs, arguments.map.as_deref().map(|map| ("--map", map)))?;
    let graded = task.grade(answers_path)?;
    if let Some(map) = &arguments.map {
        if graded.grade.kind == AnswerKind::Basis {
            return refused(
                "--map shows where in the image answers are wrong: a basis has no place there",
            );
        }
        save_map(map, &graded, graded.image)?;
    }
    let text = if arguments.json { to_json(&to_value(&graded))? } else { text(&graded) };
    let status = match graded.grade.is_judged() {
        true => status(graded.grade.passes()),
        false => Err(CommandError::Unreadable(graded.grade.advice())),
    };
    Ok((text, status))
}

/// The scene for which answers are graded, and the options by which they are.
pub(super) struct Task<'a> {
    arguments: &'a CheckArguments,
    scene_path: &'a Path,
    document: Document,
    scene: Scene,
    pub(super) image: ImageSize,
}

impl<'a> Task<'a> {
    fn read(arguments: &'a CheckArguments, scene_path: &'a Path) -> Result<Task<'a>, CommandError> {
        let document = load(scene_path)?;
        let image = pose(scene_path, &document)?.image();
        let scene = document.scene().map_err(|error| scene_fault(scene_path, error))?;
        Ok(Task { arguments, scene_path, document, scene, image })
    }

    /// Grades the answers in a file.
    pub(super) fn grade(&self, answers_path: &Path) -> Result<Graded, CommandError> {
        let (arguments, document, image) = (self.arguments, &self.document, self.image);
        let (path, bytes) = read(answers_path, answers::largest(image))?;
        if let (Some(asked), Some(kind)) = (&arguments.kind, answers::kind_of(&bytes))
            && asked != kind.name()
        {
            let problem = format!("these are answers of the kind {}, not {asked}", kind.name());
            return Err(FileError::of_file(path, problem).into());
        }
        if let [missing, ..] = answers::missing(&bytes, &arguments.columns)[..] {
            let problem = format!("column {missing} is missing: it is asked for");
            return Err(FileError::of_file(path, problem).into());
        }
        let answers = answers::parse(path, &bytes, image, arguments.count_from)?;
        let color_of = |object| document.color_of(object);
        let truth = Truth { camera: &document.camera, scene: &self.scene, color_of: &color_of };
        let grade: Grade = grade(&truth, &answers, arguments.tolerance)
            .map_err(|error| scene_fault(self.scene_path, error))?;
        let graded = Graded { answers, grade, image, count_from: arguments.count_from };
        Ok(if arguments.complete { graded.complete() } else { graded })
    }
}

fn save_map(path: &Path, graded: &Graded, image: ImageSize) -> Result<(), FileError> {
    let cells = graded.map().unwrap_or_default();
    let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
    let pixels: Vec<[u8; 4]> = cells.iter().map(|cell| opaque(cell.color())).collect();
    let size = [image.width(), image.height()];
    atomic::write(path, |file| png::encode(BufWriter::new(file), size, &pixels, false))
}

fn text(graded: &Graded) -> String {
    let grade = &graded.grade;
    let mut text = format!("{}: {}\n", grade.kind.name(), graded.agreement());
    if let Some(unanswered) = graded.unanswered() {
        let _ = writeln!(text, "missing: {unanswered}");
    }
    for note in graded.notes() {
        let _ = writeln!(text, "note: {note}");
    }
    if grade.wrong() == 0 {
        return text;
    }
    if let Some(worst) = graded.worst() {
        let _ = writeln!(text, "worst: {worst}");
        let sketch = graded.sketch();
        for (index, line) in sketch.iter().enumerate() {
            let head = if index == 0 { "where: " } else { "       " };
            let _ = writeln!(text, "{head}{}", line.trim_end());
        }
        if !sketch.is_empty() {
            let not = if grade.not_judged.is_empty() { "" } else { "? not judged, " };
            let _ = writeln!(text, "       # wrong, {not}. right, blank not answered");
        }
    }
    if grade.diagnosis.mistakes.is_empty() {
        let _ = writeln!(text, "mistake: {}", grade.advice());
        return text;
    }
    let _ = writeln!(text, "mistake: {}", graded.mistakes());
    let sentences =
        grade.diagnosis.mistakes.iter().map(|mistake| graded.advice_on(*mistake).to_owned());
    for sentence in sentences.chain(graded.remarks()) {
        let _ = writeln!(text, "  {sentence}");
    }
    text
}

/// Returns the JSON output, with its fields in the order in which the man page explains them. The shade is the
/// shading with which a graded picture was compared. `unanswered` counts the pixels without an answer if they count
/// as wrong, and `not_judged` the answers that are not judged, because wrong ones would be accepted, too.
pub(super) fn to_value(graded: &Graded) -> Value {
    let grade = &graded.grade;
    let ids = |mistakes: &Vec<Mistake>| -> Vec<&str> {
        mistakes.iter().map(|mistake| mistake.id()).collect()
    };
    json!({
        "kind": grade.kind.name(),
        "answers": grade.answers(),
        "agree": grade.agree(),
        "tolerance": grade.tolerance,
        "worst": grade.worst.as_ref().map(|worst| worst_of(graded, worst)),
        "mistakes": ids(&grade.diagnosis.mistakes),
        "advice": graded.advice(),
        // Other sets of mistakes that would lead to the same answers.
        "alternatives": grade.diagnosis.alternatives.iter().map(ids).collect::<Vec<_>>(),
        "shade": grade.shade.map(|shade| shade.name()),
        "unanswered": grade.unanswered,
        "not_judged": grade.not_judged.len(),
    })
}

/// Returns the worst answer as JSON: its position, the given and the right answer, and the distance between
/// these two. The distance is `null` if a hit is confused with a miss, or with a hit of another object. A
/// miss is `"miss"`. If the pixel does not exist, the right answer is `null`.
fn worst_of(graded: &Graded, worst: &Worst) -> Value {
    let index = worst.index;
    let json_of = |value: AnswerValue| match value {
        AnswerValue::Vector(vector) => json!(vector.to_array()),
        AnswerValue::Ray(ray) => {
            json!({"origin": ray.origin.to_array(), "direction": ray.direction.to_array()})
        }
        AnswerValue::Hit { t, point, object } => {
            json!({"t": t, "point": point.map(|point| point.to_array()), "object": object})
        }
        AnswerValue::Miss => json!("miss"),
        AnswerValue::NoPixel => Value::Null,
        AnswerValue::Color(color) => json!(color),
    };
    let (given, right) = (json_of(graded.given(index)), json_of(worst.right));
    let name = ["u", "v", "w"].get(index);
    let error = worst.error.is_finite().then_some(worst.error);
    let mut value = json!({"given": given, "right": right, "error": error});
    match graded.pixel(index) {
        Some(pixel) => {
            value["row"] = json!(pixel.row + graded.count_from);
            value["column"] = json!(pixel.column + graded.count_from);
        }
        None => value["vector"] = json!(name),
    }
    value
}
