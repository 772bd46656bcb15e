//! The window's event loop: input to egui, egui's output to a [`Surface`] and the desktop.
//!
//! One loop for all renderers. It sleeps until there is input or until egui asked to be woken.

use super::start;
use super::{FrameTimes, PresentError, Program, Renderer, RendererInfo, WindowOptions};
use egui::epaint::{ClippedPrimitive, textures::TexturesDelta};
use egui::{
    FullOutput, ScreenshotCallback, ViewportCommand, ViewportEvent, ViewportId, ViewportInfo,
};
use egui_winit::{ActionRequested, accesskit_winit};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

/// What draws into the window.
pub(super) trait Surface {
    /// Who it is.
    fn info(&self) -> &RendererInfo;

    /// The longest side that a texture may have.
    fn max_texture_side(&self) -> Option<usize>;

    /// Draws a frame and hands it to the display. Tells how long it waited for the display.
    fn paint(&mut self, frame: Frame<'_>) -> Result<Duration, String>;
}

/// What is to be drawn.
pub(super) struct Frame<'a> {
    pub(super) window: &'a Arc<Window>,
    /// The window's size in pixels, not zero.
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    /// What is seen where nothing is drawn.
    pub(super) ground: egui::Color32,
    pub(super) primitives: Vec<ClippedPrimitive>,
    /// Changes of textures, to be taken out.
    pub(super) delta: &'a mut TexturesDelta,
    /// Who wants to have the picture.
    pub(super) screenshots: Vec<ScreenshotCallback>,
    /// The display may have lost what it showed.
    pub(super) exposed: bool,
}

/// What wakes the event loop, apart from the window's own events.
#[derive(Debug)]
pub(super) enum UserEvent {
    /// egui wants to be run again.
    Repaint {
        when: Instant,
        /// The pass that asked. A request is out of date when others have been run since.
        pass: u64,
    },
    /// A screen reader or the like wants something.
    Accessibility(accesskit_winit::Event),
}

impl From<accesskit_winit::Event> for UserEvent {
    fn from(event: accesskit_winit::Event) -> Self {
        Self::Accessibility(event)
    }
}

/// Runs the event loop until the window is closed.
pub(super) fn run<F>(
    event_loop: EventLoop<UserEvent>,
    choice: Option<Renderer>,
    options: WindowOptions,
    make_program: F,
) -> Result<(), PresentError>
where
    F: FnOnce(&egui::Context, &RendererInfo) -> Box<dyn Program>,
{
    event_loop.set_control_flow(ControlFlow::Wait);
    let mut handler = Handler {
        choice,
        options,
        make_program: Some(make_program),
        proxy: event_loop.create_proxy(),
        open: None,
        failure: None,
    };
    let ended = event_loop.run_app(&mut handler);
    handler.finish();
    match (handler.failure, ended) {
        (Some(failure), _) => Err(failure),
        (None, Err(error)) => Err(PresentError::Lost(error.to_string())),
        (None, Ok(())) => Ok(()),
    }
}

struct Handler<F> {
    choice: Option<Renderer>,
    options: WindowOptions,
    make_program: Option<F>,
    proxy: EventLoopProxy<UserEvent>,
    open: Option<Open>,
    failure: Option<PresentError>,
}

impl<F> Handler<F>
where
    F: FnOnce(&egui::Context, &RendererInfo) -> Box<dyn Program>,
{
    fn start(&mut self, event_loop: &ActiveEventLoop) -> Result<(), PresentError> {
        let Some(make_program) = self.make_program.take() else { return Ok(()) };
        let ctx = start::context();
        let builder = start::builder(&self.options, event_loop);
        let (window, surface) = start::surface(self.choice, &ctx, event_loop, &builder)?;
        let proxy = Mutex::new(self.proxy.clone());
        ctx.set_request_repaint_callback(move |info| {
            let when = Instant::now() + info.delay;
            let event = UserEvent::Repaint { when, pass: info.current_cumulative_pass_nr };
            // The loop is gone only at the very end, when nothing needs to be painted.
            let _ = proxy.lock().unwrap_or_else(PoisonError::into_inner).send_event(event);
        });
        let mut state = egui_winit::State::new(
            ctx.clone(),
            ViewportId::ROOT,
            event_loop,
            Some(window.scale_factor() as f32),
            event_loop.system_theme(),
            surface.max_texture_side(),
        );
        state.init_accesskit(event_loop, &window, self.proxy.clone());
        let mut info = ViewportInfo::default();
        egui_winit::update_viewport_info(&mut info, &ctx, &window, true);
        // Asked for before the input is locked, since it takes the same lock.
        let pixels_per_point = egui_winit::pixels_per_point(&ctx, &window);
        ctx.input_mut(|input| {
            input.raw.viewports.insert(ViewportId::ROOT, info.clone());
            input.pixels_per_point = pixels_per_point;
        });
        let program = make_program(&ctx, surface.info());
        let mut open = Open {
            program,
            state,
            ctx,
            info,
            delta: TexturesDelta::default(),
            actions: Vec::new(),
            repaint_at: None,
            asked: false,
            input_since: None,
            maximize: self.options.geometry.maximized,
            shown: false,
            began: Instant::now(),
            pace: start::pace(surface.info().renderer, &window),
            surface,
            window,
        };
        // Painted before it is shown: no flash of an empty window.
        let closed = open.frame(event_loop, true)?;
        self.open = Some(open);
        if closed {
            event_loop.exit();
        }
        Ok(())
    }

    /// Runs something on the open window; a failure or `true` ends the program.
    fn with(
        &mut self,
        event_loop: &ActiveEventLoop,
        run: impl FnOnce(&mut Open) -> Result<bool, PresentError>,
    ) {
        let Some(open) = &mut self.open else { return };
        match run(open) {
            Ok(false) => open.schedule(event_loop),
            Ok(true) => event_loop.exit(),
            Err(failure) => {
                self.failure = Some(failure);
                event_loop.exit();
            }
        }
    }

    fn finish(&mut self) {
        if let Some(mut open) = self.open.take() {
            open.ctx.on_exit();
            open.program.on_exit();
            open.delta.clear();
        }
    }
}

impl<F> ApplicationHandler<UserEvent> for Handler<F>
where
    F: FnOnce(&egui::Context, &RendererInfo) -> Box<dyn Program>,
{
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if let Err(failure) = self.start(event_loop) {
            self.failure = Some(failure);
            event_loop.exit();
        }
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _: StartCause) {
        self.with(event_loop, |_| Ok(false));
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        self.with(event_loop, |open| open.window_event(event_loop, &event));
    }

    fn device_event(&mut self, event_loop: &ActiveEventLoop, _: DeviceId, event: DeviceEvent) {
        if let DeviceEvent::MouseMotion { delta } = event {
            self.with(event_loop, |open| {
                if open.state.on_mouse_motion(delta) {
                    open.repaint_by(Instant::now());
                }
                Ok(false)
            });
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: UserEvent) {
        self.with(event_loop, |open| match event {
            UserEvent::Repaint { when, pass } => {
                let now = open.ctx.cumulative_pass_nr();
                if now == pass || now == pass + 1 {
                    open.repaint_by(when.max(open.began + open.pace));
                }
                Ok(false)
            }
            UserEvent::Accessibility(event) => open.accessibility(event_loop, event.window_event),
        });
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        // While the display is still there: windows are to be dropped before it.
        self.finish();
    }
}

/// The window while it is open.
///
/// The order of the fields is the order of their end: the window goes last.
struct Open {
    surface: Box<dyn Surface>,
    program: Box<dyn Program>,
    state: egui_winit::State,
    ctx: egui::Context,
    info: ViewportInfo,
    /// Changes of textures that no frame has taken yet.
    delta: TexturesDelta,
    actions: Vec<ActionRequested>,
    repaint_at: Option<Instant>,
    /// The next `RedrawRequested` is one that was asked for here.
    asked: bool,
    /// When the first of the input events came that no frame has answered yet.
    input_since: Option<Instant>,
    maximize: bool,
    shown: bool,
    /// When the last frame was begun, and how long after it one that is only animation may follow.
    began: Instant,
    pace: Duration,
    window: Arc<Window>,
}

impl Open {
    fn repaint_by(&mut self, when: Instant) {
        self.repaint_at = Some(self.repaint_at.map_or(when, |at| at.min(when)));
    }

    /// Asks for a redraw that is due, and sets the alarm for one that is not.
    fn schedule(&mut self, event_loop: &ActiveEventLoop) {
        if self.repaint_at.is_some_and(|at| at <= Instant::now()) {
            self.repaint_at = None;
            self.asked = true;
            self.window.request_redraw();
        }
        event_loop.set_control_flow(match self.repaint_at {
            Some(at) => ControlFlow::WaitUntil(at),
            None => ControlFlow::Wait,
        });
    }

    fn window_event(
        &mut self,
        event_loop: &ActiveEventLoop,
        event: &WindowEvent,
    ) -> Result<bool, PresentError> {
        match event {
            WindowEvent::RedrawRequested => {
                // One that nobody asked for comes from the display, which has lost the picture.
                let exposed = !std::mem::take(&mut self.asked);
                return self.frame(event_loop, exposed);
            }
            WindowEvent::CloseRequested => {
                self.info.events.push(ViewportEvent::Close);
                // At once: a hidden window is not redrawn, but has to be closable.
                return self.frame(event_loop, false);
            }
            WindowEvent::Occluded(occluded) => self.info.occluded = Some(*occluded),
            _ => {}
        }
        let response = self.state.on_window_event(&self.window, event);
        if response.repaint {
            self.input_since.get_or_insert_with(Instant::now);
            self.repaint_by(Instant::now());
        }
        Ok(false)
    }

    fn accessibility(
        &mut self,
        event_loop: &ActiveEventLoop,
        event: accesskit_winit::WindowEvent,
    ) -> Result<bool, PresentError> {
        match event {
            accesskit_winit::WindowEvent::InitialTreeRequested => {
                self.ctx.enable_accesskit();
                return self.frame(event_loop, false);
            }
            accesskit_winit::WindowEvent::ActionRequested(request) => {
                self.state.on_accesskit_action_request(request);
                self.repaint_by(Instant::now());
            }
            accesskit_winit::WindowEvent::AccessibilityDeactivated => self.ctx.disable_accesskit(),
        }
        Ok(false)
    }

    /// Runs the program once and paints. `true`: the window is to be closed.
    fn frame(&mut self, event_loop: &ActiveEventLoop, exposed: bool) -> Result<bool, PresentError> {
        let began = Instant::now();
        egui_winit::update_viewport_info(&mut self.info, &self.ctx, &self.window, false);
        let closing = self.info.close_requested();
        let visible = self.info.visible().unwrap_or(true)
            || self.actions.iter().any(ActionRequested::wants_paint);
        if !visible && !closing {
            // Its input waits until it is seen again.
            return Ok(false);
        }
        self.began = began;
        self.repaint_at = self.repaint_at.filter(|&at| at > began);
        let mut input = self.state.take_egui_input(&self.window);
        input.viewports.insert(ViewportId::ROOT, self.info.clone());
        let mut output = self.ctx.run_ui(input, |ui| self.program.ui(ui));
        self.info.events.clear();
        let ui_done = began.elapsed();
        let commands = output
            .viewport_output
            .remove(&ViewportId::ROOT)
            .map(|viewport| viewport.commands)
            .unwrap_or_default();
        if closing && !commands.contains(&ViewportCommand::CancelClose) {
            output.drop_without_applying_deltas();
            return Ok(true);
        }
        if closing && self.info.minimized == Some(true) {
            // The program wants to ask something first.
            self.window.set_minimized(false);
        }
        self.paint(event_loop, output, began, ui_done, exposed)?;
        self.apply(commands);
        Ok(false)
    }

    fn paint(
        &mut self,
        event_loop: &ActiveEventLoop,
        output: FullOutput,
        began: Instant,
        ui: Duration,
        exposed: bool,
    ) -> Result<(), PresentError> {
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
        let primitives = self.ctx.tessellate(shapes, pixels_per_point);
        let frame = Frame {
            window: &self.window,
            size: [size.width, size.height],
            pixels_per_point,
            ground: self.ctx.global_style().visuals.panel_fill.to_opaque(),
            primitives,
            delta: &mut self.delta,
            screenshots: take_screenshots(&mut self.actions),
            exposed,
        };
        let wait = self.surface.paint(frame).map_err(PresentError::Lost)?;
        if !std::mem::replace(&mut self.shown, true) {
            self.window.set_visible(true);
            if self.maximize {
                // X11's window managers ignore this for a window that is not shown.
                self.window.set_maximized(true);
            }
        }
        let now = Instant::now();
        let frame = now - began;
        self.program.presented(&FrameTimes {
            since_input: self.input_since.take().map(|since| now - since),
            frame,
            ui,
            paint: frame.saturating_sub(ui).saturating_sub(wait),
            wait,
        });
        Ok(())
    }

    /// Does what the program asked of the window.
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
            match action {
                ActionRequested::Cut => self.state.egui_input_mut().events.push(egui::Event::Cut),
                ActionRequested::Copy => self.state.egui_input_mut().events.push(egui::Event::Copy),
                ActionRequested::Paste => {
                    if let Some(text) = self.state.clipboard_text().filter(|text| !text.is_empty())
                    {
                        let event = egui::Event::Paste(text.replace("\r\n", "\n"));
                        self.state.egui_input_mut().events.push(event);
                    }
                }
                ActionRequested::Screenshot(_) | ActionRequested::PaintWhileHidden => {}
            }
            self.repaint_by(Instant::now());
        }
        if !later.is_empty() || self.info.close_requested() {
            self.repaint_by(Instant::now());
        }
        self.actions = later;
    }
}

/// The requests for a picture of the next frame; a request just to paint is thereby met.
fn take_screenshots(actions: &mut Vec<ActionRequested>) -> Vec<ScreenshotCallback> {
    let screenshots = actions.drain(..).filter_map(|action| match action {
        ActionRequested::Screenshot(callback) => Some(callback),
        _ => None,
    });
    screenshots.collect()
}
