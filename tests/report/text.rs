//! The table, JSON and CSV.

use expect_test::expect;
use pinhole::report::model::Report;
use pinhole::report::table;

use super::sample;

/// The report with a few methods of its first and its last case.
fn small() -> Report {
    let mut report = sample::report();
    report.cases.drain(1..6);
    for case in &mut report.cases {
        case.methods.retain(|row| ["ladder", "textbook-f32", "half-b-f64"].contains(&&*row.name));
    }
    report
}

#[test]
fn the_table_is_aligned_and_says_what_it_rests_on() {
    expect![[r#"
        reference  dashu-float, 420 bits
        cpu        Some processor, AVX2 and FMA there, one thread
        baseline   textbook-f32: both roots, the same loop over the same rays
        seed       7
        note       an f32 method rounds what it is given
        reading    wrong: hit or miss, which object is first, or another root of it (t less than half as far from that as from
                   the true one); errors are of all other rays, in t in ulps of f64, the spacing of f64 numbers there, of
                   which an ulp of f32 is 2^29, and the largest one in ulps of the method's own precision: from 2^53 ulps of
                   f64 on no digit of t is right; backward: the share of their sizes, in units of 2^-53, by which centre,
                   radius, origin and direction move to make that t exact; an error in ulps of f64 is, to first order, at most
                   the problem's condition times it; × base: the shortest rounds compared

        the 2 families that all methods have, together: share: the mean of their cases; largest errors in t in ulps of f64
        (none: no digit right, or no hit alike) and times in nanoseconds a pixel
                                             largest error in t           ns a pixel
        method        wrong    of   share  least  middle   most  least  middle  most
        ladder            0  8192     0 %    0.5     0.5    0.5   9.18    9.18  9.18
        textbook-f32    721  8192   8.8 %  1.1e9    none   none   3.51    3.51  3.51
        half-b-f64       18  8192  0.22 %      2  11,193  6.3e7   4.77    4.77  4.77

        canonical: 4096 decisions, coverage 19.6 %, condition of t: median 9.5, max 50
                                      error in t, ulps of f64  own ulps  backward      rad       ns a pixel
        method        wrong  share   median      p99      max       max       max   normal   min  quartiles  × base
        ladder            0    0 %        0      0.4      0.5       0.5      0.15  1.5e-16  9.18  9.69–11.2    2.62
        textbook-f32      0    0 %        0    8.6e8    1.1e9         2    19,500    6e-16  3.51   3.7–4.29       1
        half-b-f64        0    0 %        0      1.6        2         2    19,200    6e-16  4.77  5.03–5.83    1.36
        ladder decided 4096 in f32 or f64, 0 in double-double, 0 exactly; t: 800 in double-double, 0 exactly; in the 4096
        pixels timed

        tiny far sphere: A sphere that is tiny for its distance.
        tiny far sphere, radius / distance = 1e-12: 4096 decisions, coverage 3.27 %, condition of t: median 9.5, max 40.2
                                        error in t, ulps of f64  own ulps  backward      rad       ns a pixel
        method        wrong    share   median      p99      max       max       max   normal   min  quartiles  × base
        ladder            0      0 %      0.1      0.4      0.5       0.5      0.15  1.5e-16  9.18  9.69–11.2    2.62
        textbook-f32    721   17.6 %        -        -        -         -         -        -  3.51   3.7–4.29       1
        half-b-f64       18  0.439 %    1.3e7      5e7    6.3e7     6.3e7    19,200   1.9e-8  4.77  5.03–5.83    1.36
        ladder decided 4046 in f32 or f64, 45 in double-double, 5 exactly; t: 765 in double-double, 35 exactly; in the 4096
        pixels timed

        left out:
          planes: canonical has none
          rays from inside a sphere: the eye is outside
    "#]]
    .assert_eq(&table::to_table(&small()));
}

#[test]
fn the_table_fits_a_terminal() {
    let mut report = sample::report();
    report.cpu = "a processor with a name that goes on ".repeat(9);
    report.left_out.push("something with many reasons ".repeat(12));
    for row in report.cases.iter_mut().flat_map(|case| &mut case.methods) {
        row.ulp.max = Some(f64::MAX);
        row.ulp.p99 = Some(1.234_567e-300);
        row.normal_error_max = Some(5e-324);
        (row.wrong, row.decisions) = (1_234_567, 1_234_567_890);
    }
    let table = table::to_table(&report);
    let widest = table.lines().map(|line| line.chars().count()).max().unwrap();
    assert!((60..=120).contains(&widest), "{widest} columns:\n{table}");
}

#[test]
fn json_has_the_fields_of_the_contract_in_their_order() {
    let mut report = small();
    report.cases.truncate(1);
    report.cases[0].methods.truncate(2);
    expect![[r#"
        {
          "reference": "dashu-float, 420 bits",
          "cpu": "Some processor, AVX2 and FMA there, one thread",
          "cases": [
            {
              "name": "canonical",
              "knob": null,
              "coverage": 0.196,
              "methods": [
                {
                  "name": "ladder",
                  "wrong": 0,
                  "decisions": 4096,
                  "ulp": {
                    "median": 0.0,
                    "p99": 0.4,
                    "max": 0.5
                  },
                  "normal_error_max": 1.5e-16,
                  "ns_per_pixel": {
                    "median": 10.2,
                    "min": 9.18,
                    "lower_quartile": 9.69,
                    "upper_quartile": 11.22
                  },
                  "steps": {
                    "f64": 4096,
                    "double_double": 0,
                    "exact": 0
                  },
                  "ulp_f64": {
                    "median": 0.0,
                    "p99": 0.4,
                    "max": 0.5
                  },
                  "steps_of_t": {
                    "f64": 0,
                    "double_double": 800,
                    "exact": 0
                  },
                  "wrong_share": 0.0,
                  "backward_error_max": 0.15,
                  "t_out_of_range": 0,
                  "pixels_timed": 4096
                },
                {
                  "name": "textbook-f32",
                  "wrong": 0,
                  "decisions": 4096,
                  "ulp": {
                    "median": 0.0,
                    "p99": 1.6,
                    "max": 2.0
                  },
                  "normal_error_max": 6e-16,
                  "ns_per_pixel": {
                    "median": 3.9,
                    "min": 3.51,
                    "lower_quartile": 3.7049999999999996,
                    "upper_quartile": 4.29
                  },
                  "steps": null,
                  "ulp_f64": {
                    "median": 0.0,
                    "p99": 858993459.2,
                    "max": 1073741824.0
                  },
                  "steps_of_t": null,
                  "wrong_share": 0.0,
                  "backward_error_max": 19500.0,
                  "t_out_of_range": 0,
                  "pixels_timed": 4096
                }
              ],
              "knob_name": "",
              "condition": {
                "median": 9.5,
                "max": 50.0
              },
              "about": ""
            }
          ],
          "left_out": [
            "planes: canonical has none",
            "rays from inside a sphere: the eye is outside"
          ],
          "baseline": "textbook-f32: both roots, the same loop over the same rays",
          "notes": [
            "an f32 method rounds what it is given"
          ],
          "seed": 7
        }
    "#]]
    .assert_eq(&(serde_json::to_string_pretty(&report).unwrap() + "\n"));
}

#[test]
fn json_reads_back_to_the_same_numbers() {
    let mut report = sample::report();
    report.cases[0].coverage = 0.1 + 0.2;
    report.cases[1].methods[3].ulp.max = Some(5e-324);
    let json = serde_json::to_string_pretty(&report).unwrap();
    let read: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(read["cases"][0]["coverage"], report.cases[0].coverage);
    assert_eq!(read["cases"][1]["methods"][3]["ulp"]["max"], 5e-324);
}
