//! The bench as text, in aligned columns, for a terminal of 80 columns.

use super::model::{Bench, Row};
use crate::model::number::short;
use crate::report::columns::{aligned, widths, wrapped};

/// As wide as text may be.
const WIDTH: usize = 80;

/// As wide as a scene's name may be; what is longer loses its beginning.
const NAME: usize = 20;

const COLUMNS: [&str; 7] =
    ["scene", "method", "median ms", "min ms", "Mrays/s", "× ladder", "× stores"];

/// The whole bench.
pub fn to_table(bench: &Bench) -> String {
    let mut out = String::new();
    wrapped(&mut out, WIDTH, "cpu      ", &bench.cpu);
    wrapped(&mut out, WIDTH, "threads  ", &bench.threads.to_string());
    wrapped(&mut out, WIDTH, "images   ", &images(bench));
    wrapped(&mut out, WIDTH, "times    ", ABOUT);
    out.push('\n');
    let mut rows = vec![COLUMNS.map(str::to_owned)];
    let mut last = "";
    for row in &bench.rows {
        let name = if row.scene == last { "" } else { &row.scene };
        rows.push(cells(bench, row, &cut(name)));
        last = &row.scene;
    }
    // The second column stands to the left too, as it holds names.
    let width = widths(&rows)[1];
    rows.iter_mut().for_each(|row| row[1] = format!("{:<width$}", row[1]));
    let all = widths(&rows);
    aligned(&mut out, &rows, all);
    if !bench.left_out.is_empty() {
        out.push_str("\nleft out:\n");
        for line in &bench.left_out {
            wrapped(&mut out, WIDTH, "  ", line);
        }
    }
    out
}

const ABOUT: &str = "a frame, from the camera to t as f32 and the object of every pixel, the camera \
                     moved every frame; × ladder, × stores: times as long as the ladder, and as only \
                     storing the same numbers";

/// Every size of image that was traced.
fn images(bench: &Bench) -> String {
    let mut sizes: Vec<String> = Vec::new();
    for image in bench.rows.iter().filter_map(|row| row.image) {
        let size = format!("{} x {}", image.width(), image.height());
        if !sizes.contains(&size) {
            sizes.push(size);
        }
    }
    sizes.join(", ")
}

/// The end of a long name.
fn cut(name: &str) -> String {
    let length = name.chars().count();
    if length <= NAME {
        return name.to_owned();
    }
    let end = name.chars().skip(length - NAME + 1);
    std::iter::once('…').chain(end).collect()
}

fn cells(bench: &Bench, row: &Row, name: &str) -> [String; COLUMNS.len()] {
    let ratio = |method: &str| {
        let base = bench.median(&row.scene, method);
        base.map_or("-".to_owned(), |base| short(row.ms.median / base))
    };
    [
        name.to_owned(),
        row.method.clone(),
        short(row.ms.median),
        short(row.ms.min),
        short(row.mrays_per_s),
        ratio("ladder"),
        ratio("stores"),
    ]
}
