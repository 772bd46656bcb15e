//! Tests that links keep a scene to the last bit, and that broken ones are refused with a reason.

use std::io::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use expect_test::expect;
use flate2::write::DeflateEncoder;
use pinhole_core::{DVec2, DVec3, Pixel, Selection, Sphere};
use pinhole_exchange::document::{CsvSpheres, Document, Item};
use pinhole_exchange::link::{self, Link, Linked};
use pinhole_exchange::{BuiltinScene, scene_file};
use proptest::option;
use proptest::prelude::*;

use super::round_trip::{bits, document, number};

fn plain(shown: Linked) -> Link {
    Link { shown, ray: None, page: None }
}

fn step(lesson: usize, step: usize) -> Link {
    plain(Linked::Step { lesson, step })
}

/// Ten spheres with names and colours at places as a hand drags them to, and a camera likewise.
fn ten_spheres() -> Document {
    let names = [
        "sun", "mercury", "venus", "earth", "moon", "mars", "jupiter", "saturn", "uranus",
        "neptune",
    ];
    let sphere = |(k, name): (usize, &&str)| {
        let x = k as f64;
        let center = DVec3::new((x * 0.73).sin() * 3.0, (x * 1.31).cos(), -5.0 - x / 3.0);
        let shape = Sphere { center, radius: 0.3 + x / 7.0 };
        let color = [(k * 23) as u8, (200 - k * 11) as u8, (k * k * 3) as u8];
        Item { name: Some((*name).to_owned()), color: Some(color), shape }
    };
    let spheres: Vec<Item<Sphere>> = names.iter().enumerate().map(sphere).collect();
    let mut document = Document { spheres: spheres.into(), ..Document::default() };
    document.camera.eye = DVec3::new(0.123456789, 1.0 / 3.0, 2.0f64.sqrt());
    document
}

fn fragment(link: &Link) -> String {
    link.to_fragment().unwrap()
}

fn problem(text: &str) -> String {
    Link::parse(text).unwrap_err().to_string()
}

#[test]
fn a_step_is_a_few_characters_with_or_without_the_page() {
    assert_eq!(fragment(&step(7, 3)), "7.3");
    for text in ["7.3", "#7.3", " https://example.org/a/pinhole.html#7.3\n", "pinhole.html#7.3"] {
        assert_eq!(Link::parse(text).unwrap(), step(7, 3), "{text}");
    }
    assert_eq!(Link::parse("#12").unwrap(), step(12, 1));
}

#[test]
fn links_are_short() {
    let canonical = Linked::scene(&BuiltinScene::find("canonical").unwrap().load().unwrap());
    assert_eq!(fragment(&plain(canonical)).len(), "v1/canonical/12345678".len());
    let mut near = Document::default();
    near.camera.eye.x = 0.25;
    let lengths = |document: &Document| {
        let fragment = fragment(&plain(Linked::scene(document)));
        (scene_file::to_text(document, None).len(), fragment.len())
    };
    assert_eq!(fragment(&step(7, 3)).len(), 3);
    assert!(lengths(&near).1 < 60);
    assert!(lengths(&ten_spheres()).1 < 700);
    for builtin in BuiltinScene::all() {
        let mut document = builtin.load().unwrap();
        document.camera.eye.x += 0.25;
        let (text, link) = lengths(&document);
        println!("{}, eye moved: {text} bytes, link {link}", builtin.name);
        assert!(link < 500, "{}: {link}", builtin.name);
    }
}

/// Links that are printed somewhere must open for ever.
#[test]
fn links_of_version_1_are_read() {
    let link = "v1/ZzdKxCQAgDADBVQT7oIjgEk6htlqIzi8WKUICaTPC8e9dXXd0UKXZrBTT7zPZS1FgB0ikdCv_pQc/uv0.25,-0.0/plot/901be81d";
    let mut document = Document { note: "Moved.".to_owned(), ..ten_spheres() };
    document.camera.eye = DVec3::new(0.5, 0.0, 0.0);
    document.spheres.truncate(1);
    let ray = Some(Selection::Uv(DVec2::new(0.25, -0.0)));
    let expected = Link { ray, page: Some("plot".to_owned()), ..plain(Linked::scene(&document)) };
    assert_eq!(Link::parse(link).as_ref(), Ok(&expected), "now: {}", fragment(&expected));
    let expected =
        Link { ray: Some(Selection::Pixel(Pixel { row: 99, column: 199 })), ..step(7, 3) };
    assert_eq!(
        Link::parse("v1/7.3/p99,199/e993d62c"),
        Ok(expected.clone()),
        "now: {}",
        fragment(&expected)
    );
}

#[test]
fn what_is_wrong_is_told_at_its_place() {
    let link = fragment(&plain(Linked::Builtin(BuiltinScene::find("look-at").unwrap())));
    let newer = link.replace("v1", "v2");
    let with_end = |body: &str| format!("{body}/{:08x}", crc32fast::hash(body.as_bytes()));
    let cases = [
        "".to_owned(),
        "https://example.org/pinhole.html".to_owned(),
        "#7.x".to_owned(),
        "#hello".to_owned(),
        newer,
        link.replace("v1", "v0"),
        link[..link.len() - 3].to_owned(),
        link.replace("look", "lock"),
        with_end("v1/lock-at"),
        with_end("v1/look-at/p1,x"),
        with_end("v1/look-at/uv1,inf"),
        with_end("v1/look-at/Plot"),
        with_end("v1/look-at/plot/p1,1"),
        with_end("v1/Z!"),
        with_end("v1/ZAAAA"),
        format!("#{}", "x".repeat(100_000)),
    ];
    let told: Vec<String> = cases.iter().map(|case| problem(case)).collect();
    expect![[r#"
        link:1:1: not a link that Pinhole has made: copy the whole link again, to its end, or type a lesson's step, such as 7.3
        link:1:1: not a link that Pinhole has made: copy the whole link again, to its end, or type a lesson's step, such as 7.3
        link:1:1: not a lesson's step, such as 7.3
        link:1:1: not a link that Pinhole has made: copy the whole link again, to its end, or type a lesson's step, such as 7.3
        link:1:2: of version 2, and this program reads version 1: a newer Pinhole opens it
        link:1:2: of version 0, and this program reads version 1: mistyped, or of an older Pinhole: make it again
        link:1:17: cut off: copy it again as a whole
        link:1:12: mistyped or cut off: copy it again as a whole
        link:1:4: this program has no scene "lock-at"
        link:1:12: not a ray, such as p99,199 or uv0.2,-0.1
        link:1:12: not a ray, such as p99,199 or uv0.2,-0.1
        link:1:12: not a page's name in lowercase letters
        link:1:17: there is more than scene, ray and page
        link:1:5: the scene is not base64url: Invalid symbol 33, offset 0.
        link:1:5: the scene cannot be unpacked: incomplete deflate stream
        link: 100000 characters long: it has at most 8000"#]]
    .assert_eq(&told.join("\n"));
}

/// A packed text that is no scene, or names a file, or is endless.
#[test]
fn a_packed_text_is_checked_like_a_file() {
    let packed = |text: &[u8]| {
        let mut encoder = DeflateEncoder::new(Vec::new(), flate2::Compression::best());
        encoder.write_all(text).unwrap();
        let body = format!("v1/Z{}", URL_SAFE_NO_PAD.encode(encoder.finish().unwrap()));
        format!("{body}/{:08x}", crc32fast::hash(body.as_bytes()))
    };
    let scene = scene_file::to_text(&Document::default(), None);
    assert_eq!(Link::parse(&packed(scene.as_bytes())), Ok(plain(Linked::Scene(Box::default()))));
    let told = [
        problem(&packed(scene.replace("width = 1.0", "width = -1.0").as_bytes())),
        problem(&packed(
            scene.replace("[camera]", "spheres = \"/etc/passwd\"\n[camera]").as_bytes(),
        )),
        problem(&packed(b"\xff")),
        problem(&packed(&vec![b'\n'; 1 << 22])),
    ];
    expect![[r#"
        scene in the link:9:9: viewport.width is -1.0: it must be greater than 0
        scene in the link: names a file of spheres, which only files may
        link:1:5: the scene is not UTF-8 text
        link:1:5: the scene is larger than 128 KiB"#]]
    .assert_eq(&told.join("\n"));
}

#[test]
fn scenes_without_a_link_are_refused_with_advice() {
    let file = "many.csv";
    let (path, items) = (file.to_owned(), Default::default());
    let csv = CsvSpheres { path, file: file.into(), stamp: None, count: 0, items };
    let with_csv = Document { csv_spheres: Some(csv), ..Document::default() };
    let mut large = ten_spheres();
    let all = large.spheres.clone();
    for k in 0..900 {
        let mut item = all[k % 10].clone();
        item.shape.center = DVec3::new(k as f64, (k as f64).sqrt(), (k as f64).sin());
        large.spheres.push(item);
    }
    let mut huge = ten_spheres();
    huge.note = "long ".repeat(40_000);
    let told = [with_csv, large, huge]
        .map(|document| plain(Linked::scene(&document)).to_fragment().unwrap_err().to_string());
    expect![[r#"
        link: the scene's spheres are in many.csv, which a link cannot have: write them into the scene, or save it as a page
        link: the scene is too large for a link: it needs 30112 characters, and a link has at most 8000. Save it as a page instead
        link: the scene is too large for a link: its text has 201543 bytes, and a link has at most 8000. Save it as a page instead"#]].assert_eq(&told.join("\n"));
}

#[test]
fn urls_and_what_is_meant_as_one() {
    assert_eq!(link::url("", "7.3"), "pinhole.html#7.3");
    assert_eq!(link::url(" example.org/p.html#1.1 ", "7.3"), "https://example.org/p.html#7.3");
    assert_eq!(link::url("http://a.b/my page.html", "7.3"), "http://a.b/my%20page.html#7.3");
    for text in ["#7.3", "https://a.b/c#x", "file:///a/b.html#7", " pinhole.html#7.3 "] {
        assert!(link::is_meant(text), "{text}");
    }
    for text in ["", "7.3", "# a comment", "eye = 1 # x", "https://a.b/c", "a#b"] {
        assert!(!link::is_meant(text), "{text}");
    }
}

fn link() -> impl Strategy<Value = Link> {
    let scene = document()
        .prop_map(|document| Linked::Scene(Box::new(Document { csv_spheres: None, ..document })));
    let all = BuiltinScene::all();
    let builtin = (0..all.len()).prop_map(|k| Linked::Builtin(&all[k]));
    let step = (1..20usize, 1..20usize).prop_map(|(lesson, step)| Linked::Step { lesson, step });
    let ray = prop_oneof![
        (any::<u32>(), any::<u32>())
            .prop_map(|(row, column)| Selection::Pixel(Pixel { row, column })),
        (number(), number()).prop_map(|(u, v)| Selection::Uv(DVec2::new(u, v))),
    ];
    let shown = prop_oneof![scene, builtin, step];
    (shown, option::of(ray), option::of("[a-z]{1,12}")).prop_map(|(shown, ray, page)| Link {
        shown,
        ray,
        page,
    })
}

fn all_bits(link: &Link) -> String {
    match &link.shown {
        Linked::Scene(document) => format!("{} {:?} {:?}", bits(document), link.ray, link.page),
        _ => format!("{link:?}"),
    }
}

proptest! {
    #[test]
    fn every_link_reads_back_to_the_last_bit(link in link()) {
        match link.to_fragment() {
            Ok(fragment) => {
                prop_assert!(fragment.bytes().all(|b| b.is_ascii_graphic() && b != b'#' && b != b'%'));
                let read = Link::parse(&link::url("a.b", &fragment)).unwrap();
                prop_assert_eq!(all_bits(&read), all_bits(&link), "{}", fragment);
            }
            Err(error) => prop_assert!(error.problem.contains("Save it as a page"), "{}", error),
        }
    }

    #[test]
    fn a_changed_or_cut_link_is_refused_or_a_step(
        link in link(),
        at in any::<prop::sample::Index>(),
        other in "[0-9a-zA-Z./#_, -]|\\PC",
    ) {
        let Ok(whole) = link.to_fragment() else { return Ok(()) };
        let at = at.index(whole.len());
        let changed = format!("{}{other}{}", &whole[..at], &whole[at + 1..]);
        for broken in [changed, whole[..at].to_owned()] {
            if broken != whole && let Ok(read) = Link::parse(&broken) {
                prop_assert!(!whole.starts_with('v'), "{broken} of {whole}");
                let is_step = matches!(read.shown, Linked::Step { .. });
                prop_assert!(is_step && read.ray.is_none());
            }
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC*|#?v?[0-9]*/?[a-zA-Z0-9/.,_-]{0,200}") {
        let _ = (Link::parse(&text), link::is_meant(&text));
        let body = format!("v1/{}", text.replace('#', ""));
        let _ = Link::parse(&format!("{body}/{:08x}", crc32fast::hash(body.as_bytes())));
    }
}

/// Reads links of random bytes that pass the check, so that every byte reaches the unpacking.
#[test]
fn random_packed_bytes_are_refused_or_read() {
    proptest!(|(bytes in prop::collection::vec(any::<u8>(), 0..200))| {
        let body = format!("v1/Z{}", URL_SAFE_NO_PAD.encode(&bytes));
        let _ = Link::parse(&format!("{body}/{:08x}", crc32fast::hash(body.as_bytes())));
    });
}
