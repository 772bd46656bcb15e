//! The window's event loop, which passes input to egui, and egui's output to a [`Surface`] and the
//! desktop.
//!
//! All renderers share one loop. It sleeps until there is input or until egui asked to be woken.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use egui::ScreenshotCallback;
use egui::epaint::{ClippedPrimitive, textures::TexturesDelta};
use egui_winit::accesskit_winit;
use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

use super::open::Open;
use super::{PresentError, RendererInfo, WindowOptions, start};
use crate::cli::arguments::Renderer;
use crate::ui::program::Program;

/// A renderer of the window.
pub(super) trait Surface {
    /// Returns the renderer's description.
    fn info(&self) -> &RendererInfo;

    /// Returns the maximum side of a texture.
    fn max_texture_side(&self) -> Option<usize>;

    /// Draws a frame and presents it.
    fn paint(&mut self, frame: Frame<'_>) -> Result<PaintTimes, String>;
}

/// The parts of the painting time that are not drawing.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PaintTimes {
    /// Time for uploading textures; zero unless the frame is timed.
    pub(super) upload: Duration,
    /// Time for waiting for the display.
    pub(super) wait: Duration,
}

/// Runs a function and returns its duration, or zero if no time is requested.
pub(super) fn timed(is_asked: bool, run: impl FnOnce()) -> Duration {
    let start = is_asked.then(Instant::now);
    run();
    start.map_or(Duration::ZERO, |start| start.elapsed())
}

/// A frame to draw.
pub(super) struct Frame<'a> {
    pub(super) window: &'a Arc<Window>,
    /// The window's size in pixels, not zero.
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    /// The background colour.
    pub(super) ground: egui::Color32,
    pub(super) primitives: Vec<ClippedPrimitive>,
    /// Changes of textures; the renderer takes them out.
    pub(super) delta: &'a mut TexturesDelta,
    /// The requests for a copy of the picture.
    pub(super) screenshots: Vec<ScreenshotCallback>,
    /// True if the display may have lost its picture.
    pub(super) exposed: bool,
    /// True if the time of the upload is requested.
    pub(super) is_timed: bool,
}

/// An event, apart from the window's own events, that wakes the event loop.
#[derive(Debug)]
pub(super) enum UserEvent {
    /// A repaint that egui requested.
    Repaint {
        when: Instant,
        /// The pass that requested it. A request is out of date once others have run since.
        pass: u64,
    },
    /// A request of a screen reader or a similar tool.
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
            // Sending fails only at the very end, when nothing needs to be painted.
            let _ = proxy.lock().unwrap_or_else(PoisonError::into_inner).send_event(event);
        });
        let maximized = self.options.geometry.maximized;
        let proxy = self.proxy.clone();
        let mut open = Open::new(event_loop, ctx, window, surface, proxy, make_program, maximized);
        // Paint before showing the window, to avoid a flash of an empty window.
        let closed = open.frame(event_loop, true)?;
        self.open = Some(open);
        if closed {
            event_loop.exit();
        }
        Ok(())
    }

    /// Runs a function on the open window; an error or `true` ends the program.
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
        if let Some(open) = self.open.take() {
            open.end();
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
                open.mouse_motion(delta);
                Ok(false)
            });
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: UserEvent) {
        self.with(event_loop, |open| match event {
            UserEvent::Repaint { when, pass } => {
                open.wake(when, pass);
                Ok(false)
            }
            UserEvent::Accessibility(event) => open.accessibility(event_loop, event.window_event),
        });
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        // The display still exists here; windows must be dropped before it.
        self.finish();
    }
}
