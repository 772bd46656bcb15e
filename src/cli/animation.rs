//! `pinhole figure --play`: an animation, by the window's recorder.

use super::CommandError;
use super::figure;
use super::load;
use super::progress::Progress;
use crate::cli::arguments::FigureArguments;
use crate::figures::{Animation, Frames, Recorder, Reel, Subject, check_name};
use crate::model::play::{Kind, Start};
use crate::model::session::Session;
use crate::view::derive::{Deriver, ViewSizes};
use pinhole_exchange::atomic;
use pinhole_exchange::document::Document;

pub(super) fn run(arguments: &FigureArguments, kind: Kind) -> Result<(), CommandError> {
    let refused = |problem: &str| Err(CommandError::Arguments(problem.to_owned()));
    if !matches!(arguments.view, Subject::World | Subject::Camera) {
        return refused("--play shows a view: --view world or --view camera");
    }
    let output = &arguments.output;
    check_name(output).map_err(|problem| CommandError::Arguments(format!("-o {problem}")))?;
    if !arguments.numbered {
        atomic::check(output)?;
    }
    let document = load(&arguments.scene)?;
    let order = figure::order_of(arguments, document.camera.image)?;
    let mut session = figure::session_of(arguments, &document, order.size)?;
    let start = start_of(&document, &session);
    let [width, height] = order.size.map(f64::from);
    session.observer = session
        .observer
        .map(|from| from.following(&document.camera, &start.cameras(kind), width / height));
    let frames = frames_of(arguments, kind);
    let scene = (document, session);
    let loops = kind.is_round();
    let animation = Animation { kind, start, loops, scene, order, frames };
    let why = |problem| CommandError::Input(format!("{}: {problem}", arguments.scene.display()));
    // What cannot move is known before anything is written.
    animation.start.at(kind, 0.5).map_err(|error| why(error.to_string()))?;
    let mut recorder = Recorder::new(animation, output.clone()).map_err(CommandError::Input)?;
    let progress = Progress::of_frames(frames.count);
    for _ in 0..frames.count {
        recorder.step().map_err(why)?;
        progress.add(1);
    }
    recorder.finish().map_err(CommandError::Input)
}

fn start_of(document: &Document, session: &Session) -> Start {
    // The ray is asked about wherever the derivation is open.
    let derived = Deriver::default().derive(document, session, &ViewSizes::default());
    Start::of(document, session, derived.inspection.as_deref())
}

fn frames_of(arguments: &FigureArguments, kind: Kind) -> Frames {
    let mut frames = arguments.per_second.map_or(Frames::of(kind), |each| Frames::at(kind, each));
    frames.count = arguments.frames.unwrap_or(frames.count);
    if arguments.numbered {
        frames.reel = Reel::Numbered;
    }
    frames
}
