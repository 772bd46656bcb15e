use super::*;

/// A stand-in for fonts: every letter is 0.55 em wide, or 0.6 em if it is bold.
struct Even;

impl TextMeasure for Even {
    fn width(&mut self, text: &str, face: Face, size: f32) -> f32 {
        let em = if face == Face::Bold { 0.6 } else { 0.55 };
        em * size * text.chars().count() as f32
    }
}

const U: Formula = Formula::Vector("u", SymbolInk::U);
const W: Formula = Formula::Vector("w", SymbolInk::W);
const UP: Formula = Formula::Vector("up", SymbolInk::Given);

fn equals() -> Formula {
    Operator::Equals.into()
}

fn up_cross_w() -> Formula {
    row([UP, Operator::Times.into(), W])
}

fn coordinates(numbers: [&str; 3]) -> Formula {
    tuple(numbers.map(number))
}

/// Returns `u = up × w / |up × w| = (5, 0, −7) / √74 = (0.58124, 0, −0.81373)`.
fn long() -> Formula {
    row([
        U,
        equals(),
        fraction(up_cross_w(), norm(up_cross_w())),
        equals(),
        fraction(coordinates(["5", "0", "-7"]), square_root(number("74"))),
        equals(),
        coordinates(["0.58124", "0", "-0.81373"]),
    ])
}

#[test]
fn plain_text_keeps_vectors_and_scalars_apart() {
    let u = Formula::Scalar("u");
    let cases = [
        (row([u.clone(), U]), "u 𝐮"),
        (long(), "𝐮 = (up × 𝐰)/|up × 𝐰| = (5, 0, −7)/√74 = (0.58124, 0, −0.81373)"),
        (row([negative(Formula::Scalar("distance")), W]), "−distance 𝐰"),
        (row([word("normalize"), parentheses(negative(W))]), "normalize(−𝐰)"),
        (square_root(row([u.clone(), Operator::Plus.into(), number("1")])), "√(u + 1)"),
        (fraction(negative(u.clone()), square_root(number("2"))), "−u/√2"),
        (power(norm(UP), "2"), "|up|²"),
        (power(row([U, Operator::Minus.into(), W]), "2"), "(𝐮 − 𝐰)²"),
        (index(Formula::Scalar("t"), number("1")), "t₁"),
        (index(Formula::Scalar("t"), word("far")), "t_far"),
        (row([number("2"), Operator::Dot.into(), number("-3").guarded()]), "2 · (−3)"),
    ];
    for (formula, text) in cases {
        assert_eq!(formula.to_string(), text);
    }
}

/// Returns the bounds of every text and stroke of a layout, with the text.
fn boxes(layout: &Layout) -> Vec<(String, [f32; 4])> {
    let runs = layout.runs.iter().map(|run| {
        let width = Even.width(&run.text, run.face, run.size);
        let [x, y] = run.at;
        (run.text.clone(), [x, y - 0.7 * run.size, x + width, y + 0.2 * run.size])
    });
    let rules = layout.rules.iter().map(|rule| {
        let fold = |k: usize, f: fn(f32, f32) -> f32| {
            rule.points.iter().map(|point| point[k]).reduce(f).expect("a stroke has points")
        };
        (
            "—".to_owned(),
            [fold(0, f32::min), fold(1, f32::min), fold(0, f32::max), fold(1, f32::max)],
        )
    });
    runs.chain(rules).collect()
}

/// Checks that everything lies in the layout's own box, and that no texts overlap.
fn check(layout: &Layout) {
    let boxes = boxes(layout);
    for (k, (text, [left, top, right, bottom])) in boxes.iter().enumerate() {
        assert!(*left >= -1e-3 && *right <= layout.width + 1e-3, "{text}: {left}..{right}");
        let (up, down) = (-layout.ascent - 1e-3, layout.descent + 1e-3);
        assert!(*top >= up && *bottom <= down, "{text}: {top}..{bottom} in {up}..{down}");
        for (other, [l, t, r, b]) in boxes[..k].iter().filter(|(o, _)| o != "—" && text != "—")
        {
            let apart = *left >= r - 1e-3
                || l >= &(right - 1e-3)
                || *top >= b - 1e-3
                || t >= &(bottom - 1e-3);
            assert!(apart, "{text} lies over {other}");
        }
    }
}

#[test]
fn parts_stand_beside_and_above_each_other() {
    let formulas = [
        long(),
        Formula::Tuple(["1", "20", "-3.5"].map(number).to_vec(), Arrangement::Column),
        square_root(fraction(number("1"), square_root(number("2")))),
        parentheses(fraction(power(U, "2"), index(Formula::Scalar("t"), number("1")))),
        power(parentheses(fraction(number("1"), number("2"))), "2"),
        norm(Formula::Tuple(["1", "2"].map(number).to_vec(), Arrangement::Column)),
    ];
    for formula in formulas {
        check(&layout(&formula, 17.0, &mut Even));
    }
}

#[test]
fn names_have_their_fonts_and_colours() {
    let set = layout(&row([Formula::Scalar("h"), U, Formula::Scalar("distance")]), 17.0, &mut Even);
    let runs: Vec<_> = set.runs.iter().map(|run| (run.text.as_str(), run.face, run.ink)).collect();
    assert_eq!(
        runs,
        [
            ("ℎ", Face::Italic, SymbolInk::Text),
            ("u", Face::Bold, SymbolInk::U),
            ("distance", Face::Italic, SymbolInk::Text)
        ]
    );
}

/// Returns the lines of a layout as text.
fn lines_of(layout: &Layout) -> Vec<String> {
    let mut lines: Vec<(f32, String)> = Vec::new();
    for run in &layout.runs {
        match lines.last_mut() {
            Some((y, line)) if (run.at[1] - *y).abs() < 12.0 => line.push_str(&run.text),
            _ => lines.push((run.at[1], run.text.clone())),
        }
    }
    lines.into_iter().map(|(_, line)| line).collect()
}

#[test]
fn lines_break_before_relations() {
    let formula =
        row([U, equals(), up_cross_w(), equals(), coordinates(["0.58124", "0", "-0.81373"])]);
    let column = |width| Column { size: 10.0, width, indent: 14.0 };
    let narrow = lines(&formula, column(160.0), &mut Even);
    assert_eq!(lines_of(&narrow), ["u=up×w", "=(0.58124,0,−0.81373)"]);
    let second = narrow.runs.iter().find(|run| run.at[1] > 5.0).expect("a second line");
    assert_eq!((second.text.as_str(), second.at[0]), ("=", 14.0));
    check(&narrow);
    assert_eq!(lines_of(&lines(&formula, column(1000.0), &mut Even)).len(), 1);
}

#[test]
fn a_sum_that_is_too_wide_breaks_before_its_signs() {
    let term = || coordinates(["0.123456789", "0", "-0.987654321"]);
    let formula = row([U, equals(), term(), Operator::Plus.into(), term()]);
    let set = lines(&formula, Column { size: 10.0, width: 190.0, indent: 14.0 }, &mut Even);
    assert_eq!(lines_of(&set), ["u=(0.123456789,0,−0.987654321)", "+(0.123456789,0,−0.987654321)"]);
}

#[test]
fn a_vector_that_is_too_wide_becomes_a_column() {
    let set = lines(
        &row([U, equals(), coordinates(["0.12345678901234567", "0", "-0.98765432109876543"])]),
        Column { size: 10.0, width: 180.0, indent: 14.0 },
        &mut Even,
    );
    assert!(set.runs.iter().all(|run| run.size == 10.0));
    check(&set);
}

#[test]
fn nothing_is_wider_than_it_may_be() {
    for width in 30..400 {
        let width = width as f32;
        let set = lines(
            &long(),
            Column { size: 17.0, width, indent: 20.0_f32.min(0.2 * width) },
            &mut Even,
        );
        assert!(set.width <= width, "{} in {width}", set.width);
        let right = boxes(&set).iter().map(|(_, b)| b[2]).fold(0.0, f32::max);
        assert!(right <= width + 1e-3, "{right} in {width}");
    }
}
