//! `pinhole figure --play`

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use super::entries;
use super::figure::{decode, figure};

/// Each frame's bytes, and how often they are shown: 0 is for ever.
fn frames(path: &Path) -> (Vec<Vec<u8>>, u32) {
    let decoder = png::Decoder::new(BufReader::new(File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let control = *reader.info().animation_control().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let frames = (0..control.num_frames).map(|_| {
        reader.next_frame(&mut bytes).unwrap();
        bytes.clone()
    });
    (frames.collect(), control.num_plays)
}

#[test]
fn an_animation_begins_with_the_figure_and_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let line = "canonical --view camera --width 120 --uv 0.2,-0.1";
    figure(folder.path(), &format!("{line} -o still.png")).done();
    let (.., still, _) = decode(&folder.path().join("still.png"));
    let still: Vec<u8> = still.iter().flat_map(|pixel| pixel[..3].to_vec()).collect();
    for (kind, plays) in [("swing-up", 0), ("orbit", 0), ("over-the-top", 0), ("walk", 1)] {
        let more = format!("-o {kind}.png --play {kind} --frames 4");
        assert_eq!(figure(folder.path(), &format!("{line} {more}")).done(), "");
        let (frames, repeats) = frames(&folder.path().join(format!("{kind}.png")));
        assert_eq!((frames.len(), repeats), (4, plays), "{kind}");
        assert!(frames[0] == still || kind == "walk", "{kind} begins elsewhere");
        for (k, pair) in frames.windows(2).enumerate() {
            // What walks along a ray is one point, seen from the eye: it stays in its pixel.
            assert!(pair[0] != pair[1] || kind == "walk", "{kind}: frames {k} and after are alike");
        }
    }
}

#[test]
fn a_ray_is_walked_and_pixels_are_scanned_in_the_world_view() {
    let folder = tempfile::tempdir().unwrap();
    for kind in ["walk", "scan"] {
        let line = format!("canonical --view world --width 200 -o {kind}.png --play {kind}");
        figure(folder.path(), &format!("{line} --frames 3 --per-second 2")).done();
        let (frames, _) = frames(&folder.path().join(format!("{kind}.png")));
        assert_eq!(frames.len(), 3);
        assert!(frames[0] != frames[1] && frames[1] != frames[2], "{kind}");
    }
}

#[test]
fn a_gif_has_the_frames_for_slide_programs() {
    let folder = tempfile::tempdir().unwrap();
    let line = "canonical --view camera --width 60 --play orbit --frames 3";
    figure(folder.path(), &format!("{line} --per-second 25 -o turn.gif")).done();
    let options = gif::DecodeOptions::new();
    let file = File::open(folder.path().join("turn.gif")).unwrap();
    let mut decoder = options.read_info(BufReader::new(file)).unwrap();
    assert_eq!((decoder.width(), decoder.height()), (60, 60));
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
    let mut delays = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        delays.push(frame.delay);
    }
    assert_eq!(delays, [4, 4, 4]);
    for (more, problem) in [
        ("--numbered", "-o writes numbered pictures as PNG: end the name with .png"),
        (
            "--transparent",
            "-o writes what is transparent as PNG, as GIF has no half-transparent dots: end the name \
             with .png",
        ),
        ("--per-second 60", "-o writes at most 50 frames a second as GIF"),
    ] {
        figure(folder.path(), &format!("{line} {more} -o other.gif")).failed(2, problem);
    }
    assert_eq!(entries(folder.path()), ["turn.gif"]);
}

#[test]
fn numbered_ones_are_files_of_their_own_and_written_once() {
    let folder = tempfile::tempdir().unwrap();
    let line = "canonical --view world --width 90 -o turn.png --play orbit --frames 2 --numbered";
    figure(folder.path(), line).done();
    assert_eq!(entries(folder.path()), ["turn-0001.png", "turn-0002.png"]);
    let first = fs::read(folder.path().join("turn-0001.png")).unwrap();
    figure(folder.path(), line).failed(1, "turn-0001.png exists: choose another name");
    assert_eq!(fs::read(folder.path().join("turn-0001.png")).unwrap(), first);
}

#[test]
fn a_camera_that_cannot_be_moved_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 2, 0]\nup = [0, 1, 0]\n";
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    let run = figure(folder.path(), "s.toml --view world -o a.png --play swing-up --frames 2");
    run.failed(
        1,
        "s.toml:5:6: camera.up: up (0, 1, 0) is parallel to the view direction (0, 2, 0): turn one of \
         them",
    );
    assert_eq!(entries(folder.path()), ["s.toml"]);
}

/// The disk is at fault, not the scene.
#[cfg(unix)]
#[test]
fn a_full_disk_is_told_by_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let script = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
    for more in ["", " --numbered"] {
        let line = format!(
            "figure canonical --view world -o a.png --play orbit --frames 3 --width 300{more}"
        );
        let output = std::process::Command::new("sh")
            .args(["-c", script, env!("CARGO_BIN_EXE_pinhole")])
            .args(line.split(' '))
            .current_dir(folder.path())
            .output();
        super::finished(output.unwrap()).failed(1, "a.png: cannot be written: file too large");
        assert!(entries(folder.path()).is_empty());
    }
}
