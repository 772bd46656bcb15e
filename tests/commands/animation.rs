//! `pinhole figure --play`

use std::fs;

use super::entries;
use super::figure::{decode, figure};
use crate::support::Gif;

#[test]
fn an_animation_begins_with_the_figure_and_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let line = "canonical --view camera --width 60 --uv 0.2,-0.1";
    figure(folder.path(), &format!("{line} -o still.png")).done();
    let (.., still, _) = decode(&folder.path().join("still.png"));
    let endless = gif::Repeat::Infinite;
    for (kind, repeats) in [
        ("swing-up", endless),
        ("orbit", endless),
        ("over-the-top", endless),
        ("walk", gif::Repeat::Finite(0)),
    ] {
        let more = format!("-o {kind}.gif --play {kind} --frames 4");
        assert_eq!(figure(folder.path(), &format!("{line} {more}")).done(), "");
        let gif = Gif::read(&folder.path().join(format!("{kind}.gif")));
        assert_eq!((gif.size, gif.frames.len(), gif.repeats), ([60, 60], 4, repeats), "{kind}");
        let still: Vec<[u8; 3]> = still.iter().map(|p| [p[0], p[1], p[2]]).collect();
        // A frame has 255 colours.
        assert!(Gif::difference(&gif.frames[0], &still) < 4.0 || kind == "walk", "{kind}");
        for (k, pair) in gif.frames.windows(2).enumerate() {
            // What walks along a ray is one point, seen from the eye: it stays in its pixel.
            assert!(pair[0] != pair[1] || kind == "walk", "{kind}: frames {k} and after are alike");
        }
    }
}

#[test]
fn a_ray_is_walked_and_pixels_are_scanned_in_the_world_view() {
    let folder = tempfile::tempdir().unwrap();
    for kind in ["walk", "scan"] {
        let line = format!("canonical --view world --width 200 -o {kind}.gif --play {kind}");
        figure(folder.path(), &format!("{line} --frames 3 --per-second 2")).done();
        let gif = Gif::read(&folder.path().join(format!("{kind}.gif")));
        assert_eq!(gif.delays, [50, 50, 50]);
        assert!(gif.frames[0] != gif.frames[1] && gif.frames[1] != gif.frames[2], "{kind}");
    }
}

#[test]
fn what_a_gif_cannot_hold_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let line = "canonical --view camera --width 60 --play orbit --frames 3";
    let ending = "-o writes animations as GIF: end the name with .gif";
    for name in ["other.png", "other", "-"] {
        figure(folder.path(), &format!("{line} -o {name}")).failed(2, ending);
    }
    figure(folder.path(), &format!("{line} --transparent -o a.gif")).refused("cannot be used with");
    figure(folder.path(), &format!("{line} --per-second 60 -o a.gif")).refused("1..=50");
    assert!(entries(folder.path()).is_empty());
}

#[test]
fn a_camera_that_cannot_be_moved_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 2, 0]\nup = [0, 1, 0]\n";
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    let run = figure(folder.path(), "s.toml --view world -o a.gif --play swing-up --frames 2");
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
    let line = "figure canonical --view world -o a.gif --play orbit --frames 3 --width 300";
    let output = std::process::Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_pinhole")])
        .args(line.split(' '))
        .current_dir(folder.path())
        .output();
    super::finished(output.unwrap()).failed(1, "a.gif: cannot be written: file too large");
    assert!(entries(folder.path()).is_empty());
}
