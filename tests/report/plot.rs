//! The plot.

use pinhole::report::model::Report;
use pinhole::report::plot;
use pinhole_figure::export::{Figure, FigureFormat};

use super::sample;

/// All pages, one after the other.
fn svg_of(report: &Report) -> String {
    let page = |page: Figure| String::from_utf8(page.to_file(FigureFormat::Svg).unwrap()).unwrap();
    plot::pages(report, 1.0).into_iter().map(page).collect()
}

/// The ring of a method that decided wrong.
const RING: &str = "stroke=\"#b00020\"";
const CONDITION: &str = "#a0a0a0";

/// How often an element with this in it is there.
fn count(svg: &str, part: &str) -> usize {
    svg.lines().filter(|line| line.contains(part)).count()
}

#[test]
fn wrong_decisions_are_marked_and_counted_and_in_no_error() {
    let mut report = sample::report();
    report.cases.truncate(1);
    assert_eq!(count(&svg_of(&report), RING), 0);
    report.cases[0].methods[2].wrong = 12_345;
    let svg = svg_of(&report);
    assert_eq!(count(&svg, RING), 1);
    assert_eq!(count(&svg, ">12,345</tspan></text>"), 1);
}

#[test]
fn a_family_has_a_curve_a_method() {
    let report = sample::report();
    let svg = svg_of(&report);
    assert_eq!(count(&svg, ">radius / distance (not to scale)</tspan></text>"), 1);
    let is_curve = |line: &&str| {
        let is_long = line.starts_with("<polyline") && line.matches(',').count() >= 5;
        is_long && !line.contains(CONDITION)
    };
    // Those in f32 are dashed.
    assert_eq!(svg.lines().filter(is_curve).count(), 9);
    // What the problem costs, whatever the method.
    assert_eq!(count(&svg, CONDITION), 1);
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

#[test]
fn an_error_as_large_as_t_is_in_a_lane_of_its_own() {
    let mut report = sample::report();
    report.cases.truncate(1);
    report.cases[0].methods.truncate(1);
    report.cases[0].methods[0].ulp_f64.max = Some(1e16);
    assert_eq!(count(&svg_of(&report), ">no digit right</tspan></text>"), 1);
}

#[test]
fn what_was_left_out_is_told_without_end() {
    let mut report = sample::report();
    report.left_out = (0..100).map(|k| format!("the rays of case {k}")).collect();
    let svg = svg_of(&report);
    assert!(svg.contains("Left out: 100 measurements, listed by the table</tspan></text>"));
}

#[test]
fn a_method_without_a_common_hit_has_a_place_of_its_own() {
    let mut report = sample::report();
    report.cases.truncate(1);
    assert_eq!(count(&svg_of(&report), ">no hit alike</tspan></text>"), 0);
    report.cases[0].methods[2].ulp_f64 = Default::default();
    report.cases[0].methods[2].wrong = 800;
    assert_eq!(count(&svg_of(&report), ">no hit alike</tspan></text>"), 1);
    // Right, but beyond the numbers of its precision.
    report.cases[0].methods[2].wrong = 0;
    report.cases[0].methods[2].t_out_of_range = 800;
    let svg = svg_of(&report);
    assert_eq!(count(&svg, ">no hit alike</tspan></text>"), 0);
    assert_eq!(count(&svg, ">out of range</tspan></text>"), 1);
}

/// One setting of many is enough, and the mark is there with its ring.
#[test]
fn a_method_that_is_lost_at_one_setting_is_drawn_there() {
    let mut report = sample::report();
    report.cases.remove(0);
    report.cases.iter_mut().for_each(|case| case.methods.retain(|row| row.name == "ladder"));
    assert_eq!(count(&svg_of(&report), ">no hit alike</tspan></text>"), 0);
    report.cases[2].methods[0].ulp_f64 = Default::default();
    report.cases[2].methods[0].wrong = 4096;
    let svg = svg_of(&report);
    assert_eq!(count(&svg, ">no hit alike</tspan></text>"), 1);
    // In both panels.
    assert_eq!(count(&svg, RING), 2);
}

/// Numbers that do not follow from each other are all there.
#[test]
fn settings_side_by_side_are_all_named_and_said_to_be_so() {
    let mut report = sample::report();
    report.cases.remove(0);
    let knobs = [-320.0, -300.0, -150.0, 0.0201, 300.0, 307.0];
    for (case, knob) in report.cases.iter_mut().zip(knobs) {
        case.knob = Some(knob);
    }
    let svg = svg_of(&report);
    for knob in knobs {
        assert_eq!(count(&svg, &format!(">{knob}</tspan></text>")), 1, "{knob}");
    }
    assert_eq!(count(&svg, ">radius / distance (not to scale)</tspan></text>"), 1);
}

#[test]
fn a_setting_with_nothing_to_hit_says_so() {
    let mut report = sample::report();
    report.cases.remove(0);
    report.cases[1].coverage = 0.0;
    for row in &mut report.cases[1].methods {
        row.ulp_f64 = Default::default();
        row.wrong = 0;
    }
    let svg = svg_of(&report);
    assert!(svg.contains(">all</tspan>") && svg.contains(">miss</tspan>"));
}

/// No mark hides another, and no ring seems to be around another's mark.
#[test]
fn marks_at_the_same_place_stand_side_by_side_each_with_its_ring() {
    let mut report = sample::report();
    report.cases.remove(0);
    for case in &mut report.cases {
        case.methods.retain(|row| ["ladder", "half-b-f64"].contains(&&*row.name));
        for row in &mut case.methods {
            row.ulp_f64.max = Some(0.5);
            row.wrong = u64::from(row.name != "ladder");
        }
    }
    let svg = svg_of(&report);
    let chains: Vec<&str> = svg
        .lines()
        .filter(|line| line.starts_with("<polyline") && line.matches(',').count() == 6)
        .collect();
    let start = |color: &str| {
        let line = chains.iter().find(|line| line.contains(color)).unwrap();
        line.split(['"', ',']).nth(1).unwrap().parse::<f64>().unwrap()
    };
    assert!((3.0..6.0).contains(&(start("#000000") - start("#e69f00")).abs()));
    let last = |part: &str| svg.rfind(part).unwrap();
    assert!(last(RING) < last("fill=\"#e69f00\""), "a ring is drawn with its mark");
    assert!(last(RING) < last("fill=\"#000000\""), "the ladder on top");
}

#[test]
fn a_scene_is_a_page() {
    let mut report = sample::report();
    report.cases.truncate(1);
    assert_eq!(plot::pages(&report, 1.0).len(), 1);
    assert_eq!(count(&svg_of(&report), ">nanoseconds a pixel</tspan></text>"), 1);
    // Several scenes: a summary, and a page each.
    report.cases.push(sample::report().cases.remove(0));
    report.cases[1].name = "look-at".to_owned();
    assert_eq!(plot::pages(&report, 1.0).len(), 3);
    assert_eq!(count(&svg_of(&report), ">mean share, 2 scenes</tspan></text>"), 1);
}

/// With planes alone there is no half-b to join.
#[test]
fn double_double_is_a_precision_of_the_textbook_where_there_are_planes_alone() {
    let mut report = sample::report();
    report.cases.truncate(1);
    report.cases[0]
        .methods
        .retain(|row| row.name == "double-double" || row.formula() == "textbook");
    let svg = svg_of(&report);
    assert_eq!((count(&svg, "#e69f00"), count(&svg, ">half-b</tspan></text>")), (0, 0));
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
    // A summary, the scene, and the family.
    let [_, _, figure] = pages.as_slice() else { panic!("{} pages", pages.len()) };
    let pixels = figure.to_pixels();
    assert_eq!((figure.size, pixels.len()), ([1920, 1080], 1920 * 1080));
    let count =
        |[r, g, b]: [u8; 3]| pixels.iter().filter(|p| p.to_array() == [r, g, b, 255]).count();
    assert!(count([0xff; 3]) > pixels.len() / 2);
    for ink in [[0, 0, 0], [0xb0, 0, 0x20], [0xd5, 0x5e, 0], [0, 0x72, 0xb2], [0x1a; 3]] {
        assert!(count(ink) > 200, "{ink:?}: {}", count(ink));
    }
}
