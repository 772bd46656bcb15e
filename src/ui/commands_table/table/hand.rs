//! The commands that take the camera, the observer and the objects in the hand, by keys.

use egui::{Key, Modifiers};

use super::{CTRL, CTRL_SHIFT, key, plain};
use crate::ui::action::{
    FigureAction, LookAction, ObjectAction, Observe, PlayAction, Steer, Switch,
};
use crate::ui::commands_table::{Group, UiCommand, When};

const ALT: Modifiers = Modifiers::ALT;

/// All of them.
pub(super) fn hand() -> Vec<UiCommand> {
    let mut commands = steering();
    commands.extend(observing());
    commands.extend(objects());
    commands.extend(switches());
    commands
}

#[rustfmt::skip]
fn steering() -> Vec<UiCommand> {
    use When::CameraView;
    commands![
        Hand, "Look up", "Turns the camera upwards.",
            [key(CameraView, ALT, Key::ArrowUp)], Steer::Look(0, 1);
        Hand, "Look down", "Turns the camera downwards.",
            [key(CameraView, ALT, Key::ArrowDown)], Steer::Look(0, -1);
        Hand, "Look left", "Turns the camera to its left.",
            [key(CameraView, ALT, Key::ArrowLeft)], Steer::Look(-1, 0);
        Hand, "Look right", "Turns the camera to its right.",
            [key(CameraView, ALT, Key::ArrowRight)], Steer::Look(1, 0);
        Hand, "Orbit upwards", "Takes the eye up around what it looks at.",
            [key(CameraView, CTRL, Key::ArrowUp)], Steer::Orbit(0, 1);
        Hand, "Orbit downwards", "Takes the eye down around what it looks at.",
            [key(CameraView, CTRL, Key::ArrowDown)], Steer::Orbit(0, -1);
        Hand, "Orbit to the left", "Takes the eye to its left around what it looks at.",
            [key(CameraView, CTRL, Key::ArrowLeft)], Steer::Orbit(-1, 0);
        Hand, "Orbit to the right", "Takes the eye to its right around what it looks at.",
            [key(CameraView, CTRL, Key::ArrowRight)], Steer::Orbit(1, 0);
        Hand, "Narrow the field of view", "Makes the viewport smaller, and what is seen larger.",
            [plain(CameraView, Key::Plus), plain(CameraView, Key::Equals)], Steer::Zoom(1);
        Hand, "Widen the field of view", "Makes the viewport larger, and what is seen smaller.",
            [plain(CameraView, Key::Minus)], Steer::Zoom(-1);
        Hand, "Dolly forwards", "Takes the eye along w, towards what it looks at.",
            [key(CameraView, CTRL_SHIFT, Key::ArrowUp)], Steer::Dolly(1);
        Hand, "Dolly backwards", "Takes the eye along w, away from what it looks at.",
            [key(CameraView, CTRL_SHIFT, Key::ArrowDown)], Steer::Dolly(-1);
    ]
}

#[rustfmt::skip]
fn observing() -> Vec<UiCommand> {
    use When::{View, WorldView};
    commands![
        Views, "Frame the camera", "Puts the observer where eye and viewport fill the world view.",
            [key(View, Modifiers::SHIFT, Key::F)], Observe::FrameCamera;
        Views, "Observer upwards", "Takes the observer up around what it looks at.",
            [key(WorldView, CTRL, Key::ArrowUp)], Observe::Orbit(0, 1);
        Views, "Observer downwards", "Takes the observer down around what it looks at.",
            [key(WorldView, CTRL, Key::ArrowDown)], Observe::Orbit(0, -1);
        Views, "Observer to the left", "Takes the observer to the left around what it looks at.",
            [key(WorldView, CTRL, Key::ArrowLeft)], Observe::Orbit(-1, 0);
        Views, "Observer to the right", "Takes the observer to the right around what it looks at.",
            [key(WorldView, CTRL, Key::ArrowRight)], Observe::Orbit(1, 0);
        Views, "Pan upwards", "Shows what is above the world view.",
            [key(WorldView, ALT, Key::ArrowUp)], Observe::Pan(0, 1);
        Views, "Pan downwards", "Shows what is below the world view.",
            [key(WorldView, ALT, Key::ArrowDown)], Observe::Pan(0, -1);
        Views, "Pan to the left", "Shows what is left of the world view.",
            [key(WorldView, ALT, Key::ArrowLeft)], Observe::Pan(-1, 0);
        Views, "Pan to the right", "Shows what is right of the world view.",
            [key(WorldView, ALT, Key::ArrowRight)], Observe::Pan(1, 0);
        Views, "Observer nearer", "Takes the observer nearer to what it looks at.",
            [plain(WorldView, Key::Plus), plain(WorldView, Key::Equals)], Observe::Zoom(1);
        Views, "Observer farther", "Takes the observer away from what it looks at.",
            [plain(WorldView, Key::Minus)], Observe::Zoom(-1);
    ]
}

#[rustfmt::skip]
fn objects() -> Vec<UiCommand> {
    use When::View;
    commands![
        Objects, "Previous object", "Chooses the previous object in the list.",
            [plain(View, Key::OpenBracket)], ObjectAction::Next(-1);
        Objects, "Next object", "Chooses the next object in the list.",
            [plain(View, Key::CloseBracket)], ObjectAction::Next(1);
        Objects, "+ Sphere", "Adds a sphere that the camera sees, and chooses it.",
            [], ObjectAction::AddSphere;
        Objects, "+ Plane", "Adds a plane below the origin, and chooses it.",
            [], ObjectAction::AddPlane;
        Objects, "Remove the chosen object", "Removes it from the scene.",
            [], ObjectAction::Remove;
    ]
}

/// The switches of what stays fixed in a drag.
#[rustfmt::skip]
fn switches() -> Vec<UiCommand> {
    commands![
        Hand, "Eye travels", "On: a moved eye keeps its view direction. Off: it orbits at.",
            [], LookAction::Toggle(Switch::EyeTravels);
        Hand, "Keep the pixels' shape", "Lets width, height and image keep their proportions.",
            [], LookAction::Toggle(Switch::KeepPixelShape);
        Hand, "Keep the picture",
            "Scales distance, width and height together, so that the picture stays.",
            [], LookAction::Toggle(Switch::KeepPicture);
        Hand, "Keep up",
            "On: up stays as given while eye or at is dragged. Off: it turns with the camera where view comes close.",
            [], LookAction::Toggle(Switch::KeepUp);
    ]
}

/// The strip of the animation that is open.
#[rustfmt::skip]
pub(super) fn strip() -> Vec<UiCommand> {
    use When::Untyped;
    commands![
        Play, "Faster", "Runs the open animation faster.",
            [key(Untyped, Modifiers::SHIFT, Key::Period)], PlayAction::Faster(1);
        Play, "Slower", "Runs the open animation more slowly.",
            [key(Untyped, Modifiers::SHIFT, Key::Comma)], PlayAction::Faster(-1);
        Play, "Loop", "Repeats the open animation, or not.",
            [plain(Untyped, Key::L)], PlayAction::Loop;
        Play, "Keep", "Closes the animation with everything as it is now.",
            [], PlayAction::Keep;
        Play, "Stop", "Closes the animation with everything as it was at the start.",
            [], PlayAction::Close;
        Play, "Export the animation…", "Asks how to write the open animation to a file.",
            [], FigureAction::AskAnimation;
    ]
}
