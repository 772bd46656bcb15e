//! Opens the window and chooses its renderer.

use std::io::Cursor;
use std::sync::Arc;
use std::time::Duration;

use egui::ViewportBuilder;
use winit::event_loop::ActiveEventLoop;
use winit::window::Window;

use super::cpu::Cpu;
use super::display::cause;
#[cfg(feature = "wgpu")]
use super::gpu::Gpu;
use super::surface::WindowSurface;
use crate::cli::arguments::Renderer;
use crate::model::store::WindowGeometry;

/// Returns egui's context, configured for the window.
pub(super) fn context() -> egui::Context {
    let ctx = egui::Context::default();
    // There is only one window: egui shows inside it any viewport that would otherwise get a window of
    // its own.
    ctx.set_embed_viewports(true);
    ctx.options_mut(|options| {
        options.max_passes = options.max_passes.max(std::num::NonZeroUsize::MIN.saturating_add(1));
    });
    ctx
}

/// Returns the settings of the window to open, with its size and place limited to the screens.
pub(super) fn builder(geometry: WindowGeometry, event_loop: &ActiveEventLoop) -> ViewportBuilder {
    let screens: Vec<egui::Rect> = event_loop
        .available_monitors()
        .map(|monitor| {
            let scale = monitor.scale_factor();
            let (position, size) = (monitor.position(), monitor.size());
            let point = |x: i32, y: i32| egui::pos2(x as f32, y as f32) / scale as f32;
            egui::Rect::from_min_max(
                point(position.x, position.y),
                point(position.x + size.width as i32, position.y + size.height as i32),
            )
        })
        .collect();
    let mut builder = ViewportBuilder::default()
        .with_title("Pinhole")
        .with_app_id("pinhole")
        .with_inner_size(size_on(&screens, geometry.inner_size.into()))
        .with_min_inner_size([320.0, 240.0])
        .with_maximized(geometry.maximized)
        .with_visible(false);
    if let Some(position) = geometry.position.map(egui::Pos2::from)
        && screens.iter().any(|screen| screen.contains(position))
    {
        builder = builder.with_position(position);
    }
    if let Some(icon) = icon() {
        builder = builder.with_icon(icon);
    }
    builder
}

/// Room for the window's frame and the desktop's bar, in points.
const FRAME: egui::Vec2 = egui::vec2(16.0, 80.0);

/// Returns the wanted size of the window's content, limited to fit on the largest screen.
fn size_on(screens: &[egui::Rect], wanted: egui::Vec2) -> egui::Vec2 {
    const LEAST: egui::Vec2 = egui::Vec2::splat(64.0);
    let largest = screens.iter().map(|screen| screen.size()).reduce(egui::Vec2::max);
    let room = largest.map_or(wanted, |screen| screen - FRAME);
    wanted.min(room).max(LEAST)
}

/// Returns the icon of the window; `None` if it cannot be read, in which case the window opens
/// without an icon.
fn icon() -> Option<egui::IconData> {
    let mut decoder = png::Decoder::new(Cursor::new(include_bytes!("../../../assets/icon.png")));
    decoder.set_transformations(png::Transformations::ALPHA);
    let mut reader = decoder.read_info().ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    Some(egui::IconData { rgba, width: info.width, height: info.height })
}

/// A window and its renderer.
pub(super) struct OpenWindow {
    pub(super) window: Arc<Window>,
    pub(super) surface: Box<dyn WindowSurface>,
    pub(super) renderer: Renderer,
    /// The adapter and its driver, or the reason why the CPU is used.
    pub(super) detail: String,
}

/// Opens a window and starts its renderer: the one that the user chose, otherwise the best that works.
///
/// # Errors
/// Returns the reason as a sentence if no window opens, or if the chosen renderer does not work.
pub(super) fn surface(
    choice: Option<Renderer>,
    ctx: &egui::Context,
    event_loop: &ActiveEventLoop,
    builder: &ViewportBuilder,
) -> Result<OpenWindow, String> {
    let refused = |cause| format!("the display refused to open a window: {cause}");
    let open = || {
        // The window is created by a context without zoom: the geometry is unzoomed, and the app's
        // context may already be zoomed.
        let window = egui_winit::create_window(&egui::Context::default(), event_loop, builder);
        window.map(Arc::new).map_err(|error| refused(cause(&error)))
    };
    #[cfg(feature = "wgpu")]
    let on_adapter = |by_hand| {
        let window = open()?;
        // Drivers can be broken in many ways, and wgpu panics on some of them.
        let gpu =
            super::display::without_panic(|| Gpu::new(ctx, event_loop, &window, by_hand)).flatten();
        Ok::<_, String>(gpu.map(|(gpu, detail)| OpenWindow {
            window,
            surface: Box::new(gpu),
            renderer: Renderer::Wgpu,
            detail,
        }))
    };
    #[cfg(not(feature = "wgpu"))]
    let on_adapter = |_| {
        let _ = ctx;
        Ok::<Result<OpenWindow, String>, String>(Err("this build has no feature wgpu".to_owned()))
    };
    let detail = if choice == Some(Renderer::Cpu) {
        "chosen by hand".to_owned()
    } else {
        let by_hand = choice == Some(Renderer::Wgpu);
        match on_adapter(by_hand)? {
            Ok(drawn) => return Ok(drawn),
            Err(error) if by_hand => {
                return Err(format!(
                    "no graphics adapter works: {error}; without one: pinhole --renderer cpu"
                ));
            }
            // Opens a new window, because this one may keep traces of the failed driver.
            Err(error) => error,
        }
    };
    let window = open()?;
    let cpu = Cpu::new(event_loop, &window).map_err(|error| refused(error.to_string()))?;
    Ok(OpenWindow { window, surface: Box::new(cpu), renderer: Renderer::Cpu, detail })
}

/// Returns the minimum time between two frames of an animation.
///
/// A graphics adapter waits for the display by itself. Our own painter, on the CPU, would draw as fast as it
/// can, and would keep a processor busy with frames that are never shown.
pub(super) fn pace(renderer: Renderer, window: &Window) -> Duration {
    const USUAL_MILLIHERTZ: u32 = 60_000;
    match renderer {
        Renderer::Wgpu => Duration::ZERO,
        Renderer::Cpu => {
            let monitor = window.current_monitor();
            let rate = monitor.and_then(|monitor| monitor.refresh_rate_millihertz());
            let rate = rate.filter(|&rate| rate > 0).unwrap_or(USUAL_MILLIHERTZ);
            Duration::from_secs_f64(1000.0 / f64::from(rate))
        }
    }
}

#[cfg(test)]
mod tests {
    use egui::{Rect, pos2, vec2};

    use super::*;

    #[test]
    fn the_icon_is_a_picture() {
        let icon = icon().expect("assets/icon.png is a PNG");
        assert_eq!(icon.rgba.len(), (icon.width * icon.height * 4) as usize);
        assert!(icon.rgba.chunks(4).any(|pixel| pixel != &icon.rgba[..4]));
    }

    #[test]
    fn the_window_with_its_frame_fits_on_the_screen() {
        let screen = |width, height| Rect::from_min_size(pos2(0.0, 0.0), vec2(width, height));
        let first = WindowGeometry::default().inner_size.into();
        assert_eq!(size_on(&[screen(1920.0, 1080.0)], first), first);
        assert_eq!(size_on(&[screen(1280.0, 800.0)], first), vec2(1264.0, 720.0));
        assert_eq!(size_on(&[screen(1024.0, 768.0), screen(1920.0, 1080.0)], first), first);
        assert_eq!(size_on(&[screen(10.0, 10.0)], first), vec2(64.0, 64.0));
        assert_eq!(size_on(&[], first), first);
    }
}
