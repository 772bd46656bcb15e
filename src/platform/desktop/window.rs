//! The window's event loop. It passes input to egui, and egui's output to a renderer and the desktop.
//!
//! All renderers share one loop. It sleeps until there is input or egui's next repaint is due.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::window::WindowId;

use super::display::{UserEvent, event_loop, lost, reason_of_end};
use super::frames::{FirstPass, FrameLog};
use super::open::Open;
use super::{signals, start};
use crate::cli::arguments::Renderer;
use crate::model::fault::caught;
use crate::model::store::WindowGeometry;
use crate::ui::app::App;

/// Opens the window and returns when it is closed. `choice` is the renderer that the user
/// requested; `None` chooses the best renderer that works.
///
/// # Errors
/// Returns the reason as a sentence if the window cannot open or can no longer be drawn.
pub(super) fn run(
    choice: Option<Renderer>,
    geometry: WindowGeometry,
    app: App,
    log: Option<FrameLog>,
) -> Result<(), String> {
    let ctx = start::context();
    let first_pass = FirstPass::start(ctx.clone(), app, geometry);
    let event_loop = match event_loop() {
        Ok(event_loop) => event_loop,
        Err(error) => {
            first_pass.discard();
            return Err(error);
        }
    };
    event_loop.set_control_flow(ControlFlow::Wait);
    let mut handler = Handler {
        choice,
        geometry,
        ctx,
        first: Some((first_pass, log)),
        proxy: event_loop.create_proxy(),
        open: None,
        failure: None,
    };
    let ended = caught(|| event_loop.run_app(&mut handler).map_err(|error| reason_of_end(&error)));
    handler.finish();
    match handler.failure {
        Some(failure) => Err(failure),
        None => ended.flatten().map_err(lost),
    }
}

struct Handler {
    choice: Option<Renderer>,
    geometry: WindowGeometry,
    ctx: egui::Context,
    /// The app's first pass and the frame log; `None` once the window is open.
    first: Option<(FirstPass, Option<FrameLog>)>,
    proxy: EventLoopProxy<UserEvent>,
    open: Option<Open>,
    failure: Option<String>,
}

impl Handler {
    /// Opens the window and paints its first frame. Returns true if the app closes it at once.
    fn start(&mut self, event_loop: &ActiveEventLoop) -> Result<bool, String> {
        let builder = start::builder(self.geometry, event_loop);
        let drawn = start::surface(self.choice, &self.ctx, event_loop, &builder)?;
        let Some((first_pass, log)) = self.first.take() else { return Ok(false) };
        let proxy = Mutex::new(self.proxy.clone());
        self.ctx.set_request_repaint_callback(move |info| {
            let when = Instant::now() + info.delay;
            let event = UserEvent::Repaint { when, pass: info.current_cumulative_pass_nr };
            // Sending fails only when the event loop has ended, and nothing needs to be painted any
            // more.
            let _ = proxy.lock().unwrap_or_else(PoisonError::into_inner).send_event(event);
        });
        let proxy = self.proxy.clone();
        signals::end_window_by(move || drop(proxy.send_event(UserEvent::End)));
        let (ctx, proxy) = (self.ctx.clone(), self.proxy.clone());
        let mut open = Open::new(event_loop, ctx, drawn, proxy, first_pass, log);
        open.maximizing = self.geometry.maximized;
        // Paint before showing the window, to avoid a flash of an empty window.
        let closed = open.frame(event_loop, true)?;
        self.open = Some(open);
        Ok(closed)
    }

    /// Runs a function on the open window. Ends the program if the function returns an error or true.
    fn with(
        &mut self,
        event_loop: &ActiveEventLoop,
        run: impl FnOnce(&mut Open) -> Result<bool, String>,
    ) {
        let Some(open) = &mut self.open else { return };
        match run(open) {
            Ok(false) => open.schedule(event_loop),
            ended => self.end(event_loop, ended),
        }
    }

    /// Ends the program if `ended` is an error or true.
    fn end(&mut self, event_loop: &ActiveEventLoop, ended: Result<bool, String>) {
        if ended != Ok(false) {
            self.failure = ended.err();
            event_loop.exit();
        }
    }

    fn finish(&mut self) {
        if let Some((first_pass, _)) = self.first.take() {
            first_pass.discard();
        }
        if let Some(open) = self.open.take() {
            open.end();
        }
    }
}

impl ApplicationHandler<UserEvent> for Handler {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.first.is_some() {
            let ended = self.start(event_loop);
            self.end(event_loop, ended);
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
            self.with(event_loop, |open| open.mouse_motion(delta));
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: UserEvent) {
        self.with(event_loop, |open| open.user_event(event_loop, event));
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        // The display still exists here; windows must be dropped before it.
        self.finish();
    }
}
