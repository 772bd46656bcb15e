//! Lesson files: those that come with the program, what a teacher can write, and each fault with the
//! message that it gets, to the letter.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use pinhole::model::lessons::{
    AskedExercise, LessonArgument, Step, StepId, Which, builtin, load, parse,
};
use pinhole::model::session::ViewLayout;
use pinhole_core::{DVec2, DVec3, Pixel, Selection, Sphere};
use pinhole_exchange::scene_file::with_table;
use pinhole_exchange::{Document, SceneSource};
use pinhole_figure::concept::Concept;
use pinhole_figure::overlay_items::{Item, OverlayItems};
use pinhole_lecture::exercises::Exercise;

#[test]
fn every_lesson_is_read_and_says_how_it_begins() {
    assert_eq!(builtin::all().len(), 13);
    for (name, text) in builtin::FILES {
        let lesson = parse(text, Path::new(name), None).unwrap_or_else(|error| panic!("{error}"));
        assert!((1..=10).contains(&lesson.steps.len()), "{name}");
        // Whatever was shown before, a lesson begins in the same way.
        let first = &lesson.steps[0];
        let keys = "layout show shade count_from_one keep_picture teaching derivation highlight";
        assert!(keys.split(' ').all(|key| first.says(key)), "{name}");
        assert!(first.shown.observer.is_some(), "{name}");
        for step in &lesson.steps {
            let sentences = step.text.matches(['.', '?']).count();
            assert!(sentences >= 1 && step.text.chars().count() < 260, "{}", step.text);
            assert_eq!(step.text.matches('*').count() % 2, 0, "{}", step.text);
        }
    }
}

/// Fails unless a step asks before it tells: the question is one, and neither the text nor an item
/// that it leaves in the views is the answer.
fn assert_asks(step: &Step) {
    let Some(question) = &step.question else { return };
    let [text, ask, answer] = [&step.text, &question.ask, &question.answer];
    assert!(ask.ends_with('?') && ask.chars().count() <= 120, "{ask}");
    assert!(answer.ends_with('.') && answer.chars().count() <= 200, "{answer}");
    assert!(!text.contains('?'), "one question is enough: {text}");
    for printed in [text, &step.title, ask] {
        assert!(!printed.contains(answer.trim_end_matches('.')), "{answer}");
    }
    for marked in [ask, answer] {
        assert_eq!(marked.matches('*').count() % 2, 0, "{marked}");
    }
    assert!(step.says("show"), "{ask}");
    let shown = step.shown.setup.items;
    for item in Item::ALL.into_iter().filter(|item| question.hidden.shows(*item)) {
        assert!(shown.shows(item), "{} is hidden but never shown: {ask}", item.name());
    }
    assert_ne!(step.layout(), Some(ViewLayout::Exercises), "an exercise asks by itself: {ask}");
    assert_eq!(step.play, None, "an animation is to be watched: {ask}");
}

#[test]
fn lessons_ask_before_they_tell() {
    for lesson in builtin::all() {
        lesson.steps.iter().for_each(assert_asks);
        let asks = lesson.steps.iter().any(|step| step.question.is_some());
        let is_other =
            |step: &Step| step.layout() == Some(ViewLayout::Exercises) || step.play.is_some();
        assert!(asks || lesson.steps.iter().all(is_other), "{}", lesson.title);
    }
}

#[test]
fn every_lesson_has_a_file_and_every_file_is_a_lesson() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let mut files: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    let known: Vec<String> =
        builtin::FILES.iter().map(|(name, _)| format!("{name}.toml")).collect();
    assert_eq!(files, known);
}

const HEAD: &str = "pinhole_lesson = 1\ntitle = \"Mine\"\n[[step]]\ntitle = \"A\"\ntext = \"B.\"\n";

#[test]
fn a_step_says_what_it_wants_and_inherits_the_rest() {
    let text = format!(
        "{HEAD}{}",
        r#"
scene = "canonical"
uv = [0.5, 0]
observer = { target = [0, 0, -3], azimuth = 40, elevation = 20, distance = 12 }
layout = "derivation"
show = ["eye", "view-and-up"]
derivation = ["basis"]
mistake = "w-as-printed"
t = 2
lines = { implicit = [1, 1, -2], p = [0, 0], d = [1, 1] }
exercise = "eye-at-up"
seed = 3
[step.viewport]
distance = 2
[[step]]
title = "C"
text = "Two\nlines."
pixel = [3, 4]
layout = "world"
[[step.sphere]]
center = [0, 0, -9]
radius = 2
[[step]]
title = "D"
text = "E."
scene = "planet"
exercise = "lines"
"#
    );
    let lesson = parse(&text, Path::new("mine.toml"), None).unwrap();
    let [a, c, d] = &lesson.steps[..] else { panic!("{}", lesson.steps.len()) };
    assert_eq!(a.document.camera.viewport.distance, 2.0);
    assert_eq!(a.shown.selection, Selection::Uv(DVec2::new(0.5, 0.0)));
    assert_eq!(a.layout(), Some(ViewLayout::Derivation));
    let shown = OverlayItems::NONE.with(Item::Eye, true).with(Item::ViewAndUp, true);
    assert_eq!(a.shown.setup.items, shown);
    let observer = a.shown.observer.unwrap();
    assert_eq!((observer.target(), observer.distance()), (DVec3::new(0.0, 0.0, -3.0), 12.0));
    assert_eq!(a.shown.lines.ray.d, DVec2::ONE);
    let asked = |exercise, seed| Some(AskedExercise { exercise, seed });
    assert_eq!(a.exercise, asked(Exercise::EyeAtUp, Some(3)));
    assert_eq!(c.exercise, a.exercise);
    assert_eq!(d.exercise, asked(Exercise::Lines, None), "the seed was another question's");
    assert!(!a.says("shade") && !a.says("digits"), "left alone");
    assert_eq!(c.text, "Two lines.");
    assert_eq!(c.shown.selection, Selection::Pixel(Pixel { row: 3, column: 4 }));
    assert_eq!(c.layout(), Some(ViewLayout::World));
    assert_eq!(
        (c.shown.sections, c.shown.ray_point_t, c.shown.observer),
        (a.shown.sections, Some(2.0), a.shown.observer)
    );
    assert_eq!(c.document.camera, a.document.camera);
    let sphere = Sphere { center: DVec3::new(0.0, 0.0, -9.0), radius: 2.0 };
    assert_eq!(c.document.spheres.iter().map(|item| item.shape).collect::<Vec<_>>(), [sphere]);
    assert_eq!(c.document.planes, a.document.planes);
    assert_eq!((a.scene_from, c.scene_from, d.scene_from), (0, 0, 2));
    assert_eq!(
        d.shown.selection,
        Selection::Uv(DVec2::new(0.2, -0.1)),
        "another scene begins afresh"
    );
    assert_eq!((d.shown.observer, d.shown.ray_point_t), (None, None));
    assert_eq!(d.layout(), Some(ViewLayout::World), "how it is looked at goes on");
}

#[test]
fn a_highlighted_object_goes_with_its_scene() {
    let more = "scene = \"look-at\"\nhighlight = \"object 4\"\n\
                [[step]]\ntitle = \"B\"\ntext = \"C.\"\nhighlight = \"root 4 0\"\n\
                [[step]]\ntitle = \"C\"\ntext = \"D.\"\nscene = \"canonical\"\n";
    let lesson = parse(&format!("{HEAD}{more}"), Path::new("lesson.toml"), None).unwrap();
    let highlighted: Vec<_> = lesson.steps.iter().map(|step| step.shown.highlighted).collect();
    let root = Concept::Root { object: 4, number: 0 };
    assert_eq!(highlighted, [Some(Concept::Object(4)), Some(root), None]);
}

#[test]
fn the_areas_of_both_products_have_a_name_together() {
    let text = format!("{HEAD}scene = \"canonical\"\nshow = [\"areas\"]\n");
    let lesson = parse(&text, Path::new("lesson.toml"), None).unwrap();
    let both = OverlayItems::NONE.with(Item::UpCrossW, true).with(Item::WCrossU, true);
    assert_eq!(lesson.steps[0].shown.setup.items, both);
}

#[test]
fn a_lesson_is_no_scene_of_a_lesson() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    fs::write(&path, format!("{HEAD}scene = \"mine.toml\"\n")).unwrap();
    let error = load(&path).unwrap_err().to_string();
    let expected = "mine.toml:6:9: step 1.scene is \"mine.toml\": it is a lesson: name a scene file, or \
                    a built-in scene";
    assert!(error.ends_with(expected), "{error}");
}

/// Two hundred steps with a million spheres each fit into memory.
#[test]
fn the_tables_of_a_lesson_are_checked_and_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let step = |scene: &str| {
        format!("[[step]]\ntitle = \"A\"\ntext = \"B.\"\nhighlight = \"object 1\"\n{scene}")
    };
    for name in ["a", "b"] {
        write(&format!("{name}.csv"), "x,y,z,r\n0,0,-9,1\n0,1,-9,1\n");
        write(
            &format!("{name}.toml"),
            &format!(
                "pinhole = 1\nspheres = \"{name}.csv\"\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n"
            ),
        );
    }
    let [a, b] = ["a", "b"].map(|name| step(&format!("scene = \"{name}.toml\"\n")));
    let text = format!("pinhole_lesson = 1\ntitle = \"Mine\"\n{a}{b}{}{a}", step(""));
    write("mine.toml", &text);
    let path = folder.path().join("mine.toml");
    let lesson = load(&path).unwrap();
    for step in &lesson.steps {
        let csv = step.document.csv_spheres.as_ref().unwrap();
        assert_eq!((step.document.object_count(), csv.items.spheres.len()), (2, 0));
    }
    let shown = |step: usize, at_hand: &Document| with_table(&lesson.steps[step].document, at_hand);
    let whole = SceneSource::File(folder.path().join("b.toml")).load().unwrap();
    let [b, goes_on] = [1, 2].map(|step| shown(step, &whole).unwrap());
    assert_eq!((&b, &lesson.steps[1].document), (&whole, &whole));
    let items = |document: &Document| Arc::clone(&document.csv_spheres.as_ref().unwrap().items);
    assert!(
        Arc::ptr_eq(&items(&b), &items(&whole)) && Arc::ptr_eq(&items(&goes_on), &items(&whole))
    );
    assert_eq!(items(&shown(0, &whole).unwrap()).spheres.len(), 2);
    // A step must not surprise in front of the class.
    write("b.csv", "x,y,z,r\n0,0,-9,-1\n");
    let error = load(&path).unwrap_err().to_string();
    assert!(error.ends_with("b.csv:2:8: column r is \"-1\": it must be greater than 0"), "{error}");
    write("b.csv", "x,y,z,r\n0,0,-9,1\n");
    let error = shown(1, &Document::default()).unwrap_err().problem;
    assert_eq!(
        error,
        "has another number of spheres than when the lesson was opened: open it again"
    );
    fs::remove_file(folder.path().join("b.csv")).unwrap();
    let error = load(&path).unwrap_err().to_string();
    assert!(error.contains("the table of the scene's spheres must be there"), "{error}");
}

/// The head of lesson 1 is the format's documentation.
#[test]
fn lesson_1_explains_every_field() {
    let wrong = format!("{HEAD}scene = \"canonical\"\nzzzzzzzzzzzz = 1\n");
    let error = parse(&wrong, Path::new("lesson.toml"), None).unwrap_err().to_string();
    let (_, fields) = error.split_once("the fields here are ").unwrap();
    let fields: Vec<&str> = fields.split(", ").collect();
    assert!(fields.len() > 20, "{fields:?}");
    let text = include_str!("../../assets/lessons/01-canonical-camera.toml");
    let head: Vec<&str> = text.lines().take_while(|line| line.starts_with('#')).collect();
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    let exercises = Exercise::LISTED.iter().map(|exercise| exercise.id());
    for field in fields.into_iter().chain(exercises) {
        let has_field = |line: &&str| line.split(|c| !is_word(c)).any(|word| word == field);
        assert!(head.iter().any(has_field), "{field} is not explained");
    }
}

#[test]
fn texts_have_an_end() {
    let lesson = |title: &str, text: &str| {
        let text = format!(
            "pinhole_lesson = 1\ntitle = \"Mine\"\n[[step]]\ntitle = \"{title}\"\ntext = \"{text}\"\n\
             scene = \"canonical\"\n"
        );
        parse(&text, Path::new("lesson.toml"), None).map_err(|error| error.to_string())
    };
    assert!(lesson(&"é".repeat(120), &"a ".repeat(400)).is_ok());
    let expected = "lesson.toml:4:9: step 1.title: 121 letters are too many above the views: at most \
                    120 fit; part the step";
    assert_eq!(lesson(&"é".repeat(121), "a").unwrap_err(), expected);
    let expected = "lesson.toml:5:8: step 1.text: 802 letters are too many above the views: at most \
                    800 fit; part the step";
    assert_eq!(lesson("a", &format!("{}aa", "a ".repeat(400))).unwrap_err(), expected);
}

#[test]
fn a_lesson_may_have_its_own_scene_or_name_a_file_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let inline = "[step.camera]\neye = [1, 2, 3]\nview = [0, 0, -1]\nup = [0, 1, 0]\n";
    fs::write(&path, format!("{HEAD}{inline}")).unwrap();
    let document = load(&path).unwrap().steps.remove(0).document;
    assert_eq!((document.camera.eye, document.object_count()), (DVec3::new(1.0, 2.0, 3.0), 0));
    let scene = "pinhole = 1\n[camera]\neye = [7, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n";
    fs::write(folder.path().join("room.toml"), scene).unwrap();
    fs::write(&path, format!("{HEAD}scene = \"room.toml\"\n")).unwrap();
    let step = load(&path).unwrap().steps.remove(0);
    assert_eq!((step.document.camera.eye.x, step.shown.observer), (7.0, None));
    let observer = "[observer]\ntarget = [1, 2, 3]\nazimuth = 40\nelevation = 20\ndistance = 12\n";
    fs::write(folder.path().join("room.toml"), format!("{scene}{observer}")).unwrap();
    let observer = load(&path).unwrap().steps[0].shown.observer.unwrap();
    assert_eq!((observer.target(), observer.distance()), (DVec3::new(1.0, 2.0, 3.0), 12.0));
    fs::write(folder.path().join("room.toml"), "pinhole = 1\n").unwrap();
    let error = load(&path).unwrap_err().to_string();
    assert!(
        error.ends_with("room.toml:1:1: camera is missing: write [camera] with eye, at and up")
    );
}

/// What stands in a file, and the message behind `lesson.toml:`.
type Cases = &'static [(&'static str, &'static str)];

const WHOLE_FILES: Cases = &[
    (
        "",
        "1:1: pinhole_lesson is missing: write pinhole_lesson = 1 (the format version) at the top",
    ),
    (
        "pinhole_lesson = 2\n",
        "1:18: pinhole_lesson is 2: this lesson format is newer than this program, which reads 1: get a newer Pinhole",
    ),
    ("pinhole_lesson = 1\ntitel = \"A\"\n", "2:1: titel is unknown: did you mean title?"),
    ("pinhole_lesson = 1\n", "1:1: title is missing: write title = \"What the lesson is about\""),
    ("pinhole_lesson = 1\ntitle = \" \"\n", "2:9: title is \" \": it must say something"),
    (
        "pinhole_lesson = 1\ntitle = \"A\"\n",
        "1:1: step is missing: write [[step]] with title, text and scene",
    ),
    (
        "pinhole_lesson = 1\ntitle = \"A\"\nstep = []\n",
        "1:1: step is missing: write [[step]] with title, text and scene",
    ),
    (
        "pinhole_lesson = 1\ntitle = \"A\"\n[step]\n",
        "3:1: step is a table: each one must be a table that begins with [[step]]",
    ),
    (
        "pinhole_lesson = 1\ntitle = \"A\"\n[[step]]\ntext = \"B\"\n",
        "3:1: step 1.title is missing: write title = \"What the step is about\"",
    ),
    ("pinhole_lesson = 1\ntitle = A\n", "2:9: A is no value: write a number, or text in quotes"),
];

/// Behind [`HEAD`], which is five lines.
const STEPS: Cases = &[
    (
        "",
        "3:1: step 1.camera is missing: write scene = \"canonical\", or [step.camera] with eye, at and up",
    ),
    ("scne = \"canonical\"\n", "6:1: step 1.scne is unknown: did you mean scene?"),
    (
        "pinhole_lesson = 1\n",
        "6:1: step 1.pinhole_lesson is unknown: it belongs at the top of the file, before the first [table]",
    ),
    ("scene = \"canonicle\"\n", "6:9: step 1.scene is \"canonicle\": did you mean \"canonical\"?"),
    (
        "scene = \"zzz\"\n",
        "6:9: step 1.scene is \"zzz\": it must be a built-in scene, or the path of a .toml file",
    ),
    (
        "scene = \"gone.toml\"\n",
        "6:9: step 1.scene is \"gone.toml\": gone.toml: cannot be read: no such file or directory",
    ),
    ("scene = 3\n", "6:9: step 1.scene is 3: it must be a scene's name in quotes"),
    (
        "scene = \"canonical\"\npixel = [400, 0]\n",
        "7:10: step 1.pixel[0] is 400: it must be a row of the image, 0 to 399",
    ),
    (
        "scene = \"canonical\"\npixel = [1]\n",
        "7:9: step 1.pixel is [1]: it must be row and column, counted from 0, such as [99, 199]",
    ),
    (
        "scene = \"canonical\"\nuv = [0, 0]\npixel = [1, 1]\n",
        "8:9: step 1.pixel is there beside uv: keep exactly one of them",
    ),
    (
        "scene = \"canonical\"\nuv = [0, \"a\"]\n",
        "7:10: step 1.uv[1] is \"a\": it must be a number",
    ),
    (
        "scene = \"canonical\"\nlayout = \"deriwation\"\n",
        "7:10: step 1.layout is \"deriwation\": did you mean \"derivation\"?",
    ),
    (
        "scene = \"canonical\"\nlayout = \"side\"\n",
        "7:10: step 1.layout is \"side\": it must be one of both, world, camera, derivation, plot, lines, mistakes, compare, translator, exercises",
    ),
    (
        "scene = \"canonical\"\nshow = [\"eye\", \"frustrum\"]\n",
        "7:16: step 1.show[1] is \"frustrum\": did you mean \"frustum\"?",
    ),
    (
        "scene = \"canonical\"\nshow = \"eye\"\n",
        "7:8: step 1.show is \"eye\": it must be a list, such as [\"eye\", \"basis\", \"ray\"]",
    ),
    (
        "scene = \"canonical\"\nderivation = [\"basics\"]\n",
        "7:15: step 1.derivation[0] is \"basics\": did you mean \"basis\"?",
    ),
    (
        "scene = \"canonical\"\nhighlight = \"up-cross-v\"\n",
        "7:13: step 1.highlight is \"up-cross-v\": did you mean \"up-cross-w\"?",
    ),
    (
        "scene = \"canonical\"\nshade = \"phong\"\n",
        "7:9: step 1.shade is \"phong\": it must be one of lambert, normal, t, object",
    ),
    (
        "scene = \"canonical\"\nteaching = 1\n",
        "7:12: step 1.teaching is 1: it must be true or false",
    ),
    (
        "scene = \"canonical\"\ndigits = 40\n",
        "7:10: step 1.digits is 40: it must be a number of significant digits, 2 to 17",
    ),
    (
        "scene = \"canonical\"\nobserver = { target = [0, 0, 0] }\n",
        "7:12: step 1.observer.azimuth is missing: write azimuth = 40.0 (degrees, from +z towards +x)",
    ),
    (
        "scene = \"canonical\"\nexercise = \"sfere\"\n",
        "7:12: step 1.exercise is \"sfere\": did you mean \"sphere\"?",
    ),
    (
        "scene = \"canonical\"\nexercise = \"circle\"\n",
        "7:12: step 1.exercise is \"circle\": it must be one of pixel-uv, warm-up-ray, point-at-t, warm-up-plane, distance, turned-basis, view-up, eye-at-up, coefficients, sphere, lines",
    ),
    (
        "scene = \"canonical\"\nask = \"Why?\"\n",
        "7:7: step 1.ask is there without answer: say what comes after the question",
    ),
    (
        "scene = \"canonical\"\nanswer = \"So.\"\n",
        "7:10: step 1.answer is there without ask: say the question, or write text",
    ),
    (
        "scene = \"canonical\"\nhide = [\"basis\"]\n",
        "7:8: step 1.hide is there without ask and answer: what is shown stands in show",
    ),
    (
        "scene = \"canonical\"\nask = \"Why?\"\nanswer = \"So.\"\nhide = [\"bases\"]\n",
        "9:9: step 1.hide[0] is \"bases\": did you mean \"basis\"?",
    ),
    (
        "scene = \"canonical\"\nchoices = [\"1\", \"2\"]\n",
        "7:11: step 1.choices is there without ask and answer: a vote is on a question",
    ),
    (
        "scene = \"canonical\"\nask = \"Why?\"\nanswer = \"So.\"\nchoices = [\"So\"]\n",
        "9:11: step 1.choices is [\"So\"]: it must be 2 to 4 answers, the right one first",
    ),
    (
        "scene = \"canonical\"\nask = \"Why?\"\nanswer = \"So.\"\nchoices = [\"So\", \" So\"]\n",
        "9:18: step 1.choices[1] is \" So\": it is there twice: each answer must be another one",
    ),
    (
        "scene = \"canonical\"\nseed = 3\n",
        "7:8: step 1.seed is there without exercise: say which, or leave the seed out",
    ),
    (
        "scene = \"canonical\"\nexercise = \"lines\"\nseed = -1\n",
        "8:8: step 1.seed is -1: it must be a whole number, 0 to 1000000000",
    ),
    (
        "scene = \"canonical\"\nexercise = \"lines\"\nseed = 9007199254740993\n",
        "8:8: step 1.seed is 9007199254740993: it must be a whole number, 0 to 1000000000",
    ),
    (
        "scene = \"canonical\"\nlines = { implicit = [1, 2], p = [0, 0], d = [1, 1] }\n",
        "7:22: step 1.lines.implicit is [1, 2]: it must be a, b and c, such as [1.0, 1.0, -2.0]",
    ),
    (
        "scene = \"canonical\"\nlines = { implicit = [1, 2, 3], p = [0, 0], d = [0, 0] }\n",
        "7:49: step 1.lines.d: d is (0, 0): every t gives the one point (0, 0)",
    ),
    (
        "scene = \"canonical\"\nlines = { implicit = [1, 2, 3], t = 2 }\n",
        "7:37: step 1.lines.t is 2: it needs p and d beside it",
    ),
    (
        "scene = \"canonical\"\nlines = { p = [0, 0], d = [1, 1], trail = [3, -1] }\n",
        "7:43: step 1.lines.trail is [3, -1]: its first t must not be above its last, as in [-1.0, 3.0]",
    ),
    (
        "scene = \"canonical\"\n[[step.sphere]]\ncenter = [0, 0, -5]\nradius = 0\n",
        "9:10: step 1.sphere[0].radius is 0: it must be greater than 0",
    ),
    (
        "scene = \"canonical\"\n[step.camera]\neye = [0, 0, 0]\n",
        "7:1: step 1.camera.at (or view, or basis) is missing: write at = [0.0, 0.0, -1.0]",
    ),
    (
        "scene = \"canonical\"\nsubject = [\"up\", \"object 99\"]\n",
        "7:18: step 1.subject[1] is \"object 99\": the scene's objects are 0 to 2",
    ),
    (
        "scene = \"canonical\"\nsubject = \"up\"\n",
        "7:11: step 1.subject is \"up\": it must be a list, such as [\"up\", \"w\"]",
    ),
    (
        "scene = \"canonical\"\nsubject = [\"upp\"]\n",
        "7:12: step 1.subject[0] is \"upp\": did you mean \"up\"?",
    ),
    (
        "scene = \"canonical\"\nhighlight = \"object 99\"\n",
        "7:13: step 1.highlight is \"object 99\": the scene's objects are 0 to 2",
    ),
    (
        "scene = \"canonical\"\nhighlight = \"root 3 0\"\n",
        "7:13: step 1.highlight is \"root 3 0\": the scene's objects are 0 to 2",
    ),
    (
        "highlight = \"object 0\"\n[step.camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n",
        "6:13: step 1.highlight is \"object 0\": the scene has no objects",
    ),
];

#[test]
fn every_fault_has_its_place_and_says_what_would_be_right() {
    let check = |text: &str, message: &str| {
        let error = parse(text, Path::new("lesson.toml"), Some(Path::new(""))).unwrap_err();
        assert_eq!(error.to_string(), format!("lesson.toml:{message}"), "{text}");
    };
    for (text, message) in WHOLE_FILES {
        check(text, message);
    }
    for (text, message) in STEPS {
        check(&format!("{HEAD}{text}"), message);
    }
}

#[test]
fn an_argument_is_a_number_a_step_or_a_file() {
    let at =
        |lesson, step| Ok(LessonArgument::Builtin(StepId { lesson: Which::Builtin(lesson), step }));
    assert_eq!(LessonArgument::parse("7"), at(6, 0));
    assert_eq!(LessonArgument::parse("7.3"), at(6, 2));
    assert_eq!(LessonArgument::parse("13"), at(12, 0));
    assert_eq!(LessonArgument::parse("a/my.toml"), Ok(LessonArgument::File("a/my.toml".into())));
    for (text, message) in [
        ("0", "there is no lesson 0: there are lessons 1 to 13"),
        ("14", "there is no lesson 14: there are lessons 1 to 13"),
        (
            "99999999999999999999999",
            "there is no lesson 99999999999999999999999: there are lessons 1 to 13",
        ),
        ("7.9", "lesson 7 has no step 9: it has steps 1 to 6"),
        ("7.0", "lesson 7 has no step 0: it has steps 1 to 6"),
        ("-1", "\"-1\" is no lesson: a number from 1 to 13, or the path of a .toml file"),
        ("basis", "\"basis\" is no lesson: a number from 1 to 13, or the path of a .toml file"),
    ] {
        assert_eq!(LessonArgument::parse(text), Err(message.to_owned()));
    }
}
