//! The command line: commands and their arguments.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ContextKind;
use clap::{Args, CommandFactory as _, Parser, Subcommand};
use pinhole_core::{DVec2, ImageSize, Pixel, Shade};
use pinhole_exchange::{Conventions, Format, SceneSource};
use pinhole_figure::overlay::Style;

use crate::features::export::order::FigureSubject;
use crate::model::lessons::LessonArgument;

/// See what a pinhole camera sees, and why.
///
/// Without a command, opens the window.
#[derive(Clone, Debug, Parser)]
#[command(
    version,
    long_version = env!("PINHOLE_VERSION"),
    args_conflicts_with_subcommands = true,
    after_help = "SCENE is the path of a scene file, or the name of a built-in scene. To a command, - is a \
                  scene file on standard input."
)]
pub struct Arguments {
    /// The command to run instead of opening the window.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Options of the window.
    #[command(flatten)]
    pub window: WindowArguments,
}

/// Options of the window.
#[derive(Args, Clone, Debug)]
pub struct WindowArguments {
    /// The scene to open, or a link to a scene or a lesson's step
    #[arg(conflicts_with = "lesson")]
    pub scene: Option<PathBuf>,
    /// The lesson to open: 7, or 7.3 for its third step, or a lesson file of your own
    #[arg(long, value_name = "N|FILE.toml", value_parser = LessonArgument::parse)]
    pub lesson: Option<LessonArgument>,
    /// How the window is drawn; by default, whichever works best
    #[arg(long, value_name = "wgpu|cpu")]
    pub renderer: Option<Renderer>,
}

/// A headless command.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// List the built-in scenes, a line each
    Scenes {
        /// Print one JSON object
        #[arg(long)]
        json: bool,
    },
    /// Show one ray: its camera, its numbers, and everything it hits
    Inspect(InspectArguments),
    /// Write the picture as PNG
    Render(RenderArguments),
    /// Intersect the rays in a CSV file with a scene
    Trace(TraceArguments),
    /// Grade a student's basis, rays, hits or picture, and name the mistake
    #[command(
        long_about = include_str!("about/check.txt"),
        override_usage = "pinhole check [OPTIONS] --answers <IN.csv|IN.png|FOLDER> <SCENE>\n       \
                          pinhole check --codes <CODES.txt> [--json]",
        after_help = "Status 0: all judged answers agree; 1: not all do, or a file of a class is broken; 2: \
                      answers, scene or arguments cannot be read, or no answer judged."
    )]
    Check(CheckArguments),
    /// Measure the error of every method against its run time
    #[command(long_about = include_str!("about/report.txt"))]
    Report(ReportArguments),
    /// Write a view, the derivation or two lines in the plane as a figure for slides
    #[command(long_about = include_str!("about/figure.txt"))]
    Figure(FigureArguments),
    /// Write the camera and the scene in another program's format
    #[command(long_about = include_str!("about/export.txt"))]
    Export(ExportArguments),
    /// Print a link to a scene or a lesson's step, or draw it as a QR code
    #[command(long_about = include_str!("about/share.txt"))]
    Share(ShareArguments),
    /// Read a camera from a glTF or from numbers, and write a scene file
    #[command(long_about = include_str!("about/import.txt"))]
    Import(ImportArguments),
    /// Write the program as a page for a browser, with a scene or a lesson in it
    #[command(long_about = include_str!("about/page.txt"))]
    Page(PageArguments),
    /// Print the script with which a shell completes commands, options and scenes
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// A shell that completes what is typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Shell {
    /// bash
    Bash,
    /// zsh
    Zsh,
    /// fish
    Fish,
}

/// `pinhole inspect`
#[derive(Args, Clone, Debug)]
#[command(mut_group("ray", |ray| ray.required(true)))]
pub struct InspectArguments {
    /// A scene file, or the name of a built-in scene
    pub scene: PathBuf,
    /// The ray.
    #[command(flatten)]
    pub ray: RayArguments,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// A view ray: at most one of these.
#[derive(Args, Clone, Copy, Debug)]
#[group(id = "ray", multiple = false)]
pub struct RayArguments {
    /// The ray through a pixel's centre; rows and columns count from 0, row 0 on top
    #[arg(long, value_name = "ROW,COL", allow_hyphen_values = true, value_parser = pixel)]
    pub pixel: Option<Pixel>,
    /// The ray through a point of the viewport, in world units from its centre
    #[arg(long, value_name = "U,V", allow_hyphen_values = true, value_parser = uv)]
    pub uv: Option<DVec2>,
}

impl RayArguments {
    /// Returns true if a ray is requested.
    pub(super) fn is_given(self) -> bool {
        self.pixel.is_some() || self.uv.is_some()
    }
}

/// `pinhole render`
#[derive(Args, Clone, Debug)]
pub struct RenderArguments {
    /// A scene file, or the name of a built-in scene
    pub scene: PathBuf,
    /// The PNG file to write; - writes to standard output
    #[arg(short, long, value_name = "OUT.png")]
    pub output: PathBuf,
    /// Columns; without --height, the rows follow from the ratio of the scene's image
    #[arg(long, value_name = "W", value_parser = image_measure())]
    pub width: Option<u32>,
    /// Rows; without --width, the columns follow from the ratio of the scene's image
    #[arg(long, value_name = "H", value_parser = image_measure())]
    pub height: Option<u32>,
    /// What the camera sees, or the scene with the camera in it
    #[arg(long, value_name = "camera|world", default_value = "camera", value_parser = one_of([FigureSubject::Camera, FigureSubject::World], |view| view.name().into()))]
    pub view: FigureSubject,
    /// Draw the camera into the world view, or the image's marks over the camera view
    #[arg(long)]
    pub overlay: bool,
    /// The shading: how a hit becomes a colour
    #[arg(
        long,
        value_name = "normal|lambert|t|object",
        default_value = "lambert",
        value_parser = one_of(Shade::ALL, |shade| shade.name().into())
    )]
    pub shade: Shade,
    /// Also write t, normal, u, v, object and certainty of every pixel as OpenEXR
    ///
    /// Float channels t, N.X, N.Y, N.Z, u, v, margin and uint channels object and step. Where nothing
    /// is hit, t is infinite, N is 0 and object is 4294967295. step is the arithmetic that the pixel's
    /// hardest decision needed: 0 for f64, 1 for double-double, 2 for exact. margin is what that
    /// decision has to spare, in bits: log2(|value| / bound of its error), 0 where it is exact, at
    /// most 44.
    ///
    /// Both files are complete before the first of them is put in place, and an error leaves both as
    /// they were. Only if the program is killed at that very moment, one may be new and one old.
    #[arg(long, value_name = "OUT.exr")]
    pub aov: Option<PathBuf>,
}

/// `pinhole figure`
#[derive(Args, Clone, Debug)]
pub struct FigureArguments {
    /// A scene file, or the name of a built-in scene
    pub scene: PathBuf,
    /// What is drawn: the scene with the camera in it, what the camera sees, the derivation of every
    /// number, or two lines in the plane, which are the same for every scene
    #[arg(long, value_name = "world|camera|derivation|lines")]
    #[arg(value_parser = one_of(FigureSubject::ALL, |subject| subject.name().into()))]
    pub view: FigureSubject,
    /// The file to write; the ending chooses the format, and - writes SVG to standard output
    ///
    /// SVG and PDF keep strokes and text as such, and have the fonts in them; PNG has the pixels of
    /// the window. The derivation can be written as text, too: .tex for LaTeX (with amsmath), .md for
    /// Markdown with $formulas$.
    #[arg(short, long, value_name = "OUT.svg|pdf|png")]
    pub output: PathBuf,
    /// Columns, in pixels; without --height, the rows follow in proportion
    ///
    /// Strokes and letters grow with the figure. In PDF, 96 pixels are an inch.
    #[arg(long, value_name = "W", value_parser = image_measure())]
    pub width: Option<u32>,
    /// Rows, in pixels; without --width, the columns follow in proportion
    #[arg(long, value_name = "H", value_parser = image_measure())]
    pub height: Option<u32>,
    /// Leave the background out: in the views, whatever lies behind all objects
    #[arg(long)]
    pub transparent: bool,
    /// Dark on light, light on dark, or one of the window's colour schemes on either
    #[arg(
        long = "theme",
        value_name = "THEME",
        default_value = "light",
        value_parser = one_of(Style::ALL, |style| style.name().into())
    )]
    pub style: Style,
    /// The ray that is shown.
    #[command(flatten)]
    pub ray: RayArguments,
}

/// `pinhole trace`
#[derive(Args, Clone, Debug)]
pub struct TraceArguments {
    /// A scene file, or the name of a built-in scene
    pub scene: PathBuf,
    /// The rays: header ox,oy,oz,dx,dy,dz, a row for each ray; - reads them from standard input
    #[arg(long, value_name = "IN.csv")]
    pub rays: PathBuf,
    /// Where to write object,t,px,py,pz,nx,ny,nz, a row for each ray; by default, standard output
    ///
    /// All cells of a miss are empty, and so is the cell of a number beyond f64.
    #[arg(short, long, value_name = "OUT.csv")]
    pub output: Option<PathBuf>,
}

/// `pinhole export`
#[derive(Args, Clone, Debug)]
pub struct ExportArguments {
    /// A scene file, or the name of a built-in scene
    pub scene: PathBuf,
    /// The other program, form or language
    #[arg(long, value_name = "NAME")]
    #[arg(value_parser = one_of(Format::all(), format_help))]
    pub to: &'static Format,
    /// Where to write it; by default, standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Leave the objects out
    #[arg(long, conflicts_with = "meshes")]
    pub camera_only: bool,
    /// Write objects as meshes where the format has nothing else: glTF
    #[arg(long)]
    pub meshes: bool,
}

/// `pinhole share`
#[derive(Args, Clone, Debug)]
pub struct ShareArguments {
    /// A scene file, or the name of a built-in scene
    #[arg(required_unless_present = "lesson", conflicts_with = "lesson")]
    pub scene: Option<PathBuf>,
    /// Share a lesson instead: 7, or 7.3 for its third step
    #[arg(long, value_name = "N")]
    pub lesson: Option<String>,
    /// The lesson's step
    #[arg(long, value_name = "K", requires = "lesson")]
    pub step: Option<usize>,
    /// The ray that is selected.
    #[command(flatten)]
    pub ray: RayArguments,
    /// The address of the page, with https://
    #[arg(long, value_name = "URL")]
    pub base: Option<String>,
    /// Draw the link as a QR code; the ending chooses the format, and - writes SVG to standard output
    #[arg(short, long, value_name = "OUT.svg|png", requires = "base")]
    pub output: Option<PathBuf>,
    /// Draw the QR code in the terminal, and print the link below it
    #[arg(long, requires = "base", conflicts_with = "output")]
    pub qr: bool,
}

/// `pinhole import`
#[derive(Args, Clone, Debug)]
pub struct ImportArguments {
    /// A glTF (.gltf, .glb), or a text with a camera in numbers; - reads standard input
    pub file: PathBuf,
    /// The scene file to write; by default, standard output
    #[arg(short, long, value_name = "SCENE.toml")]
    pub output: Option<PathBuf>,
}

/// `pinhole page`
#[derive(Args, Clone, Debug)]
pub struct PageArguments {
    /// A scene file, the name of a built-in scene, or a lesson file
    #[arg(conflicts_with = "lesson")]
    pub scene: Option<PathBuf>,
    /// The lesson to open: 7, or 7.3 for its third step, or a lesson file of your own
    #[arg(long, value_name = "N|FILE.toml", value_parser = LessonArgument::parse)]
    pub lesson: Option<LessonArgument>,
    /// The lesson's step to open
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u16).range(1..))]
    pub step: Option<u16>,
    /// The page to write; - writes to standard output
    #[arg(short, long, value_name = "OUT.html")]
    pub output: PathBuf,
    /// The page of the program itself; by default, pinhole.html beside the program
    #[arg(long, value_name = "PINHOLE.html")]
    pub page: Option<PathBuf>,
}

/// `pinhole check`
#[derive(Args, Clone, Debug)]
pub struct CheckArguments {
    /// A scene file, or the name of a built-in scene
    #[arg(required_unless_present = "codes")]
    pub scene: Option<PathBuf>,
    /// The answers, whose header says what they are; - reads them from standard input
    ///
    /// A basis: ux,uy,uz,vx,vy,vz,wx,wy,wz. Rays: row,column,ox,oy,oz,dx,dy,dz. Hits: row,column and
    /// t, or x,y,z, or object, or several of them, all empty for a miss. Or the whole picture as PNG,
    /// shaded in one of the ways of render. Of a folder, every file is graded.
    #[arg(long, value_name = "IN.csv|IN.png|FOLDER", required_unless_present = "codes")]
    pub answers: Option<PathBuf>,
    /// Count the mistakes of a class instead, in codes of answers to exercises; - reads standard input
    ///
    /// Students get their code by Copy my answer in Practice. Other words in the text are ignored.
    #[arg(long, value_name = "CODES.txt")]
    #[arg(conflicts_with_all = ["scene", "answers", "kind", "columns", "complete"])]
    #[arg(conflicts_with_all = ["tolerance", "count_from", "map", "csv"])]
    pub codes: Option<PathBuf>,
    /// The kind of answers that is asked for; answers of another kind are an error
    #[arg(long, value_parser = ["basis", "rays", "hits", "picture"])]
    pub kind: Option<String>,
    /// Columns that must be there, such as t,object; answers without them are an error
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub columns: Vec<String>,
    /// Require every pixel: a pixel without an answer counts as wrong
    #[arg(long)]
    pub complete: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    /// Print a table as CSV, a row for each file of a folder
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,
    /// Maximum error of an answer relative to its size, by default 0.00001; for a picture, in levels
    /// of 255 per channel, by default 2
    #[arg(long, value_name = "X", allow_hyphen_values = true, value_parser = tolerance)]
    pub tolerance: Option<f64>,
    /// The first number of rows and columns in the answers
    #[arg(long, value_name = "0|1", default_value_t = 0)]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=1))]
    pub count_from: u32,
    /// Write a map of the image: right answers light, wrong ones orange, not judged ones blue, the rest grey
    #[arg(long, value_name = "OUT.png")]
    pub map: Option<PathBuf>,
}

/// `pinhole report`
#[derive(Args, Clone, Debug)]
pub struct ReportArguments {
    /// Scene files, or names of built-in scenes; without any, the stress families
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// Write one JSON object; without a path, to standard output in place of the table
    #[arg(long, value_name = "OUT.json", num_args = 0..=1, default_missing_value = "-")]
    pub json: Option<PathBuf>,
    /// Draw error against run time, a page for each scene; the ending chooses the format. For several
    /// scenes, and for the families, OUT.svg is a summary, and the pages are OUT-2.svg, OUT-3.svg and
    /// so on
    #[arg(long, value_name = "OUT.svg|OUT.png")]
    pub plot: Option<PathBuf>,
    /// Seed of the random rays in the stress families
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
}

/// Returns a parser that takes the names of these values.
fn one_of<T: Copy + Send + Sync + 'static>(
    all: impl IntoIterator<Item = T>,
    named: fn(T) -> PossibleValue,
) -> impl TypedValueParser<Value = T> {
    let all: Vec<T> = all.into_iter().collect();
    PossibleValuesParser::new(all.iter().copied().map(named)).try_map(move |name| {
        let found = all.iter().copied().find(|value| named(*value).get_name() == name);
        found.ok_or("no such name")
    })
}

fn format_help(format: &'static Format) -> PossibleValue {
    let axes = |conventions: &Conventions| conventions.axes.map(|axis| axis.name).join(", ");
    PossibleValue::new(format.name).help(match &format.conventions {
        Some(own) => format!("{}; its camera's x, y, z are {}", format.label, axes(own)),
        None => format.label.to_owned(),
    })
}

fn image_measure() -> impl TypedValueParser<Value = u32> {
    const MOST: u32 = ImageSize::MAX;
    |text: &str| match text.parse() {
        Ok(pixels @ 1..=MOST) => Ok(pixels),
        _ => Err(format!("it must be a whole number of pixels, 1 to {MOST}")),
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number >= 0.0 && number.is_finite() => Ok(number),
        _ => Err(format!("{:?} is no tolerance: a number such as 1e-5, not below 0", text.trim())),
    }
}

fn pixel(text: &str) -> Result<Pixel, String> {
    let part = |text: &str| {
        text.trim().parse::<u32>().map_err(|_| {
            format!("{:?} is no row or column: whole numbers from 0, such as 99,199", text.trim())
        })
    };
    let (row, column) = pair(text, "99,199")?;
    Ok(Pixel { row: part(row)?, column: part(column)? })
}

fn uv(text: &str) -> Result<DVec2, String> {
    let part = |text: &str| match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("{:?} is no finite number: write it such as 0.2,-0.1", text.trim())),
    };
    let (u, v) = pair(text, "0.2,-0.1")?;
    Ok(DVec2::new(part(u)?, part(v)?))
}

fn pair<'a>(text: &'a str, such_as: &str) -> Result<(&'a str, &'a str), String> {
    match text.split(',').collect::<Vec<_>>()[..] {
        [first, second] => Ok((first, second)),
        _ => Err(format!("there must be two numbers with a comma between, such as {such_as}")),
    }
}

pinhole_core::texts! {
    /// The renderer of the window.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
    pub enum Renderer[1];
    {
        /// Returns `wgpu` or `cpu`.
        name,
    }
    /// A graphics adapter, through wgpu.
    Wgpu: "wgpu";
    /// Our own painter.
    Cpu: "cpu";
}

/// Returns the error for a first argument that is neither a command nor a scene, but similar to a
/// command's name. clap does not detect it, because the argument may also be a scene.
pub fn mistyped(first: &OsStr) -> Option<clap::Error> {
    if SceneSource::from_argument(Path::new(first)).is_ok() {
        return None;
    }
    let definition = Arguments::command();
    let commands = definition.get_subcommands().cloned();
    let alone = clap::Command::new("pinhole").subcommands(commands);
    let error = alone.try_get_matches_from([OsStr::new("pinhole"), first]).err()?;
    error.get(ContextKind::SuggestedSubcommand).is_some().then_some(error)
}
