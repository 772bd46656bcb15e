//! The forms of a bench: table and plot.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

use pinhole::bench::model::{Bench, Row, Times};
use pinhole::bench::{plot, table};
use pinhole_core::ImageSize;

/// Method, and its median time in scenes of 1, 1000 and 10^6 spheres.
const TIMES: [(&str, [Option<f64>; 3]); 5] = [
    ("ladder", [Some(0.25), Some(1.0), Some(9.0)]),
    ("uncertified", [Some(0.24), Some(0.9), Some(8.1)]),
    ("textbook", [Some(23.0), None, None]),
    ("textbook-bvh", [None, Some(340.0), Some(3500.0)]),
    ("stores", [Some(0.2), Some(0.2), Some(0.2)]),
];

fn bench() -> Bench {
    let scenes = [("N=1", 1), ("N=1000", 1000), ("N=1e6", 1_000_000)];
    let rows = scenes.iter().enumerate().flat_map(|(place, (scene, objects))| {
        TIMES.iter().filter_map(move |(method, times)| {
            let median = times[place]?;
            Some(Row {
                scene: (*scene).to_owned(),
                method: (*method).to_owned(),
                ms: Times { median, min: 0.9 * median },
                mrays_per_s: 2073.6 / median,
                objects: *objects,
                image: Some(ImageSize::new(1920, 1080).unwrap()),
            })
        })
    });
    Bench {
        cpu: "Some processor, AVX2 and FMA there".to_owned(),
        threads: 2,
        rows: rows.collect(),
        left_out: vec!["textbook (asks all spheres): N=1000, N=1e6".to_owned()],
    }
}

#[test]
fn ratios_are_to_the_ladder_and_the_stores_of_the_same_scene() {
    let table = table::to_table(&bench());
    let row_of = |parts: [&str; 2]| -> Vec<String> {
        let mut lines = table.lines().skip_while(|line| !line.starts_with(parts[0]));
        let line = lines.find(|line| line.contains(&format!(" {} ", parts[1])));
        let cells = line.unwrap().split_whitespace().filter(|cell| *cell != parts[0]);
        cells.map(str::to_owned).collect()
    };
    assert_eq!(row_of(["N=1", "textbook"]), ["textbook", "23", "20.7", "90.2", "92", "115"]);
    assert_eq!(row_of(["N=1000", "textbook-bvh"])[4..], ["340", "1700"]);
    assert_eq!(row_of(["N=1e6", "ladder"])[4..], ["1", "45"]);
    assert!(table.ends_with("\nleft out:\n  textbook (asks all spheres): N=1000, N=1e6\n"));
}

#[test]
fn long_names_and_missing_methods_fit_in() {
    let mut bench = bench();
    bench.rows.retain(|row| row.method == "textbook");
    bench.rows[0].scene = "a/very/long/path/to/some/scene/file.toml".to_owned();
    let table = table::to_table(&bench);
    assert!(table.contains("\n…ome/scene/file.toml  textbook "), "{table}");
    assert!(table.contains("  -         -\n"), "{table}");
    assert!(table.lines().all(|line| line.chars().count() <= 80), "{table}");
}

fn chains(svg: &str) -> Vec<usize> {
    let lines =
        svg.lines().filter(|line| line.starts_with("<polyline") && line.contains("\"2.5\""));
    lines.map(|line| line.matches(',').count()).collect()
}

#[test]
fn a_line_a_method_through_its_scenes() {
    let svg = plot::figure(&bench()).to_svg();
    // stores, textbook-bvh, uncertified, ladder; then five in the list of names.
    assert_eq!(chains(&svg), [3, 2, 3, 3, 2, 2, 2, 2, 2]);
    for (method, _) in TIMES {
        assert!(svg.contains(&format!(">{method}</text>")), "{method}");
    }
    for text in [
        "takes 92 times the ladder",
        "takes 340 to 389 times the ladder",
        "ladder takes 1.25 to 45 times that",
        "10⁶",
        "1920 x 1080",
        "Left out: textbook",
    ] {
        assert!(svg.contains(text), "no {text} in {svg}");
    }
}

#[test]
fn nothing_leaves_the_picture_whatever_the_numbers() {
    let mut bench = bench();
    for (index, row) in bench.rows.iter_mut().enumerate() {
        row.ms.median = [0.0, 1e300, 5e-324, 7.0][index % 4];
        row.objects = [0, 1, usize::MAX][index % 3];
    }
    for bench in [bench, Bench::default()] {
        let svg = plot::figure(&bench).to_svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        for points in svg.split("points=\"").skip(1) {
            for point in points.split('"').next().unwrap().split(' ') {
                let (x, y) = point.split_once(',').unwrap();
                let [x, y]: [f64; 2] = [x, y].map(|number| number.parse().unwrap());
                assert!((0.0..=1280.0).contains(&x) && (0.0..=1000.0).contains(&y), "{point}");
            }
        }
    }
}
