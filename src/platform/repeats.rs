//! The repeats of a held key.

use egui::Context;
use winit::event::{ElementState, KeyEvent, WindowEvent};
use winit::keyboard::{Key, NamedKey};

/// Characters whose keys step or zoom, again and again while they are held.
const STEPPING: [&str; 7] = [",", ".", "[", "]", "+", "-", "="];

/// Returns true if an event is the repeat of a held key that nothing takes: neither a text that is
/// typed, nor a shortcut with Ctrl, nor a step. Such a repeat would cost a frame, and switch a
/// command on and off.
pub(super) fn is_idle(event: &WindowEvent, ctx: &Context) -> bool {
    let WindowEvent::KeyboardInput { event, .. } = event else { return false };
    let KeyEvent { repeat: true, state: ElementState::Pressed, logical_key, .. } = event else {
        return false;
    };
    let is_taken = ctx.text_edit_focused() || ctx.input(|i| i.modifiers.command);
    !is_taken && !steps(logical_key)
}

/// Returns true if a key does something again at each repeat.
fn steps(key: &Key) -> bool {
    match key {
        Key::Named(named) => matches!(
            named,
            NamedKey::ArrowLeft
                | NamedKey::ArrowRight
                | NamedKey::ArrowUp
                | NamedKey::ArrowDown
                | NamedKey::PageUp
                | NamedKey::PageDown
                | NamedKey::Tab
                | NamedKey::Backspace
                | NamedKey::Delete
        ),
        Key::Character(character) => STEPPING.contains(&character.as_str()),
        Key::Unidentified(_) | Key::Dead(_) => false,
    }
}
