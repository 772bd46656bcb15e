//! The window's event loop, which passes input to egui, and egui's output to a renderer and the
//! desktop.
//!
//! All renderers share one loop. It sleeps until there is input or until egui asked to be woken.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::window::WindowId;

use super::display::{PresentError, UserEvent, event_loop, reason_of_end};
use super::frames::{FirstPass, FrameLog};
use super::open::Open;
use super::{signals, start};
use crate::cli::arguments::Renderer;
use crate::model::fault::caught;
use crate::model::store::WindowGeometry;
use crate::ui::app::App;

/// Opens the window and returns when it is closed. `choice` is the renderer that the user
/// requested; `None` chooses the best renderer that works.
pub(super) fn run(
    choice: Option<Renderer>,
    geometry: WindowGeometry,
    app: App,
    log: Option<FrameLog>,
) -> Result<(), PresentError> {
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
        None => ended.flatten().map_err(PresentError::Lost),
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
    failure: Option<PresentError>,
}

impl Handler {
    fn start(&mut self, event_loop: &ActiveEventLoop) -> Result<(), PresentError> {
        if self.first.is_none() {
            return Ok(());
        }
        let builder = start::builder(self.geometry, event_loop);
        let drawn = start::surface(self.choice, &self.ctx, event_loop, &builder)?;
        let Some((first_pass, log)) = self.first.take() else { return Ok(()) };
        let proxy = Mutex::new(self.proxy.clone());
        self.ctx.set_request_repaint_callback(move |info| {
            let when = Instant::now() + info.delay;
            let event = UserEvent::Repaint { when, pass: info.current_cumulative_pass_nr };
            // Sending fails only at the very end, when nothing needs to be painted.
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
            // The user is not asked: changes are saved to a separate file, and offered at the next
            // start.
            UserEvent::End => Ok(true),
            UserEvent::Repaint { when, pass } => {
                open.wake(when, pass);
                Ok(false)
            }
            UserEvent::FileDialog => {
                open.use_desktop_dialog();
                Ok(false)
            }
            UserEvent::File(number, answer) => {
                open.answer_file(number, answer);
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
