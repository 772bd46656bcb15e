//! The plot.

use pinhole::figures::{Figure, Format};
use pinhole::report::model::Report;
use pinhole::report::plot;

use super::sample;

/// All pages, one after the other.
fn svg_of(report: &Report) -> String {
    let page = |page: Figure| String::from_utf8(page.to_file(Format::Svg).unwrap()).unwrap();
    plot::pages(report, 1.0).into_iter().map(page).collect()
}

/// How often an element with this in it is there.
fn count(svg: &str, part: &str) -> usize {
    svg.lines().filter(|line| line.contains(part)).count()
}

#[test]
fn wrong_decisions_are_marked_and_counted_and_in_no_error() {
    let mut report = sample::report();
    report.cases.truncate(1);
    assert_eq!(count(&svg_of(&report), "<circle"), 0);
    report.cases[0].methods[2].wrong = 1234;
    let svg = svg_of(&report);
    // One around the mark, one in the table.
    assert_eq!(count(&svg, "<circle"), 2);
    assert_eq!(count(&svg, ">1,234</tspan></text>"), 1);
}

#[test]
fn a_family_has_a_curve_a_method() {
    let report = sample::report();
    let svg = svg_of(&report);
    assert_eq!(count(&svg, ">radius / distance</tspan></text>"), 1);
    let long_chains =
        svg.lines().filter(|line| line.starts_with("<polyline") && line.matches(',').count() >= 5);
    assert_eq!(long_chains.count(), 17);
    assert_eq!(count(&svg, ">tiny far sphere</tspan></text>"), 1);
    assert_eq!(count(&svg, ">6 settings, coverage 3.27 to 19.6 %</tspan></text>"), 1);
}

/// Of a formula, the marks of its precisions are joined: half-b has three of them.
#[test]
fn a_formula_is_a_curve_over_its_precisions() {
    let mut report = sample::report();
    report.cases.truncate(1);
    report.cases[0].methods.retain(|row| row.formula() == "half-b");
    let curves = |report: &Report| {
        let is_curve = |line: &&str| {
            line.starts_with("<polyline") && line.contains("#e69f00\" stroke-width=\"2\"")
        };
        let svg = svg_of(report);
        let lines: Vec<_> = svg.lines().filter(is_curve).map(|l| l.matches(',').count()).collect();
        lines.into_iter().max()
    };
    assert_eq!(curves(&report), Some(3));
    report.cases[0].methods.retain(|row| row.name != "double-double");
    assert_eq!(curves(&report), Some(2));
}

/// The front holds those that no other method beats in both, and none that decides wrong.
#[test]
fn the_pareto_front_is_of_methods_that_decide_all_right() {
    let mut report = sample::report();
    report.cases.truncate(1);
    let front = |report: &Report| {
        let svg = svg_of(report);
        let line = svg.lines().find(|line| line.contains("#f0e442"));
        line.map_or(0, |line| line.matches(',').count())
    };
    // ladder-f32 is the fastest, and textbook-f64 closer; lagrange-f64 is exact there.
    assert_eq!(front(&report), 3);
    report.cases[0].methods.iter_mut().for_each(|row| row.wrong = 1);
    assert_eq!(front(&report), 0);
}

#[test]
fn what_was_left_out_is_told_without_end() {
    let mut report = sample::report();
    report.left_out = (0..100).map(|k| format!("the rays of case {k}")).collect();
    let svg = svg_of(&report);
    assert!(svg.contains("Left out: the rays of case 0; the rays of case 1;"));
    assert!(svg.contains(" more, which the table lists</tspan></text>"));
    assert!(!svg.contains("case 99"));
}

#[test]
fn a_method_without_a_common_hit_has_a_place_of_its_own() {
    let mut report = sample::report();
    report.cases.truncate(1);
    assert_eq!(count(&svg_of(&report), ">no hit alike</tspan></text>"), 0);
    report.cases[0].methods[2].ulp_f64 = Default::default();
    assert_eq!(count(&svg_of(&report), ">no hit alike</tspan></text>"), 1);
}

#[test]
fn nothing_leaves_the_picture_whatever_the_numbers() {
    let mut report = sample::report();
    for (index, row) in report.cases.iter_mut().flat_map(|case| &mut case.methods).enumerate() {
        row.ulp_f64.max = [Some(f64::MAX), Some(5e-324), Some(0.0), None][index % 4];
        row.ulp_f64.p99 = [None, Some(0.0), Some(f64::MAX)][index % 3];
        row.ns_per_pixel.median = [Some(0.0), Some(1e9), None, Some(1e-3), Some(7.0)][index % 5];
    }
    for (index, case) in report.cases.iter_mut().enumerate().skip(1) {
        case.knob = [Some(0.0), Some(-1.0), Some(1e300), Some(5e-324)][index % 4];
    }
    report.cases.push(Default::default());
    let svg = svg_of(&report);
    assert!(!svg.contains("NaN") && !svg.contains("inf "));
    let (width, height) = (1280.0, 720.0);
    for line in svg.lines().filter(|line| line.starts_with("<poly")) {
        let points = line.split('"').nth(1).unwrap();
        for [x, y] in points.split(' ').map(|point| {
            let (x, y) = point.split_once(',').unwrap_or_else(|| panic!("{line}"));
            [x, y].map(|number| number.parse::<f64>().unwrap())
        }) {
            assert!((0.0..=width).contains(&x) && (0.0..=height).contains(&y), "{line}");
        }
    }
}

/// Both are drawn from one description, so a position that is dark in one is dark in the other; here
/// that the pixels are there at all, marks in their colours and text in dark.
#[test]
fn pixels_show_what_the_svg_says() {
    let pages = plot::pages(&sample::report(), plot::PNG_SCALE);
    // A summary, and both families.
    let [_, figure] = pages.as_slice() else { panic!("{} pages", pages.len()) };
    let pixels = figure.to_pixels();
    assert_eq!((figure.size(), pixels.len()), ([1920, 1080], 1920 * 1080));
    let count =
        |[r, g, b]: [u8; 3]| pixels.iter().filter(|p| p.to_array() == [r, g, b, 255]).count();
    assert!(count([0xff; 3]) > pixels.len() / 2);
    for ink in [[0, 0, 0], [0xb0, 0, 0x20], [0xd5, 0x5e, 0], [0, 0x72, 0xb2], [0x1a; 3]] {
        assert!(count(ink) > 200, "{ink:?}: {}", count(ink));
    }
}
