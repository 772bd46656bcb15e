//! The spheres of a scene of Mitsuba, and its squares and disks as planes.

use pinhole_core::{Plane, Sphere};
use roxmltree::{Document as Xml, Node};

use super::file::{File, cells, number};
use crate::FileError;
use crate::document::Item;
use crate::format::left_out::{LeftOut, readable};
use crate::format::text::byte_of_light;
use crate::images::color;

#[derive(Default)]
pub(super) struct Shapes {
    pub(super) spheres: Vec<Item<Sphere>>,
    pub(super) planes: Vec<Item<Plane>>,
    left: LeftOut,
    unpainted: usize,
}

pub(super) fn shapes<'x>(file: &File<'_, 'x>, xml: &'x Xml, notes: &mut Vec<String>) -> Shapes {
    let mut shapes = Shapes::default();
    // What stands in another shape, as in a shapegroup, stands nowhere by itself.
    let mut end = 0;
    let nodes = xml.descendants().filter(move |node| {
        let is_alone = node.has_tag_name("shape") && node.range().start >= end;
        if is_alone {
            end = node.range().end;
        }
        is_alone
    });
    let taken = nodes.map(|node| shapes.take(file, node));
    readable(taken, "shape", notes);
    let includes = xml.descendants().filter(|node| node.has_tag_name("include"));
    for _ in includes {
        shapes.left.add("include", "left out: what is in other files is not read");
    }
    shapes.left.tell(notes);
    if shapes.unpainted > 0 {
        notes.push(format!("{} of bsdf left out: a colour must be rgb", shapes.unpainted));
    }
    shapes
}

impl Shapes {
    fn take<'x>(&mut self, file: &File<'_, 'x>, shape: Node<'x, 'x>) -> Result<(), FileError> {
        let kind = file.attribute(shape, "type");
        match kind {
            "sphere" => self.sphere(file, shape)?,
            "rectangle" | "disk" => {
                let to_world = file.transform(file.named(shape, "to_world"))?;
                let (point, normal) = (to_world.at, to_world.x.cross(to_world.y));
                if normal.try_normalize().is_none() || !point.is_finite() {
                    let right = "it must have a normal, and finite numbers";
                    return Err(file.fault(shape, "shape", kind, right));
                }
                let color = self.color(file, shape);
                self.planes.push(Item { name: None, color, shape: Plane { point, normal } });
                self.left.add(kind, "taken as a plane, which has no end");
            }
            "shapegroup" | "merge" => {
                let said = "left out with its parts: Pinhole has whole spheres and planes";
                self.left.add(kind, said);
            }
            "instance" => {
                self.left.add(kind, "left out: an object must stand by itself");
            }
            other => self.left.add(other, "left out: Pinhole has spheres and planes"),
        }
        Ok(())
    }

    fn sphere<'x>(&mut self, file: &File<'_, 'x>, shape: Node<'x, 'x>) -> Result<(), FileError> {
        let to_world = file.transform(file.named(shape, "to_world"))?;
        let center = file.named(shape, "center").map(|node| file.point(node)).transpose()?;
        let center = center.unwrap_or_default();
        let radius = file.named(shape, "radius").map(|node| file.number(node)).transpose()?;
        let Some(scale) = to_world.scale() else {
            self.left.add("sphere", "left out: scaled to an ellipsoid");
            return Ok(());
        };
        // Before version 2 a scale moved the centre in some versions, and in others it did not.
        if file.is_old && center != Default::default() && (scale - 1.0).abs() > 1e-9 {
            let right = "with a scale in its transform it must be 0 0 0 before version 2";
            return Err(file.fault(shape, "center", &center.to_string(), right));
        }
        let center = to_world.point(center);
        let radius = radius.unwrap_or(1.0) * scale;
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(file.fault(
                shape,
                "radius",
                &radius.to_string(),
                "it must be finite and greater than 0",
            ));
        }
        if !center.is_finite() {
            return Err(file.fault(shape, "center", &center.to_string(), "it must be finite"));
        }
        let color = self.color(file, shape);
        self.spheres.push(Item { name: None, color, shape: Sphere { center, radius } });
        Ok(())
    }

    /// The first colour of a shape's own material, or of the one that it refers to.
    fn color<'x>(&mut self, file: &File<'_, 'x>, shape: Node<'x, 'x>) -> Option<[u8; 3]> {
        let mut is_said = false;
        for part in
            file.parts(shape).filter(|part| ["bsdf", "emitter"].contains(&part.tag_name().name()))
        {
            is_said |= part.has_tag_name("bsdf");
            // A material of more layers is not looked through further.
            let rgb = part.descendants().take(100).find(|node| node.has_tag_name("rgb"));
            let Some(rgb) = rgb else { continue };
            if let Some(color) = light(file.attribute(rgb, "value")) {
                return Some(color);
            }
        }
        self.unpainted += usize::from(is_said);
        None
    }
}

fn light(value: &str) -> Option<[u8; 3]> {
    if value.starts_with('#') {
        return color::parse(value);
    }
    let numbers: Vec<f64> = cells(value).map_while(number).collect();
    match numbers[..] {
        [grey] => Some([grey; 3].map(byte_of_light)),
        [r, g, b] => Some([r, g, b].map(byte_of_light)),
        _ => None,
    }
}
