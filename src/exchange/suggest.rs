//! The known names nearest to one that is not known.

/// The names that are a slip of the finger away, nearest first.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    // No name is as long.
    const LONGEST: usize = 100;
    if word.len() > LONGEST {
        return Vec::new();
    }
    let word = word.to_lowercase();
    let mut near: Vec<(usize, &str)> =
        known.into_iter().map(|name| (distance(&word, name), name)).collect();
    near.retain(|(distance, name)| *distance <= tolerance(&word, name));
    near.sort_by_key(|(distance, _)| *distance);
    near.into_iter().map(|(_, name)| name).collect()
}

/// A third of the letters may be wrong.
fn tolerance(word: &str, name: &str) -> usize {
    word.chars().count().max(name.chars().count()) / 3
}

/// Counts the letters to insert, remove, replace or swap with their neighbour (Damerau's distance in
/// the restricted form, as in Boytsov, *Indexing methods for approximate dictionary searching*,
/// ACM JEA 16, 2011, section 3.1).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(before[j - 2] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances() {
        let pairs = [("", "", 0), ("centre", "center", 1), ("colour", "color", 1), ("a", "eye", 3)];
        for (a, b, expected) in pairs {
            assert_eq!((distance(a, b), distance(b, a)), (expected, expected), "{a} {b}");
        }
    }

    #[test]
    fn far_names_are_not_suggested() {
        let known = ["eye", "at", "up", "view", "basis"];
        assert_eq!(nearest("eyes", known), ["eye"]);
        assert_eq!(nearest("veiw", known), ["view"]);
        assert_eq!(nearest("UP", known), ["up"]);
        assert!(nearest("position", known).is_empty());
    }
}
