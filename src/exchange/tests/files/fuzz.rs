//! Texts that nobody would write, made of those that people do: no reader panics, stalls, or says more than
//! a message should.
//!
//! A run takes two seconds with a fixed seed and two with a fresh one; `PINHOLE_FUZZ_SECONDS=3600` takes as
//! many with fresh ones. A text that fails is printed with its seed.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use pinhole_core::{Camera, ImageSize};
use pinhole_exchange::csv::{rays, spheres};
use pinhole_exchange::format::{ExportScene, Importer, Include, Input};
use pinhole_exchange::images::png;
use pinhole_exchange::programs::{FORMATS, IMPORTERS, importer_of};
use pinhole_exchange::{FileError, answers, scene_file, scenes};

/// A reader, with the beginning of its name in a failure.
type Reader = (&'static str, fn(&[u8]) -> Vec<FileError>);

const READERS: [Reader; 6] = [
    ("scene", |bytes| with_text(bytes, scene)),
    ("importers", |bytes| with_text(bytes, every_importer)),
    ("spheres", |bytes| spheres::parse(Path::new("in"), bytes).err().into_iter().collect()),
    ("rays", |bytes| rays::parse(Path::new("in"), bytes).err().into_iter().collect()),
    ("answers", |bytes| {
        let image = ImageSize::new(40, 30).unwrap();
        answers::parse(Path::new("in"), bytes, image, 0).err().into_iter().collect()
    }),
    ("png", |bytes| png::decode(Path::new("in"), bytes).err().into_iter().collect()),
];

fn with_text(bytes: &[u8], read: fn(&str) -> Vec<FileError>) -> Vec<FileError> {
    std::str::from_utf8(bytes).map_or_else(|_| Vec::new(), read)
}

fn scene(text: &str) -> Vec<FileError> {
    // The folder has no files, so that no CSV is found.
    match scene_file::parse(text, Path::new("in"), Path::new("no-such-folder")) {
        Err(error) => vec![error],
        Ok(document) => {
            let again = scene_file::to_text(&document, Some(text));
            let read = scene_file::parse(&again, Path::new("in"), Path::new("no-such-folder"));
            assert_eq!(read.unwrap(), document, "saved and read again");
            Vec::new()
        }
    }
}

fn every_importer(text: &str) -> Vec<FileError> {
    let input = Input { path: Path::new("in"), text };
    let mut errors = Vec::new();
    let detected: Option<&Importer> = importer_of(text);
    for importer in IMPORTERS.iter().chain(detected) {
        match importer.read(&input, &Camera::CANONICAL) {
            Ok(taken) => {
                assert!(taken.camera.resolve().is_ok(), "{}", importer.name);
                errors.extend(taken.notes.iter().map(|note| FileError::of_file(input.path, note)));
            }
            Err(error) => errors.push(error),
        }
    }
    errors
}

/// What people write.
fn samples() -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = Vec::new();
    for builtin in scenes::builtin::all() {
        all.push(builtin.text.into());
        let document = builtin.load().unwrap();
        let Ok(subject) = ExportScene::new(&document, Include::Objects) else { continue };
        let written = FORMATS.iter().filter_map(|format| format.write(&subject).ok());
        all.extend(written.map(|written| written.joined().text.into_bytes()));
    }
    let texts = [
        "glm::mat4 view = glm::lookAt(glm::vec3(4, 3, 3), // eye\n  glm::vec3(0, 0, 0), glm::vec3(0, 1, 0));\n\
         glm::mat4 p = glm::perspective(glm::radians(45.0f), 4.0f / 3.0f, 0.1f, 100.0f);\n",
        "const camera = new THREE.PerspectiveCamera(50, 1.5, 0.1, 100);\ncamera.position.set(1, 2, 3);\n\
         camera.lookAt(0, 0.5, 0);\n",
        "K = [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]]\nR = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]])\n\
         t = [0, 0, 5]\n",
        "%YAML:1.0\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   \
         dt: d\n   data: [ 500., 0., 319.5, 0., 500., 239.5, 0., 0., 1. ]\n",
        "c2w = [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]\n",
        "1 2 3 0 0 0 0 1 0 45\n",
        "x,y,z,r,color,name\n0,0,-5,1,#e69f00,\"a, b\"\n1,0,-6,0.5,,\n",
        "ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-1\n1,2,3,4,5,6\n",
        "ux,uy,uz,vx,vy,vz,wx,wy,wz\n1,0,0,0,1,0,0,0,1\n",
        "row,column,ox,oy,oz,dx,dy,dz\n0,1,0,0,0,0,0,-1\n",
        "row,column,t,x,y,z,object\n0,1,4,0,0,-4,0\n2,3,,,,,\n",
    ];
    all.extend(texts.map(|text| text.as_bytes().to_vec()));
    let mut picture = Vec::new();
    png::encode(&mut picture, 40, 30, &[[1, 2, 3, 255]; 1200]).unwrap();
    all.push(picture);
    all
}

/// What stands where something else should.
const STRANGE: [&str; 44] = [
    "\u{a0}",
    "\u{2019}",
    "\u{201c}",
    "\u{202e}",
    "\u{feff}",
    "\u{1d54f}",
    "\r",
    "\r\n",
    "\0",
    "\u{1b}[2J",
    "\t",
    "\n",
    "(",
    "[",
    "{",
    "<",
    ")",
    "]",
    "}",
    ">",
    "\"",
    "'",
    "/*",
    "*/",
    "//",
    "#",
    ",",
    ";",
    ":",
    "=",
    "-",
    ".",
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e999",
    "5e-324",
    "-0",
    "99999999999999999999",
    "0",
    "1e155",
    "$x",
];

/// Numbers from a seed (splitmix64: G. L. Steele, D. Lea, C. H. Flood, *Fast splittable pseudorandom
/// number generators*, OOPSLA 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }
}

/// Where the words, numbers and signs of a text begin, and where it ends.
fn tokens(bytes: &[u8]) -> Vec<usize> {
    let is_of_word =
        |byte: u8| byte.is_ascii_alphanumeric() || b"_.".contains(&byte) || byte >= 0x80;
    let goes_on = |pair: &[u8]| is_of_word(pair[0]) && is_of_word(pair[1]);
    let starts =
        bytes.windows(2).enumerate().filter(|(_, pair)| !goes_on(pair)).map(|(at, _)| at + 1);
    [0].into_iter().chain(starts).chain([bytes.len()]).collect()
}

/// A sample with some of its tokens gone, doubled, exchanged, or others in their places.
fn mutant(samples: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut text = samples[random.below(samples.len())].clone();
    for _ in 0..=random.below(4) {
        let marks = tokens(&text);
        let first = random.below(marks.len() - 1);
        let last = (first + 1 + random.below(8)).min(marks.len() - 1);
        let (from, end) = (marks[first], marks[last]);
        let piece = text[from..end].to_vec();
        let strange = STRANGE[random.below(STRANGE.len())].as_bytes();
        let new: Vec<u8> = match random.below(8) {
            0 => Vec::new(),
            1 => strange.to_vec(),
            2 => [strange, &piece].concat(),
            3 => [&piece, strange].concat(),
            4 => piece.repeat(2 + random.below(200)),
            5 => [piece, strange.repeat(1 + random.below(3000))].concat(),
            6 => {
                let other = &samples[random.below(samples.len())];
                let marks = tokens(other);
                let from = random.below(marks.len() - 1);
                let end = (from + random.below(60)).min(marks.len() - 1);
                other[marks[from]..marks[end]].to_vec()
            }
            _ => {
                text.truncate(end);
                continue;
            }
        };
        text.splice(from..end, new);
    }
    text
}

/// Maximum time for a text of some 100 kB, unoptimised on a busy machine.
const PATIENCE: Duration = Duration::from_secs(3);

/// Maximum length of a message in characters, its file and place among them.
const MESSAGE: usize = 1100;

fn run(seed: u64, time: Duration) {
    let samples = samples();
    let mut random = Random(seed);
    let (since, mut count) = (Instant::now(), 0);
    while since.elapsed() < time {
        let text = mutant(&samples, &mut random);
        for (name, read) in READERS {
            let begun = Instant::now();
            let fault = match catch_unwind(AssertUnwindSafe(|| read(&text))) {
                Err(_) => Some("panicked".to_owned()),
                Ok(_) if begun.elapsed() > PATIENCE => Some(format!("took {:?}", begun.elapsed())),
                Ok(errors) => errors.iter().map(FileError::to_string).find(|message| {
                    message.chars().count() > MESSAGE || message.chars().any(char::is_control)
                }),
            };
            let shown = String::from_utf8_lossy(&text);
            assert!(fault.is_none(), "seed {seed}, text {count}: {name}: {fault:?}\n{shown}");
        }
        count += 1;
    }
    println!("seed {seed}: {count} texts");
}

#[test]
fn no_text_makes_a_reader_panic_stall_or_chatter() {
    run(20, Duration::from_secs(2));
    let seconds = std::env::var("PINHOLE_FUZZ_SECONDS").ok().and_then(|given| given.parse().ok());
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap();
    run(now.as_nanos() as u64, Duration::from_secs(seconds.unwrap_or(2)));
}
