//! Animations as files: a figure for each phase, in one animated PNG or GIF, or in numbered PNGs.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use pinhole_exchange::FileError;
use pinhole_exchange::atomic::Draft;
use pinhole_exchange::document::Document;
use pinhole_exchange::images::{gif, png};
use pinhole_exchange::temporary::DraftFolder;

use super::figure::{Figure, Format};
use super::order::Order;
use crate::model::play::{Kind, Start};
use crate::model::session::Session;

/// The files that frames become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reel {
    /// One animated PNG or GIF, by the ending of its name.
    Animated,
    /// `name-0001.png`, `name-0002.png`, ...
    Numbered,
}

/// Number of frames, and how fast they follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    /// Number of frames, at least one.
    pub count: u32,
    /// Frames per second.
    pub per_second: u16,
    /// The files that they become.
    pub reel: Reel,
}

impl Frames {
    /// Returns as many as it has time for, twenty a second.
    pub fn new(kind: Kind) -> Frames {
        Frames::at(kind, 20)
    }

    /// Returns as many as it has time for, so many a second.
    pub fn at(kind: Kind, per_second: u16) -> Frames {
        let count = (kind.seconds() * f64::from(per_second)) as u32;
        Frames { count: count.max(1), per_second, reel: Reel::Animated }
    }

    /// Checks that they can be written to a file of this name, with a background or without.
    ///
    /// # Errors
    /// Returns an error, as a sentence with what would do, if they cannot.
    pub fn check(&self, path: &Path, transparent: bool) -> Result<(), String> {
        if has_ending(path, "png") || has_ending(path, "apng") {
            return Ok(());
        }
        if !has_ending(path, "gif") {
            return Err(
                "writes animations as PNG or GIF: end the name with .png or .gif".to_owned()
            );
        }
        let fault = match (self.reel, transparent) {
            (Reel::Numbered, _) => "writes numbered pictures as PNG",
            (_, true) => "writes what is transparent as PNG, as GIF has no half-transparent dots",
            _ if self.per_second > gif::MOST_PER_SECOND => {
                return Err("writes at most 50 frames a second as GIF".to_owned());
            }
            _ => return Ok(()),
        };
        Err(format!("{fault}: end the name with .png"))
    }
}

/// An animation as a sequence of figures.
#[derive(Clone, Debug)]
pub struct Animation {
    /// The kind of motion.
    pub kind: Kind,
    /// The state at the start.
    pub start: Start,
    /// After the end it begins again.
    pub loops: bool,
    /// The document, and the session that looks at it.
    pub scene: (Document, Session),
    /// The figure of each phase.
    pub order: Order,
    /// Number and pace of the figures.
    pub frames: Frames,
}

impl Animation {
    /// Frame `k`, from 0. It depends on the start and on its number alone.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if there is no such figure.
    pub fn figure(&self, k: u32) -> Result<Figure, String> {
        let phase = self.kind.phase_of_frame(k, self.frames.count);
        let still = self.start.at(self.kind, phase).map_err(|error| error.to_string())?;
        let (mut document, mut session) = self.scene.clone();
        still.show(self.kind, &mut document, &mut session);
        self.order.figure(&document, &session, |_| false)
    }
}

/// An animation that is being written. Dropped before it is finished, it leaves nothing.
pub struct Recorder {
    animation: Animation,
    done: u32,
    path: PathBuf,
    sink: Sink,
}

/// The unfinished files, in the folder where they will be.
enum Sink {
    Png(Box<png::Animated<BufWriter<File>>>, Draft),
    Gif(Box<gif::Animated<BufWriter<File>>>, Draft),
    Numbered(DraftFolder),
}

impl Recorder {
    /// Begins.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if nothing can be written there.
    pub fn new(animation: Animation, path: PathBuf) -> Result<Recorder, String> {
        let Frames { count, per_second, reel } = animation.frames;
        let sink = match reel {
            Reel::Animated => {
                let draft = Draft::create(&path).map_err(|error| error.to_string())?;
                let out = BufWriter::new(draft.file().map_err(|error| error.to_string())?);
                let Order { size, transparent, .. } = animation.order;
                let loops = animation.loops;
                let why = |error| FileError::unwritable(&path, &error).to_string();
                if has_ending(&path, "gif") {
                    let animated = gif::Animated::new(out, size, per_second, loops);
                    Sink::Gif(Box::new(animated.map_err(why)?), draft)
                } else {
                    let frames = (count, per_second);
                    let animated = png::Animated::new(out, size, frames, loops, transparent);
                    Sink::Png(Box::new(animated.map_err(why)?), draft)
                }
            }
            Reel::Numbered => {
                let taken = (0..count).map(|k| numbered(&path, k)).find(|path| path.exists());
                if let Some(taken) = taken {
                    return Err(format!("{} exists: choose another name", taken.display()));
                }
                Sink::Numbered(
                    DraftFolder::create_beside(&path).map_err(|error| error.to_string())?,
                )
            }
        };
        Ok(Recorder { animation, done: 0, path, sink })
    }

    /// Returns how many frames are done, and how many there are.
    pub fn progress(&self) -> (u32, u32) {
        (self.done, self.animation.frames.count)
    }

    /// Makes the next frame.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if there is no such figure or it cannot be written.
    pub fn step(&mut self) -> Result<(), String> {
        let figure = self.figure()?;
        self.push(&figure)
    }

    /// Returns the next frame's figure.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if there is none.
    pub fn figure(&self) -> Result<Figure, String> {
        self.animation.figure(self.done)
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if it cannot be written.
    pub fn push(&mut self, figure: &Figure) -> Result<(), String> {
        let written = match &mut self.sink {
            Sink::Png(animated, _) => animated.push(&figure.to_srgba()),
            Sink::Gif(animated, _) => animated.push(&figure.to_srgba()),
            Sink::Numbered(folder) => {
                folder.write(self.done as usize, &figure.to_file(Format::Png)?)
            }
        };
        self.done += 1;
        written.map_err(|error| FileError::unwritable(&self.path, &error).to_string())
    }

    /// Puts everything in its place, after the last frame.
    ///
    /// # Errors
    /// Returns the reason, as a sentence, if it cannot be written; no file is left then.
    pub fn finish(self) -> Result<(), String> {
        let (written, draft) = match self.sink {
            Sink::Png(animated, draft) => (animated.finish(), draft),
            Sink::Gif(animated, draft) => (animated.finish(), draft),
            Sink::Numbered(folder) => {
                let names: Vec<_> = (0..self.done).map(|k| numbered(&self.path, k)).collect();
                return folder.rename_all(&names).map_err(|error| error.to_string());
            }
        };
        written.map_err(|error| FileError::unwritable(&self.path, &error).to_string())?;
        draft.finish().map_err(|error| error.to_string())
    }
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending))
}

/// Path of frame `k`, counted from 1.
fn numbered(path: &Path, k: u32) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}-{:04}.png", k + 1))
}
