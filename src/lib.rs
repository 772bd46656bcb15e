//! Pinhole shows what a pinhole camera sees, and why. This library is the program behind `src/main.rs`,
//! so that tests can drive it. This page is a map of the source code.
//!
//! # Rooms
//!
//! The crates know no window and no session; Cargo keeps them apart. Above them are the rooms of the program, each of which
//! uses only rooms below it. A feature has a part on several floors: `ui.rs` is of the window's, `state.rs` of the
//! model's, which holds it. No circle of uses runs through files of features and rooms: `tests/layout.rs` checks this.
//!
//! ```text
//! platform                         a window, drawn by wgpu or the CPU; a page of a browser
//! ui, cli                          the window and its parts; the commands, a file each
//! features                         exercises, votes, the plot, animations, figures as files, ...: a folder each
//! report, view                     error against run time; from document and session to what is shown: pure
//! model                            what is edited and remembered: session, lessons, history, files
//!
//! figure                           crate: what is drawn: parts and views, formulas, charts, pixels, SVG and PDF
//! lecture, exchange                crates: every step with its numbers; files on disk
//! core                             crate: cameras, scenes, exact answers, pictures
//! ```
//!
//! In a feature's folder, `state.rs` is what it remembers, and `ui.rs` is what it shows. The crate `page` makes the
//! program for a browser, one HTML file, from `assets/page.html`, `assets/page.js` and `platform/web`. The crate
//! `reference` is the oracle, which computes correct answers independently. Tests use it, and of the program only
//! `pinhole report`.
//!
//! # The path of one edit
//!
//! When the user drags the number field of eye.x, the following happens, in the order of [`ui::app`]'s
//! `frame.rs`:
//!
//! 1. *Inputs*: the camera panel writes [`Document::camera`](pinhole_exchange::document::Document) `.eye.x`
//!    in place. At the end of the egui pass, the document is compared with its state at the start of the
//!    pass.
//! 2. *Apply*: keys, menus and views request [`Action`](ui::action::Action)s. Each is applied by the
//!    part that owns the state.
//! 3. *Derive*: [`view::derive`] computes everything that is shown from the document and the session
//!    ([`model::session`]). What costs more than a fraction of a millisecond is cached by its inputs.
//! 4. *Outputs*: views, readouts and textures all read the same [`Derived`](view::derive::Derived) and
//!    cannot change it, so all of them show the same frame.
//!
//! If the camera has no basis, this path carries a typed error, and the window shows the reason over the
//! last valid picture.
//!
//! # The path of one sphere
//!
//! [`pinhole_core`]'s `render` turns the scene into pixels; its `mod.rs` names every step. A plan for the
//! frame drops the objects that cannot be visible, and chooses how each sphere is drawn. Bands of rows are
//! drawn in `f32` with error bounds. A pixel whose bound leaves hit or miss open is decided again in `f64`;
//! if necessary in double-double arithmetic, and finally with exact integers (the *ladder*). Then the band is
//! shaded.
//!
//! # Recipes
//!
//! The compiler finds every exhaustive `match` that lacks a new variant, but not the places below.
//!
//! *A new way to give the camera* is a variant of [`Orientation`](pinhole_core::Orientation) and of its
//! `OrientationKind`. These places must be changed by hand:
//!
//! 1. `core/camera/mod.rs`: `has_up` and `has_at`, which decide what the window offers;
//! 2. `exchange/scene_file/read.rs`: the keys, and the rule that exactly one way is given;
//! 3. `ui/panels/camera.rs`: the button that switches to it; `figure/given.rs`: its vectors as fields that
//!    can be typed and pasted;
//! 4. patterns that match only the variants with *at* or *up*: `core/camera/difference.rs`,
//!    `core/steering/handles.rs`, `features/handles/placed.rs`, `figure/overlay/parts/camera.rs`,
//!    `lecture/exercises/solve.rs`, `ui/scene/compare.rs`;
//! 5. the oracle's own `Orientation` in `reference/camera.rs`; `report/measure/subject.rs` converts it.
//!
//! *A new kind of object* is a variant of [`Object`](pinhole_core::Object). These places must be changed
//! by hand:
//!
//! 1. `core/scene/mod.rs`, which owns the order of objects (spheres first, then planes), and the order of the
//!    document's lists in `exchange/document.rs`;
//! 2. `core/render/`: a kernel for a row, and the kind's entry in `plan.rs`;
//! 3. `exchange/scene_file/read.rs` and `write.rs`: its table; `exchange/template.rs` and each file of
//!    `exchange/templates/`: a section `@kind`, or a note that the program cannot show it;
//! 4. `ui/panels/objects.rs`: its button and fields; `figure/given.rs` and `features/handles/placed.rs`: what can be
//!    typed and dragged;
//! 5. `lecture/derivation.rs` and `figure/derivation/objects.rs`: how the t of a hit is derived;
//!    `reference/object.rs`: the oracle's own roots.
//!
//! *A new exercise* is a variant of [`Exercise`](pinhole_lecture::Exercise) in `lecture/exercises/question.rs`, where
//! `LISTED` has it, too. The compiler finds `pick.rs`, `solve.rs` and `texts.rs` beside it, but not the functions of
//! given numbers in its `mod.rs` and in `view/derive/views.rs`, nor the head of
//! `assets/lessons/01-canonical-camera.toml`. `features/exercises/` changes only for a new kind of answer.
//!
//! *A new concept* is a variant of [`Concept`](pinhole_figure::Concept) in `figure/concept.rs`, with a row of `NAMES`. A
//! part in `figure/overlay/parts/` and a line in `figure/derivation/` that name it light each other; no switch is needed.
//!
//! # Where to look
//!
//! Paths are below `src/`, except for `assets/`.
//!
//! | for | open |
//! | --- | --- |
//! | how a pixel gets its colour, and the error bounds | the page of `core/render/mod.rs` |
//! | a line of the derivation | `figure/derivation/camera.rs`, `figure/derivation/objects.rs`; its numbers in `lecture/derivation.rs` |
//! | a mistake; a vote on it | `lecture/mistakes/table.rs`; `lecture/mistakes/vote.rs`, in the window `features/vote/`; a step's `choices` in `model/lessons/read.rs` |
//! | a class's answers | `features/class/ui.rs`; as tables of the command `check`: `cli/check_class.rs` |
//! | a scene file's keys, such as those of `[observer]` | `exchange/scene_file/read.rs` and `write.rs`; `exchange/document.rs` |
//! | another program's format; a language | `exchange/programs/writers.rs`; `exchange/code.rs`; the text of each in `exchange/templates/` |
//! | an option of a command | `cli/arguments.rs`; carried out in the file of the command's name |
//! | a command of the window, its key and its place in a menu | `ui/commands_table/table.rs`, `ui/panels/top_bar.rs` |
//! | a switch that a lesson's step sets | `Setup` in `model/session/shown.rs`, its key in `model/lessons/keys.rs`; its command: `Switch` in `ui/action.rs` |
//! | a mark over a view: its length, concept and label | `figure/overlay/parts/`; its switch: `figure/overlay_items.rs` |
//! | where a label may stand; a chart's ticks | `figure/overlay/labels.rs`; `figure/chart.rs` |
//! | from where the world view is seen; the glide | `figure/observer/`, `figure/overlay/parts/sight.rs`; `ui/app/glide.rs` |
//! | mouse, wheel and keys in the views | `ui/scene/dragging.rs`, `ui/scene/steps.rs`; handles: `features/handles/` |
//! | the side panel and its width; the stage of a lesson's step | `ui/app/frame.rs`, `ui/panels/`; `ui/stage/` |
//! | what is kept, and when it is written | `model/store.rs`, `model/recovery.rs`, `ui/app/writing.rs` |
//!
//! Pure functions are in the middle; clocks, files and the display are at the edge (`model/files.rs`,
//! `model/store.rs`, `model/recovery.rs`, `cli`, `platform`).

pub mod cli;
pub mod features;
pub mod model;
pub mod platform;
pub mod report;
pub mod ui;
pub mod view;
