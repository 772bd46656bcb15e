//! Makes `target/pinhole.html`: the whole program for a browser in one file.
//!
//! Builds the program for WebAssembly, adds the bindings to the browser, makes it small with `wasm-opt` if that
//! is installed, packs it, and puts it into `assets/page.html` together with the page's own script. Run it in the
//! project's root: `cargo run --release -p pinhole-page`.

use std::error::Error;
use std::io::Write as _;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::{env, fs};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use wasm_bindgen_cli_support::Bindgen;
use zopfli::{Format, Options};

const TARGET: &str = "wasm32-unknown-unknown";

/// The vector instructions, and random numbers from the browser.
const FLAGS: &str = "-C target-feature=+simd128 --cfg getrandom_backend=\"wasm_js\"";

fn main() -> ExitCode {
    match make() {
        Ok(page) => {
            let _ = writeln!(std::io::stdout(), "{}", page.display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "pinhole-page: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Makes the page, and returns its path.
fn make() -> Result<PathBuf, Box<dyn Error>> {
    let target = PathBuf::from(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()));
    build()?;
    let program = target.join(TARGET).join("page/pinhole.wasm");
    let folder = target.join("page");
    let mut bindgen = Bindgen::new();
    bindgen.input_path(&program).typescript(false).remove_name_section(true);
    bindgen.no_modules(true)?.generate(&folder)?;
    let program = optimized(&folder.join("pinhole_bg.wasm"))?;
    // More rounds take twice as long, and save a thousandth.
    let options = Options { iteration_count: NonZero::<u64>::MIN, ..Options::default() };
    let mut packed = Vec::new();
    zopfli::compress(options, Format::Gzip, fs::File::open(program)?, &mut packed)?;
    let page = fs::read_to_string("assets/page.html")?
        .replace("@ICON@", &STANDARD.encode(fs::read("assets/icon.png")?))
        .replace("@BINDINGS@", &fs::read_to_string(folder.join("pinhole.js"))?)
        .replace("@SCRIPT@", &fs::read_to_string("assets/page.js")?)
        .replace("@PROGRAM@", &STANDARD.encode(packed));
    let path = target.join("pinhole.html");
    fs::write(&path, page)?;
    Ok(path)
}

/// Builds the program for WebAssembly.
fn build() -> Result<(), Box<dyn Error>> {
    const KEY: &str = "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS";
    let flags = format!("{FLAGS} {}", env::var(KEY).unwrap_or_default());
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--profile", "page", "--package", "pinhole", "--bin", "pinhole"])
        .args(["--no-default-features", "--features", "page", "--target", TARGET])
        .env(KEY, flags)
        .status()?;
    if built.success() {
        return Ok(());
    }
    Err(format!("the program was not built; if its target is missing: rustup target add {TARGET}")
        .into())
}

/// Makes the program small if wasm-opt is installed. Returns the path of the smaller one.
fn optimized(program: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let small = program.with_extension("opt.wasm");
    let run = Command::new("wasm-opt")
        .args(["-O2", "--all-features", "--strip-debug", "-o"])
        .arg(&small)
        .arg(program)
        .status();
    match run {
        Ok(status) if status.success() => Ok(small),
        Ok(status) => Err(format!("wasm-opt failed: {status}").into()),
        Err(_) => {
            let _ = writeln!(
                std::io::stderr(),
                "pinhole-page: without wasm-opt (package binaryen) the page is larger"
            );
            Ok(program.to_owned())
        }
    }
}
