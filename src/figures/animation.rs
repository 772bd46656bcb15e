//! Animations as GIF, with a figure for each phase.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use pinhole_exchange::FileError;
use pinhole_exchange::atomic::Draft;
use pinhole_exchange::document::Document;
use pinhole_exchange::images::gif;

use super::order::Order;
use super::{Figure, to_srgba};
use crate::model::play::{Kind, Start};
use crate::model::session::Session;

/// The number of frames, and how fast they follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    /// Number of frames, at least one.
    pub count: u32,
    /// Frames per second, at most [`Frames::MOST_PER_SECOND`].
    pub per_second: u16,
}

impl Frames {
    /// The usual number of frames per second.
    pub const PER_SECOND: u16 = 20;
    /// Maximum number of frames per second.
    pub const MOST_PER_SECOND: u16 = gif::MOST_PER_SECOND;

    /// Returns the frames of a whole animation of this kind.
    pub fn new(kind: Kind, per_second: u16) -> Frames {
        let count = (kind.seconds() * f64::from(per_second)) as u32;
        Frames { count: count.max(1), per_second }
    }
}

/// Checks that a file of this name may hold an animation.
///
/// # Errors
/// Returns an error, as a sentence, if the name does not end with `.gif`.
pub fn check_animation_path(path: &Path) -> Result<(), String> {
    if path.extension().is_some_and(|own| own.eq_ignore_ascii_case("gif")) {
        return Ok(());
    }
    Err("writes animations as GIF: end the name with .gif".to_owned())
}

/// An animation as a sequence of figures.
#[derive(Clone, Debug)]
pub struct Animation {
    /// The kind of motion.
    pub kind: Kind,
    /// The state at the start.
    pub start: Start,
    /// True if it begins again after the end.
    pub loops: bool,
    /// The document, and the session that looks at it.
    pub scene: (Document, Session),
    /// The figure of each phase.
    pub order: Order,
    /// The number and pace of the figures.
    pub frames: Frames,
}

/// An animation that is being written. Dropped before it is finished, it leaves no file.
pub struct Recorder {
    animation: Animation,
    done: u32,
    path: PathBuf,
    gif: gif::Animated<BufWriter<File>>,
    /// The unfinished file, in the folder where it will be.
    draft: Draft,
}

impl Recorder {
    /// Begins to write an animation.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the file cannot be written.
    pub fn new(animation: Animation, path: PathBuf) -> Result<Recorder, String> {
        let draft = Draft::create(&path).map_err(|error| error.to_string())?;
        let out = BufWriter::new(draft.file().map_err(|error| error.to_string())?);
        let per_second = animation.frames.per_second;
        let gif = gif::Animated::new(out, animation.order.size, per_second, animation.loops)
            .map_err(|error| FileError::unwritable(&path, &error).to_string())?;
        Ok(Recorder { animation, done: 0, path, gif, draft })
    }

    /// Returns how many frames are written, and how many there are.
    pub fn progress(&self) -> (u32, u32) {
        (self.done, self.animation.frames.count)
    }

    /// Returns the next frame's figure. It depends on the animation's start and the frame's number
    /// alone.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if there is no such figure.
    pub fn figure(&self) -> Result<Figure, String> {
        let Animation { kind, start, scene, order, frames, .. } = &self.animation;
        let phase = kind.phase_of_frame(self.done, frames.count);
        let still = start.at(*kind, phase).map_err(|error| error.to_string())?;
        let (mut document, mut session) = scene.clone();
        still.show(*kind, &mut document, &mut session);
        order.figure(&document, &session, |_| false)
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if it cannot be written.
    pub fn push(&mut self, figure: &Figure) -> Result<(), String> {
        self.done += 1;
        self.gif
            .push(&to_srgba(&figure.to_pixels()))
            .map_err(|error| FileError::unwritable(&self.path, &error).to_string())
    }

    /// Puts the file in its place after the last frame.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if it cannot be written; no file is left then.
    pub fn finish(self) -> Result<(), String> {
        self.gif.finish().map_err(|error| FileError::unwritable(&self.path, &error).to_string())?;
        self.draft.finish().map_err(|error| error.to_string())
    }
}
