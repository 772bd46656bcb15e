//! The open window: its events, its frames, and the app's requests to it.

use std::sync::Arc;
use std::time::{Duration, Instant};

use egui::epaint::textures::TexturesDelta;
use egui::{
    Context, FullOutput, OrderedViewportIdMap, ScreenshotCallback, ViewportCommand, ViewportEvent,
    ViewportId, ViewportInfo, ViewportOutput,
};
use egui_winit::{ActionRequested, accesskit_winit};
use winit::event::{ElementState, KeyEvent, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::{Key, NamedKey};
use winit::window::Window;

use crate::cli::arguments::Renderer;
use crate::platform::desktop::cpu::Cpu;
use crate::platform::desktop::display::{UserEvent, lost, without_panic};
use crate::platform::desktop::file_dialog::{self, FileDialog};
use crate::platform::desktop::frames::{FirstPass, FrameLog};
use crate::platform::desktop::start::{OpenWindow, pace};
use crate::platform::desktop::surface::{Textures, WindowFrame, WindowSurface};
use crate::ui::app::{App, complain};

/// The open window.
///
/// The fields are dropped in this order: the window comes last.
pub(super) struct Open {
    /// The renderer; `None` only if the last renderer has failed.
    surface: Option<Box<dyn WindowSurface>>,
    renderer: Renderer,
    app: App,
    log: Option<FrameLog>,
    state: egui_winit::State,
    ctx: egui::Context,
    info: ViewportInfo,
    /// Changes of textures that no frame has uploaded yet.
    delta: TexturesDelta,
    /// A record of what the graphics adapter's textures contain.
    textures: Textures,
    actions: Vec<ActionRequested>,
    repaint_at: Option<Instant>,
    /// True if the next `RedrawRequested` event was requested by this program, not by the display.
    redraw_requested: bool,
    /// Time when the whole picture must be presented, because a part may be lost since the last time.
    whole_due: Option<Instant>,
    /// Time of the first input event that no frame has handled yet.
    input_since: Option<Instant>,
    /// True if the window should open maximised, but is not maximised yet.
    pub(super) maximizing: bool,
    shown: Option<Instant>,
    /// Start of the last frame.
    began: Instant,
    /// Minimum time from the start of a frame to the start of the next one, if egui requests the latter, as
    /// during an animation. Frames caused by input are not delayed.
    pace: Duration,
    /// Time when the scene's file was last checked for changes.
    last_check: Instant,
    proxy: EventLoopProxy<UserEvent>,
    /// The open file dialog of the desktop, if any.
    file_dialog: Option<FileDialog>,
    /// Number of file dialogs opened so far.
    file_dialogs: u64,
    window: Arc<Window>,
}

/// Maximum time until a lost part of the picture is presented again on a display that may not report the
/// loss.
const WHOLE_INTERVAL: Duration = Duration::from_secs(1);

/// Time between two checks of the scene's file. A check causes a frame only if it finds a change.
const CHECK_INTERVAL: Duration = Duration::from_secs(1);

impl Open {
    /// Waits for the app's first pass, and combines the app with a window that is not shown yet.
    pub(super) fn new(
        event_loop: &ActiveEventLoop,
        ctx: egui::Context,
        OpenWindow { window, surface, renderer, detail }: OpenWindow,
        proxy: EventLoopProxy<UserEvent>,
        first_pass: FirstPass,
        log: Option<FrameLog>,
    ) -> Self {
        let mut state = egui_winit::State::new(
            ctx.clone(),
            ViewportId::ROOT,
            event_loop,
            Some(window.scale_factor() as f32),
            event_loop.system_theme(),
            surface.max_texture_side(),
        );
        state.init_accesskit(event_loop, &window, proxy.clone());
        let events = proxy.clone();
        file_dialog::detect(move || drop(events.send_event(UserEvent::FileDialog)));
        let (mut app, first) = first_pass.end();
        let mut info = ViewportInfo::default();
        egui_winit::update_viewport_info(&mut info, &ctx, &window, true);
        // Computed before the input is locked, because it takes the same lock.
        let pixels_per_point = egui_winit::pixels_per_point(&ctx, &window);
        ctx.input_mut(|input| {
            input.raw.viewports.insert(ViewportId::ROOT, info.clone());
            input.pixels_per_point = pixels_per_point;
        });
        app.set_renderer_name(format!("{} ({detail})", renderer.name()));
        let mut open = Self {
            app,
            log,
            state,
            ctx,
            info,
            delta: first.textures_delta,
            textures: Textures::default(),
            actions: Vec::new(),
            repaint_at: None,
            redraw_requested: false,
            whole_due: None,
            input_since: None,
            maximizing: false,
            shown: None,
            began: Instant::now(),
            pace: pace(renderer, &window),
            last_check: Instant::now(),
            proxy,
            file_dialog: None,
            file_dialogs: 0,
            surface: Some(surface),
            renderer,
            window,
        };
        open.apply(commands(first.viewport_output));
        open
    }

    /// Ends the app, which saves its state for the last time.
    pub(super) fn end(mut self) {
        self.ctx.on_exit();
        self.app.on_exit();
        if let Some(log) = &self.log
            && let Err(error) = log.save()
        {
            complain(&format!("{}: {error}", log.path.display()));
        }
        self.delta.clear();
    }

    fn repaint_by(&mut self, when: Instant) {
        self.repaint_at = Some(self.repaint_at.map_or(when, |at| at.min(when)));
    }

    /// Requests a redraw that is due, or sets the timer for a later one.
    pub(super) fn schedule(&mut self, event_loop: &ActiveEventLoop) {
        let now = Instant::now();
        if now >= self.last_check + CHECK_INTERVAL {
            self.last_check = now;
            if self.app.look_at_file() {
                self.repaint_by(now);
            }
        }
        if self.repaint_at.is_some_and(|at| at <= now) {
            self.repaint_at = None;
            self.redraw_requested = true;
            self.window.request_redraw();
        }
        let check = self.app.watches_file().then(|| self.last_check + CHECK_INTERVAL);
        let next = self.repaint_at.into_iter().chain(check).min();
        event_loop.set_control_flow(next.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }

    pub(super) fn window_event(
        &mut self,
        event_loop: &ActiveEventLoop,
        event: &WindowEvent,
    ) -> Result<bool, String> {
        match event {
            WindowEvent::RedrawRequested => {
                // A redraw that this program did not request comes from the display, which has lost the
                // picture.
                let exposed = !std::mem::take(&mut self.redraw_requested);
                return self.frame(event_loop, exposed);
            }
            WindowEvent::CloseRequested => {
                self.info.events.push(ViewportEvent::Close);
                // Not delayed: a hidden window gets no redraws, but must be closable.
                return self.frame(event_loop, false);
            }
            WindowEvent::Occluded(occluded) => self.info.occluded = Some(*occluded),
            // The window may be hidden next, which not every display reports.
            WindowEvent::Focused(false) => self.app.rest(),
            _ if is_idle(event, &self.ctx) => return Ok(false),
            _ => {}
        }
        let response = self.state.on_window_event(&self.window, event);
        if response.repaint {
            self.input_since.get_or_insert_with(Instant::now);
            self.repaint_by(Instant::now());
        }
        Ok(false)
    }

    /// Handles an event other than the window's own events. Returns true if the window should be closed.
    pub(super) fn user_event(
        &mut self,
        event_loop: &ActiveEventLoop,
        event: UserEvent,
    ) -> Result<bool, String> {
        match event {
            // The user is not asked: changes are saved to a separate file, and offered at the next
            // start.
            UserEvent::End => return Ok(true),
            UserEvent::Repaint { when, pass } => {
                // A request is outdated if it comes from a pass before the last two.
                let now = self.ctx.cumulative_pass_nr();
                if now == pass || now == pass + 1 {
                    self.repaint_by(when.max(self.began + self.pace));
                }
            }
            UserEvent::FileDialog => self.app.use_desktop_dialog(),
            UserEvent::File(number, answer) => {
                if number == self.file_dialogs && self.file_dialog.take().is_some() {
                    self.app.answer_file(answer);
                    self.repaint_by(Instant::now());
                }
            }
            UserEvent::Accessibility(event) => match event.window_event {
                accesskit_winit::WindowEvent::InitialTreeRequested => {
                    self.ctx.enable_accesskit();
                    return self.frame(event_loop, false);
                }
                accesskit_winit::WindowEvent::ActionRequested(request) => {
                    self.state.on_accesskit_action_request(request);
                    self.repaint_by(Instant::now());
                }
                accesskit_winit::WindowEvent::AccessibilityDeactivated => {
                    self.ctx.disable_accesskit();
                }
            },
        }
        Ok(false)
    }

    /// Handles a raw motion of the mouse, which is reported even if the pointer cannot move further.
    pub(super) fn mouse_motion(&mut self, delta: (f64, f64)) -> Result<bool, String> {
        if self.state.on_mouse_motion(delta) {
            self.repaint_by(Instant::now());
        }
        Ok(false)
    }

    /// Runs the app once and paints. Returns true if the window should be closed.
    pub(super) fn frame(
        &mut self,
        event_loop: &ActiveEventLoop,
        exposed: bool,
    ) -> Result<bool, String> {
        let began = Instant::now();
        self.look_at_window(began);
        let closing = self.info.close_requested();
        let visible = self.info.visible().unwrap_or(true)
            || self.actions.iter().any(ActionRequested::wants_paint);
        if !visible && !closing {
            self.app.rest();
            // The input waits until the window is visible again.
            return Ok(false);
        }
        self.began = began;
        self.repaint_at = self.repaint_at.filter(|&at| at > began);
        let mut input = self.state.take_egui_input(&self.window);
        input.viewports.insert(ViewportId::ROOT, self.info.clone());
        let zoom = self.ctx.zoom_factor();
        let mut output = self.ctx.run_ui(input, |ui| self.app.ui(ui));
        self.ask_for_file();
        self.keep_pointer(zoom);
        self.info.events.clear();
        let ui_done = began.elapsed();
        let commands = commands(std::mem::take(&mut output.viewport_output));
        if closing && !commands.contains(&ViewportCommand::CancelClose) {
            output.drop_without_applying_deltas();
            return Ok(true);
        }
        if closing && self.info.minimized == Some(true) {
            // The app must ask the user something before it closes.
            self.window.set_minimized(false);
        }
        self.paint(event_loop, output, began, ui_done, exposed)?;
        self.apply(commands);
        Ok(false)
    }

    /// Opens the desktop's file dialog if the app requests one, and closes it once the app no longer
    /// requests it.
    fn ask_for_file(&mut self) {
        let Some(request) = self.app.file_request() else {
            self.file_dialog = None;
            return;
        };
        if self.file_dialog.is_none() {
            self.file_dialogs += 1;
            let (number, proxy) = (self.file_dialogs, self.proxy.clone());
            let tell = move |answer| drop(proxy.send_event(UserEvent::File(number, answer)));
            self.file_dialog = Some(file_dialog::ask(request, &self.window, tell));
        }
    }

    /// Corrects the pointer's position in egui, which is in points, when the zoom changes. Without the
    /// correction, egui would use an outdated position until the mouse moves.
    fn keep_pointer(&mut self, before: f32) {
        let ratio = before / self.ctx.zoom_factor();
        if let (true, Some(pointer)) = (ratio != 1.0, self.ctx.pointer_latest_pos()) {
            let there = egui::Event::PointerMoved((ratio * pointer.to_vec2()).to_pos2());
            self.state.egui_input_mut().events.push(there);
            self.repaint_by(Instant::now());
        }
    }

    /// Updates the stored information about the window.
    fn look_at_window(&mut self, now: Instant) {
        const PATIENCE: Duration = Duration::from_secs(2);
        egui_winit::update_viewport_info(&mut self.info, &self.ctx, &self.window, false);
        // Between being shown and being maximised, the window briefly has a size and place that must not
        // be remembered as its normal ones.
        let late = self.shown.is_some_and(|shown| now > shown + PATIENCE);
        self.maximizing &= self.info.maximized != Some(true) && !late;
        if self.maximizing {
            self.info.maximized = Some(true);
        }
    }

    fn paint(
        &mut self,
        event_loop: &ActiveEventLoop,
        output: FullOutput,
        began: Instant,
        ui: Duration,
        exposed: bool,
    ) -> Result<(), String> {
        let FullOutput { platform_output, textures_delta, shapes, pixels_per_point, .. } = output;
        self.delta.append(textures_delta);
        self.state.handle_platform_output_with_event_loop(
            &self.window,
            event_loop,
            platform_output,
        );
        let size = self.window.inner_size();
        if size.width == 0 || size.height == 0 {
            return Ok(());
        }
        let exposed = self.presents_whole(began, exposed);
        let Some(surface) = &mut self.surface else { return Ok(()) };
        let primitives = self.ctx.tessellate(shapes, pixels_per_point);
        if self.renderer != Renderer::Cpu {
            self.textures.note(&self.delta);
        }
        let frame = WindowFrame {
            window: &self.window,
            size: [size.width, size.height],
            pixels_per_point,
            ground: self.ctx.global_style().visuals.panel_fill.to_opaque(),
            primitives,
            delta: &mut self.delta,
            screenshots: take_screenshots(&mut self.actions),
            exposed,
        };
        let wait = match surface.paint(frame) {
            Ok(wait) => wait,
            Err(reason) => return self.go_on_without(event_loop, reason),
        };
        if self.shown.is_none() {
            self.shown = Some(Instant::now());
            self.window.set_visible(true);
            if self.maximizing {
                // X11's window managers ignore this for a window that is not visible.
                self.window.set_maximized(true);
            }
        }
        let now = Instant::now();
        let (frame, input) = (now - began, self.input_since.take());
        if let Some(log) = &mut self.log {
            let since_input = input.map(|since| now - since);
            let paint = frame.saturating_sub(ui + wait);
            log.add(since_input, [frame, ui, paint, wait], self.app.work_presented());
        }
        Ok(())
    }

    /// Returns true if the frame must present the whole picture, not only its changes.
    ///
    /// X11 can report the loss of a part in the same event as a redraw that the program requested. But a
    /// whole picture takes the display some milliseconds, and the next frame waits for it. So the frames
    /// of a drag present their changes, and one frame a second, or one after the last of them, the whole.
    fn presents_whole(&mut self, now: Instant, exposed: bool) -> bool {
        let keeps_picture = self.surface.as_ref().is_none_or(|surface| surface.keeps_picture());
        let due = self.whole_due.is_some_and(|due| due <= now);
        if keeps_picture || exposed || due {
            self.whole_due = None;
        } else {
            let due = *self.whole_due.get_or_insert(now + WHOLE_INTERVAL);
            self.repaint_by(due);
        }
        exposed || due
    }

    /// Draws the window on the CPU from now on, because the graphics driver failed.
    fn go_on_without(
        &mut self,
        event_loop: &ActiveEventLoop,
        reason: String,
    ) -> Result<(), String> {
        // Saves unsaved changes first, in case anything else fails.
        self.app.rest();
        self.delta.clear();
        let failed = self.surface.take();
        if self.renderer == Renderer::Cpu {
            return Err(lost(reason));
        }
        // The lost surface is dropped first, because some displays let only one renderer draw to a
        // window. The driver may fail even while its surface is dropped.
        let _ = without_panic(|| drop(failed));
        let cpu = Cpu::new(event_loop, &self.window)
            .map_err(|error| lost(format!("{reason}; on the CPU: {error}")))?;
        if let Some(side) = cpu.max_texture_side() {
            self.state.set_max_texture_side(side);
        }
        self.surface = Some(Box::new(cpu));
        self.renderer = Renderer::Cpu;
        self.pace = pace(self.renderer, &self.window);
        self.delta.append(std::mem::take(&mut self.textures).all(&self.ctx));
        self.app.set_renderer_name(format!(
            "{} (the graphics driver failed: {reason})",
            self.renderer.name()
        ));
        let why = format!("The graphics driver failed: {reason}");
        self.app.say("The window is drawn on the CPU now".to_owned(), vec![why]);
        // Requests the pass in which the app shows this.
        self.ctx.request_repaint();
        Ok(())
    }

    /// Executes the app's requests to the window.
    fn apply(&mut self, commands: Vec<ViewportCommand>) {
        let (ctx, window) = (&self.ctx, &self.window);
        egui_winit::process_viewport_commands(
            ctx,
            &mut self.info,
            commands,
            window,
            &mut self.actions,
        );
        let (later, now) = std::mem::take(&mut self.actions)
            .into_iter()
            .partition::<Vec<_>, _>(ActionRequested::wants_paint);
        for action in now {
            let event = match action {
                ActionRequested::Cut => Some(egui::Event::Cut),
                ActionRequested::Copy => Some(egui::Event::Copy),
                ActionRequested::Paste => {
                    let text = self.state.clipboard_text().filter(|text| !text.is_empty());
                    text.map(|text| egui::Event::Paste(text.replace("\r\n", "\n")))
                }
                ActionRequested::Screenshot(_) | ActionRequested::PaintWhileHidden => None,
            };
            self.state.egui_input_mut().events.extend(event);
            self.repaint_by(Instant::now());
        }
        if !later.is_empty() || self.info.close_requested() {
            self.repaint_by(Instant::now());
        }
        self.actions = later;
    }
}

/// Returns the app's requests to the window.
fn commands(mut outputs: OrderedViewportIdMap<ViewportOutput>) -> Vec<ViewportCommand> {
    outputs.remove(&ViewportId::ROOT).map(|output| output.commands).unwrap_or_default()
}

/// Returns the requests for a screenshot of the next frame. Drops all other requests, which only ask for
/// a frame to be painted.
fn take_screenshots(actions: &mut Vec<ActionRequested>) -> Vec<ScreenshotCallback> {
    let screenshots = actions.drain(..).filter_map(|action| match action {
        ActionRequested::Screenshot(callback) => Some(callback),
        _ => None,
    });
    screenshots.collect()
}

/// Characters whose keys step or zoom repeatedly while held.
const STEPPING: [&str; 5] = [",", ".", "+", "-", "="];

/// Returns true if an event only repeats a held key and can be ignored: the key types no text, Ctrl is not
/// held, and the key does not move or zoom in steps. Such a repeat would cost a frame, and would switch a
/// command on and off.
pub(super) fn is_idle(event: &WindowEvent, ctx: &Context) -> bool {
    let WindowEvent::KeyboardInput { event, .. } = event else { return false };
    let KeyEvent { repeat: true, state: ElementState::Pressed, logical_key, .. } = event else {
        return false;
    };
    let is_taken = ctx.text_edit_focused() || ctx.input(|i| i.modifiers.command);
    !is_taken && !steps(logical_key)
}

/// Returns true if a key repeats its action while held.
fn steps(key: &Key) -> bool {
    use NamedKey::*;
    const NAMED: [NamedKey; 9] =
        [ArrowLeft, ArrowRight, ArrowUp, ArrowDown, PageUp, PageDown, Tab, Backspace, Delete];
    match key {
        Key::Named(named) => NAMED.contains(named),
        Key::Character(character) => STEPPING.contains(&character.as_str()),
        Key::Unidentified(_) | Key::Dead(_) => false,
    }
}
