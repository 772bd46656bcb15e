//! `pinhole check --codes` and `--answers FOLDER`: counts the mistakes in a class's answers.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{fs, io, iter};

use pinhole_exchange::{FileError, answers, legible, legible_name, limits};
use pinhole_lecture::Mistake;
use pinhole_lecture::grading::Graded;
use pinhole_lecture::numbers::grouped;
use rayon::prelude::*;
use serde::Serialize;
use serde_json::{Value, json};

use super::check::{CheckOutcome, Task, status, to_value};
use super::console::{CommandError, columns, read, to_json, warn};
use super::progress::Progress;
use crate::cli::arguments::CheckArguments;
use crate::features::class::state::{
    ClassAnswers, INCOMPLETE, NOT_JUDGED, RIGHT, Tally, outcomes_of_grade,
};

/// Grades the codes of answers in a text.
pub(super) fn of_codes(path: &Path, as_json: bool) -> Result<CheckOutcome, CommandError> {
    let (path, bytes) = read(path, limits::FOREIGN)?;
    let class = ClassAnswers::read(&String::from_utf8_lossy(&bytes));
    if class.exercises.is_empty() {
        let first = class.not_readable.first();
        let problem = match first {
            None => "no code in it: the code of an answer begins with answer1/".to_owned(),
            Some((line, problem)) => {
                format!("no code can be read: that in line {line} is {problem}")
            }
        };
        return Err(FileError::of_file(path, problem).into());
    }
    let text = if as_json {
        to_json(&class)?
    } else {
        let of = class.exercises.iter().map(|own| bars(&own.title, own.answers, &own.tally));
        let problems = class.problems().map(|problem| problem + "\n");
        of.chain(problems).collect()
    };
    Ok((text, status(class.all_right())))
}

/// Grades every file in a folder. Nothing is printed before the last file is graded.
pub(super) fn of_folder(
    task: &Task,
    folder: &Path,
    arguments: &CheckArguments,
) -> Result<CheckOutcome, CommandError> {
    let (skipped, files) = entries(folder)?;
    if !skipped.is_empty() {
        warn(&format!("skipped as hidden or a folder: {}", skipped.join(", ")));
    }
    if files.is_empty() {
        let problem = "there is no file in it: it must have a file for each student";
        return Err(FileError::of_file(folder, problem).into());
    }
    let progress = Progress::new("file", files.len());
    let grade = |path: &PathBuf| {
        let student = Student::new(folder, path, task);
        progress.add(1);
        student
    };
    // As many at once as there is memory for, even if each takes as much as a file of its size can.
    let most = |path: &PathBuf| {
        let length = fs::metadata(path).map_or(0, |data| data.len());
        let length = length.min(answers::largest(task.image));
        length + answers::memory(None, length / answers::SHORTEST_ROW, task.image)
    };
    let most = files.iter().map(most).max();
    let fits = |count: &usize| {
        limits::memory("the files", most.unwrap_or_default() * *count as u64).is_ok()
    };
    let threads = rayon::current_num_threads().min(files.len());
    let fitting = (1..=threads).rev().find(fits).unwrap_or(1);
    let at_once = if fitting == threads { files.len() } else { fitting };
    let graded = files.chunks(at_once).map(|some| some.par_iter().map(grade).collect::<Vec<_>>());
    let mut students: Vec<Student> = graded.flatten().collect();
    drop(progress);
    name_apart(&mut students);
    let mistakes = students.iter().flat_map(|student| &student.made).copied().collect();
    let outcomes = students.iter().map(|student| student.outcomes.clone());
    let tally = Tally::new(outcomes, &mistakes, |one| one.advice());
    let is_open = |student: &Student| [BROKEN, NOT_JUDGED].contains(&student.verdict);
    let status = if students.iter().all(is_open) {
        let problem = FileError::of_file(folder, "none of its files can be graded");
        Err(CommandError::Unreadable(problem.to_string()))
    } else {
        status(students.iter().all(|student| student.verdict == RIGHT))
    };
    let text = if arguments.json {
        to_json(&ClassFiles { students, tally, skipped })?
    } else if arguments.csv {
        csv(&students)
    } else {
        let plural = if students.len() == 1 { "file" } else { "files" };
        let title = format!("{}: {} {plural}", legible_name(folder), students.len());
        let names = short_names(&students);
        let rows: Vec<_> =
            names.into_iter().zip(&students).map(|(name, own)| own.cells(name)).collect();
        columns(&rows).join("\n") + "\n\n" + &bars(&title, students.len(), &tally)
    };
    Ok((text, status))
}

/// Returns the names of a folder's hidden files and folders, and the paths of its other files, each in the
/// order of names, in which capitals do not count.
fn entries(folder: &Path) -> Result<(Vec<String>, Vec<PathBuf>), FileError> {
    let names = fs::read_dir(folder)
        .and_then(|all| all.map(|entry| Ok(entry?.file_name())).collect::<io::Result<Vec<_>>>());
    let mut names = names.map_err(|error| FileError::unreadable(folder, &error))?;
    let stem = |name: &OsString| {
        Path::new(name).file_stem().unwrap_or_default().to_string_lossy().to_lowercase()
    };
    names.sort_by_key(|name| (stem(name), name.clone()));
    let (mut skipped, mut files) = (Vec::new(), Vec::new());
    for name in names {
        let path = folder.join(&name);
        let is_hidden = name.as_encoded_bytes().starts_with(b".");
        if is_hidden || path.is_dir() {
            skipped.push(legible_name(name));
        } else {
            files.push(path);
        }
    }
    Ok((skipped, files))
}

/// Names all students by their files with the endings if names without them are not all different.
fn name_apart(students: &mut [Student]) {
    let names: BTreeSet<&String> = students.iter().map(|student| &student.name).collect();
    if names.len() < students.len() {
        students.iter_mut().for_each(|student| student.name.clone_from(&student.file));
    }
}

/// Returns an error for a link to a file outside of the folder: what is there is not for the reader of grades.
fn refuse_link_out_of(folder: &Path, path: &Path) -> Result<(), FileError> {
    let resolved =
        |own: &Path| own.canonicalize().map_err(|error| FileError::unreadable(path, &error));
    if !path.is_symlink() || resolved(path)?.starts_with(resolved(folder)?) {
        return Ok(());
    }
    let target = legible_name(resolved(path)?);
    let problem = format!("it is a link out of the folder, to {target}, which is not followed");
    Err(FileError::of_file(path, problem))
}

/// Maximum length of a name in the table, in characters.
const LONGEST_NAME: usize = 40;

/// Returns the students' names, with the middle of long ones left out. Those that would then be alike are numbered.
fn short_names(students: &[Student]) -> Vec<String> {
    let is_short = |name: &str| name.chars().count() <= LONGEST_NAME;
    let names = students.iter().map(|student| &student.name);
    let mut used: BTreeSet<String> = names.filter(|name| is_short(name)).cloned().collect();
    let short = |student: &Student| {
        if is_short(&student.name) {
            return student.name.clone();
        }
        let chars: Vec<char> = student.name.chars().collect();
        let (start, end) = (LONGEST_NAME / 2, chars.len() + 1 - LONGEST_NAME / 2);
        let ends = [&chars[..start], &chars[end..]].map(String::from_iter);
        let gaps = iter::once("…".to_owned()).chain((2..).map(|count| format!("…{count}…")));
        let mut names = gaps.map(|gap| ends.join(&gap));
        names.find(|name| used.insert(name.clone())).unwrap_or_default()
    };
    students.iter().map(short).collect()
}

/// The JSON output for a folder.
#[derive(Serialize)]
struct ClassFiles {
    students: Vec<Student>,
    #[serde(flatten)]
    tally: Tally,
    skipped: Vec<String>,
}

/// The verdict on a file that cannot be graded.
const BROKEN: &str = "broken";

/// A student's file, and what was found in it.
#[derive(Serialize)]
struct Student {
    /// The file's name, without its ending if such names are all different; as `file`, in the form of
    /// [`legible_name`].
    name: String,
    file: String,
    /// [`RIGHT`], `wrong`, [`INCOMPLETE`], [`NOT_JUDGED`] or [`BROKEN`].
    verdict: &'static str,
    #[serde(flatten)]
    check: Option<Value>,
    /// The reason why the file cannot be graded.
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<String>,
    /// How many answers agree, such as `hits: 3 of 4, 1 not judged`; empty if the file cannot be graded.
    #[serde(skip)]
    agreement: String,
    #[serde(skip)]
    outcomes: BTreeSet<String>,
    #[serde(skip)]
    made: BTreeSet<Mistake>,
}

impl Student {
    /// Grades a file in the folder.
    fn new(folder: &Path, path: &Path, task: &Task) -> Student {
        let [name, file] =
            [path.file_stem(), path.file_name()].map(|name| legible_name(name.unwrap_or_default()));
        let is_inside = refuse_link_out_of(folder, path).map_err(CommandError::from);
        let graded = is_inside.and_then(|()| task.grade(path));
        let mut made = BTreeSet::new();
        let outcomes = match &graded {
            Ok(graded) => outcomes_of_grade(&graded.grade, &mut made),
            Err(_) => BTreeSet::from([BROKEN.to_owned()]),
        };
        let is = |verdict: &&str| outcomes.contains(*verdict);
        let verdict =
            [RIGHT, INCOMPLETE, NOT_JUDGED, BROKEN].into_iter().find(is).unwrap_or("wrong");
        let problem = graded.as_ref().err().map(ToString::to_string);
        let agreement = graded.as_ref().map(|Graded { grade, .. }| {
            let [agree, all] = [grade.agree(), grade.answers()].map(|count| grouped(count as u64));
            format!("{}: {agree} of {all}{}", grade.kind.name(), grade.not_judged_in_words())
        });
        let agreement = agreement.unwrap_or_default();
        let check = graded.as_ref().ok().map(to_value);
        Student { name, file, verdict, check, problem, agreement, outcomes, made }
    }

    /// Returns the cells of the student's line, which begins with this name.
    fn cells(&self, name: String) -> [String; 4] {
        let found = self.outcomes.iter().map(String::as_str).filter(|one| *one != self.verdict);
        let found: Vec<&str> = found.chain(self.problem.as_deref()).collect();
        let found = legible(&found.join(", "));
        [name, self.verdict.to_owned(), self.agreement.clone(), found]
    }
}

/// Returns a row for each student, with these fields of the JSON output.
fn csv(students: &[Student]) -> String {
    const COLUMNS: &str = "name,file,verdict,kind,answers,agree,not_judged,mistakes,advice,problem";
    let cell = |value: &Value| match value {
        Value::Null => String::new(),
        Value::String(text) => text_cell(text),
        Value::Array(all) => all.iter().filter_map(Value::as_str).collect::<Vec<_>>().join(" "),
        other => other.to_string(),
    };
    let row = |student: &Student| {
        let fields = json!(student);
        let cells = COLUMNS.split(',').map(|column| cell(&fields[column]));
        cells.collect::<Vec<_>>().join(",") + "\n"
    };
    format!("{COLUMNS}\n") + &students.iter().map(row).collect::<String>()
}

/// Returns a text as a cell of a CSV file. If a spreadsheet would take the text for a formula, also where semicolons
/// separate cells, an apostrophe stands before it (OWASP, *CSV Injection*). Unlike texts stay unlike, since an
/// apostrophe that stands there already gets another one.
fn text_cell(text: &str) -> String {
    const OF_FORMULA: [char; 11] =
        ['=', '+', '-', '@', '\t', '\r', '\n', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}'];
    let guarded = |part: &str| {
        let is_formula = part.trim_start_matches(['\'', '"', ' ']).starts_with(OF_FORMULA);
        if is_formula { format!("'{part}") } else { part.to_owned() }
    };
    let cell = text.split(';').map(guarded).collect::<Vec<_>>().join(";");
    if cell.contains([',', ';', '"', '\t', '\n', '\r']) {
        return format!("\"{}\"", cell.replace('"', "\"\""));
    }
    cell
}

/// Maximum length of a bar, in characters.
const LONGEST: usize = 40;

/// Returns the outcomes of `answers` answers as bars, and what the mistakes are.
fn bars(title: &str, answers: usize, tally: &Tally) -> String {
    let mut text = format!("{title}\n");
    let width = tally.counts.iter().map(|(outcome, _)| outcome.len()).max().unwrap_or_default();
    for (outcome, count) in &tally.counts {
        let bar = "#".repeat((count * LONGEST / answers.max(LONGEST)).max(1));
        let _ = writeln!(text, "  {outcome:width$}  {count:4}  {bar}");
    }
    for line in &tally.explanations {
        let _ = writeln!(text, "  {line}");
    }
    text
}
