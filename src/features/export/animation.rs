//! Exports animations as GIF files, with one figure per frame.

use std::path::{Path, PathBuf};

use pinhole_exchange::host::host;
use pinhole_exchange::images::gif;
use pinhole_exchange::{Document, FileError};
use pinhole_figure::export::{Figure, to_srgba};

use crate::features::export::order::Order;
use crate::features::play::state::{Kind, Start};
use crate::model::session::Session;

/// The number of frames and the frame rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    /// Number of frames, at least one.
    pub count: u32,
    /// Frames per second, at most [`Frames::MOST_PER_SECOND`].
    pub per_second: u16,
}

impl Frames {
    /// The default number of frames per second.
    pub const PER_SECOND: u16 = 20;
    /// Maximum number of frames per second.
    pub const MOST_PER_SECOND: u16 = gif::MOST_PER_SECOND;

    /// Returns the number of frames of a complete animation at this frame rate.
    pub fn new(kind: Kind, per_second: u16) -> Frames {
        let count = (kind.seconds() * f64::from(per_second)) as u32;
        Frames { count: count.max(1), per_second }
    }
}

/// Checks that an animation can be written to a file with the given name.
///
/// # Errors
/// Returns an error, as a sentence, if the name does not end with `.gif`.
pub fn check_animation_path(path: &Path) -> Result<(), String> {
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gif")) {
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
    /// True if the animation repeats.
    pub loops: bool,
    /// The document and the session (the state of the window, such as the selected ray) from which the
    /// figures are drawn.
    pub scene: (Document, Session),
    /// The request from which the figure of each frame is made.
    pub order: Order,
    /// The number of frames and the frame rate.
    pub frames: Frames,
}

/// Draws an animation frame by frame, and writes the GIF file when it is complete.
pub struct Recorder {
    animation: Animation,
    done: u32,
    path: PathBuf,
    gif: gif::Animated<Vec<u8>>,
}

impl Recorder {
    /// Starts to record an animation. The file is written only by [`Recorder::finish`].
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the file cannot be written.
    pub fn new(animation: Animation, path: PathBuf) -> Result<Recorder, String> {
        host().check(&path).map_err(|error| error.to_string())?;
        let Animation { order, frames, loops, .. } = &animation;
        let gif = gif::Animated::new(Vec::new(), order.size, frames.per_second, *loops)
            .map_err(|error| FileError::unwritable(&path, &error).to_string())?;
        Ok(Recorder { animation, done: 0, path, gif })
    }

    /// Returns the number of frames written so far and the total number of frames.
    pub fn progress(&self) -> (u32, u32) {
        (self.done, self.animation.frames.count)
    }

    /// Draws the next frame, for [`Recorder::push`]. It depends only on the animation and on the
    /// frame's number.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the frame cannot be drawn.
    pub fn figure(&self) -> Result<Figure, String> {
        let Animation { kind, start, scene, order, frames, .. } = &self.animation;
        let phase = kind.phase_of_frame(self.done, frames.count);
        let still = start.at(*kind, phase).map_err(|error| error.to_string())?;
        let (mut document, mut session) = scene.clone();
        still.show(*kind, &mut document, &mut session);
        order.figure(&document, &session)
    }

    /// Adds a drawn frame to the animation.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the frame cannot be encoded.
    pub fn push(&mut self, figure: &Figure) -> Result<(), String> {
        self.done += 1;
        self.gif
            .push(&to_srgba(&figure.to_pixels()))
            .map_err(|error| FileError::unwritable(&self.path, &error).to_string())
    }

    /// Writes the file. Call this after the last frame has been pushed.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the file cannot be written; no incomplete file is left.
    pub fn finish(self) -> Result<(), String> {
        let bytes = self.gif.finish();
        let bytes = bytes.map_err(|error| FileError::unwritable(&self.path, &error).to_string())?;
        host().write(&self.path, &bytes).map_err(|error| error.to_string())
    }
}
