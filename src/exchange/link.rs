//! Links: a lesson's step or a scene, with the selected ray and the page, in the fragment of a URL, which
//! is the text after its `#`.
//!
//! ```text
//! 7.3                               lesson 7, step 3, short enough to be typed
//! v1/7.3/p99,199/plot/2f7c01ae      the same with a pixel and a page of the window
//! v1/forty-five/uv0.2,-0.1/93d1...  a built-in scene with a ray through (u, v)
//! v1/Zc5aq.../5b21...               any other scene
//! ```
//!
//! All but a step alone begin with the version of the form, and end with a check ([`seal`](crate::seal)). A
//! scene is the text of its scene file: packed by DEFLATE (RFC 1951) with `PRESET` before it, then written in
//! base64url (RFC 4648) without padding. Reading it is reading a scene file, with the same checks.

use std::io::{self, Read as _, Write as _};
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use pinhole_core::{DVec2, Pixel, Selection};

use crate::seal::Form;
use crate::{BuiltinScene, Document, FileError, Location, limits, scene_file};

/// Maximum number of characters after the `#`. A QR code holds less: 2,953 bytes with the page's address.
pub const LONGEST: usize = 8000;

/// The form of what follows the `#`.
const FORM: Form = Form { prefix: "v", version: 1 };

/// The text that every packed scene may refer to: what most scenes have in common. It is part of version 1
/// and must never change.
const PRESET: &str = include_str!("link_preset.txt");

/// The name of a link in messages.
const NAME: &str = "link";

/// A link to what the window shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The step or the scene.
    pub shown: Linked,
    /// The selected ray; `None` for the step's own, or the usual one.
    pub ray: Option<Selection>,
    /// The page of the window, by its name in lesson files; `None` for the step's own, or both views. The
    /// reader must check that there is such a page.
    pub page: Option<String>,
}

/// What a link shows.
#[derive(Clone, Debug, PartialEq)]
pub enum Linked {
    /// A step of a built-in lesson. Both are counted from 1. The reader must check that there is such a step.
    Step {
        /// The lesson.
        lesson: usize,
        /// The step in the lesson.
        step: usize,
    },
    /// A built-in scene.
    Builtin(&'static BuiltinScene),
    /// Any other scene.
    Scene(Box<Document>),
}

impl Linked {
    /// Returns the scene of a document. It is a built-in one if it is the same to the last bit.
    pub fn scene(document: &Document) -> Linked {
        let text = scene_file::to_text(document, None);
        let is_same = |known: &Document| scene_file::to_text(known, None) == text;
        let mut all = BuiltinScene::all().iter();
        match all.find(|builtin| builtin.load().is_ok_and(|known| is_same(&known))) {
            Some(builtin) => Linked::Builtin(builtin),
            None => Linked::Scene(Box::new(document.clone())),
        }
    }
}

impl Link {
    /// Returns the text after the `#` of a URL. It reads back to the same link, bit for bit.
    ///
    /// # Errors
    /// Returns an error if the scene needs a file of spheres, is too large, or has a value that could not
    /// be read back.
    pub fn to_fragment(&self) -> Result<String, FileError> {
        let shown = match &self.shown {
            Linked::Step { lesson, step } => format!("{lesson}.{step}"),
            Linked::Builtin(scene) => scene.name.to_owned(),
            Linked::Scene(document) => format!("Z{}", pack(document)?),
        };
        let ray = match self.ray {
            Some(Selection::Pixel(Pixel { row, column })) => format!("/p{row},{column}"),
            Some(Selection::Uv(uv)) if uv.is_finite() => format!("/uv{:?},{:?}", uv.x, uv.y),
            _ => String::new(),
        };
        let page = self.page.as_ref().map_or_else(String::new, |page| format!("/{page}"));
        if matches!(self.shown, Linked::Step { .. }) && ray.is_empty() && page.is_empty() {
            return Ok(shown);
        }
        let fragment = FORM.seal(&format!("{shown}{ray}{page}"));
        if fragment.len() > LONGEST {
            return Err(too_large(&format!("it needs {} characters", fragment.len())));
        }
        Ok(fragment)
    }

    /// Reads a link: a whole URL, or what follows its `#`.
    ///
    /// # Errors
    /// Returns an error if it is no link of this program, if it was cut off or mistyped, or if another
    /// version has written it. The error has the place: line 1 and the character after the `#`.
    pub fn parse(text: &str) -> Result<Link, FileError> {
        let text = text.trim();
        // A # inside a link without the page's address is a mistyped character.
        let url = text.split_once('#').filter(|(page, _)| !page.starts_with("v1/"));
        let fragment = url.map_or(text, |(_, fragment)| fragment);
        if fragment.len() > LONGEST {
            let problem = format!("{} characters long: it has at most {LONGEST}", fragment.len());
            return Err(FileError::of_file(Path::new(NAME), problem));
        }
        if fragment.starts_with(|c: char| c.is_ascii_digit()) {
            return Ok(Link { shown: step(fragment, fragment)?, ray: None, page: None });
        }
        if !FORM.is_meant(fragment) {
            let problem = "not a link that Pinhole has made: copy the whole link again, to its end, or \
                           type a lesson's step, such as 7.3";
            return Err(fault_at(fragment, fragment, problem));
        }
        let content =
            FORM.open(fragment).map_err(|(at, problem)| fault_at(fragment, at, problem))?;
        parts(fragment, content)
    }
}

/// Returns true if a text can only be meant as a link: the address of a page with a `#`, or `#` and what
/// follows it, without blanks.
pub fn is_meant(text: &str) -> bool {
    let text = text.trim();
    let is_page = |page: &str| page.is_empty() || page.contains("://") || page.ends_with(".html");
    let page = text.split_once('#').map(|(page, _)| page);
    page.is_some_and(is_page) && !text.contains(char::is_whitespace)
}

/// Returns true if a text can be the address of a page: with a scheme that a browser opens, or a host alone.
pub fn is_address(text: &str) -> bool {
    match text.trim().split_once("://") {
        Some((scheme, rest)) => ["http", "https", "file"].contains(&scheme) && !rest.is_empty(),
        None => {
            let host = text.trim().split('/').next().unwrap_or_default();
            host.contains('.') && !host.contains(char::is_whitespace)
        }
    }
}

/// Returns the URL of a page at this address with this fragment. Without an address, it is relative: the
/// page's usual file name.
pub fn url(address: &str, fragment: &str) -> String {
    let page = address.split('#').next().unwrap_or_default().trim().replace(' ', "%20");
    match &page[..] {
        "" => format!("pinhole.html#{fragment}"),
        // Cameras of phones open nothing else.
        page if !page.contains("://") => format!("https://{page}#{fragment}"),
        page => format!("{page}#{fragment}"),
    }
}

/// Returns an error at `at`, a part of the fragment.
fn fault_at(fragment: &str, at: &str, problem: impl Into<String>) -> FileError {
    let byte = at.as_ptr().addr().saturating_sub(fragment.as_ptr().addr());
    FileError::at(Path::new(NAME), Location::of_byte(fragment.as_bytes(), byte), problem)
}

fn too_large(what: &str) -> FileError {
    let problem = format!(
        "the scene is too large for a link: {what}, and a link has at most {LONGEST}. Save it as a page instead"
    );
    FileError::of_file(Path::new(NAME), problem)
}

/// Reads what stands between the version and the check.
fn parts(fragment: &str, content: &str) -> Result<Link, FileError> {
    let mut parts = content.split('/').peekable();
    let shown = parts.next().unwrap_or_default();
    let shown = match shown.strip_prefix('Z') {
        Some(packed) => Linked::Scene(Box::new(unpack(fragment, packed)?)),
        None if shown.starts_with(|c: char| c.is_ascii_digit()) => step(fragment, shown)?,
        None => {
            let builtin = BuiltinScene::find(shown).ok_or_else(|| {
                fault_at(fragment, shown, format!("this program has no scene {shown:?}"))
            })?;
            Linked::Builtin(builtin)
        }
    };
    let ray = parts.next_if(|part| part.contains(','));
    let ray = ray.map(|part| {
        let no_ray = || fault_at(fragment, part, "not a ray, such as p99,199 or uv0.2,-0.1");
        ray_of(part).ok_or_else(no_ray)
    });
    let page = parts.next().map(|page| {
        let is_word = page.bytes().all(|b| b.is_ascii_lowercase()) && !page.is_empty();
        let no_word = || fault_at(fragment, page, "not a page's name in lowercase letters");
        is_word.then(|| page.to_owned()).ok_or_else(no_word)
    });
    let link = Link { shown, ray: ray.transpose()?, page: page.transpose()? };
    match parts.next() {
        Some(more) => Err(fault_at(fragment, more, "there is more than scene, ray and page")),
        None => Ok(link),
    }
}

/// Reads `7.3`, or `7` for a lesson's first step.
fn step(fragment: &str, text: &str) -> Result<Linked, FileError> {
    let (lesson, step) = text.split_once('.').unwrap_or((text, "1"));
    let number = |digits: &str| {
        let number = Some(digits).filter(|digits| digits.bytes().all(|b| b.is_ascii_digit()));
        let not_one = || fault_at(fragment, text, "not a lesson's step, such as 7.3");
        number.and_then(|digits| digits.parse().ok()).ok_or_else(not_one)
    };
    Ok(Linked::Step { lesson: number(lesson)?, step: number(step)? })
}

fn ray_of(text: &str) -> Option<Selection> {
    if let Some((u, v)) = text.strip_prefix("uv").and_then(|pair| pair.split_once(',')) {
        let uv = DVec2::new(u.parse().ok()?, v.parse().ok()?);
        return uv.is_finite().then_some(Selection::Uv(uv));
    }
    let (row, column) = text.strip_prefix('p')?.split_once(',')?;
    Some(Selection::Pixel(Pixel { row: row.parse().ok()?, column: column.parse().ok()? }))
}

/// Packs a scene.
fn pack(document: &Document) -> Result<String, FileError> {
    let refused = |problem: String| FileError::of_file(Path::new(NAME), problem);
    if let Some(csv) = &document.csv_spheres {
        let problem = format!(
            "the scene's spheres are in {}, which a link cannot have: write them into the scene, or save it as a page",
            csv.path
        );
        return Err(refused(problem));
    }
    let text = scene_file::to_text(document, None);
    if text.len() > limits::PASTE {
        return Err(too_large(&format!("its text has {} bytes", text.len())));
    }
    scene_file::parse_alone(&text, Path::new(NAME)).map_err(|error| {
        refused(format!("the scene cannot be read back from a link: {}", error.problem))
    })?;
    let packed = deflate(&text).map_err(|error| refused(error.to_string()))?;
    Ok(URL_SAFE_NO_PAD.encode(packed))
}

fn deflate(text: &str) -> io::Result<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(PRESET.as_bytes())?;
    // After it, the output is at the boundary of a byte: what the text adds stands alone.
    encoder.flush()?;
    let start = encoder.get_ref().len();
    encoder.write_all(text.as_bytes())?;
    Ok(encoder.finish()?.split_off(start))
}

/// Unpacks a scene of at most [`limits::PASTE`] bytes.
fn unpack(fragment: &str, packed: &str) -> Result<Document, FileError> {
    let fault = |problem: String| fault_at(fragment, packed, problem);
    let bytes = URL_SAFE_NO_PAD.decode(packed);
    let bytes = bytes.map_err(|error| fault(format!("the scene is not base64url: {error}")))?;
    // The preset text as a stored block, whatever the encoder made of it.
    let [low, high] = (PRESET.len() as u16).to_le_bytes();
    let stored = [0, low, high, !low, !high];
    let source = stored.chain(PRESET.as_bytes()).chain(&bytes[..]);
    let mut text = Vec::new();
    let most = PRESET.len() + limits::PASTE;
    let read = DeflateDecoder::new(source).take(most as u64 + 1).read_to_end(&mut text);
    read.map_err(|error| fault(format!("the scene cannot be unpacked: {error}")))?;
    if text.len() > most {
        return Err(fault(format!("the scene is larger than {} KiB", limits::PASTE >> 10)));
    }
    let text = String::from_utf8(text.split_off(PRESET.len()));
    let text = text.map_err(|_| fault("the scene is not UTF-8 text".to_owned()))?;
    scene_file::parse_alone(&text, Path::new("scene in the link"))
}
