//! Presents a grade in words, and as a map that shows for each pixel whether its answer is right, for
//! the command line and the window.

use pinhole_core::{BACKGROUND, DVec3, ImageSize, Pixel, Ray, Rgb};

use super::answers::{AnswerKind, Answers};
use super::grade::{AnswerValue, Grade, Worst};
use super::picture::off;
use crate::mistakes::Mistake;
use crate::numbers::{grouped, significant};

/// Answers with their grade.
#[derive(Clone, Debug, PartialEq)]
pub struct Graded {
    /// The answers.
    pub answers: Answers,
    /// Their grade.
    pub grade: Grade,
    /// The size of the graded scene's image.
    pub image: ImageSize,
    /// The number of the first row and the first column in the answers: 0 or 1.
    pub count_from: u32,
}

/// Whether a pixel's answer is right, for the map of all pixels. If the map is shown smaller than the
/// image, each dot shows the greatest value of its pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cell {
    /// The pixel has no answer.
    Unanswered,
    /// The answer is right.
    Right,
    /// A wrong answer would have been accepted, too.
    NotJudged,
    /// The answer is wrong.
    Wrong,
}

impl Cell {
    /// Returns the colour of such a pixel on the map. The colours also differ in lightness.
    pub fn color(self) -> Rgb {
        match self {
            Cell::Unanswered => [0x8a, 0x8f, 0x98],
            Cell::Right => [0xdf, 0xe7, 0xee],
            Cell::NotJudged => [0x34, 0x4e, 0x6a],
            Cell::Wrong => [0xd5, 0x5e, 0x00],
        }
    }
}

/// The numbers of significant digits with which a given and a right value are displayed: the first with
/// which they do not look the same.
const DIGITS: [usize; 4] = [7, 10, 13, 17];

/// The advice for answers whose rows and columns were read as counted from 1, but that are right when
/// counted from 0.
const COUNT_FROM_ZERO: &str = "They were read as counting from 1. They count from 0, and then all agree: leave \
                               out --count-from 1, or clear “The file counts from 1”.";

/// The advice to check whether rows and columns are counted from 0 or 1, for answers that were read as
/// counted from 1.
const READ_FROM_ONE: &str = "Look at where counting begins: they were read as counting from 1. If they count \
                             from 0, leave out --count-from 1, or clear “The file counts from 1”.";

/// The reason why answers are not judged.
const WHY_NOT: &str = "What is not judged: numbers of this size are rounded by more than a pixel, the tolerance \
                       is larger than one or than the contrast of colours, or two surfaces are closer than the \
                       tolerance, so that a wrong answer would pass, too.";

impl Graded {
    /// Returns the map: whether each pixel's answer is right, row by row from the top. Returns `None`
    /// for a basis, whose vectors do not belong to pixels.
    pub fn map(&self) -> Option<Vec<Cell>> {
        if self.grade.kind == AnswerKind::Basis {
            return None;
        }
        let width = self.image.width() as usize;
        let mut cells = vec![Cell::Unanswered; width * self.image.height() as usize];
        for index in 0..self.grade.is_right.len() {
            let pixel = self.pixel(index).filter(|pixel| self.image.contains(*pixel));
            if let Some(Pixel { row, column }) = pixel {
                cells[row as usize * width + column as usize] = self.grade.cell(index);
            }
        }
        Some(cells)
    }

    /// Returns the map as lines of text, in which a letter stands for several pixels: `#` if one of them is
    /// wrong, `?` if one is not judged, `.` if all that are answered are right, and a blank if none is
    /// answered. There are no lines if less than a twentieth of the image is answered, because a sketch then shows nothing.
    pub fn sketch(&self) -> Vec<String> {
        let (width, height) = (self.image.width() as usize, self.image.height() as usize);
        let Some(cells) = self.map().filter(|_| 20 * self.grade.is_right.len() >= width * height)
        else {
            return Vec::new();
        };
        let (columns, rows) = (width.min(48), height.min(16));
        let mut letters = vec![vec![' '; columns]; rows];
        for (index, cell) in cells.into_iter().enumerate() {
            let (row, column) = (index / width * rows / height, index % width * columns / width);
            let letter = &mut letters[row][column];
            let known = " .?#".find(*letter).unwrap_or_default();
            *letter = [' ', '.', '?', '#'][known.max(cell as usize)];
        }
        letters.into_iter().map(String::from_iter).collect()
    }

    /// Returns the pixel to which the answer with this index belongs, counted from 0; `None` for a
    /// vector of a basis.
    pub fn pixel(&self, index: usize) -> Option<Pixel> {
        match &self.answers {
            Answers::Basis(_) => None,
            Answers::Rays(rays) => rays.get(index).map(|ray| ray.pixel),
            Answers::Hits(hits) => hits.get(index).map(|hit| hit.pixel),
            Answers::Picture(_) => {
                let width = self.image.width() as usize;
                Some(Pixel { row: (index / width) as u32, column: (index % width) as u32 })
            }
        }
    }

    /// Returns the pixel of the answer with the largest error; `None` if there is no such answer, or if
    /// its pixel is outside the image.
    pub fn worst_pixel(&self) -> Option<Pixel> {
        let worst = self.grade.worst.as_ref()?;
        self.pixel(worst.index).filter(|pixel| self.image.contains(*pixel))
    }

    /// Returns the number of right answers as text, for example `159,999 of 160,000 hits agree, within
    /// 0.00001 of their distance`, and that of answers that are not judged.
    pub fn agreement(&self) -> String {
        let grade = &self.grade;
        let [agree, all] = [grade.agree(), grade.answers()].map(|count| grouped(count as u64));
        let plural = grade.kind.plural();
        let verb = if grade.agree() == 1 { "agrees" } else { "agree" };
        let not = grade.not_judged_in_words();
        format!("{agree} of {all} {plural} {verb}{not}, within {}", self.tolerance())
    }

    /// Returns the reason why answers are not judged, and what is said of exact ties.
    pub fn notes(&self) -> Vec<String> {
        let Grade { not_judged, ties, .. } = &self.grade;
        let not_judged = (!not_judged.is_empty()).then(|| WHY_NOT.to_owned());
        let ties = ties.first().map(|[a, b]| {
            let n = grouped(ties.len() as u64);
            format!("Either of two objects is right where both are hit at the same t ({n} times, such as {a} and {b}).")
        });
        not_judged.into_iter().chain(ties).collect()
    }

    /// Returns the grade under the rule that every pixel must be answered: a pixel without an answer
    /// counts as wrong.
    pub fn complete(self) -> Graded {
        let is_unanswered = |cell: &&Cell| **cell == Cell::Unanswered;
        let unanswered = self.map().map_or(0, |cells| cells.iter().filter(is_unanswered).count());
        Graded { grade: Grade { unanswered, ..self.grade }, ..self }
    }

    /// Returns the number of unanswered pixels as text, for example `3 pixels are not answered`; `None`
    /// if there are none or they do not count as wrong.
    pub fn unanswered(&self) -> Option<String> {
        match self.grade.unanswered {
            0 => None,
            1 => Some("1 pixel is not answered".to_owned()),
            count => Some(format!("{} pixels are not answered", grouped(count as u64))),
        }
    }

    fn tolerance(&self) -> String {
        let tolerance = significant(self.grade.tolerance, 3);
        match (self.grade.kind, self.grade.shade) {
            (AnswerKind::Picture, Some(shade)) => {
                format!("{tolerance} of 255 levels, shaded by {}", shade.name())
            }
            (AnswerKind::Picture, None) => format!("{tolerance} of 255 levels"),
            (AnswerKind::Basis, _) => format!("{tolerance} in each coordinate"),
            (AnswerKind::Rays, _) => format!("{tolerance} in each coordinate of the unit vector"),
            (AnswerKind::Hits, _) => format!("{tolerance} of their distance"),
        }
    }

    /// Describes the answer with the largest error and the right one, for example `row 3, column 4:
    /// hits object 0 at t = 5; right: t = 4`. Returns `None` if there is no answer.
    pub fn worst(&self) -> Option<String> {
        let worst = self.grade.worst.as_ref()?;
        let pixel_label = match (self.pixel(worst.index), worst.index) {
            (Some(pixel), _) => self.pixel_label(pixel),
            (None, 0) => "u".to_owned(),
            (None, 1) => "v".to_owned(),
            (None, _) => "w".to_owned(),
        };
        let (given, right) = (self.given(worst.index), self.right(worst));
        let texts = DIGITS.map(|digits| (self.words(given, digits), self.words(right, digits)));
        let differ = texts.iter().find(|(given, right)| given != right);
        let (given, right) = differ.unwrap_or(&texts[0]);
        Some(format!(
            "{pixel_label} is {given}; right is {right}{}",
            off_by(worst.error, self.grade.kind)
        ))
    }

    /// Describes a pixel as `row 3, column 4`, where rows and columns are counted from 0 or 1 as in the
    /// student's file.
    pub fn pixel_label(&self, pixel: Pixel) -> String {
        let (row, column) = (pixel.row + self.count_from, pixel.column + self.count_from);
        format!("row {row}, column {column}")
    }

    /// Returns the answer with this index as the student gave it.
    pub fn given(&self, index: usize) -> AnswerValue {
        match &self.answers {
            Answers::Basis(vectors) => AnswerValue::Vector(vectors[index].value),
            Answers::Rays(rays) => {
                let (origin, direction) = (rays[index].origin.value, rays[index].direction.value);
                AnswerValue::Ray(Ray { origin, direction })
            }
            Answers::Hits(hits) => hits[index].hit.map_or(AnswerValue::Miss, |hit| {
                let (t, point) = (hit.t.map(|t| t.value), hit.point.map(|point| point.value));
                AnswerValue::Hit { t, point, object: hit.object }
            }),
            Answers::Picture(pixels) => AnswerValue::Color(pixels[index]),
        }
    }

    /// Returns the right answer in place of the answer `worst`, with only those of t, point and object
    /// that the student gave. If the student gave a miss, it has t and the object.
    fn right(&self, worst: &Worst) -> AnswerValue {
        let AnswerValue::Hit { t, point, object } = worst.right else { return worst.right };
        match self.given(worst.index) {
            AnswerValue::Hit { t: given_t, point: given_point, object: given_object } => {
                AnswerValue::Hit {
                    t: t.filter(|_| given_t.is_some()),
                    point: point.filter(|_| given_point.is_some()),
                    object: object.filter(|_| given_object.is_some()),
                }
            }
            _ => AnswerValue::Hit { t, point: None, object },
        }
    }

    /// Formats an answer in words, with this number of significant digits.
    fn words(&self, value: AnswerValue, digits: usize) -> String {
        let triple = |v: DVec3| {
            let [x, y, z] = v.to_array().map(|x| significant(x, digits));
            format!("({x}, {y}, {z})")
        };
        match value {
            AnswerValue::Vector(vector) => triple(vector),
            AnswerValue::Ray(ray) => {
                format!("{} + t {}", triple(ray.origin), triple(ray.direction))
            }
            AnswerValue::Miss => "a miss".to_owned(),
            AnswerValue::Hit { t, point, object } => {
                let parts = [
                    t.map(|t| format!("t = {}", significant(t, digits))),
                    point.map(|point| format!("point {}", triple(point))),
                    object.map(|object| format!("object {object}")),
                ];
                parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
            }
            AnswerValue::Color([r, g, b]) => format!("#{r:02x}{g:02x}{b:02x}"),
            AnswerValue::NoPixel => {
                let (row, column) = (self.image.height() - 1, self.image.width() - 1);
                format!("that there is none: rows are 0 to {row}, columns 0 to {column}")
            }
        }
    }

    /// Returns the names of the mistakes, such as `far-root, negative-t`. It is empty if no mistake was
    /// found.
    pub fn mistakes(&self) -> String {
        ids(&self.grade.diagnosis.mistakes, ", ")
    }

    /// Returns the advice for the student, followed by remarks on how certain it is, and by the number
    /// of unanswered pixels.
    pub fn advice(&self) -> String {
        let missing = self.unanswered().map(|words| format!("{words}."));
        let counting = Mistake::CountedFromOne;
        let advice = self.grade.advice().replace(counting.advice(), self.advice_on(counting));
        let advice =
            [advice].into_iter().chain(self.further_remarks()).chain(self.notes()).chain(missing);
        advice.collect::<Vec<_>>().join(" ")
    }

    /// Returns a sentence of advice on one of the diagnosed mistakes.
    pub fn advice_on(&self, mistake: Mistake) -> &'static str {
        match (mistake, self.count_from) {
            (Mistake::CountedFromOne, 1) if self.grade.diagnosis.counted_from_zero => {
                COUNT_FROM_ZERO
            }
            (Mistake::CountedFromOne, 1) => READ_FROM_ONE,
            _ => mistake.advice(),
        }
    }

    /// Returns remarks that supplement the sentences of advice, such as other explanations or a caveat.
    pub fn remarks(&self) -> Vec<String> {
        self.grade.remarks().into_iter().chain(self.further_remarks()).collect()
    }

    fn further_remarks(&self) -> impl Iterator<Item = String> {
        let is_from_one = self.count_from == 0 && self.grade.diagnosis.counted_from_one;
        let from_one = is_from_one.then_some(
            "If they are meant to count from 1, all agree: say --count-from 1, or “The file counts from 1”.",
        );
        let said = [from_one, self.caveat()].into_iter().flatten().map(str::to_owned);
        said.chain(self.alternatives())
    }

    /// Returns a caveat if the diagnosis is a guess. It is one if all wrong answers are misses or hits
    /// of objects behind the right one, since such answers can have many causes.
    fn caveat(&self) -> Option<&'static str> {
        let Grade { diagnosis, tolerance, .. } = &self.grade;
        let is_miss = |index: usize| match &self.answers {
            Answers::Hits(hits) => hits[index].hit.is_none(),
            Answers::Picture(pixels) => off(pixels[index], BACKGROUND) <= *tolerance,
            Answers::Basis(_) | Answers::Rays(_) => false,
        };
        let is_wrong = |index: &usize| self.grade.cell(*index) == Cell::Wrong;
        let mut wrong = (0..self.grade.is_right.len()).filter(is_wrong);
        if diagnosis.mistakes.is_empty() {
            None
        } else if wrong.all(is_miss) {
            Some(
                "This is a guess: all wrong answers are misses, and a program may miss for other reasons.",
            )
        } else {
            diagnosis.may_be_unseen.then_some(
                "This is a guess: every wrong answer is what lies behind the right object, or a miss: \
                 that object may not be tested at all.",
            )
        }
    }

    /// Returns a sentence that lists other sets of mistakes that explain the answers as well, such as
    /// `negative-t; far-root + negative-t`; `None` if there are none.
    fn alternatives(&self) -> Option<String> {
        let sets = &self.grade.diagnosis.alternatives;
        let words: Vec<String> = sets.iter().map(|set| ids(set, " + ")).collect();
        (!words.is_empty()).then(|| {
            let words = words.join("; ");
            format!("It may be another mistake, with the same answers here: {words}.")
        })
    }
}

/// Describes the size of an error in brackets, such as ` (off by 0.01)`; empty if it is 0 or not
/// finite.
fn off_by(error: f64, kind: AnswerKind) -> String {
    match kind {
        _ if !error.is_finite() || error == 0.0 => String::new(),
        AnswerKind::Picture => format!(" (off by {error} levels)"),
        _ => format!(" (off by {})", significant(error, 3)),
    }
}

fn ids(mistakes: &[Mistake], between: &str) -> String {
    mistakes.iter().map(|mistake| mistake.id()).collect::<Vec<_>>().join(between)
}
