//! `pinhole render`

use std::fs::{self, File};
use std::io::{BufReader, Cursor};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use exr::prelude::{FlatSamples, read_first_flat_layer_from_file};
use pinhole::cli::arguments::RenderArguments;
use pinhole::cli::render::Picture;
use pinhole::features::export::order::FigureSubject;
use pinhole_core::{Frame, ImageSize, NO_OBJECT, Outputs, Raster, Rgb, Shade, shade, trace_as};
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::BuiltinScene;

use super::{Run, entries, run_in};

fn render(folder: &Path, line: &str) -> Run {
    run_in(folder, &format!("render {line}").split(' ').collect::<Vec<_>>())
}

/// Width, height and pixels of a PNG file.
fn decode(path: &Path) -> (u32, u32, Vec<Rgb>) {
    let mut reader =
        png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
    (info.width, info.height, bytes.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect())
}

fn document(name: &str, width: u32, height: u32) -> Document {
    let mut document = BuiltinScene::find(name).unwrap().load().unwrap();
    document.camera.image = ImageSize::new(width, height).unwrap();
    document
}

fn traced(document: &Document) -> Frame<f32> {
    let camera = document.camera.resolve().unwrap();
    let outputs = Outputs { normal: true, ..Outputs::default() };
    trace_as(&document.scene().unwrap(), &camera, &Raster::full(camera.image()), outputs)
}

#[test]
fn the_picture_is_the_core_s_own() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.png");
    for shading in Shade::ALL {
        for name in ["canonical", "planet"] {
            let line =
                format!("{name} -o out.png --width 90 --height 70 --shade {}", shading.name());
            assert_eq!(render(folder.path(), &line).done(), "");
            let document = document(name, 90, 70);
            let color_of = |object| document.color_of(object);
            let scene = document.scene().unwrap();
            let expected = shade(&traced(&document), &scene, shading, color_of, |rgb| rgb);
            assert!(expected.iter().any(|rgb| *rgb != expected[0]));
            assert_eq!(decode(&out), (90, 70, expected), "{name} {}", shading.name());
        }
    }
    assert_eq!(entries(folder.path()), ["out.png"]);
}

#[test]
fn bands_write_the_bytes_of_one_band_and_count_every_row_once_a_pass() {
    let document = document("planet", 130, 333);
    for (overlay, aov, shade) in [
        (false, false, Shade::Lambert),
        (true, false, Shade::Lambert),
        (true, true, Shade::T),
        (false, true, Shade::T),
        (false, true, Shade::Normal),
    ] {
        let arguments = RenderArguments {
            scene: "planet".into(),
            output: "-".into(),
            width: None,
            height: None,
            view: FigureSubject::Camera,
            overlay,
            shade,
            aov: aov.then(|| "a.exr".into()),
        };
        let picture = Picture::new(document.clone(), &arguments, document.camera.image).unwrap();
        let passes = 1 + usize::from(aov) + usize::from(shade == Shade::T && !overlay);
        let written = |band| {
            let (mut png, mut exr) = (Vec::new(), Cursor::new(Vec::new()));
            let rows = AtomicUsize::new(0);
            let aov = aov.then_some((Path::new("a.exr"), &mut exr));
            let done = |done| {
                rows.fetch_add(done, Ordering::Relaxed);
            };
            picture.write(&mut png, aov, band, done).unwrap();
            assert_eq!((rows.into_inner(), picture.passes()), (333 * passes, passes));
            (png, exr.into_inner())
        };
        let whole = written(1 << 20);
        assert!(written(1) == whole && whole.1.is_empty() != aov, "{arguments:?}");
    }
}

#[test]
fn the_size_is_the_scene_s_unless_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("wide.toml"),
        "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
         [image]\nwidth = 60\nheight = 20\n",
    )
    .unwrap();
    let cases = [
        ("", 60, 20),
        (" --width 30", 30, 10),
        (" --height 40", 120, 40),
        (" --width 5 --height 7", 5, 7),
    ];
    for (arguments, width, height) in cases {
        render(folder.path(), &format!("wide.toml -o out.png{arguments}")).done();
        let (w, h, pixels) = decode(&folder.path().join("out.png"));
        assert_eq!((w, h, pixels.len() as u32), (width, height, width * height));
    }
    render(folder.path(), "wide.toml -o out.png --height 10000").failed(
        2,
        "image width is 30000: it must be 1 to 16384 pixels; give both --width and --height",
    );
}

/// How many pixels have exactly this colour.
fn count(pixels: &[Rgb], color: egui::Color32) -> usize {
    pixels.iter().filter(|pixel| **pixel == [color.r(), color.g(), color.b()]).count()
}

#[test]
fn the_overlay_marks_the_top_edge_and_leaves_the_rest_of_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    render(folder.path(), "canonical -o plain.png").done();
    render(folder.path(), "canonical -o overlay.png --overlay").done();
    let (_, _, plain) = decode(&folder.path().join("plain.png"));
    let (w, h, overlay) = decode(&folder.path().join("overlay.png"));
    assert_eq!((w, h), (400, 400));
    let mark = pinhole_figure::overlay::Style::Light.colors().mark;
    assert_eq!(count(&plain, mark), 0);
    assert!(count(&overlay, mark) > 300, "the bar along the top edge, and the label's words");
    let lower_half = 200 * 400..;
    assert_eq!(plain[lower_half.clone()], overlay[lower_half]);
}

#[test]
fn the_world_view_shows_the_camera_only_with_its_overlay() {
    let folder = tempfile::tempdir().unwrap();
    render(folder.path(), "look-at -o plain.png --view world --width 600 --height 400").done();
    render(folder.path(), "look-at -o world.png --view world --overlay --width 600 --height 400")
        .done();
    let (_, _, plain) = decode(&folder.path().join("plain.png"));
    let (w, h, world) = decode(&folder.path().join("world.png"));
    assert_eq!((w, h), (600, 400));
    let colors = pinhole_figure::overlay::Style::Light.colors();
    for vector in colors.basis {
        // A shaded sphere may have a dot of the arrow's very colour.
        assert!(count(&world, vector) > count(&plain, vector) + 20, "the arrow and its label");
    }
    assert_eq!(count(&world, colors.ray), 0, "no ray is selected");
}

#[test]
fn the_name_of_another_format_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    render(folder.path(), "canonical -o out.jpg")
        .failed(2, "-o writes PNG: not out.jpg but out.png");
    render(folder.path(), "canonical -o out.png --aov out.tiff")
        .failed(2, "--aov writes OpenEXR: not out.tiff but out.exr");
    assert!(entries(folder.path()).is_empty());
}

#[test]
fn the_exr_file_holds_what_the_rays_meet() {
    let folder = tempfile::tempdir().unwrap();
    render(folder.path(), "planet -o out.png --width 50 --height 30 --aov out.exr").done();
    assert_eq!(entries(folder.path()), ["out.exr", "out.png"]);
    let document = document("planet", 50, 30);
    let frame = traced(&document);
    let camera = document.camera.resolve().unwrap();

    let image = read_first_flat_layer_from_file(folder.path().join("out.exr")).unwrap();
    assert_eq!((image.layer_data.size.width(), image.layer_data.size.height()), (50, 30));
    let channels = &image.layer_data.channel_data.list;
    let names: Vec<String> = channels.iter().map(|c| c.name.to_string()).collect();
    assert_eq!(names, ["N.X", "N.Y", "N.Z", "margin", "object", "step", "t", "u", "v"]);
    let floats = |name: &str| -> &[f32] {
        let channel = channels.iter().find(|c| c.name.to_string() == name).unwrap();
        let FlatSamples::F32(samples) = &channel.sample_data else { panic!("{name} is no float") };
        samples
    };
    let FlatSamples::U32(objects) = &channels[4].sample_data else { panic!("object is no uint") };
    assert_eq!(objects, &frame.object);
    assert!(objects.contains(&NO_OBJECT) && objects.contains(&0));
    assert_eq!(NO_OBJECT, 4_294_967_295);
    for (k, object) in objects.iter().enumerate() {
        let (t, n) = (frame.t[k], frame.normal[k]);
        assert_eq!(floats("t")[k], t);
        assert_eq!(*object == NO_OBJECT, floats("t")[k].is_infinite());
        assert_eq!(
            [floats("N.X")[k], floats("N.Y")[k], floats("N.Z")[k]],
            n.to_array().map(|x| x as f32)
        );
        let uv = camera.uv_of_pixel(frame.at(k / 50, k % 50).pixel);
        assert_eq!([floats("u")[k], floats("v")[k]], [uv.x as f32, uv.y as f32]);
    }
}

/// A ball that one pixel's ray touches, and one that the next pixel's all but touches; before a wall.
#[cfg(feature = "report")]
const TANGENTS: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
     [image]\nwidth = 21\nheight = 21\n\
     [[sphere]]\ncenter = [0, 1, -5]\nradius = 1\n\
     [[sphere]]\ncenter = [0.19047619047619047, 1.0000000000000002, -4]\nradius = 1\n\
     [[plane]]\npoint = [0, 0, -6]\nnormal = [0, 0, 1]\n";

/// Returns `((q.d)^2 - |d|^2 (|q|^2 - r^2)) / (|d|^2 |q|^2)`, with q a sphere's centre, seen from the origin.
#[cfg(feature = "report")]
fn grazing(sphere: &pinhole_reference::Object, d: &[pinhole_reference::Real; 3]) -> f64 {
    use pinhole_reference::{Object, Real};
    let Object::Sphere { center, radius } = *sphere else { panic!("{sphere:?}") };
    let (q, r) = (center.map(Real::from), Real::from(radius));
    let dot = |a: &[Real; 3], b: &[Real; 3]| {
        let [x, y, z] = std::array::from_fn(|i| a[i].times(&b[i]));
        x.plus(&y).plus(&z)
    };
    let (a, b, square) = (dot(d, d), dot(&q, d), dot(&q, &q));
    b.times(&b).minus(&a.times(&square.minus(&r.times(&r)))).over(&a.times(&square))
}

#[cfg(feature = "report")]
#[test]
fn each_pixel_s_margin_in_the_exr_file_is_that_of_exact_arithmetic() {
    use pinhole_core::{Certificate, Question, Step};
    use pinhole_exchange::scenes::SceneSource;
    use pinhole_reference::{Camera, Object, Orientation};

    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.toml"), TANGENTS).unwrap();
    render(folder.path(), "s.toml -o out.png --aov out.exr").done();
    let image = read_first_flat_layer_from_file(folder.path().join("out.exr")).unwrap();
    let channels = &image.layer_data.channel_data.list;
    let samples = |name| &channels.iter().find(|c| c.name.to_string() == name).unwrap().sample_data;
    let FlatSamples::F32(margins) = samples("margin") else { panic!("margin is no float") };
    let FlatSamples::U32(steps) = samples("step") else { panic!("step is no uint") };
    assert!((0..3).all(|step| steps.contains(&step)), "{steps:?}");

    let exact = Camera {
        eye: [0.0; 3],
        orientation: Orientation::View { view: [0.0, 0.0, -1.0], up: [0.0, 1.0, 0.0] },
        width: 1.0,
        height: 1.0,
        distance: 1.0,
        columns: 21,
        rows: 21,
    };
    let objects = [
        Object::Sphere { center: [0.0, 1.0, -5.0], radius: 1.0 },
        Object::Sphere { center: [4.0 / 21.0, 1.0_f64.next_up(), -4.0], radius: 1.0 },
        Object::Plane { point: [0.0, 0.0, -6.0], normal: [0.0, 0.0, 1.0] },
    ];
    let exact = exact.prepare(&objects).unwrap();
    let document =
        SceneSource::from_argument(&folder.path().join("s.toml")).unwrap().load().unwrap();
    let (scene, camera) = (document.scene().unwrap(), document.camera.resolve().unwrap());
    let all: Vec<u32> = (0..21).collect();
    let certificates = scene.certificates(&camera, &all, &all, |_| ());
    for (k, certificate) in certificates.iter().enumerate() {
        let (row, column) = (k as u32 / 21, k as u32 % 21);
        let step = [Step::F64, Step::DoubleDouble, Step::Exact][steps[k] as usize];
        assert_eq!((step, margins[k]), (certificate.step, certificate.margin as f32));
        let Some(hardest) = certificate.hardest else {
            assert_eq!(f64::from(margins[k]), Certificate::MOST);
            continue;
        };
        let object = hardest.object as usize;
        let value = match hardest.question {
            Question::Meets => grazing(&objects[object], &exact.direction_of_pixel(row, column)),
            Question::Order => {
                let first = exact.first_hit_of_pixel(row, column).unwrap().t;
                let roots = exact.roots_of_pixel(object, row, column);
                let Some(t) = roots.first() else { continue };
                t.relative_difference(&first)
            }
            other => panic!("{other:?} is easy here"),
        };
        let (told, is_so) = (f64::from(margins[k]).exp2(), value.abs() / hardest.bound);
        let about = format!("row {row}, column {column}: {certificate:?}, {is_so}");
        if step == Step::Exact {
            assert!(margins[k] == 0.0 && is_so <= 2.0, "{about}");
        } else {
            // What is computed is within a bound of what is exact; an f32 has 24 bits.
            assert!((told - is_so).abs() <= 1.0 + 1e-5 * told, "{about}");
        }
    }
}

#[test]
fn what_cannot_be_drawn_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("s.toml"),
        "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 2, 0]\nup = [0, 1, 0]\n",
    )
    .unwrap();
    render(folder.path(), "s.toml -o out.png").failed(
        1,
        "s.toml:5:6: camera.up: up (0, 1, 0) is parallel to the view direction (0, 2, 0): turn one \
         of them",
    );
    render(folder.path(), "canonical -o out.png --aov out.png")
        .failed(2, "--aov and -o both write out.png");
    render(folder.path(), "canonical -o out.png --view world --aov out.exr")
        .failed(2, "--aov writes what the camera's rays meet: leave out --view world");
    render(folder.path(), "canonical -o no/out.png")
        .failed(1, "no/out.png: cannot be written: no such file or directory");
    assert_eq!(entries(folder.path()), ["s.toml"]);
}

#[test]
fn where_nothing_can_be_written_is_told_before_anything_is_read() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("dir")).unwrap();
    fs::write(folder.path().join("file"), "").unwrap();
    for (output, problem) in [
        ("no/out", "no such file or directory"),
        ("dir", "is a directory"),
        ("file/out", "not a directory"),
    ] {
        // The scene is not there either: were it looked for first, that would be the message.
        for line in [format!("-o {output}"), format!("-o out.png --aov {output}")] {
            render(folder.path(), &format!("no.toml {line}"))
                .failed(1, &format!("{output}: cannot be written: {problem}"));
        }
    }
    assert_eq!(entries(folder.path()), ["dir", "file"]);
}

#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_files() {
    use super::outputs::run_within;

    let folder = tempfile::tempdir().unwrap();
    for name in ["out.png", "out.exr"] {
        fs::write(folder.path().join(name), "old").unwrap();
    }
    let run = run_within("-f 1", folder.path(), "render planet -o out.png --aov out.exr");
    run.failed(
        1,
        "out.exr: cannot be written: the file may not become larger, by ulimit -f or on this disk",
    );
    for name in ["out.png", "out.exr"] {
        assert_eq!(fs::read_to_string(folder.path().join(name)).unwrap(), "old");
    }
    assert_eq!(entries(folder.path()), ["out.exr", "out.png"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_picture_takes_bounded_memory_or_there_is_too_little() {
    use super::outputs::run_within;

    let folder = tempfile::tempdir().unwrap();
    let run = |line| run_within("-v 450000", folder.path(), line);
    run("render planet -o out.png --aov out.exr --width 16384 --height 320").done();
    run("render planet -o no.png --width 16384 --height 16384 --overlay").failed(
        1,
        "planet: there is too little memory: a figure of 16384 x 16384 pixels takes 6443 MB",
    );
    assert_eq!(entries(folder.path()), ["out.exr", "out.png"]);
}

/// What the memory suffices for depends on the build and the machine.
#[cfg(target_os = "linux")]
#[test]
fn where_memory_is_short_there_is_a_picture_or_a_line_that_says_so() {
    use super::outputs::run_within;

    for limit in [240_000, 284_000, 292_000, 300_000, 308_000, 340_000] {
        let folder = tempfile::tempdir().unwrap();
        let line = "render planet -o out.png --aov out.exr --width 8000 --height 64";
        let run = run_within(&format!("-v {limit}"), folder.path(), line);
        if run.status == 0 {
            assert_eq!(entries(folder.path()), ["out.exr", "out.png"]);
        } else {
            let told = run.stderr.starts_with("error: out.png: cannot be written: there is too ");
            assert!(told && run.stderr.lines().count() == 1, "{limit}: {}", run.stderr);
            assert_eq!(entries(folder.path()), [""; 0]);
        }
    }
}

/// A tile's place in the file does not depend on which thread is done with it first.
#[test]
fn openexr_is_the_same_bytes_whatever_the_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let bytes = ["1", "4", "4", "7"].map(|threads| {
        let line = "render planet -o out.png --aov out.exr --width 700";
        let mut command = super::command_in(folder.path());
        let output = command.args(line.split(' ')).env("RAYON_NUM_THREADS", threads).output();
        super::finished(output.unwrap()).done();
        fs::read(folder.path().join("out.exr")).unwrap()
    });
    assert!(bytes.iter().all(|other| *other == bytes[0]));
}

/// Standard output by its name, which is a link to no file.
#[cfg(target_os = "linux")]
#[test]
fn a_pipe_is_written_to_by_its_name() {
    let mut command = super::command_in(&std::env::temp_dir());
    let output = command.args("render canonical -o /dev/stdout --width 8".split(' ')).output();
    let output = output.unwrap();
    assert_eq!((output.status.code(), &output.stderr[..]), (Some(0), &b""[..]));
    assert!(output.stdout.starts_with(b"\x89PNG\r\n"), "{:?}", output.stdout);
}

#[cfg(target_os = "linux")]
#[test]
fn a_device_is_written_to_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    render(folder.path(), "canonical -o /dev/null --width 8").done();
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
    render(folder.path(), "canonical -o /dev/full --width 8")
        .failed(1, "/dev/full: cannot be written: no space left on device");
}
