//! `pinhole figure`

use std::fs;
use std::path::Path;

use egui::Color32;
use pinhole_figure::overlay::Style;

use super::figure_read_back::decoded;
use super::{Run, entries, run_in};

const VIEWS: [&str; 4] = ["world", "camera", "derivation", "lines"];

pub(crate) fn figure(folder: &Path, line: &str) -> Run {
    run_in(folder, &format!("figure {line}").split(' ').collect::<Vec<_>>())
}

/// Width, height and pixels of a PNG file, and whether it can be transparent.
pub(crate) fn decode(path: &Path) -> (u32, u32, Vec<[u8; 4]>, bool) {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut decoder = png::Decoder::new(file);
    decoder.set_transformations(png::Transformations::ALPHA);
    let mut reader = decoder.read_info().unwrap();
    let clear = reader.info().color_type == png::ColorType::Rgba;
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    let pixels = bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect();
    (info.width, info.height, pixels, clear)
}

fn rgba(color: Color32) -> [u8; 4] {
    color.to_array()
}

#[test]
fn every_view_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    for view in VIEWS {
        for (ending, magic) in [("svg", "<svg "), ("pdf", "%PDF-"), ("png", "\u{fffd}PNG")] {
            let out = format!("{view}.{ending}");
            let line = format!("canonical --view {view} -o {out} --width 500");
            assert_eq!(figure(folder.path(), &line).done(), "");
            let first = fs::read(folder.path().join(&out)).unwrap();
            assert!(String::from_utf8_lossy(&first).starts_with(magic), "{out}");
            figure(folder.path(), &line).done();
            let second = fs::read(folder.path().join(&out)).unwrap();
            assert!(first == second, "{out} is not the same twice");
        }
    }
    assert_eq!(entries(folder.path()).len(), 12);
}

#[test]
fn the_size_is_as_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let size = |arguments: &str| {
        figure(folder.path(), &format!("{arguments} -o out.png")).done();
        let (width, height, ..) = decode(&folder.path().join("out.png"));
        (width, height)
    };
    for (arguments, expected) in [
        ("canonical --view world --width 320", (320, 180)),
        ("canonical --view world --height 180", (320, 180)),
        ("canonical --view world --width 200 --height 300", (200, 300)),
        // Two dots for each of the 400 pixels, which is as large as fits.
        ("canonical --view camera", (800, 800)),
        ("canonical --view camera --height 90", (90, 90)),
        ("canonical --view camera --width 90 --height 90", (90, 90)),
        ("canonical --view lines --width 320", (320, 240)),
    ] {
        assert_eq!(size(arguments), expected, "{arguments}");
    }
    let [small, large] =
        [400, 800].map(|w| size(&format!("canonical --view derivation --width {w}")));
    assert_eq!((small.0, large.0), (400, 800));
    // The same lines, twice as large, but for letters on whole dots.
    assert!(small.1.abs_diff(large.1 / 2) <= large.1 / 50, "{small:?} {large:?}");
}

/// Width and height of the picture in an SVG.
fn picture_of(svg: &str, folder: &Path) -> (u32, u32) {
    let (_, data) = svg.split_once("data:image/png;base64,").unwrap();
    let data = data.split('"').next().unwrap();
    let path = folder.join("picture.png");
    fs::write(&path, decoded(data)).unwrap();
    let (width, height, ..) = decode(&path);
    (width, height)
}

#[test]
fn a_printed_world_view_has_300_pixels_an_inch() {
    let folder = tempfile::tempdir().unwrap();
    let size = |arguments: &str| {
        figure(folder.path(), &format!("canonical {arguments} -o out.svg")).done();
        let svg = fs::read_to_string(folder.path().join("out.svg")).unwrap();
        picture_of(&svg, folder.path())
    };
    // At 96 dots an inch, 480 are five inches.
    assert_eq!(size("--view world --width 480"), (1500, 844));
    assert_eq!(size("--view world --width 4096 --height 64"), (8192, 128));
    assert_eq!(size("--view camera --width 1200"), (1200, 1200), "its pixels are its subject");
}

/// The numbers of the ellipses in an SVG: centre, semi-axes, and the angle of the first one.
fn ellipses(svg: &str) -> Vec<[f64; 5]> {
    let of = |element: &str| {
        let number = |name: &str| {
            let (_, rest) = element.split_once(name).unwrap();
            rest.split(['"', ' ']).next().unwrap().parse::<f64>().unwrap()
        };
        ["cx=\"", "cy=\"", "rx=\"", "ry=\"", "rotate("].map(number)
    };
    svg.split("<ellipse ").skip(1).map(of).collect()
}

#[test]
fn the_edge_of_a_ball_is_the_curve_at_which_its_pixels_end() {
    let folder = tempfile::tempdir().unwrap();
    // This scene has balls alone, so that no line crosses their edges.
    figure(folder.path(), "tiny-far --view world -o out.svg --width 480").done();
    let svg = fs::read_to_string(folder.path().join("out.svg")).unwrap();
    let found = ellipses(&svg);
    assert!(!found.is_empty(), "balls that nothing covers");
    assert!(svg.contains("<clipPath id=\"spheres\">") && svg.contains("url(#spheres)"));
    run_in(
        folder.path(),
        &[
            "render", "tiny-far", "--view", "world", "--width", "1920", "--height", "1080", "-o",
            "4.png",
        ],
    )
    .done();
    let (width, height, pixels, _) = decode(&folder.path().join("4.png"));
    assert_eq!((width, height), (1920, 1080));
    let is_colourful = |[r, g, b, _]: [u8; 4]| r.max(g).max(b) - r.min(g).min(b) > 40;
    for [x, y, a, b, angle] in found {
        let (sin, cos) = angle.to_radians().sin_cos();
        let (mut inside, mut outside) = (0, 0);
        for row in 0..height {
            for column in 0..width {
                let (dx, dy) =
                    ((f64::from(column) + 0.5) / 4.0 - x, (f64::from(row) + 0.5) / 4.0 - y);
                let share = ((dx * cos + dy * sin) / a).hypot((dy * cos - dx * sin) / b);
                // In pixels of the finer picture, whose edges are smooth.
                let distance = 4.0 * a.min(b) * (share - 1.0);
                let colourful = is_colourful(pixels[(row * width + column) as usize]);
                if (-3.0..-1.0).contains(&distance) {
                    inside += 1;
                    assert!(colourful, "row {row}, column {column}");
                } else if (1.0..3.0).contains(&distance) {
                    outside += 1;
                    assert!(!colourful, "row {row}, column {column}");
                }
            }
        }
        assert!(inside > 100 && outside > 100);
    }
}

#[test]
fn strokes_are_strokes_and_text_is_text() {
    let folder = tempfile::tempdir().unwrap();
    let line = "look-at --view world -o world.svg --width 900 --uv 0.2,-0.1";
    figure(folder.path(), line).done();
    let svg = fs::read_to_string(folder.path().join("world.svg")).unwrap();
    for label in ["eye", "at", "u", "v", "w", "hit"] {
        assert_eq!(svg.matches(&format!(">{label}</tspan>")).count(), 1, "{label}");
    }
    let colors = Style::Light.colors();
    for color in colors.basis.into_iter().chain([colors.ray]) {
        let [r, g, b, _] = color.to_array();
        let stroke = "<polyline points=";
        let ink = format!("stroke=\"#{r:02x}{g:02x}{b:02x}\"");
        assert!(svg.lines().any(|line| line.starts_with(stroke) && line.contains(&ink)), "{ink}");
    }
    assert_eq!(svg.matches("<image").count(), 2, "the ground, and the balls");
    assert!(svg.contains("@font-face{font-family:\"Noto Sans\";font-weight:bold;"));
    figure(folder.path(), "look-at --view world -o plain.svg --width 900").done();
    let plain = fs::read_to_string(folder.path().join("plain.svg")).unwrap();
    assert!(!plain.contains(">hit</tspan>"), "no ray was asked for");
}

#[test]
fn in_greys_u_v_w_have_dashes_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    for style in [Style::GreyLight, Style::GreyDark, Style::Light] {
        let line = format!("look-at --view world -o out.svg --width 900 --theme {}", style.name());
        figure(folder.path(), &line).done();
        let svg = fs::read_to_string(folder.path().join("out.svg")).unwrap();
        // The widest lines of this colour: the arrow's shaft, with its dashes, if it has any.
        let dashes = style.colors().basis.map(|color| {
            let [r, g, b, _] = color.to_array();
            let ink = format!("stroke=\"#{r:02x}{g:02x}{b:02x}\"");
            let lines =
                svg.lines().filter(|line| line.starts_with("<polyline") && line.contains(&ink));
            let after = |line: &str, key: &str| {
                let (_, rest) = line.split_once(key)?;
                Some(rest.split('"').next()?.to_owned())
            };
            let width =
                |line: &&str| after(line, "stroke-width=\"").unwrap().parse::<f64>().unwrap();
            let lines: Vec<&str> = lines.collect();
            let widest = lines.iter().map(width).fold(0.0, f64::max);
            // Heads may be lines, too, but none with dashes.
            let wide = lines.iter().filter(|line| width(line) == widest);
            wide.filter_map(|line| after(line, "stroke-dasharray=\"")).next().unwrap_or_default()
        });
        if style == Style::Light {
            assert_eq!(dashes, ["", "", ""], "told apart by hue");
        } else {
            let [u, v, w] = &dashes;
            assert!(u.is_empty() && !v.is_empty() && !w.is_empty() && v != w, "{dashes:?}");
        }
    }
}

#[test]
fn hidden_lines_are_dashed() {
    let folder = tempfile::tempdir().unwrap();
    figure(folder.path(), "canonical --view world -o out.svg --uv 0,0").done();
    let svg = fs::read_to_string(folder.path().join("out.svg")).unwrap();
    assert!(svg.contains("stroke-dasharray="));
}

#[test]
fn transparent_figures_have_no_ground() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
                 [[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n\
                 [[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n";
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    for view in VIEWS {
        let draw = |more: &str| {
            let line = format!("s.toml --view {view} -o out.png --width 400{more}");
            figure(folder.path(), &line).done();
            decode(&folder.path().join("out.png"))
        };
        let (.., whole, may_be_clear) = draw("");
        assert!(!may_be_clear && whole.iter().all(|pixel| pixel[3] == 255), "{view}");
        let (.., clear, may_be_clear) = draw(" --transparent");
        assert!(may_be_clear, "{view}");
        let count = |alpha: u8| clear.iter().filter(|pixel| pixel[3] == alpha).count();
        // The lab's half planes are tinted all over.
        assert!(count(0) > clear.len() / 5 || view == "lines", "{view}: {}", count(0));
        // Small letters cover few dots as a whole.
        assert!(count(255) > 50, "{view}: {}", count(255));
        let same = whole.iter().zip(&clear).filter(|(_, c)| c[3] == 255);
        // A stroke's edge that covers a dot almost wholly counts as opaque.
        let near = |(w, c): (&[u8; 4], &[u8; 4])| (0..3).all(|k| w[k].abs_diff(c[k]) <= 3);
        assert!(same.clone().all(near), "{view}: what is opaque is the same");
    }
    for view in ["derivation", "lines"] {
        figure(folder.path(), &format!("roll --view {view} -o a.svg")).done();
        figure(folder.path(), &format!("roll --view {view} -o b.svg --transparent")).done();
        let [a, b] =
            ["a.svg", "b.svg"].map(|name| fs::read_to_string(folder.path().join(name)).unwrap());
        assert_eq!((a.matches("<rect ").count(), b.matches("<rect ").count()), (1, 0));
    }
}

#[test]
fn the_theme_is_that_of_the_window() {
    let folder = tempfile::tempdir().unwrap();
    for style in Style::ALL {
        let theme = style.name();
        let line = format!("canonical --view world -o out.png --width 600 --theme {theme}");
        figure(folder.path(), &line).done();
        let (.., pixels, _) = decode(&folder.path().join("out.png"));
        let colors = style.colors();
        assert_eq!(pixels[0], rgba(colors.background));
        assert!(pixels.contains(&rgba(colors.basis[2])));
        figure(folder.path(), &line.replace("world", "derivation")).done();
        let (.., pixels, _) = decode(&folder.path().join("out.png"));
        let is_dark = pixels[0][0] < 100;
        assert_eq!(is_dark, style.is_dark());
        assert!(pixels.contains(&rgba(colors.basis[2])), "w has the same colour as in the views");
    }
}

#[test]
fn the_camera_s_pixels_are_kept_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
                 [image]\nwidth = 300\nheight = 200\n[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n";
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    let draw = |line: &str| {
        figure(folder.path(), line).done();
        fs::read_to_string(folder.path().join("out.svg")).unwrap()
    };
    let svg = draw("s.toml --view camera -o out.svg --width 1500");
    let image = svg.lines().find(|line| line.starts_with("<image ")).unwrap();
    assert!(image.contains("image-rendering:pixelated"));
    let (_, data) = image.split_once("base64,").unwrap();
    let bytes = super::figure_read_back::decoded(data.split('"').next().unwrap());
    let info = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    assert_eq!((info.info().width, info.info().height), (1500, 1000));
}

#[test]
fn the_derivation_is_text_too() {
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    figure(folder.path(), "forty-five --view derivation -o out.tex --uv 0.2,-0.1").done();
    let latex = read("out.tex");
    assert!(latex.contains(r"\begin{align*}"), "{latex}");
    figure(folder.path(), "forty-five --view derivation -o out.md --uv 0.2,-0.1").done();
    let markdown = read("out.md");
    assert!(markdown.contains(r"t = "), "{markdown}");
    for (name, text) in [("LaTeX", &latex), ("Markdown", &markdown)] {
        // The lecture's answer: t = 5 sqrt 2 at (-4, -sqrt2/2, -6).
        assert!(text.contains(r"5 \sqrt{2}"), "{name}: {text}");
        assert!(text.contains(r"\frac{1}{\sqrt{2}}"), "{name}: {text}");
    }
}

#[test]
fn a_camera_without_a_basis() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 2, 0]\nup = [0, 1, 0]\n";
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    let why = "s.toml:5:6: camera.up: up (0, 1, 0) is parallel to the view direction (0, 2, 0): turn \
               one of them";
    for view in ["world", "camera"] {
        figure(folder.path(), &format!("s.toml --view {view} -o out.svg")).failed(1, why);
    }
    figure(folder.path(), "s.toml --view derivation -o out.svg --pixel 0,0").failed(1, why);
    assert_eq!(entries(folder.path()), ["s.toml"]);
    // The derivation says where it fails.
    figure(folder.path(), "s.toml --view derivation -o out.md").done();
    let text = fs::read_to_string(folder.path().join("out.md")).unwrap();
    assert!(text.contains("is parallel to the view direction"), "{text}");
}

#[test]
fn what_does_not_fit_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let at = |line: &str| figure(folder.path(), line);
    at("canonical -o out.svg").refused("--view <world|camera|derivation|lines>");
    at("canonical --view side -o out.svg").refused("world, camera, derivation, lines");
    at("canonical --view world").refused("--output <OUT.svg|pdf|png>");
    at("canonical --view world -o a.svg --theme sepia")
        .refused("light, dark, colour-blind, colour-blind-dark, grey, grey-dark");
    at("canonical --view world -o a.svg --width 0")
        .refused("it must be a whole number of pixels, 1 to 16384");
    at("canonical --view world -o a.svg --uv 0,0 --pixel 1,1").refused("cannot be used with");
    at("canonical --view world -o out.jpg")
        .failed(2, "-o writes SVG, PDF or PNG: not out.jpg but out.svg, out.pdf or out.png");
    at("canonical --view camera -o out.tex").failed(
        2,
        "-o writes SVG, PDF or PNG: not out.tex but out.svg, out.pdf or out.png; LaTeX and Markdown \
         are for --view derivation",
    );
    at("canonical --view derivation -o out").failed(
        2,
        "-o writes SVG, PDF, PNG, LaTeX or Markdown: not out but out.svg, out.pdf, out.png, out.tex \
         or out.md",
    );
    at("canonical --view derivation -o out.svg --height 9")
        .failed(2, "the derivation is as high as its lines: leave out --height, give --width");
    at("canonical --view derivation -o out.md --width 9")
        .failed(2, "--width is for pictures: leave it out, out.md is text");
    at("canonical --view camera -o out.svg --width 300 --height 200").failed(
        2,
        "300 x 200 is not in the proportions of the camera's image, 400 x 400 pixels: leave out \
         --width or --height",
    );
    at("canonical --view world -o out.png --height 10000").failed(
        2,
        "image width is 17778: it must be 1 to 16384 pixels; give both --width and --height",
    );
    at("canonical --view world -o out.svg --pixel 400,0").failed(
        1,
        "canonical: pixel 400,0 is outside the image of 400 rows and 400 columns: rows are 0 to 399, \
         columns 0 to 399",
    );
    at("no.toml --view world -o no/out.svg")
        .failed(1, "no/out.svg: cannot be written: no such file or directory");
    assert!(entries(folder.path()).is_empty());
}

#[test]
fn a_figure_is_seen_from_the_scene_s_own_observer() {
    let folder = tempfile::tempdir().unwrap();
    let plain = pinhole_exchange::BuiltinScene::find("canonical").unwrap().text;
    let picture = |name: &str, observer: &str| {
        fs::write(folder.path().join("scene.toml"), format!("{plain}\n{observer}")).unwrap();
        let out = folder.path().join(name);
        let line = format!("scene.toml --view world --width 320 -o {name}");
        figure(folder.path(), &line).done();
        decode(&out).2
    };
    let from = |azimuth: f64| {
        format!(
            "[observer]\ntarget = [0, 0, -3]\nazimuth = {azimuth}\nelevation = 20\ndistance = 12\n"
        )
    };
    let fitted = picture("fitted.png", "");
    let [left, right] = [picture("left.png", &from(-40.0)), picture("right.png", &from(40.0))];
    assert!(fitted != left && left != right && right != fitted);
    assert!(left == picture("turned.png", &from(320.0)));
}
