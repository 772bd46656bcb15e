//! Pinhole shows what a pinhole camera sees, and why. This library is the program behind `src/main.rs`,
//! so that tests can drive it. This page is a map of the source code.
//!
//! # Layers
//!
//! Each folder uses only folders below it; in addition, `exchange` uses `lecture`, and `report` uses
//! `figures`. No two folders use one another. `tests/layout.rs` checks this from the code's own `use`
//! lines.
//!
//! ```text
//! platform                         a window, drawn by wgpu or the CPU; a page of a browser
//! ui, cli                          what is in the window; the commands, a file each
//! figures, report                  SVG, PDF and PNG; error against run time
//! view                             from document and session to what is shown: pure
//! model                            what is edited and remembered
//! lecture, exchange                crates: every step with its numbers; files on disk
//! core                             crate: cameras, scenes, exact answers, pictures
//! ```
//!
//! The crate `page` makes the program for a browser, one HTML file, from `assets/page.html`, `assets/page.js`
//! and `platform/web`. The crate `reference` is the oracle, which computes correct answers independently. Tests
//! use it, and of the program only `pinhole report`.
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
//!    ([`model::session`]). It caches the results by their inputs, so that an idle window does no work.
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
//! # Two recipes
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
//!    `core/steering/handles.rs`, `view/handles.rs`, `figure/overlay/parts/camera.rs`,
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
//! 4. `ui/panels/objects.rs`: its button and fields; `figure/given.rs` and `view/handles.rs`: what can be
//!    typed and dragged;
//! 5. `lecture/derivation.rs` and `figure/derivation/objects.rs`: how the t of a hit is derived;
//!    `reference/object.rs`: the oracle's own roots.
//!
//! # Where to look
//!
//! Paths are below `src/`, except for `tests/` and `assets/`.
//!
//! | for | open |
//! | --- | --- |
//! | how a hit gets its colour | `core/render/shade/shade_rows.rs`, for single hits `core/render/shade/mod.rs`; the kinds of shading in `core/render/shade/paint.rs` |
//! | the error bound of the `f32` row kernel | `core/render/rows/span.rs`; kept by `core/render/outline/mod.rs` |
//! | a basis, and why there is none | `core/camera/basis.rs`; the picture meanwhile in `view/derive/mod.rs` |
//! | a mistake, its name and its texts | `lecture/mistakes/table.rs`; its thumbnail in the gallery: `ui/practice/gallery.rs` |
//! | a new exercise | `lecture/exercises/question.rs`, then `pick.rs`, `solve.rs`, `texts.rs` in the same folder |
//! | a line of the derivation | `figure/derivation/camera.rs` and `figure/derivation/objects.rs`; its numbers in `lecture/derivation.rs` |
//! | the format of scene files | `exchange/scene_file/mod.rs` |
//! | what a lesson's step sets, and its keys | `model/session/shown.rs`; `model/lessons/keys.rs`, and the head of `assets/lessons/01-canonical-camera.toml` |
//! | a chart: scales, ticks, strokes | `figure/chart.rs`; error against run time in `report/plot/mod.rs` |
//! | another export format | `exchange/programs/writers.rs`, a language `exchange/code.rs`; the text of each in `exchange/templates/` |
//! | panes, the floor and its drop lines | `figure/overlay/world_view/ground.rs`; smooth borders of balls: `core/render/edges.rs`, in vector figures `figure/export/spheres.rs` |
//! | from where the world view is seen | `figure/observer/fit.rs`; what must be in sight: `figure/observer/subject.rs`, `figure/overlay/parts/sight.rs`; kept in the scene, or as a step of a lesson: `ui/app/keep.rs`, `model/lessons/write.rs` |
//! | where a label stands | `figure/overlay/labels.rs`; numbers of rows and columns: `figure/overlay/pixel_numbers.rs` |
//! | a mark over a view, and the concept that it stands for | `figure/overlay/parts/`; its emphasis in `figure/overlay/parts/emphasis.rs`, what a concept is made from in `figure/concept.rs`; of the camera view alone: `figure/overlay/camera_view/mod.rs`; its switch in `figure/overlay_items.rs` |
//! | the numbers of the selected ray, each with its name, concept and meaning | `figure/readings.rs`; shown in `ui/scene/readouts.rs` |
//! | the labels, names and texts of an enum | the macro in `core/texts.rs`, used where the enum is |
//! | how a number is written, and read | `lecture/numbers.rs`; `model/expression.rs` |
//! | a finger: larger buttons, swipes, and what it has while presenting | `is_by_touch` in `ui/app/apply.rs`, `ui/stage/navigation.rs`; narrow areas: `STACKED` in `figure/typesetting/theme.rs` |
//! | mouse, wheel and keys in the views | `ui/scene/dragging.rs`, `ui/scene/views.rs`, `ui/scene/steps.rs`, `ui/scene/gizmo.rs`; what is under the pointer: `figure/overlay/world_view/under_pointer.rs`; how far they move: `model/interaction.rs` |
//! | a workspace of the window | `ui/workspaces.rs`; where its views, column and numbers are: `ui/scene/view_rects.rs` |
//! | the stage of a lesson's step: figure, inset, column, card of formulas | `ui/stage/`; which formulas: `formulas` in the lesson's file; the glide to the next step or view: `ui/app/glide.rs` |
//! | an exercise on the stage | `ui/stage/exercises.rs`, its fields and what is said at them: `ui/stage/answer_fields.rs`; *Show me*, a mistake as a ghost in it: `model/practice/show_me.rs`; its scene, observer and solution: `ui/app/question.rs`; which exercises are done: `model/practice/progress.rs`; hints: `model/practice/hints.rs` |
//! | the vote, its rounds and hands | `model/practice/vote.rs`, `ui/practice/vote.rs` |
//! | codes of answers, and the mistakes of a class | `model/practice/code.rs`, `model/practice/class.rs`, `ui/practice/class.rs`, `cli/check_class.rs` |
//! | the side panel and its width | `ui/app/frame.rs`; its contents in `ui/panels/` |
//! | a handle and what its drag changes | `model/session/handles.rs`, `view/handles.rs`, `view/handle_drag.rs` |
//! | a link and its QR code | `exchange/link.rs`, `figure/export/qr.rs`; what it is a link to: `model/link.rs`; `ui/app/share.rs` |
//! | a command and its key | `ui/commands_table/table.rs`; its place in a menu: `ui/panels/top_bar.rs` |
//! | what the window opens with | `platform/mod.rs`, `platform/desktop/mod.rs`, `platform/web/mod.rs` |
//! | files, where a browser differs from a desktop | `exchange/host.rs`, `platform/web/browser.rs` |
//! | the page of a browser, and a scene or lesson in it | `assets/page.js`; `exchange/page.rs`, `model/page_part.rs` |
//! | presenting, colours and zoom of the window | `ui/app/apply.rs`; undo: `ui/app/history.rs`, `model/history.rs` |
//! | unsaved changes, and what the next run knows | when they are written: `ui/app/writing.rs`; what: `model/recovery.rs`, `model/store.rs` |
//! | the dialog for a file | the window's list in `ui/dialogs/path_field.rs`, the desktop's in `platform/desktop/file_dialog/` |
//! | an option of a command | `cli/arguments.rs`, carried out in the file of the command's name; `export` and `import` in `cli/other_programs.rs` |
//! | the built-in scenes and lessons | `exchange/scenes/builtin/`, listed in `exchange/scenes.rs`; `assets/lessons/`, listed in `model/lessons/builtin.rs` |
//! | tests | `tests/` for the program, `tests/` or `tests.rs` in the folder of each crate |
//!
//! Pure functions are in the middle; clocks, files and the display are at the edge (`model/files.rs`,
//! `model/store.rs`, `model/recovery.rs`, `cli`, `platform`).

pub mod cli;
pub mod model;
pub mod platform;
pub mod report;
pub mod ui;
pub mod view;
