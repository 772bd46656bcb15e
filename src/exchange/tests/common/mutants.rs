//! Fuzzing: reads mutated copies of valid texts, and checks that no reader panics, takes too long, or
//! returns an overlong message or one with hidden characters.
//!
//! A run takes two seconds with the seed of `PROPTEST_RNG_SEED`; with `PINHOLE_FUZZ_SECONDS=3600` it takes an
//! hour. A text that fails is printed with its seed.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use pinhole_exchange::is_hidden;

/// A reader: its name, and a function that reads a text and returns the messages for the user.
pub(crate) type Reader = (&'static str, fn(&[u8]) -> Vec<String>);

/// Reads mutants of the samples with every reader.
pub(crate) fn fuzz(samples: &[Vec<u8>], readers: &[Reader]) {
    let (seed, time) = play("PINHOLE_FUZZ_SECONDS", Duration::from_secs(2));
    run(samples, readers, seed, time);
}

/// Returns the seed of `PROPTEST_RNG_SEED`, or of the clock, and for how long to draw cases with it: `usual`, or as
/// many seconds as the environment variable `seconds` says.
pub(crate) fn play(seconds: &str, usual: Duration) -> (u64, Duration) {
    let number = |name: &str| std::env::var(name).ok().and_then(|given| given.parse().ok());
    let clock = || SystemTime::now().duration_since(UNIX_EPOCH).unwrap().as_nanos() as u64;
    let seed = number("PROPTEST_RNG_SEED").unwrap_or_else(clock);
    (seed, number(seconds).map_or(usual, Duration::from_secs))
}

/// Texts that are inserted where they do not belong.
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

/// A generator of pseudorandom numbers (splitmix64: G. L. Steele, D. Lea, C. H. Flood, *Fast splittable
/// pseudorandom number generators*, OOPSLA 2014).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    /// Returns a random item, or `None` if there are none.
    pub(crate) fn one_of<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        all.get(self.below(all.len()))
    }
}

/// Returns the byte positions at which the tokens of a text (words, numbers, punctuation marks) begin,
/// followed by its length.
fn tokens(bytes: &[u8]) -> Vec<usize> {
    let is_of_word =
        |byte: u8| byte.is_ascii_alphanumeric() || b"_.".contains(&byte) || byte >= 0x80;
    let goes_on = |pair: &[u8]| is_of_word(pair[0]) && is_of_word(pair[1]);
    let starts =
        bytes.windows(2).enumerate().filter(|(_, pair)| !goes_on(pair)).map(|(at, _)| at + 1);
    [0].into_iter().chain(starts).chain([bytes.len()]).collect()
}

/// Returns a random sample in which some tokens are deleted, repeated, or replaced by others, or from
/// which the end is cut off.
fn mutant(samples: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut text = random.one_of(samples).unwrap().clone();
    for _ in 0..=random.below(4) {
        let marks = tokens(&text);
        let first = random.below(marks.len() - 1);
        let last = (first + 1 + random.below(8)).min(marks.len() - 1);
        let (from, end) = (marks[first], marks[last]);
        let piece = text[from..end].to_vec();
        let strange = random.one_of(&STRANGE).unwrap().as_bytes();
        let new: Vec<u8> = match random.below(8) {
            0 => Vec::new(),
            1 => strange.to_vec(),
            2 => [strange, &piece].concat(),
            3 => [&piece, strange].concat(),
            4 => piece.repeat(2 + random.below(200)),
            5 => [piece, strange.repeat(1 + random.below(3000))].concat(),
            6 => {
                let other = random.one_of(samples).unwrap();
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
        text.truncate(LENGTH);
    }
    text
}

/// Maximum length of a mutated text in bytes, since repetitions may themselves be repeated.
const LENGTH: usize = 256 << 10;

/// Maximum time to read a text, generous enough for 100 kB in a debug build on a busy machine. A reader
/// whose time grows with the square of the length would take minutes.
const PATIENCE: Duration = Duration::from_secs(30);

/// Maximum length of a message in characters, including file name and position.
const MESSAGE: usize = 1100;

fn run(samples: &[Vec<u8>], readers: &[Reader], seed: u64, time: Duration) {
    let mut random = Random::new(seed);
    let (since, mut count) = (Instant::now(), 0);
    while since.elapsed() < time {
        let text = mutant(samples, &mut random);
        for (name, read) in readers {
            let begun = Instant::now();
            let is_bad = |message: &String| {
                message.chars().count() > MESSAGE || message.chars().any(is_hidden)
            };
            let fault = match catch_unwind(AssertUnwindSafe(|| read(&text))) {
                Err(_) => Some("panicked".to_owned()),
                Ok(_) if begun.elapsed() > PATIENCE => Some(format!("took {:?}", begun.elapsed())),
                Ok(messages) => messages.into_iter().find(is_bad),
            };
            let shown = String::from_utf8_lossy(&text);
            assert!(fault.is_none(), "seed {seed}, text {count}: {name}: {fault:?}\n{shown}");
        }
        count += 1;
    }
}
