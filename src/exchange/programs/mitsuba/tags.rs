//! The tags of an XML text, before its parser goes through it.

use crate::limits;

/// A tag, from `<` to `>`.
struct Tag<'t> {
    at: usize,
    name: &'t str,
    closes: bool,
    is_empty: bool,
    attributes: usize,
    has_namespace: bool,
}

/// Finds the byte at which there is more of something than any scene has, and says of what.
pub(super) fn too_much(text: &str) -> Option<(usize, String)> {
    let (mut depth, mut namespaces) = (0_usize, 0);
    for tag in tags(text) {
        depth = match (tag.closes, tag.is_empty) {
            (true, _) => depth.saturating_sub(1),
            (false, true) => depth,
            (false, false) => depth + 1,
        };
        namespaces += usize::from(tag.has_namespace);
        let (most, what) = match tag {
            _ if depth > limits::NESTING => (limits::NESTING, "nested elements"),
            _ if tag.attributes > limits::ATTRIBUTES => (limits::ATTRIBUTES, "attributes"),
            // Every element has its own list of those around it.
            _ if namespaces > limits::NESTING => (limits::NESTING, "namespaces"),
            _ => continue,
        };
        return Some((tag.at, format!("there are too many {what}: at most {most} are read")));
    }
    None
}

/// The innermost element that is not closed at the end of a text, and where it begins.
pub(super) fn unclosed(text: &str) -> Option<(usize, &str)> {
    let mut open: Vec<Tag> = Vec::new();
    for tag in tags(text) {
        match (tag.closes, tag.is_empty) {
            (true, _) => _ = open.pop_if(|last| last.name == tag.name),
            (false, true) => (),
            (false, false) => open.push(tag),
        }
    }
    open.pop().map(|tag| (tag.at, tag.name))
}

fn tags(text: &str) -> impl Iterator<Item = Tag<'_>> {
    let mut from = 0;
    std::iter::from_fn(move || {
        loop {
            let at = from + text[from..].find('<')?;
            let rest = &text[at..];
            let hidden = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("<!", ">")];
            let Some((begin, end)) = hidden.iter().find(|(begin, _)| rest.starts_with(begin))
            else {
                let tag = tag(rest, at)?;
                from = tag.1;
                return Some(tag.0);
            };
            from = at + begin.len();
            from += text[from..].find(end)? + end.len();
        }
    })
}

/// The tag with which a text begins, which stands at this byte, and the byte behind it; `None` where the text
/// ends in it.
fn tag(text: &str, at: usize) -> Option<(Tag<'_>, usize)> {
    let (mut quote, mut attributes) = (None, 0);
    let end = text.bytes().position(|byte| {
        match (byte, quote) {
            (b'"' | b'\'', None) => quote = Some(byte),
            (byte, Some(open)) if byte == open => quote = None,
            (b'=', None) => attributes += 1,
            _ => (),
        }
        byte == b'>' && quote.is_none()
    })?;
    let inside = &text[1..end];
    let name = inside.trim_start_matches('/');
    let name = name.split(|c: char| c.is_whitespace() || c == '/').next().unwrap_or_default();
    let tag = Tag {
        at,
        name,
        closes: inside.starts_with('/'),
        is_empty: inside.ends_with('/'),
        attributes,
        has_namespace: inside.contains("xmlns"),
    };
    Some((tag, at + end + 1))
}
