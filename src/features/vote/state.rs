//! A vote: the class chooses one of several options, in two rounds, by raising hands. They are mistakes, one of which
//! made a picture, or the answers to a step's question.

use pinhole_figure::typesetting::notation::without_marks;
use pinhole_lecture::{Mistake, Vote};

/// Number of rounds: before and after neighbours have talked about their answers.
pub const ROUNDS: usize = 2;

/// Maximum number of hands for an option.
const MOST_HANDS: u32 = 9999;

/// Numbers of hands as an example.
const EXAMPLE: [&str; Vote::OPTIONS] = ["12", "40", "9", "3"];

/// The hands raised in one round, for each option.
pub type Hands = [u32; Vote::OPTIONS];

/// An option of a vote.
#[derive(Clone, Debug, PartialEq)]
pub struct VoteOption {
    /// The mistake's name, or the answer. Symbols are marked as in a step's text.
    pub text: String,
    /// The mistake, in a vote on the one that made a picture.
    pub mistake: Option<Mistake>,
}

/// An open vote.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OpenVote {
    /// The options: at least two.
    pub options: Vec<VoteOption>,
    /// Index of the option that is right.
    pub right: usize,
    /// Index of the option that was chosen in the current round.
    pub answer: Option<usize>,
    /// True once the right option is shown.
    pub is_revealed: bool,
    /// The current round, counted from 0.
    pub round: usize,
    /// The hands that were counted in each round.
    pub hands: [Option<Hands>; ROUNDS],
    /// The text in the field for the hands of the current round.
    pub typed: String,
}

impl OpenVote {
    /// Opens a vote on the mistake that made a picture.
    pub fn on_mistake(vote: &Vote) -> OpenVote {
        let option = |mistake: &Mistake| VoteOption {
            text: mistake.name().to_owned(),
            mistake: Some(*mistake),
        };
        let options = vote.options.iter().map(option).collect();
        OpenVote { options, right: vote.right, ..OpenVote::default() }
    }

    /// Opens a vote on the answers to a question, of which the first is right. Their order depends on their texts alone.
    pub fn on_choices(choices: &[String]) -> OpenVote {
        let mut sorted: Vec<&String> = choices.iter().collect();
        sorted.sort();
        let letters: usize = choices.iter().map(String::len).sum();
        sorted.rotate_left(letters % choices.len().max(1));
        let right = sorted.iter().position(|text| Some(*text) == choices.first()).unwrap_or(0);
        let option = |text: &String| VoteOption { text: text.clone(), mistake: None };
        OpenVote { options: sorted.into_iter().map(option).collect(), right, ..OpenVote::default() }
    }

    /// Chooses an option, unless the right one is shown already.
    pub fn choose(&mut self, option: usize) {
        if !self.is_revealed && option < self.options.len() {
            self.answer = Some(option);
        }
    }

    /// Returns the letter of an option and its text, without the marks of symbols.
    pub fn named(&self, index: usize) -> String {
        format!("{}: {}", Vote::LETTERS[index], without_marks(&self.options[index].text))
    }

    /// Returns true if another round can begin.
    pub fn has_another_round(&self) -> bool {
        !self.is_revealed && self.round + 1 < ROUNDS
    }

    /// Begins the next round, if there is one. The hands of the round before stay.
    pub fn begin_round(&mut self) {
        if self.has_another_round() {
            self.round += 1;
            self.answer = None;
            self.typed.clear();
        }
    }

    /// Takes the typed numbers as the current round's hands. Leaves the hands unchanged if the text is not a
    /// list of them; an empty text removes them.
    pub fn count_typed(&mut self) {
        if self.typed.trim().is_empty() {
            self.hands[self.round] = None;
        } else if let Ok(hands) = self.read_typed() {
            self.hands[self.round] = Some(hands);
        }
    }

    /// Returns the typed numbers.
    ///
    /// # Errors
    /// Returns a sentence that says what is wrong with the text.
    pub fn read_typed(&self) -> Result<Hands, String> {
        let count = self.options.len();
        let example = EXAMPLE[..count].join(" ");
        let mut hands = [0; Vote::OPTIONS];
        let words = self.typed.split(|c: char| c.is_whitespace() || c == ',' || c == ';');
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        if words.len() != count {
            let given = words.len();
            return Err(format!("Give {count} numbers, such as {example}: here are {given}."));
        }
        for (hands, word) in hands.iter_mut().zip(words) {
            *hands = word.parse().ok().filter(|hands| *hands <= MOST_HANDS).ok_or_else(|| {
                let wanted = format!("whole numbers up to {MOST_HANDS}, such as {example}");
                format!("“{word}” is no number of hands: give {wanted}.")
            })?;
        }
        Ok(hands)
    }

    /// Returns the rounds in which hands were counted, each as its number, counted from 0, and its hands.
    pub fn counted(&self) -> impl Iterator<Item = (usize, Hands)> {
        self.hands.iter().enumerate().filter_map(|(round, hands)| Some((round, (*hands)?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(text: &str) -> OpenVote {
        let vote = Vote { options: Mistake::GALLERY[..Vote::OPTIONS].to_vec(), right: 1 };
        OpenVote { typed: text.to_owned(), ..OpenVote::on_mistake(&vote) }
    }

    #[test]
    fn hands_are_four_whole_numbers() {
        for text in ["12 40 9 3", " 12, 40,9 ; 3 ", "12\t40\t9\t3"] {
            assert_eq!(typed(text).read_typed(), Ok([12, 40, 9, 3]), "{text:?}");
        }
        for (text, about) in [
            ("12 40 9", "here are 3"),
            ("12 40 9 3 1", "here are 5"),
            ("12 4o 9 3", "“4o”"),
            ("12 -4 9 3", "“-4”"),
            ("12 4.5 9 3", "“4.5”"),
            ("12 40 9 10000", "“10000”"),
            ("12 40 9 99999999999999999999", "up to 9999"),
        ] {
            let problem = typed(text).read_typed().expect_err(text);
            assert!(problem.contains(about), "{problem}");
        }
    }

    #[test]
    fn the_second_round_keeps_the_hands_of_the_first() {
        let mut open = typed("12 40 9 3");
        open.choose(2);
        open.count_typed();
        open.begin_round();
        assert_eq!((open.round, open.answer, open.typed.as_str()), (1, None, ""));
        open.typed = "4 57 3".to_owned();
        open.count_typed();
        assert_eq!(open.hands, [Some([12, 40, 9, 3]), None], "three numbers are no count");
        open.typed.push_str(" 0");
        open.count_typed();
        open.is_revealed = true;
        open.begin_round();
        assert_eq!(open.counted().collect::<Vec<_>>(), [(0, [12, 40, 9, 3]), (1, [4, 57, 3, 0])]);
        open.choose(0);
        assert_eq!(open.answer, None);
    }
}
