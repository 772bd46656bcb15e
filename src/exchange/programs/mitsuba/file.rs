//! The values in a scene of Mitsuba: names, defaults, numbers and transforms.

use std::collections::HashMap;

use pinhole_core::DVec3;
use roxmltree::{Document as Xml, Node};

use crate::FileError;
use crate::error::one_line;
use crate::format::Input;
use crate::format::affine::Affine;

pub(super) struct File<'a, 'x> {
    text: &'a Input<'a>,
    /// Values of `$name`.
    defaults: HashMap<&'x str, &'x str>,
    /// Elements by their id.
    ids: HashMap<&'x str, Node<'x, 'x>>,
    /// Before version 2.
    pub(super) is_old: bool,
}

impl<'a, 'x> File<'a, 'x> {
    pub(super) fn new(text: &'a Input<'a>, xml: &'x Xml) -> File<'a, 'x> {
        let version = xml.root_element().attribute("version");
        let major = version.and_then(|version| version.split('.').next()?.trim().parse().ok());
        let is_old = major.is_none_or(|major: u32| major < 2);
        let mut file = File { text, defaults: HashMap::new(), ids: HashMap::new(), is_old };
        for node in xml.descendants().filter(Node::is_element) {
            if let (false, Some(id)) = (node.has_tag_name("ref"), node.attribute("id")) {
                file.ids.entry(id).or_insert(node);
            }
            if let (true, Some(name)) = (node.has_tag_name("default"), node.attribute("name")) {
                // A default may be one of those before it.
                let value = file.attribute(node, "value");
                file.defaults.entry(name).or_insert(value);
            }
        }
        file
    }

    /// The child of this name, which is `toWorld` for `to_world` in old files.
    pub(super) fn named(&self, node: Node<'x, 'x>, name: &str) -> Option<Node<'x, 'x>> {
        node.children().find(|child| child.attribute("name").is_some_and(|n| snake(n) == name))
    }

    /// The children, and in the places of `ref` what they refer to.
    pub(super) fn parts(&self, node: Node<'x, 'x>) -> impl Iterator<Item = Node<'x, 'x>> {
        node.children().filter_map(|child| match child.has_tag_name("ref") {
            true => self.ids.get(child.attribute("id")?).copied(),
            false => Some(child),
        })
    }

    /// An attribute, or the default whose `$name` it is; empty where there is none.
    pub(super) fn attribute(&self, node: Node<'x, 'x>, name: &str) -> &'x str {
        let value = node.attribute(name).unwrap_or_default();
        let default = value.strip_prefix('$').and_then(|name| self.defaults.get(name));
        default.copied().unwrap_or(value)
    }

    pub(super) fn missing(&self, problem: &str) -> FileError {
        FileError::of_file(self.text.path, problem)
    }

    pub(super) fn fault(&self, node: Node, field: &str, value: &str, right: &str) -> FileError {
        let problem = format!("{} is {}: {right}", one_line(field), one_line(value));
        self.text.error_at(node.range().start, problem)
    }

    fn quoted(&self, node: Node, attribute: &str, field: &str, right: &str) -> FileError {
        let value = node.attribute(attribute).unwrap_or_default();
        self.fault(node, field, &format!("{:?}", one_line(value)), right)
    }

    fn numbers(&self, node: Node<'x, 'x>, attribute: &str) -> Result<Vec<f64>, FileError> {
        let numbers: Option<Vec<f64>> =
            cells(self.attribute(node, attribute)).map(number).collect();
        numbers.ok_or_else(|| self.quoted(node, attribute, attribute, "it must be numbers"))
    }

    pub(super) fn number(&self, node: Node<'x, 'x>) -> Result<f64, FileError> {
        let name = node.attribute("name").unwrap_or("value");
        match self.numbers(node, "value")?[..] {
            [number] => Ok(number),
            _ => Err(self.quoted(node, "value", name, "it must be one number")),
        }
    }

    pub(super) fn vector(&self, node: Node<'x, 'x>, attribute: &str) -> Result<DVec3, FileError> {
        match self.numbers(node, attribute)?[..] {
            [x, y, z] => Ok(DVec3::new(x, y, z)),
            _ => Err(self.quoted(node, attribute, attribute, "it must be three numbers")),
        }
    }

    /// Reads a point by x, y and z, each 0 where it is left out, or by one value.
    pub(super) fn point(&self, node: Node<'x, 'x>) -> Result<DVec3, FileError> {
        if node.has_attribute("value") {
            return self.vector(node, "value");
        }
        let part = |name: &str| match node.attribute(name) {
            Some(_) => self.numbers(node, name).map(|n| n.first().copied().unwrap_or_default()),
            None => Ok(0.0),
        };
        Ok(DVec3::new(part("x")?, part("y")?, part("z")?))
    }

    pub(super) fn is_look_at(&self, step: Node) -> bool {
        ["lookat", "lookAt"].contains(&step.tag_name().name())
    }

    /// Steps of a transform, each after those above it.
    pub(super) fn transform(&self, node: Option<Node<'x, 'x>>) -> Result<Affine, FileError> {
        let Some(node) = node else { return Ok(Affine::IDENTITY) };
        let mut whole = Affine::IDENTITY;
        for step in node.children().filter(Node::is_element) {
            let one = match step.tag_name().name() {
                _ if self.is_look_at(step) => self.look_at(step)?,
                "translate" => Some(Affine::translation(self.point(step)?)),
                "scale" => Some(self.scaling(step)?),
                "rotate" => {
                    let angle = self.numbers(step, "angle")?.first().copied().unwrap_or_default();
                    Affine::rotation(angle, self.point(step)?)
                }
                "matrix" => {
                    let numbers = self.numbers(step, "value")?;
                    Some(numbers).filter(|n| n.len() == 16).and_then(|n| Affine::from_rows(&n))
                }
                _ => None,
            };
            let name = step.tag_name().name();
            let right =
                "it must be translate, scale, rotate, lookat, or an affine matrix of 16 numbers";
            let one = one.ok_or_else(|| self.fault(step, "to_world", name, right))?;
            whole = one.after(&whole);
        }
        Ok(whole)
    }

    fn scaling(&self, step: Node<'x, 'x>) -> Result<Affine, FileError> {
        let part = |name: &str| -> Result<f64, FileError> {
            Ok(self.numbers(step, name)?.first().copied().unwrap_or(1.0))
        };
        Ok(Affine::scaling(match self.numbers(step, "value")?[..] {
            [scale] => DVec3::splat(scale),
            [x, y, z] => DVec3::new(x, y, z),
            _ => DVec3::new(part("x")?, part("y")?, part("z")?),
        }))
    }

    fn look_at(&self, node: Node<'x, 'x>) -> Result<Option<Affine>, FileError> {
        let origin = self.vector(node, "origin")?;
        let ahead = (self.vector(node, "target")? - origin).try_normalize();
        let up = self.vector(node, "up")?;
        Ok(ahead.and_then(|z| {
            let x = up.cross(z).try_normalize()?;
            Some(Affine { x, y: z.cross(x), z, at: origin })
        }))
    }
}

/// `to_world` of `toWorld`.
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for c in name.chars() {
        if c.is_ascii_uppercase() {
            snake.push('_');
        }
        snake.push(c.to_ascii_lowercase());
    }
    snake
}

pub(super) fn cells(value: &str) -> impl Iterator<Item = &str> {
    value.split([' ', ',', '\t', '\n', '\r']).filter(|cell| !cell.is_empty())
}

/// A finite number.
pub(super) fn number(cell: &str) -> Option<f64> {
    cell.parse().ok().filter(|number: &f64| number.is_finite())
}
