//! `pinhole share`: a link, and its code as SVG, as PNG and in the terminal.

use std::fs;

use pinhole_exchange::link::Link;
use pinhole_exchange::scene_file;

use super::{run, run_in};

#[test]
fn a_step_and_a_built_in_scene_are_short() {
    for line in ["share --lesson 7.3", "share --lesson 7 --step 3"] {
        assert_eq!(run(line).done(), "pinhole.html#7.3\n");
    }
    assert_eq!(
        run("share --lesson 7.3 --base https://a.b/c.html#old").done(),
        "https://a.b/c.html#7.3\n"
    );
    let link = run("share forty-five --pixel 99,199").done();
    assert!(link.starts_with("pinhole.html#v1/forty-five/p99,199/"), "{link}");
    assert_eq!(link.len(), "pinhole.html#v1/forty-five/p99,199/12345678\n".len());
}

#[test]
fn a_scene_is_in_its_link() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let mut document = pinhole_exchange::Document::default();
    document.camera.eye.x = 1.0 / 3.0;
    scene_file::save(&document, &path, None).unwrap();
    let link = run_in(folder.path(), &["share", "mine.toml"]).done();
    let pinhole_exchange::link::Linked::Scene(read) = Link::parse(&link).unwrap().shown else {
        panic!("{link}");
    };
    assert_eq!(*read, document);
}

#[test]
fn codes_are_written_as_svg_and_png_and_into_the_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let base = ["--base", "https://example.org/pinhole.html"];
    for file in ["code.svg", "code.png"] {
        let line = ["share", "--lesson", "7.3", base[0], base[1], "-o", file];
        assert_eq!(run_in(folder.path(), &line).done(), "");
    }
    let svg = fs::read(folder.path().join("code.svg")).unwrap();
    let tree = resvg::usvg::Tree::from_data(&svg, &Default::default()).unwrap();
    let modules = tree.size().width();
    let png = image::open(folder.path().join("code.png")).unwrap().to_rgb8();
    assert!(png.width() >= 1024 && png.width() as f32 % modules == 0.0, "{} px", png.width());
    let mut drawn = resvg::tiny_skia::Pixmap::new(png.width(), png.width()).unwrap();
    let scale = png.width() as f32 / modules;
    let larger = resvg::tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, larger, &mut drawn.as_mut());
    for (x, y, pixel) in png.enumerate_pixels() {
        let other = drawn.pixel(x, y).unwrap();
        assert_eq!(pixel.0, [other.red(), other.green(), other.blue()], "({x}, {y})");
    }
    let line = ["share", "--lesson", "7.3", base[0], base[1], "--qr"];
    let text = run_in(folder.path(), &line).done();
    assert!(text.ends_with("\nhttps://example.org/pinhole.html#7.3\n"), "{text}");
    assert_eq!(
        text.lines().filter(|line| line.starts_with("\x1b[30;107m")).count(),
        (modules as usize).div_ceil(2)
    );
}

#[test]
fn what_has_no_link_or_code_is_refused() {
    run("share").refused("<SCENE>");
    run("share canonical --lesson 7").refused("cannot be used with");
    run("share --lesson 14").refused("there is no lesson 14");
    run("share --lesson mine.toml").refused("only lessons of the program have a link");
    run("share canonical --qr").refused("--base <URL>");
    for wrong in ["nowhere", "javascript:alert(1)", "https://", "ftp://a.b"] {
        run(&format!("share canonical --base {wrong}")).refused("not the address of a page");
    }
    run("share canonical --base a.b -o code.pdf")
        .refused("-o writes SVG or PNG: not code.pdf but code.svg or code.png");
    run("share canonical --pixel 400,0").failed(
        1,
        "canonical: pixel 400,0 is outside the image of 400 rows and 400 columns: rows are 0 to 399, \
         columns 0 to 399",
    );
    let base = format!("https://a.b/{}", "long".repeat(800));
    let line = ["share", "canonical", "--qr", "--base", &base];
    let failed = run_in(&std::env::temp_dir(), &line);
    assert_eq!(failed.status, 1);
    assert!(failed.stderr.contains("a QR code holds 2953"), "{}", failed.stderr);
}

#[test]
fn a_wrong_link_as_argument_is_refused_before_a_window_opens() {
    run("https://a.b/pinhole.html#14.1")
        .failed(1, "link: there is no lesson 14: there are lessons 1 to 13");
    run("#v1/canonical/00000000")
        .failed(1, "link:1:14: mistyped or cut off: copy it again as a whole");
}
