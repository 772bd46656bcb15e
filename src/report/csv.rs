//! The report as CSV: a row a case and method.

use super::model::{Case, MethodRow, Report};

/// The whole file. What does not exist is an empty cell; numbers read back to the same `f64`.
///
/// # Errors
/// Never fails: it writes to memory.
pub fn to_csv(report: &Report) -> csv::Result<Vec<u8>> {
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(cells(&Case::default(), &MethodRow::default()).map(|(name, _)| name))?;
    for case in &report.cases {
        for row in &case.methods {
            out.write_record(cells(case, row).map(|(_, cell)| cell))?;
        }
    }
    out.into_inner().map_err(|error| csv::Error::from(error.into_error()))
}

/// Returns the columns' names and the cells of a row.
fn cells(case: &Case, row: &MethodRow) -> [(&'static str, String); 32] {
    let number = |x: Option<f64>| x.map(|x| format!("{x:?}")).unwrap_or_default();
    let count = |n: Option<u64>| n.map(|n| n.to_string()).unwrap_or_default();
    let [condition, condition_f32] = [case.condition, case.condition_f32];
    [
        ("case", case.name.clone()),
        ("knob_name", case.knob_name.clone()),
        ("knob", number(case.knob)),
        ("coverage", number(Some(case.coverage))),
        ("method", row.name.clone()),
        ("wrong", row.wrong.to_string()),
        ("decisions", row.decisions.to_string()),
        ("ulp_median", number(row.ulp.median)),
        ("ulp_p99", number(row.ulp.p99)),
        ("ulp_max", number(row.ulp.max)),
        ("normal_error_max", number(row.normal_error_max)),
        ("ns_per_pixel_median", number(row.ns_per_pixel.median)),
        ("ns_per_pixel_min", number(row.ns_per_pixel.min)),
        ("steps_f64", count(row.steps.map(|steps| steps.f64))),
        ("steps_double_double", count(row.steps.map(|steps| steps.double_double))),
        ("steps_exact", count(row.steps.map(|steps| steps.exact))),
        ("ulp_f64_median", number(row.ulp_f64.median)),
        ("ulp_f64_p99", number(row.ulp_f64.p99)),
        ("ulp_f64_max", number(row.ulp_f64.max)),
        ("wrong_share", number(row.wrong_share)),
        ("backward_error_max", number(row.backward_error_max)),
        ("condition_median", number(condition.map(|condition| condition.median))),
        ("condition_max", number(condition.map(|condition| condition.max))),
        ("steps_of_t_double_double", count(row.steps_of_t.map(|steps| steps.double_double))),
        ("steps_of_t_exact", count(row.steps_of_t.map(|steps| steps.exact))),
        ("condition_f32_median", number(condition_f32.map(|condition| condition.median))),
        ("condition_f32_max", number(condition_f32.map(|condition| condition.max))),
        ("ns_per_pixel_lower_quartile", number(row.ns_per_pixel.lower_quartile)),
        ("ns_per_pixel_upper_quartile", number(row.ns_per_pixel.upper_quartile)),
        ("t_out_of_range", row.t_out_of_range.to_string()),
        ("pixels_timed", row.pixels_timed.to_string()),
        ("part_of", case.part_of.clone().unwrap_or_default()),
    ]
}
