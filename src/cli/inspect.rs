//! `pinhole inspect`: prints one ray, its camera, and everything that it hits.

use std::fmt::Write as _;

use pinhole_core::{DVec3, Orientation, Pixel, ResolvedCamera, UpAngle, shortest, triple};
use pinhole_exchange::document::Document;
use pinhole_figure::readings::{Reading, ReadingValue, of_basis};
use pinhole_figure::{Concept, Inspection};
use pinhole_lecture::numbers::grouped;
use serde_json::{Value, json};

use super::console::{CommandError, columns, scene_fault, to_json, to_stdout};
use super::load::{load, pose, selection_of};
use crate::cli::arguments::InspectArguments;

/// A ray with the numbers to print.
struct Readout<'a> {
    document: &'a Document,
    camera: ResolvedCamera,
    up_angle: UpAngle,
    inspection: Inspection,
}

pub(super) fn run(arguments: &InspectArguments) -> Result<(), CommandError> {
    let document = load(&arguments.scene)?;
    let at_fault = |error: &dyn std::fmt::Display| scene_fault(&arguments.scene, error);
    let camera = pose(&arguments.scene, &document)?;
    let up_angle = document.camera.up_angle().map_err(|e| at_fault(&e))?;
    let scene = document.scene().map_err(|e| at_fault(&e))?;
    let selection = selection_of(&arguments.scene, &camera, arguments.ray)?;
    let inspection = Inspection::new(&camera, &scene, selection.unwrap_or_default());
    let readout = Readout { document: &document, camera, up_angle, inspection };
    let text = if arguments.json { to_json(&readout.json())? } else { readout.to_text() };
    to_stdout(|out| out.write_all(text.as_bytes()))
}

impl Readout<'_> {
    fn to_text(&self) -> String {
        let mut text = String::new();
        let parts = [
            ("camera", self.camera_lines()),
            ("observer", self.observer_lines()),
            ("ray", self.ray_lines()),
            ("hits", self.hit_lines()),
        ];
        // A scene without an observer has no such part.
        for (title, lines) in parts.into_iter().filter(|(_, lines)| !lines.is_empty()) {
            text.push_str(title);
            text.push('\n');
            for line in lines {
                let _ = writeln!(text, "  {}", line.trim_end());
            }
        }
        text
    }

    fn camera_lines(&self) -> Vec<String> {
        let camera = &self.document.camera;
        let viewport = self.camera.viewport();
        let mut lines = vec![row("eye", triple(camera.eye))];
        let given = match camera.orientation {
            Orientation::At { at, up } => vec![("at", at), ("up", up)],
            Orientation::View { view, up } => vec![("view", view), ("up", up)],
            Orientation::Basis(_) => Vec::new(),
        };
        lines.extend(given.into_iter().map(|(name, vector)| row(name, triple(vector))));
        let has_up = camera.orientation.has_up();
        let readings = of_basis(&self.camera, has_up.then_some(self.up_angle));
        lines.extend(readings.iter().map(|reading| self.row_of(reading)));
        lines.push(row(
            "viewport",
            format!(
                "{} x {} at distance {}, field of view {:.2} x {:.2} degrees",
                shortest(viewport.width),
                shortest(viewport.height),
                shortest(viewport.distance),
                viewport.horizontal_fov().to_degrees(),
                viewport.vertical_fov().to_degrees()
            ),
        ));
        let image = self.camera.image();
        let [width, height] = [image.width(), image.height()].map(|n| grouped(n.into()));
        let size = format!("{width} x {height} pixels");
        lines.push(row("image", size));
        lines
    }

    fn observer_lines(&self) -> Vec<String> {
        let Some(observer) = self.document.observer else { return Vec::new() };
        let degrees = |x: f64| format!("{} degrees", shortest(x));
        vec![
            row("target", triple(observer.target)),
            row("azimuth", degrees(observer.azimuth)),
            row("elevation", degrees(observer.elevation)),
            row("distance", shortest(observer.distance)),
        ]
    }

    fn ray_lines(&self) -> Vec<String> {
        let mut readings = self.inspection.ray_readings(self.camera.image());
        readings.swap(0, 1);
        readings.iter().map(|reading| self.row_of(reading)).collect()
    }

    fn row_of(&self, reading: &Reading) -> String {
        let value = match &reading.value {
            ReadingValue::Number(x) if reading.concept == Some(Concept::Up) => {
                let roll = "(degrees of roll for each degree that up is tipped sideways)";
                format!("{} {roll}", shortest(*x))
            }
            ReadingValue::Number(x) => shortest(*x),
            ReadingValue::Uv(uv) => format!("({}, {})", shortest(uv.x), shortest(uv.y)),
            ReadingValue::Vector(v) => triple(*v),
            ReadingValue::Angle(angle) => format!("{} degrees", shortest(angle.angle.to_degrees())),
            ReadingValue::Pixel(..) => self.pixel_text(),
            ReadingValue::Text(text) => text.clone(),
        };
        row(reading.long_name, value)
    }

    fn pixel_text(&self) -> String {
        let Some(position) = self.inspection.image_position else {
            return "none: outside the viewport".to_owned();
        };
        if let Some(Pixel { row, column }) = position.only_pixel() {
            return format!("row {row}, column {column} (counted from 0)");
        }
        let what = match (position.column_edge, position.row_edge) {
            (Some(_), Some(_)) => "the corner of",
            _ => "on the edge of",
        };
        let pixels = position.touching(self.camera.image());
        let names: Vec<String> = pixels.iter().map(|p| format!("{},{}", p.row, p.column)).collect();
        format!("none: {what} row,column {}", names.join("  "))
    }

    fn hit_lines(&self) -> Vec<String> {
        let roots = &self.inspection.roots;
        let mut table = vec![["object", "t", "distance", "point", "normal"].map(str::to_owned)];
        table.extend(roots.iter().zip(&self.inspection.distances).map(|(root, distance)| {
            [
                self.object_text(root.object),
                number_text(root.t),
                number_text(*distance),
                format!("({})", root.point.to_array().map(number_text).join(", ")),
                triple(root.normal),
            ]
        }));
        let mut lines = if roots.is_empty() { Vec::new() } else { columns(&table) };
        lines.push(match self.inspection.first_hit() {
            Some(first) => format!(
                "first: {} at t = {}, the smallest t above 0{}",
                self.object_text(first.object),
                number_text(first.t),
                self.inspection.why_first().map(|why| format!(" ({why})")).unwrap_or_default()
            ),
            None if roots.is_empty() => "first: none, the ray's line meets nothing".to_owned(),
            None => "first: none, no t is above 0".to_owned(),
        });
        lines
    }

    fn object_text(&self, object: u32) -> String {
        let kind = self.document.kind_of(object as usize);
        match self.document.name_of(object) {
            Some(name) => format!("{kind} {object} {name:?}"),
            None => format!("{kind} {object}"),
        }
    }
}

/// Returns a number as text. The largest `f64` may stand for a number beyond the range of `f64`, and the
/// text says so.
fn number_text(x: f64) -> String {
    match x {
        f64::MAX.. => "beyond f64".to_owned(),
        ..=f64::MIN => "-beyond f64".to_owned(),
        _ => shortest(x),
    }
}

fn row(name: &str, value: impl std::fmt::Display) -> String {
    format!("{name:22}{value}")
}

impl Readout<'_> {
    /// Returns the JSON output. Numbers read back to the same `f64`. A number beyond the range of `f64`, such as
    /// the distance between two points at opposite ends of the range, is `null`, because JSON has no infinity.
    /// The conditioning (degrees of roll for each degree that up is tipped sideways) is never `null`, because
    /// the core caps it at the largest `f64`.
    fn json(&self) -> Value {
        let Readout { document, camera, up_angle, inspection } = self;
        let basis = camera.basis();
        let hits = inspection.roots.iter().zip(&inspection.distances).map(|(root, distance)| {
            json!({
                "object": document.kind_of(root.object as usize),
                "index": root.object,
                "name": document.name_of(root.object),
                "t": root.t,
                "distance": distance,
                "point": plain(root.point),
                "normal": plain(root.normal),
            })
        });
        let mut json = json!({
            "camera": {
                "eye": plain(camera.eye()),
                "u": plain(basis.u),
                "v": plain(basis.v),
                "w": plain(basis.w),
                "up_view_angle_deg": up_angle.angle.to_degrees(),
                "conditioning": up_angle.conditioning,
            },
            "observer": document.observer,
            "pixel": inspection.pixel(),
            "uv": inspection.uv,
            "ray": {
                "origin": plain(inspection.ray.origin),
                "direction": plain(inspection.ray.direction),
            },
            "hits": hits.collect::<Vec<_>>(),
            "first": inspection.first,
        });
        if let (Value::Object(fields), None) = (&mut json, document.observer) {
            fields.shift_remove("observer");
        }
        json
    }
}

/// Replaces every negative zero in the vector by zero, because readers do not expect a negative zero.
fn plain(v: DVec3) -> DVec3 {
    v + DVec3::ZERO
}
