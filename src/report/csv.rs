//! The report as CSV: a row a case and method.

use super::model::Report;

/// The first line.
const HEADER: [&str; 16] = [
    "case",
    "knob_name",
    "knob",
    "coverage",
    "method",
    "wrong",
    "decisions",
    "ulp_median",
    "ulp_p99",
    "ulp_max",
    "normal_error_max",
    "ns_per_pixel_median",
    "ns_per_pixel_min",
    "steps_f64",
    "steps_double_double",
    "steps_exact",
];

/// The whole file. What does not exist is an empty cell; numbers read back to the same `f64`.
///
/// # Errors
/// None: what is written goes to memory.
pub fn to_csv(report: &Report) -> csv::Result<Vec<u8>> {
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(HEADER)?;
    let number = |x: Option<f64>| x.map(|x| format!("{x:?}")).unwrap_or_default();
    let count = |n: Option<u64>| n.map(|n| n.to_string()).unwrap_or_default();
    for case in &report.cases {
        for row in &case.methods {
            out.write_record([
                case.name.clone(),
                case.knob_name.clone(),
                number(case.knob),
                number(Some(case.coverage)),
                row.name.clone(),
                row.wrong.to_string(),
                row.decisions.to_string(),
                number(row.ulp.median),
                number(row.ulp.p99),
                number(row.ulp.max),
                number(row.normal_error_max),
                number(row.ns_per_pixel.median),
                number(row.ns_per_pixel.min),
                count(row.steps.map(|steps| steps.f64)),
                count(row.steps.map(|steps| steps.double_double)),
                count(row.steps.map(|steps| steps.exact)),
            ])?;
        }
    }
    out.into_inner().map_err(|error| csv::Error::from(error.into_error()))
}
