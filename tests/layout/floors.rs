//! The rule of the floors: nothing reaches up, and no circle runs between folders.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use super::uses::Use;

/// The rooms of `src`, from the ground up. Rooms of one floor may use each other one way; files in `src`
/// itself are the roof.
const FLOORS: [&[&str]; 7] = [
    &["core"],
    &["lecture", "exchange"],
    &["model"],
    &["view"],
    &["figures", "report", "reference"],
    &["ui", "cli"],
    &["platform"],
];

/// Returns the number of a file's floor; `None` for a room that is on none.
fn floor_of(file: &str) -> Option<usize> {
    let inside = file.strip_prefix("src/").unwrap_or(file);
    let room = inside.split('/').next().unwrap_or_default();
    let name = room.trim_end_matches(".rs");
    match FLOORS.iter().position(|floor| floor.contains(&name)) {
        None if room.ends_with(".rs") => Some(FLOORS.len()),
        floor => floor,
    }
}

/// Returns a sentence for each use of a higher floor, and for each file that is on none.
pub(super) fn faults_of_floors(uses: &[Use]) -> Vec<String> {
    let mut faults = Vec::new();
    let mut strangers = BTreeSet::new();
    for Use { from, line, to } in uses {
        match (floor_of(from), floor_of(to)) {
            (Some(lower), Some(upper)) if lower < upper => {
                faults.push(format!("{from}:{line} reaches up to {to}"));
            }
            (lower, upper) => {
                strangers.extend(lower.is_none().then_some(from));
                strangers.extend(upper.is_none().then_some(to));
            }
        }
    }
    faults.extend(strangers.into_iter().map(|file| format!("{file} is on no floor")));
    faults
}

/// Returns a sentence for each circle of rooms, the shortest through its first room.
pub(super) fn circles_of_folders(uses: &[Use]) -> Vec<String> {
    let mut graph: BTreeMap<String, BTreeMap<String, &Use>> = BTreeMap::new();
    let files = uses.iter().flat_map(|one| [&one.from, &one.to]);
    let folders: BTreeSet<&str> = files.filter_map(|file| parent(file)).collect();
    for one in uses {
        let [from, to] = [&one.from, &one.to].map(|file| room_of(file, &folders));
        // What stands for a folder names its parts.
        let is_own_part = is_page(&one.from, &folders) && to.starts_with(&format!("{from}/"));
        if from != to && !is_own_part {
            graph.entry(from).or_default().entry(to).or_insert(one);
        }
    }
    let mut told = BTreeSet::new();
    let mut circles = Vec::new();
    for start in graph.keys() {
        let circle = circle_through(start, &graph);
        if circle.is_empty() || circle.iter().any(|one| told.contains(&one.from)) {
            continue;
        }
        told.extend(circle.iter().map(|one| &one.from));
        let ways = circle.iter().map(|Use { from, line, to }| format!("{from}:{line} uses {to}"));
        circles.push(format!("{start}: {}", ways.collect::<Vec<_>>().join(", ")));
    }
    circles
}

/// Returns the shortest way from a folder back to it, empty if there is none.
fn circle_through<'a>(
    start: &str,
    graph: &BTreeMap<String, BTreeMap<String, &'a Use>>,
) -> Vec<&'a Use> {
    let mut ways: BTreeMap<&str, Vec<&Use>> = BTreeMap::new();
    let mut next = VecDeque::from([(start, Vec::new())]);
    while let Some((folder, way)) = next.pop_front() {
        for (to, one) in graph.get(folder).into_iter().flatten() {
            let way = [&way[..], &[*one]].concat();
            if to == start {
                return way;
            }
            if !ways.contains_key(&**to) {
                ways.insert(to, way.clone());
                next.push_back((to, way));
            }
        }
    }
    Vec::new()
}

fn parent(file: &str) -> Option<&str> {
    file.rsplit_once('/').map(|(folder, _)| folder)
}

/// Returns the room that a file belongs to: its folder, or the file itself where its folder is a floor with
/// rooms in it. `src/view/plot.rs` is of `src/view/plot` where that has files.
fn room_of(file: &str, folders: &BTreeSet<&str>) -> String {
    let own = file.trim_end_matches(".rs");
    if folders.contains(own) {
        return own.to_owned();
    }
    let folder = parent(file).unwrap_or_default();
    let below = format!("{folder}/");
    let is_floor = folders.iter().any(|other| other.starts_with(&below));
    if is_floor && !is_page(file, folders) { file } else { folder }.to_owned()
}

/// Says whether a file stands for its folder.
fn is_page(file: &str, folders: &BTreeSet<&str>) -> bool {
    let name = file.rsplit('/').next().unwrap_or_default();
    ["mod.rs", "lib.rs", "main.rs"].contains(&name)
        || folders.contains(file.trim_end_matches(".rs"))
}
