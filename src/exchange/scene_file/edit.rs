//! Changing the values of a scene file's text and nothing else of it.

use std::path::Path;

use pinhole_core::{Basis, Camera, DVec3, Orientation, Viewport};
use toml_edit::{ArrayOfTables, DocumentMut, Item as TomlItem, Table, TableLike, Value};

use super::{note, read, write};
use crate::document::{Document, Item};
use crate::images::color;

/// The previous text with the document's values; `None` where it is no scene file.
pub(super) fn edited(document: &Document, previous: &str) -> Option<String> {
    let previous = previous.trim_start_matches('\u{feff}');
    let old = read::document(previous, Path::new(""), None).ok()?;
    let (block, rest) = note::split(previous);
    let mut toml: DocumentMut = rest.parse().ok()?;
    let root = toml.as_table_mut();
    let csv_path = |document: &Document| document.csv_spheres.as_ref().map(|csv| csv.path.clone());
    set_text(root, "spheres", csv_path(&old), csv_path(document))?;
    edit_camera(root, &old.camera, &document.camera)?;
    let spheres = Objects {
        key: "sphere",
        fields: write::sphere_fields,
        edit: |table, old, new| {
            set_vector(table, "center", old.center, new.center)?;
            set_number(table, "radius", old.radius, new.radius)
        },
    };
    spheres.edit(root, &old.spheres, &document.spheres)?;
    let planes = Objects {
        key: "plane",
        fields: write::plane_fields,
        edit: |table, old, new| {
            set_vector(table, "point", old.point, new.point)?;
            set_vector(table, "normal", old.normal, new.normal)
        },
    };
    planes.edit(root, &old.planes, &document.planes)?;
    let rest = toml.to_string();
    let text = if old.note == document.note {
        format!("{block}{rest}")
    } else {
        format!("{}{rest}", note::to_block(&document.note))
    };
    Some(if previous.contains("\r\n") { with_carriage_returns(&text) } else { text })
}

fn with_carriage_returns(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\n', "\r\n")
}

fn edit_camera(root: &mut Table, old: &Camera, new: &Camera) -> Option<()> {
    let table = root.get_mut("camera")?.as_table_like_mut()?;
    set_vector(table, "eye", old.eye, new.eye)?;
    edit_orientation(table, &old.orientation, &new.orientation)?;
    let (a, b) = (&old.viewport, &new.viewport);
    let measures = [
        ("width", a.width, b.width),
        ("height", a.height, b.height),
        ("distance", a.distance, b.distance),
    ];
    if let Some(table) = optional_table(root, "viewport", *b != Viewport::CANONICAL) {
        for (key, old, new) in measures {
            set_number(table, key, old, new)?;
        }
    }
    let (a, b) = (old.image, new.image);
    if let Some(table) = optional_table(root, "image", b != Camera::CANONICAL.image) {
        for (key, old, new) in [("width", a.width(), b.width()), ("height", a.height(), b.height())]
        {
            if old != new {
                set(table, key, i64::from(new).into());
            }
        }
    }
    Some(())
}

/// A table of the file, which is added behind the camera's if it is wanted and not there.
fn optional_table<'a>(
    root: &'a mut Table,
    key: &str,
    wanted: bool,
) -> Option<&'a mut dyn TableLike> {
    if wanted && !root.contains_key(key) {
        let mut table = Table::new();
        table.set_position(root.get("camera")?.as_table().and_then(Table::position));
        root.insert(key, TomlItem::Table(table));
    }
    root.get_mut(key)?.as_table_like_mut()
}

fn edit_orientation(table: &mut dyn TableLike, old: &Orientation, new: &Orientation) -> Option<()> {
    if std::mem::discriminant(old) == std::mem::discriminant(new) {
        let table = match new {
            Orientation::Basis(_) => table.get_mut("basis")?.as_table_like_mut()?,
            _ => table,
        };
        let mut pairs = vectors(old).into_iter().zip(vectors(new));
        return pairs.try_for_each(|((key, old), (_, new))| set_vector(table, key, old, new));
    }
    for key in ["at", "view", "basis", "up"] {
        table.remove(key);
    }
    if let Orientation::Basis(basis) = new {
        set(table, "basis", write::basis_table(basis).parse().ok()?);
        return Some(());
    }
    for (key, value) in vectors(new) {
        set(table, key, vector(value)?);
    }
    Some(())
}

/// The vectors that an orientation is given by, in the order of the file.
fn vectors(orientation: &Orientation) -> Vec<(&'static str, DVec3)> {
    match *orientation {
        Orientation::At { at, up } => vec![("at", at), ("up", up)],
        Orientation::View { view, up } => vec![("view", view), ("up", up)],
        Orientation::Basis(Basis { u, v, w }) => vec![("u", u), ("v", v), ("w", w)],
    }
}

/// Functions that write and edit a list of objects.
struct Objects<S> {
    key: &'static str,
    fields: fn(&Item<S>) -> String,
    edit: fn(&mut dyn TableLike, &S, &S) -> Option<()>,
}

impl<S> Objects<S> {
    /// Objects that are the same at both ends of the list keep their tables; between them, one
    /// after the other is edited, and what is too many or too few is taken out or put in.
    fn edit(&self, root: &mut Table, old: &[Item<S>], new: &[Item<S>]) -> Option<()> {
        let same = |(a, b): &(&Item<S>, &Item<S>)| (self.fields)(a) == (self.fields)(b);
        let head = old.iter().zip(new).take_while(same).count();
        if head == old.len() && head == new.len() {
            return Some(());
        }
        let (old, new) = (&old[head..], &new[head..]);
        let tail = old.iter().rev().zip(new.iter().rev()).take_while(same).count();
        let (old, new) = (&old[..old.len() - tail], &new[..new.len() - tail]);
        let tables = self.tables(root)?;
        for (k, (old, new)) in old.iter().zip(new).enumerate() {
            self.edit_item(tables.get_mut(head + k)?, old, new)?;
        }
        for _ in new.len()..old.len() {
            tables.remove(head + new.len());
        }
        for (k, item) in new.iter().enumerate().skip(old.len()) {
            let mut table = (self.fields)(item).parse::<DocumentMut>().ok()?.into_table();
            table.set_position(position_at(tables, head + k));
            tables.insert(head + k, table);
        }
        if tables.is_empty() {
            root.remove(self.key);
        }
        Some(())
    }

    /// The list's tables, from whichever form they have in the file.
    fn tables<'a>(&self, root: &'a mut Table) -> Option<&'a mut ArrayOfTables> {
        if !root.contains_array_of_tables(self.key) {
            let tables = match root.remove(self.key) {
                None => ArrayOfTables::new(),
                Some(item) => item.into_array_of_tables().ok()?,
            };
            root.insert(self.key, TomlItem::ArrayOfTables(tables));
        }
        root.get_mut(self.key)?.as_array_of_tables_mut()
    }

    fn edit_item(&self, table: &mut Table, old: &Item<S>, new: &Item<S>) -> Option<()> {
        set_text(table, "name", old.name.clone(), new.name.clone())?;
        (self.edit)(table, &old.shape, &new.shape)?;
        set_text(table, "color", old.color.map(color::to_text), new.color.map(color::to_text))
    }
}

/// Returns the place in the file of a table that is put into a list: behind the one before it, or before the
/// first one.
fn position_at(tables: &ArrayOfTables, index: usize) -> Option<isize> {
    tables.get(index.saturating_sub(1)).and_then(Table::position)
}

fn set_number(table: &mut dyn TableLike, key: &str, old: f64, new: f64) -> Option<()> {
    if old.to_bits() != new.to_bits() {
        set(table, key, number(new)?);
    }
    Some(())
}

fn set_vector(table: &mut dyn TableLike, key: &str, old: DVec3, new: DVec3) -> Option<()> {
    let array = table.get_mut(key)?.as_array_mut()?;
    for (k, (old, new)) in old.to_array().into_iter().zip(new.to_array()).enumerate() {
        if old.to_bits() != new.to_bits() {
            array.replace(k, number(new)?);
        }
    }
    Some(())
}

fn set_text(
    table: &mut dyn TableLike,
    key: &str,
    old: Option<String>,
    new: Option<String>,
) -> Option<()> {
    if old != new {
        match new {
            None => drop(table.remove(key)),
            Some(text) => set(table, key, write::string(&text).parse().ok()?),
        }
    }
    Some(())
}

/// Gives a field a value, with the blanks and the comment of the old one.
fn set(table: &mut dyn TableLike, key: &str, mut value: Value) {
    match table.get_mut(key).and_then(TomlItem::as_value_mut) {
        Some(old) => {
            *value.decor_mut() = old.decor().clone();
            *old = value;
        }
        None => {
            table.insert(key, TomlItem::Value(value));
        }
    }
}

fn number(x: f64) -> Option<Value> {
    write::number(x).parse().ok()
}

fn vector(v: DVec3) -> Option<Value> {
    write::vector(v).parse().ok()
}
