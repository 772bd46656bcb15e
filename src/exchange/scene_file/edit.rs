//! Changes values in the text of a scene file, and leaves comments and layout unchanged.

use std::path::Path;

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, TableLike, Value};

use super::{note_to_block, read, split_note, write};
use crate::document::Document;

/// Returns the text `previous` with its values replaced by those of the document. Returns `None` if it
/// is not a scene file, or cannot be edited.
pub(super) fn edited(document: &Document, previous: &str) -> Option<String> {
    let previous = previous.trim_start_matches('\u{feff}');
    let old = read::document(previous, Path::new(""), None, false).ok()?;
    let (block, rest) = split_note(previous);
    let mut toml: DocumentMut = rest.parse().ok()?;
    let plain = |document: &Document| write::fresh(document).parse::<DocumentMut>().ok();
    edit(&mut *toml, &*plain(&old)?, &*plain(document)?)?;
    let rest = toml.to_string();
    let text = if old.note == document.note {
        format!("{block}{rest}")
    } else {
        format!("{}{rest}", note_to_block(&document.note))
    };
    let has_carriage_returns = previous.contains("\r\n");
    Some(if has_carriage_returns { text.replace("\r\n", "\n").replace('\n', "\r\n") } else { text })
}

/// Changes `table`, a table of the user's file, wherever `new` differs from `old`. Both are written by
/// this program; `old` has the same values as `table`. Returns `None` if that is impossible.
fn edit(table: &mut dyn TableLike, old: &dyn TableLike, new: &dyn TableLike) -> Option<()> {
    for (key, _) in old.iter().filter(|(key, _)| !new.contains_key(key)) {
        table.remove(key);
    }
    for (key, new) in new.iter() {
        let old = old.get(key);
        if old.is_some_and(|old| old.to_string() == new.to_string()) {
            continue;
        }
        match new {
            Item::Table(new) => {
                if !table.contains_key(key) {
                    // The table stands for default values while it is missing in the text. It is
                    // inserted after the camera.
                    let mut added = Table::new();
                    added.set_position(table.get("camera")?.as_table().and_then(Table::position));
                    table.insert(key, Item::Table(added));
                }
                let none = Table::new();
                let old = old.and_then(Item::as_table_like).unwrap_or(&none);
                edit(table.get_mut(key)?.as_table_like_mut()?, old, new)?;
            }
            Item::ArrayOfTables(new) => {
                let none = ArrayOfTables::new();
                let old = old.and_then(Item::as_array_of_tables).unwrap_or(&none);
                edit_list(tables(table, key)?, old, new)?;
            }
            _ => edit_value(table, key, old.and_then(Item::as_value), new.as_value()?)?,
        }
    }
    Some(())
}

/// Changes `tables`, an array of tables of the user's file, wherever `new` differs from `old`. Tables
/// at both ends that are equal in `old` and `new` are kept. In between, tables are edited in order;
/// then surplus ones are removed, or missing ones inserted.
fn edit_list(tables: &mut ArrayOfTables, old: &ArrayOfTables, new: &ArrayOfTables) -> Option<()> {
    let [old, new] = [old, new].map(|list| list.iter().collect::<Vec<&Table>>());
    let same = |(a, b): &(&&Table, &&Table)| a.to_string() == b.to_string();
    let head = old.iter().zip(&new).take_while(same).count();
    let (old, new) = (&old[head..], &new[head..]);
    let tail = old.iter().rev().zip(new.iter().rev()).take_while(same).count();
    let (old, new) = (&old[..old.len() - tail], &new[..new.len() - tail]);
    for (k, (old, new)) in old.iter().zip(new).enumerate() {
        edit(tables.get_mut(head + k)?, *old, *new)?;
    }
    for _ in new.len()..old.len() {
        tables.remove(head + new.len());
    }
    for (k, added) in new.iter().enumerate().skip(old.len()) {
        // Insert it after the previous table, or before the first one.
        let neighbour = tables.get((head + k).saturating_sub(1));
        let mut table = (*added).clone();
        table.set_position(neighbour.and_then(Table::position));
        tables.insert(head + k, table);
    }
    Some(())
}

/// Returns the array of tables with this key, whichever of TOML's notations the file uses.
fn tables<'a>(root: &'a mut dyn TableLike, key: &str) -> Option<&'a mut ArrayOfTables> {
    if root.get(key).is_none_or(|item| !item.is_array_of_tables()) {
        let tables = match root.remove(key) {
            None => ArrayOfTables::new(),
            Some(item) => item.into_array_of_tables().ok()?,
        };
        root.insert(key, Item::ArrayOfTables(tables));
    }
    root.get_mut(key)?.as_array_of_tables_mut()
}

/// Sets the value of a field, but keeps the spaces and the comment around the old value. In a vector,
/// only the components that differ are replaced.
fn edit_value(
    table: &mut dyn TableLike,
    key: &str,
    old: Option<&Value>,
    new: &Value,
) -> Option<()> {
    let Some(item) = table.get_mut(key) else {
        table.insert(key, Item::Value(new.clone()));
        return Some(());
    };
    match (old, new) {
        (Some(Value::InlineTable(old)), Value::InlineTable(new)) => {
            edit(item.as_table_like_mut()?, old, new)?;
        }
        (Some(Value::Array(old)), Value::Array(new)) => {
            let array = item.as_array_mut()?;
            for (k, (old, new)) in old.iter().zip(new).enumerate() {
                if old.to_string() != new.to_string() {
                    array.replace(k, new.clone());
                }
            }
        }
        _ => {
            let value = item.as_value_mut()?;
            let decor = value.decor().clone();
            *value = new.clone();
            *value.decor_mut() = decor;
        }
    }
    Some(())
}
