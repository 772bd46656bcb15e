//! All that is said of a student's answers, kept as text. `UPDATE_EXPECT=1` writes the file anew.

use std::fmt::Write as _;

use expect_test::expect_file;

use super::*;

/// Writes all that is said, and returns the grade.
fn say(
    text: &mut String,
    title: &str,
    exercise: &Exercise,
    answers: Answers,
    count_from: u32,
) -> Graded {
    let grade = match answers.kind() {
        AnswerKind::Picture => pictures::graded(exercise, &answers),
        _ => graded(exercise, &answers),
    };
    let image = camera_of(exercise).image;
    let graded = Graded { answers, grade, image, count_from };
    let grade = &graded.grade;
    let (kind, agreement) = (grade.kind.name(), graded.agreement());
    writeln!(text, "# {title}: {kind}\n{agreement}").unwrap();
    // How far right answers are off depends on the processor.
    if let Some(worst) = graded.worst().filter(|_| grade.agree() < grade.is_right.len()) {
        let pixel = graded.worst_pixel();
        let at = pixel.map(|pixel| graded.pixel_label(pixel)).unwrap_or_default();
        writeln!(text, "worst: {worst} ({at})").unwrap();
    }
    writeln!(text, "{}\n{}", graded.advice(), graded.mistakes()).unwrap();
    for remark in graded.remarks() {
        writeln!(text, "  {remark}").unwrap();
    }
    for mistake in &grade.diagnosis.mistakes {
        writeln!(text, "  {mistake}: {}", graded.advice_on(*mistake)).unwrap();
    }
    text.push('\n');
    graded
}

fn sketch_and_what_is_missing(text: &mut String, graded: Graded) {
    for line in graded.sketch() {
        writeln!(text, "  {line}").unwrap();
    }
    let complete = graded.complete();
    let missing = complete.unanswered().unwrap_or_default();
    let (grade, advice) = (&complete.grade, complete.advice());
    writeln!(text, "complete: {} {missing}: {advice}\n", grade.all_agree()).unwrap();
}

/// Returns the hits with `change` made to each.
fn changed(
    student: &Student,
    change: impl Fn(Pixel, Option<GivenHit>) -> Option<HitAnswer>,
) -> Answers {
    let hits = student.hits().into_iter();
    Answers::Hits(hits.filter_map(|HitAnswer { pixel, hit }| change(pixel, hit)).collect())
}

#[test]
fn what_is_said_of_answers_reads_as_it_did() {
    let mut text = String::new();
    let exercise = general();
    let right = Student { exercise: &exercise, mistakes: &[] };
    say(&mut text, "right", &exercise, basis_of(&right), 0);
    for (id, _) in MISTAKES {
        let student = Student { exercise: &exercise, mistakes: &[id] };
        if OF_BASIS.contains(&id) {
            say(&mut text, id, &exercise, basis_of(&student), 0);
        }
        say(&mut text, id, &exercise, rays_of(&student), 0);
        say(&mut text, id, &exercise, hits_of(&student), 1);
        say(&mut text, id, &exercise, pictures::painted(&student, Shade::Object), 0);
    }
    let telling = telling();
    for (id, _) in ALONE {
        let student = Student { exercise: &telling, mistakes: &[id] };
        say(&mut text, id, &telling, hits_of(&student), 0);
    }
    let single = single::Student { exercise: &far_out(), mistakes: &[] };
    say(&mut text, "in f32", &far_out(), Answers::Hits(single.hits()), 0);
    let pair = Student { exercise: &exercise, mistakes: &["rows-from-bottom", "far-root"] };
    say(&mut text, "two mistakes", &exercise, hits_of(&pair), 0);
    let reversed = Student { exercise: &exercise, mistakes: &["ray-reversed"] };
    say(&mut text, "reversed", &exercise, rays_of(&reversed), 0);
    expect_file!["mistakes.txt"].assert_eq(&text);
}

fn at(pixel: Pixel, hit: Option<GivenHit>) -> Option<HitAnswer> {
    Some(HitAnswer { pixel, hit })
}

/// Returns the hit with only its t, as `write` changes it.
fn t_alone(hit: Option<GivenHit>, write: &dyn Fn(f64) -> f64) -> Option<GivenHit> {
    let t = hit?.t.map(|t| Written::exactly(write(t.value)));
    Some(GivenHit { t, ..GivenHit::default() })
}

/// Balls without a wall, so that rays miss, too.
fn balls() -> Exercise {
    Exercise { planes: vec![], ..general() }
}

#[test]
fn what_is_said_of_some_pixels_reads_as_it_did() {
    let mut text = String::new();
    let exercise = balls();
    let right = Student { exercise: &exercise, mistakes: &[] };
    for (title, every) in [("every 2nd", 2), ("every 15th", 15), ("every 25th", 25), ("one", 1000)]
    {
        let answers = changed(&right, |pixel, hit| {
            let index = pixel.row * 30 + pixel.column;
            (index % every == 0).then_some(HitAnswer { pixel, hit })
        });
        let graded = say(&mut text, title, &exercise, answers, 0);
        sketch_and_what_is_missing(&mut text, graded);
    }
    let all_but_one = changed(&right, |pixel, hit| {
        (pixel.row != 3 || pixel.column != 4).then_some(HitAnswer { pixel, hit })
    });
    let graded = say(&mut text, "all but one", &exercise, all_but_one, 0);
    sketch_and_what_is_missing(&mut text, graded);
    let far = Student { exercise: &exercise, mistakes: &["far-root"] };
    let graded = say(&mut text, "all, far-root", &exercise, hits_of(&far), 0);
    sketch_and_what_is_missing(&mut text, graded);
    expect_file!["pixels.txt"].assert_eq(&text);
}

#[test]
fn what_is_said_of_few_digits_reads_as_it_did() {
    let mut text = String::new();
    let exercise = balls();
    let right = Student { exercise: &exercise, mistakes: &[] };
    let far = Student { exercise: &exercise, mistakes: &["far-root"] };
    for digits in [1, 2, 3, 5] {
        let short = |t: f64| format!("{t:.*e}", digits - 1).parse().unwrap();
        let title = format!("{digits} digits");
        let hits = changed(&right, |pixel, hit| at(pixel, t_alone(hit, &short)));
        say(&mut text, &title, &exercise, hits, 0);
        let hits = changed(&far, |pixel, hit| at(pixel, t_alone(hit, &short)));
        say(&mut text, &format!("{title}, far-root"), &exercise, hits, 0);
        let misses = changed(&right, |pixel, hit| {
            let minus = GivenHit { t: Some(Written::exactly(-1.0)), ..GivenHit::default() };
            at(pixel, t_alone(hit, &short).or(Some(minus)))
        });
        say(&mut text, &format!("{title}, -1 for a miss"), &exercise, misses, 0);
    }
    expect_file!["digits.txt"].assert_eq(&text);
}

#[test]
fn what_is_said_of_habits_reads_as_it_did() {
    let mut text = String::new();
    let exercise = balls();
    let right = Student { exercise: &exercise, mistakes: &[] };
    let moved = |rows: i64, objects: u32| {
        changed(&right, move |pixel, hit| {
            let moved = |x: u32| u32::try_from(i64::from(x) + rows).ok();
            let pixel = Pixel { row: moved(pixel.row)?, column: moved(pixel.column)? };
            let hit = hit.map(|hit| GivenHit { object: hit.object.map(|k| k + objects), ..hit });
            Some(HitAnswer { pixel, hit })
        })
    };
    say(&mut text, "read as from 0, but from 1", &exercise, moved(1, 0), 0);
    say(&mut text, "read as from 1, but from 0", &exercise, moved(-1, 0), 1);
    say(&mut text, "objects from 1", &exercise, moved(0, 1), 0);
    say(&mut text, "all from 1", &exercise, moved(1, 1), 0);
    say(&mut text, "misses", &exercise, changed(&right, |pixel, _| at(pixel, None)), 0);
    let wrong = changed(&right, |pixel, hit| at(pixel, t_alone(hit, &|t| t * t)));
    say(&mut text, "nonsense", &exercise, wrong, 0);
    let points = changed(&right, |pixel, hit| {
        at(pixel, hit.map(|hit| GivenHit { t: None, object: None, ..hit }))
    });
    say(&mut text, "points", &exercise, points, 0);
    say(&mut text, "black", &exercise, Answers::Picture(vec![[0; 3]; 600]), 0);
    say(&mut text, "background", &exercise, Answers::Picture(vec![BACKGROUND; 600]), 0);
    expect_file!["habits.txt"].assert_eq(&text);
}
