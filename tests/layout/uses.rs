//! Which file of a tree of Rust sources uses which other one, by their own paths: `use` lines and
//! `crate::a::b` in code, through what is re-exported. Comments and texts do not count.

use std::collections::{BTreeMap, BTreeSet};

/// A use of something that is written down in another file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Use {
    pub(super) from: String,
    pub(super) line: usize,
    pub(super) to: String,
}

/// A module: its file, and what is known by name in it. Its key is its path, such as `pinhole::view::plot`.
#[derive(Default)]
struct Module {
    file: String,
    /// Names that stand for something elsewhere.
    imports: BTreeMap<String, Vec<String>>,
    /// Paths of which everything is imported.
    globs: Vec<Vec<String>>,
    items: BTreeSet<String>,
}

/// A path as it stands in a module.
struct Mention {
    module: String,
    line: usize,
    path: Vec<String>,
}

#[derive(Default)]
struct Modules {
    by_name: BTreeMap<String, Module>,
    /// The modules of which everything is imported into another one.
    globs: BTreeMap<String, Vec<String>>,
    mentions: Vec<Mention>,
}

/// Returns the uses between files, given with their paths; of several between two files the first.
/// A folder with a `lib.rs` is a crate: `src` is `pinhole`, and `src/core` is `pinhole_core`.
pub(super) fn uses(files: &[(String, String)]) -> Vec<Use> {
    let mut modules = Modules::default();
    let crates: BTreeSet<&str> =
        files.iter().filter_map(|(file, _)| file.strip_suffix("/lib.rs")).collect();
    for (file, text) in files {
        let path = module_path(file, &crates);
        modules.by_name.entry(path.clone()).or_default().file.clone_from(file);
        Reader { tokens: tokens(text), at: 0, file, modules: &mut modules }.read(&path);
    }
    modules.globs = modules.modules_of_globs();
    let mut found: Vec<Use> = Vec::new();
    let mut known = BTreeSet::new();
    for Mention { module, line, path } in &modules.mentions {
        let Some((owner, _)) = modules.resolve(module, path, 0) else { continue };
        let [from, to] = [module, &owner].map(|module| modules.by_name[module].file.clone());
        if from != to && known.insert((from.clone(), to.clone())) {
            found.push(Use { from, line: *line, to });
        }
    }
    found
}

/// Returns the path of the module that a file is.
fn module_path(file: &str, crates: &BTreeSet<&str>) -> String {
    let parts: Vec<&str> = file.trim_end_matches(".rs").split('/').collect();
    let roots = (1..parts.len()).rev().map(|length| (length, parts[..length].join("/")));
    let (length, root) =
        roots.into_iter().find(|(_, root)| crates.contains(&**root)).unwrap_or_default();
    let name = match root.rsplit_once('/') {
        Some((_, name)) => format!("pinhole_{name}"),
        None => "pinhole".to_owned(),
    };
    let inside = &parts[length..];
    match inside {
        ["lib"] => name,
        // A program beside the library is a crate of its own.
        ["main"] => format!("{name}(program)"),
        [folders @ .., "mod"] => [&[&*name], folders].concat().join("::"),
        inside => [&[&*name], inside].concat().join("::"),
    }
}

impl Modules {
    fn modules_of_globs(&self) -> BTreeMap<String, Vec<String>> {
        let whole = |module: &str, path: &Vec<String>| {
            self.resolve(module, path, 0).filter(|(other, whole)| *whole && other != module)
        };
        let modules = self.by_name.iter().map(|(name, module)| {
            let globs = module.globs.iter().filter_map(|path| whole(name, path));
            (name.clone(), globs.map(|(other, _)| other).collect())
        });
        modules.collect()
    }

    /// Returns the module that holds what a path stands for in a module, and whether it is that module itself.
    fn resolve(&self, module: &str, path: &[String], depth: usize) -> Option<(String, bool)> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => self.walk(module.split("::").next()?, rest, depth),
            "self" => self.walk(module, rest, depth),
            "super" => self.walk(module.rsplit_once("::")?.0, rest, depth),
            _ if self.home(module, first, &mut BTreeSet::new()).is_some() => {
                self.walk(module, path, depth)
            }
            name if self.by_name.contains_key(name) => self.walk(name, rest, depth),
            _ => None,
        }
    }

    fn walk(&self, module: &str, path: &[String], depth: usize) -> Option<(String, bool)> {
        let Some((first, rest)) = path.split_first() else {
            return Some((module.to_owned(), true));
        };
        if first == "super" {
            return self.walk(module.rsplit_once("::")?.0, rest, depth);
        }
        let home = self.home(module, first, &mut BTreeSet::new());
        let home = home.unwrap_or_else(|| module.to_owned());
        let child = format!("{home}::{first}");
        if self.by_name.contains_key(&child) {
            return self.walk(&child, rest, depth);
        }
        match self.by_name.get(&home)?.imports.get(first) {
            // Names that stand for each other lead nowhere.
            Some(import) if depth < 20 => self.resolve(&home, &[import, rest].concat(), depth + 1),
            Some(_) => None,
            None => Some((home, false)),
        }
    }

    /// Returns the module in which a name is written down that is known in this one.
    fn home(&self, module: &str, name: &str, seen: &mut BTreeSet<String>) -> Option<String> {
        let own = self.by_name.get(module).filter(|_| seen.insert(module.to_owned()))?;
        let is_other = |path: &Vec<String>| path.first().is_some_and(|first| first != name);
        if own.items.contains(name)
            || own.imports.get(name).is_some_and(is_other)
            || self.by_name.contains_key(&format!("{module}::{name}"))
        {
            return Some(module.to_owned());
        }
        let globs = self.globs.get(module).into_iter().flatten();
        globs.filter_map(|other| self.home(other, name, seen)).next()
    }
}

/// Reads the tokens of a file.
struct Reader<'a> {
    tokens: Vec<(usize, &'a str)>,
    at: usize,
    file: &'a str,
    modules: &'a mut Modules,
}

impl<'a> Reader<'a> {
    fn token(&self, ahead: usize) -> &'a str {
        self.tokens.get(self.at + ahead).map_or("", |(_, token)| token)
    }

    fn read(&mut self, module: &str) {
        // The modules that are open, with the braces that are open inside each.
        let mut open = vec![(module.to_owned(), 0_usize)];
        while self.at < self.tokens.len() {
            let last = open.len() - 1;
            let (module, braces) = &mut open[last];
            match self.token(0) {
                "use" if !self.token(1).starts_with(['<', '+', ',', '>']) => {
                    self.at += 1;
                    let module = module.clone();
                    self.use_tree(&module, &[]);
                    continue;
                }
                "mod" if self.token(2) == "{" => {
                    let inner = format!("{module}::{}", self.token(1));
                    self.modules.by_name.entry(inner.clone()).or_default().file =
                        self.file.to_owned();
                    open.push((inner, 0));
                    self.at += 3;
                    continue;
                }
                "{" => *braces += 1,
                "}" if *braces == 0 && last > 0 => drop(open.pop()),
                "}" => *braces = braces.saturating_sub(1),
                "struct" | "enum" | "trait" | "type" | "fn" | "const" | "static" | "macro" => {
                    let item = self.token(1).to_owned();
                    self.modules.by_name.entry(module.clone()).or_default().items.insert(item);
                }
                word if is_word(word) && self.token(1) == "::" => {
                    let module = module.clone();
                    self.path(&module);
                    continue;
                }
                "::" | "." => self.at += 1,
                _ => {}
            }
            self.at += 1;
        }
    }

    /// A path in code, from its first word.
    fn path(&mut self, module: &str) {
        let line = self.tokens[self.at].0;
        let mut path = vec![self.token(0).to_owned()];
        self.at += 1;
        while self.token(0) == "::" && is_word(self.token(1)) {
            path.push(self.token(1).to_owned());
            self.at += 2;
        }
        self.modules.mentions.push(Mention { module: module.to_owned(), line, path });
    }

    /// What is imported, after `use` or inside its braces.
    fn use_tree(&mut self, module: &str, before: &[String]) {
        let mut path = before.to_vec();
        let line = self.tokens.get(self.at).map_or(0, |(line, _)| *line);
        let mut name = None;
        loop {
            match self.token(0) {
                "{" => {
                    self.at += 1;
                    while !["}", ""].contains(&self.token(0)) {
                        self.use_tree(module, &path);
                        self.at += usize::from(self.token(0) == ",");
                    }
                    self.at += 1;
                    return;
                }
                "*" => {
                    self.at += 1;
                    self.modules
                        .by_name
                        .entry(module.to_owned())
                        .or_default()
                        .globs
                        .push(path.clone());
                    break;
                }
                "::" => self.at += 1,
                "as" => {
                    name = Some(self.token(1).to_owned());
                    self.at += 2;
                }
                "self" if !path.is_empty() => self.at += 1,
                word if is_word(word) => {
                    path.push(word.to_owned());
                    self.at += 1;
                }
                _ => {
                    let name = name.or_else(|| path.last().cloned()).unwrap_or_default();
                    let own = self.modules.by_name.entry(module.to_owned()).or_default();
                    own.imports.insert(name, path.clone());
                    // Whatever else ends a path is no part of another one.
                    self.at += usize::from(![",", "}"].contains(&self.token(0)));
                    break;
                }
            }
        }
        if !path.is_empty() {
            self.modules.mentions.push(Mention { module: module.to_owned(), line, path });
        }
    }
}

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Returns the words and signs of Rust with their lines, without comments, texts, characters and lifetimes.
fn tokens(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut rest = text;
    let mut line = 1;
    while let Some(next) = rest.chars().next() {
        let is_in_word = |c: char| c.is_alphanumeric() || c == '_';
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            comment_length(rest)
        } else if next == '"' {
            text_length(rest)
        } else if next == '\'' {
            character_length(rest)
        } else if is_in_word(next) {
            let end = rest.find(|c| !is_in_word(c)).unwrap_or(rest.len());
            let (word, after) = rest.split_at(end);
            let hashes = after.len() - after.trim_start_matches('#').len();
            if ["r", "br", "cr"].contains(&word) && after[hashes..].starts_with('"') {
                let close = format!("\"{}", "#".repeat(hashes));
                let inside = &after[hashes + 1..];
                let length = inside.find(&close).map_or(inside.len(), |end| end + close.len());
                end + hashes + 1 + length
            } else {
                found.push((line, word));
                end
            }
        } else if rest.starts_with("::") {
            found.push((line, "::"));
            2
        } else {
            let length = next.len_utf8();
            if !next.is_whitespace() {
                found.push((line, &rest[..length]));
            }
            length
        };
        line += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    found
}

fn comment_length(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < text.len() {
        let rest = &text.as_bytes()[at..];
        if rest.starts_with(b"/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if rest.starts_with(b"*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                break;
            }
        } else {
            at += 1;
        }
    }
    at
}

fn text_length(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        if c == '"' && !escaped {
            return at + 1;
        }
        escaped = c == '\\' && !escaped;
    }
    text.len()
}

/// Length of a character, or of the sign before a lifetime.
fn character_length(text: &str) -> usize {
    let mut inside = text.char_indices().skip(1);
    match (inside.next(), inside.next()) {
        // The escaped character itself may be a quote.
        (Some((_, '\\')), Some((at, c))) => {
            let after = at + c.len_utf8();
            text[after..].find('\'').map_or(text.len(), |end| after + end + 1)
        }
        (Some(_), Some((at, '\''))) => at + 1,
        _ => 1,
    }
}
