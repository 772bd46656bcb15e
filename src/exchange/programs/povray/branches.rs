//! A POV-Ray scene's directives: which of their branches are taken.

use super::source::{Code, Piece, split};
use super::values::{OPENING, Values};

/// State of a branch of `#if` and the like.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Branch {
    Imported,
    Skipped,
    /// Depends on a condition that is not worked out here.
    Open,
}

/// A directive that is not ended.
struct Begun<'t> {
    branch: Branch,
    /// True once this branch or one before it is taken.
    was_taken: bool,
    /// Input in its brackets, or its word where it has none.
    condition: Piece<'t>,
    /// Value of a `#switch`, where it is one.
    switch: Option<Option<f64>>,
}

/// The directives that are not ended.
#[derive(Default)]
pub(super) struct Branches<'t> {
    begun: Vec<Begun<'t>>,
    skipped: usize,
    open: Vec<Piece<'t>>,
    /// Indices of those that `#break` leaves.
    left_by_break: Vec<usize>,
}

impl<'t> Branches<'t> {
    pub(super) fn now(&self) -> Branch {
        match (self.skipped, self.open.is_empty()) {
            (0, true) => Branch::Imported,
            (0, false) => Branch::Open,
            _ => Branch::Skipped,
        }
    }

    /// The innermost condition that is not worked out.
    pub(super) fn undecided(&self) -> Option<Piece<'t>> {
        self.open.last().copied()
    }

    fn begin(&mut self, begun: Begun<'t>) {
        match begun.branch {
            Branch::Imported => (),
            Branch::Skipped => self.skipped += 1,
            Branch::Open => self.open.push(begun.condition),
        }
        let was_taken = begun.was_taken || begun.branch == Branch::Imported;
        self.begun.push(Begun { was_taken, ..begun });
    }

    fn end(&mut self) -> Option<Begun<'t>> {
        let ended = self.begun.pop()?;
        match ended.branch {
            Branch::Imported => (),
            Branch::Skipped => self.skipped = self.skipped.saturating_sub(1),
            Branch::Open => drop(self.open.pop()),
        }
        Some(ended)
    }

    /// `#else`, `#elseif`, `#case` and their like, of which some have a condition of their own.
    fn turn(&mut self, next: Branch, condition: Option<Piece<'t>>) {
        if let Some(begun) = self.end() {
            let branch = match begun.branch {
                Branch::Open => Branch::Open,
                // A case goes on into the next one.
                Branch::Imported if begun.switch.is_some() => Branch::Imported,
                _ if begun.was_taken => Branch::Skipped,
                _ => next,
            };
            let condition = condition.filter(|_| begun.branch != Branch::Open);
            self.begin(Begun { branch, condition: condition.unwrap_or(begun.condition), ..begun });
        }
    }

    /// `#break` leaves a case for good; where it stands under a condition in it, it is not known what
    /// is left.
    fn leave(&mut self) {
        let last = self.begun.len().checked_sub(1);
        let left = self.left_by_break.last().copied();
        if self.now() == Branch::Skipped {
            return;
        }
        if left == last {
            if let Some(begun) = self.end() {
                let branch = match begun.branch {
                    Branch::Imported => Branch::Skipped,
                    other => other,
                };
                self.begin(Begun { branch, ..begun });
            }
        } else if let Some(begun) = left.and_then(|left| self.begun.get_mut(left))
            && begun.branch == Branch::Imported
        {
            begun.branch = Branch::Open;
            self.open.push(begun.condition);
        }
    }

    /// Takes a directive's word; `behind` is what follows it.
    pub(super) fn take(
        &mut self,
        code: &'t Code,
        values: &Values,
        word: Piece<'t>,
        behind: Piece<'t>,
    ) {
        let inside = code.bracketed(behind);
        let condition = inside.unwrap_or(word);
        let begun = |branch| Begun { branch, was_taken: false, condition, switch: None };
        let of = |holds: Option<bool>| match holds {
            Some(true) => Branch::Imported,
            Some(false) => Branch::Skipped,
            None => Branch::Open,
        };
        let decided = || of(inside.and_then(|inside| values.condition(inside)));
        match word.text {
            "if" => self.begin(begun(decided())),
            "elseif" => self.turn(decided(), Some(condition)),
            "else" => self.turn(Branch::Imported, None),
            "switch" => {
                let on = inside.and_then(|inside| values.number(inside));
                self.left_by_break.push(self.begun.len());
                let branch = if on.is_some() { Branch::Skipped } else { Branch::Open };
                self.begin(Begun { switch: Some(on), ..begun(branch) });
            }
            "case" | "range" | "default" => {
                let Some(on) = self.begun.last().and_then(|begun| begun.switch) else { return };
                let among = || {
                    let parts = split(inside?).into_iter().map(|part| values.number(part));
                    match parts.collect::<Option<Vec<_>>>()?[..] {
                        [one] if word.text == "case" => Some(one == on?),
                        [from, to] if word.text == "range" => Some((from..=to).contains(&on?)),
                        _ => None,
                    }
                };
                match word.text {
                    "default" => self.turn(Branch::Imported, None),
                    _ => self.turn(of(among()), Some(condition)),
                }
            }
            "break" => self.leave(),
            "end" => {
                self.end();
                self.left_by_break.pop_if(|left| *left >= self.begun.len());
            }
            word if OPENING.contains(&word) => {
                if ["while", "for"].contains(&word) {
                    self.left_by_break.push(self.begun.len());
                }
                self.begin(begun(Branch::Open));
            }
            _ => (),
        }
    }
}
