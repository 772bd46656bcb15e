//! C++ programs whose frame times are compared with those of `pinhole-core`: one that only writes a
//! frame with streaming (non-temporal) stores, for which it needs intrinsics, and one that uses Embree.
//! They are built if there is a compiler, and run while a scene is measured.

use std::fs;
use std::io::{BufRead, BufReader, Error, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::Duration;

use pinhole_core::ResolvedCamera;

use super::frames::Rays;
use super::scenes::Setting;

/// Name of the contestant that only writes every pixel's t and object, with streaming stores, and
/// traces nothing.
pub(crate) const STREAMING: &str = "streaming stores";

/// Names of the ways in which Embree is used: with its built-in spheres, and with user geometry whose
/// intersection test takes packets of 16 rays, which are declared coherent or not.
pub(crate) const EMBREE: [&str; 3] = ["Embree's spheres", "Embree, 16 wide", "Embree, incoherent"];

const SOURCES: [(&str, &str); 3] = [
    ("rig.hpp", include_str!("rigs/rig.hpp")),
    ("stores.cpp", include_str!("rigs/stores.cpp")),
    ("embree.cpp", include_str!("rigs/embree.cpp")),
];

/// A program that has been built.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    path: PathBuf,
    modes: &'static [&'static str],
}

impl Program {
    /// Compiles the program that makes the streaming stores, into a folder.
    ///
    /// # Errors
    /// Returns the compiler's messages, or a message that there is no compiler.
    pub(crate) fn stores(folder: &Path) -> Result<Program, String> {
        build(folder, "stores", &[])?;
        Ok(Program { path: folder.join("stores"), modes: &[STREAMING] })
    }

    /// Compiles the program that uses Embree, into a folder: with Embree 4 or, if that fails, with
    /// Embree 3.
    ///
    /// # Errors
    /// Returns the compiler's messages for both versions, or a message that there is no compiler.
    pub(crate) fn embree(folder: &Path) -> Result<Program, String> {
        let with = |version: &str| {
            build(
                folder,
                "embree",
                &[&format!("-DEMBREE={version}"), &format!("-lembree{version}")],
            )
        };
        with("4").or_else(|of_4| with("3").map_err(|of_3| of_4 + "\n" + &of_3))?;
        Ok(Program { path: folder.join("embree"), modes: &EMBREE })
    }

    /// Starts the program for a scene, and waits until it has read the scene.
    ///
    /// # Errors
    /// Returns an error if the program cannot be started.
    pub(crate) fn start(&self, setting: &Setting) -> Result<Rig, Error> {
        let [frame, spheres] = ["frame", "spheres"].map(|kind| self.path.with_extension(kind));
        let numbers = |sphere: &pinhole_core::Sphere| {
            let [x, y, z] = sphere.center.to_array();
            [x, y, z, sphere.radius].map(|number| (number as f32).to_ne_bytes())
        };
        let bytes: Vec<u8> = setting.scene.spheres().iter().flat_map(numbers).flatten().collect();
        fs::write(&spheres, bytes)?;
        let size = setting.image();
        let mut child = Command::new(&self.path)
            .args([size.width(), size.height()].map(|number| number.to_string()))
            .args([&frame, &spheres])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let answers = BufReader::new(child.stdout.take().ok_or(Error::other("no stdout"))?);
        let mut rig = Rig { child, answers, frame, modes: self.modes };
        // The program answers once it has built the scene.
        rig.frames(0, 1, &[])?;
        Ok(rig)
    }
}

fn build(folder: &Path, name: &str, flags: &[&str]) -> Result<(), String> {
    let failed = |error: Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(failed)?;
    for (file, text) in SOURCES {
        fs::write(folder.join(file), text).map_err(failed)?;
    }
    let compiler = std::env::var("CXX").unwrap_or("c++".into());
    let mut command = Command::new(&compiler);
    command.current_dir(folder).args(["-std=c++17", "-O3", "-march=native", "-pthread"]);
    command.args(["-o", name, &format!("{name}.cpp")]).args(flags);
    let output = command.output().map_err(|error| format!("{compiler}: {error}"))?;
    let told = String::from_utf8_lossy(&output.stderr);
    output.status.success().then_some(()).ok_or_else(|| format!("{compiler}: {}", told.trim_end()))
}

/// A running C++ program that makes frames of a scene on request.
#[derive(Debug)]
pub(crate) struct Rig {
    child: Child,
    answers: BufReader<ChildStdout>,
    frame: PathBuf,
    /// The names of the program's modes.
    pub(crate) modes: &'static [&'static str],
}

impl Rig {
    /// Makes a frame for each camera, in the mode with this index in [`Rig::modes`]. Returns how long
    /// each frame took.
    ///
    /// # Errors
    /// Returns an error if the program has ended.
    pub(crate) fn frames(
        &mut self,
        mode: usize,
        threads: usize,
        cameras: &[ResolvedCamera],
    ) -> Result<Vec<Duration>, Error> {
        let numbers = |camera: &ResolvedCamera| {
            Rays::new(camera).numbers().map(|number| number.to_string()).join(" ") + "\n"
        };
        let cameras_told: String = cameras.iter().map(numbers).collect();
        let answer = self.ask(&format!("{mode} {threads} {}\n{cameras_told}", cameras.len()))?;
        let seconds =
            answer.split_whitespace().map(|word| word.parse().map(Duration::from_secs_f64));
        seconds.collect::<Result<_, _>>().map_err(Error::other)
    }

    /// Returns the objects of the last frame's pixels.
    ///
    /// # Errors
    /// Returns an error if the program has ended or cannot write the file.
    pub(crate) fn objects(&mut self) -> Result<Vec<u32>, Error> {
        self.ask("save\n")?;
        let bytes = fs::read(&self.frame)?;
        let (numbers, _) = bytes[bytes.len() / 2..].as_chunks();
        Ok(numbers.iter().map(|number| u32::from_ne_bytes(*number)).collect())
    }

    fn ask(&mut self, order: &str) -> Result<String, Error> {
        self.child.stdin.as_mut().ok_or(Error::other("no stdin"))?.write_all(order.as_bytes())?;
        let mut answer = String::new();
        match self.answers.read_line(&mut answer)? {
            0 => Err(Error::other("it has ended")),
            _ => Ok(answer),
        }
    }
}

impl Drop for Rig {
    /// Closes the program's input and waits for it to exit, so that the processor time that it used is
    /// counted as that of an ended child process.
    fn drop(&mut self) {
        drop(self.child.stdin.take());
        _ = self.child.wait();
    }
}
