//! Loads the inputs of most commands: the scene, its camera, and the requested ray.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use pinhole_core::{CameraError, ImageSize, Pixel, ResolvedCamera, Selection};
use pinhole_exchange::atomic::{self, is_same_file};
use pinhole_exchange::{Document, FileError, SceneSource, limits, scene_file};

use super::console::{CommandError, is_standard, read, refused, scene_fault, to_stdout};
use crate::cli::arguments::RayArguments;

/// Reads the scene that an argument names: a file, a built-in scene, or standard input for `-`.
pub(super) fn load(scene: &Path) -> Result<Document, CommandError> {
    if is_standard(scene) {
        let (path, bytes) = read(scene, limits::TEXT)?;
        let text = String::from_utf8(bytes);
        let text = text.map_err(|_| FileError::of_file(path, "not UTF-8 text, as a scene is"))?;
        return Ok(scene_file::parse(&text, path, Path::new("."))?);
    }
    Ok(SceneSource::from_argument(scene)?.load()?)
}

/// Returns the files from which a scene is read: the scene file, and the CSV file of its spheres.
pub(super) fn files_of(scene: &Path, document: &Document) -> Vec<PathBuf> {
    let source = SceneSource::from_argument(scene).ok();
    let file = source.and_then(|source| source.scene_file().map(Path::to_owned));
    let scene_file = if is_standard(scene) { Some(scene.to_owned()) } else { file };
    scene_file
        .into_iter()
        .chain(document.csv_spheres.as_ref().map(|csv| csv.file.clone()))
        .collect()
}

/// Refuses to read two inputs from standard input.
pub(super) fn refuse_reading_twice(scene: &Path, other: (&str, &Path)) -> Result<(), CommandError> {
    if is_standard(scene) && is_standard(other.1) {
        let option = other.0;
        return refused(format!(
            "SCENE and {option} are both -: standard input can be read only once"
        ));
    }
    Ok(())
}

/// Writes what a command made to a file, which must not be one that it reads; for `-` or no file, to standard
/// output.
///
/// # Errors
/// Returns an error if the file is one of `inputs`, or if it cannot be written.
pub(super) fn deliver(
    output: Option<&Path>,
    inputs: &[PathBuf],
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), CommandError> {
    let Some(output) = output.filter(|output| !is_standard(output)) else {
        return to_stdout(write);
    };
    refuse_overwriting(inputs, [("-o", output)])?;
    Ok(atomic::write(output, |file| {
        let mut out = BufWriter::new(file);
        write(&mut out)?;
        out.flush()
    })?)
}

/// Rejects outputs that would overwrite an input. Each output is paired with the option that names
/// it.
pub(super) fn refuse_overwriting<'a>(
    inputs: &[PathBuf],
    outputs: impl IntoIterator<Item = (&'a str, impl AsRef<Path>)>,
) -> Result<(), CommandError> {
    for (option, output) in outputs {
        let output = output.as_ref();
        let is_same = |input: &&PathBuf| {
            is_same_file(if is_standard(input) { Path::new("/dev/stdin") } else { input }, output)
        };
        if let Some(input) = inputs.iter().find(is_same) {
            let read = match input.to_str() {
                Some("-") => ", which is standard input".to_owned(),
                _ if input == output => ", which is read".to_owned(),
                _ => format!(", which is read as {}", input.display()),
            };
            let output = output.display();
            return refused(format!(
                "{option} would write over {output}{read}: choose another name"
            ));
        }
    }
    Ok(())
}

/// Returns the camera of a scene with its basis.
///
/// If the camera is invalid, the error includes the position in the scene file, like other errors in
/// that file.
pub(super) fn pose(scene: &Path, document: &Document) -> Result<ResolvedCamera, CommandError> {
    let location_of = |error: &CameraError| match SceneSource::from_argument(scene) {
        Ok(source) => scene_file::camera_fault(source.scene_file()?, error),
        Err(_) => None,
    };
    document.camera.resolve().map_err(|error| match location_of(&error) {
        Some(fault) => fault.into(),
        None => scene_fault(scene, error),
    })
}

/// Returns the requested ray of a scene's camera; `None` if none is requested.
pub(super) fn selection_of(
    scene: &Path,
    camera: &ResolvedCamera,
    RayArguments { pixel, uv }: RayArguments,
) -> Result<Option<Selection>, CommandError> {
    let image = camera.image();
    if let Some(Pixel { row, column }) = pixel.filter(|pixel| !image.contains(*pixel)) {
        let (height, width) = (image.height(), image.width());
        let problem = format!(
            "pixel {row},{column} is outside the image of {height} rows and {width} columns: rows are \
             0 to {}, columns 0 to {}",
            height - 1,
            width - 1
        );
        return Err(scene_fault(scene, problem));
    }
    let selection = pixel.map(Selection::Pixel).or(uv.map(Selection::Uv));
    let is_finite = |one: Selection| camera.ray(one.uv(camera)).direction.is_finite();
    if !selection.is_none_or(is_finite) {
        let problem = "the ray's direction is beyond the range of numbers: make the viewport, its \
                       distance or (u, v) smaller";
        return Err(scene_fault(scene, problem));
    }
    Ok(selection)
}

/// Returns the size of a picture, by default the `usual` size. If only the width or the height is given,
/// the other follows from the aspect ratio of the `usual` size.
///
/// # Errors
/// Returns an error if no image has this size.
pub(super) fn size(
    width: Option<u32>,
    height: Option<u32>,
    usual: [u32; 2],
) -> Result<ImageSize, CommandError> {
    let ratio = f64::from(usual[0]) / f64::from(usual[1]);
    let [width, height] = match (width, height) {
        (None, None) => usual,
        (Some(width), Some(height)) => [width, height],
        (Some(width), None) => [width, follow(width, 1.0 / ratio)],
        (None, Some(height)) => [follow(height, ratio), height],
    };
    ImageSize::new(width, height).map_err(|error| {
        CommandError::Arguments(format!("{error}; give both --width and --height"))
    })
}

/// Returns the missing side of a picture, in pixels: the given side times `ratio`.
pub(super) fn follow(pixels: u32, ratio: f64) -> u32 {
    (f64::from(pixels) * ratio).round().max(1.0) as u32
}
