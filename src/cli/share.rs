//! `pinhole share`: prints a scene or a lesson's step as a link, or draws the link as a QR code.

use std::path::PathBuf;

use pinhole_exchange::Document;
use pinhole_exchange::link::{self, Link, Linked};
use pinhole_figure::export::QrCode;

use super::console::{CommandError, is_standard, refused, scene_fault, to_stdout, unmade};
use super::load::{deliver, files_of, load, pose, selection_of};
use crate::cli::arguments::ShareArguments;
use crate::features::export::order::by_ending;
use crate::features::share::link::of_step;
use crate::model::lessons::{LessonArgument, OpenLesson};

pub(super) fn run(arguments: &ShareArguments) -> Result<(), CommandError> {
    let (scene, document, shown) = shown(arguments)?;
    let ray = match arguments.ray.is_given() {
        true => selection_of(&scene, &pose(&scene, &document)?, arguments.ray)?,
        false => None,
    };
    let fragment = Link { shown, ray, page: None }.to_fragment();
    let fragment = fragment.map_err(|error| scene_fault(&scene, error.problem))?;
    if let Some(base) = arguments.base.as_deref().filter(|base| !link::is_address(base)) {
        return refused(format!(
            "--base {base}: not the address of a page, which begins with https://"
        ));
    }
    let url = link::url(arguments.base.as_deref().unwrap_or_default(), &fragment);
    let code = || QrCode::of(&url).map_err(|problem| scene_fault(&scene, problem));
    let Some(output) = &arguments.output else {
        let drawn = if arguments.qr { code()?.to_terminal() } else { String::new() };
        return to_stdout(|out| writeln!(out, "{drawn}{url}"));
    };
    let by_ending = || by_ending(output, &[("svg", false), ("png", true)], "SVG or PNG");
    let is_png = if is_standard(output) { Ok(false) } else { by_ending() };
    let is_png = is_png.map_err(|problem| CommandError::Arguments(format!("-o {problem}")))?;
    let code = code()?;
    let bytes = match is_png {
        true => code.to_png().map_err(|error| unmade(output, &error))?,
        false => code.to_svg().into_bytes(),
    };
    deliver(Some(output), &files_of(&scene, &document), |out| out.write_all(&bytes))
}

/// Returns what is shared, with its document and its name in messages.
fn shown(arguments: &ShareArguments) -> Result<(PathBuf, Document, Linked), CommandError> {
    let Some(lesson) = &arguments.lesson else {
        let scene = arguments.scene.clone().unwrap_or_default();
        let document = load(&scene)?;
        let shown = Linked::scene(&document);
        return Ok((scene, document, shown));
    };
    let step = arguments.step.map(|step| format!(".{step}")).unwrap_or_default();
    let name = format!("{lesson}{step}");
    let refused = |problem: String| CommandError::Arguments(format!("--lesson {name}: {problem}"));
    let found = match LessonArgument::parse(&name).map_err(refused)? {
        LessonArgument::Builtin(id) => OpenLesson::at(id, None),
        LessonArgument::File(_) => None,
    };
    let step = found.and_then(|open| Some((open.step().document.clone(), of_step(open.id())?)));
    let (document, shown) =
        step.ok_or_else(|| refused("only lessons of the program have a link".to_owned()))?;
    Ok((name.into(), document, shown))
}
