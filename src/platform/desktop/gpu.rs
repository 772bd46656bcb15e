//! The window drawn by a graphics adapter. Only this file uses wgpu.

use std::num::NonZeroU32;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use egui::ViewportId;
use egui_wgpu::{
    RendererOptions, SurfaceConfig, SurfaceErrorAction, WgpuConfiguration, WgpuError, WgpuSetup,
    WgpuSetupCreateNew, winit::Painter,
};
use wgpu::{self, Adapter, AdapterInfo, Backend, CurrentSurfaceTexture, DeviceType};
use winit::event_loop::ActiveEventLoop;
use winit::window::Window;

use super::display::without_panic;
use super::surface::{PATIENCE, WindowFrame, WindowSurface};

/// Words in the names of software adapters. Some of these adapters claim to be hardware.
const SOFTWARE: [&str; 7] = [
    "llvmpipe",
    "lavapipe",
    "softpipe",
    "swrast",
    "software rasterizer",
    "swiftshader",
    "microsoft basic render",
];

/// A window's surface on a graphics adapter.
pub(super) struct Gpu {
    painter: Painter,
    size: [u32; 2],
    failure: Failure,
    /// True if the display invalidated the surface instead of accepting the frame.
    took_surface: Arc<AtomicBool>,
    /// Number of consecutive frames for which the display invalidated the surface.
    retries: u32,
}

/// The first error that the driver reported, on any thread, if there was one.
type Failure = Arc<Mutex<Option<String>>>;

impl Gpu {
    /// Starts the best adapter that can draw to the window. Also returns the adapter's description. If
    /// `software` is true, software adapters are allowed.
    pub(super) fn new(
        ctx: &egui::Context,
        event_loop: &ActiveEventLoop,
        window: &Arc<Window>,
        software: bool,
    ) -> Result<(Self, String), String> {
        let mut setup = WgpuSetupCreateNew::from_display_handle(event_loop.owned_display_handle());
        setup.native_adapter_selector =
            Some(Arc::new(move |adapters, surface| best(adapters, surface, software)));
        let took_surface = Arc::new(AtomicBool::new(false));
        let default = WgpuConfiguration::default();
        let (notes, usual) = (Arc::clone(&took_surface), default.on_surface_status);
        let config = WgpuConfiguration {
            surface: SurfaceConfig::LOW_LATENCY,
            wgpu_setup: WgpuSetup::CreateNew(setup),
            on_surface_status: Arc::new(move |status| match status {
                CurrentSurfaceTexture::Lost => {
                    notes.store(true, Ordering::Relaxed);
                    // egui would create another surface, without reporting whether that fails.
                    SurfaceErrorAction::SkipFrame
                }
                status => usual(status),
            }),
        };
        // Without dithering, the picture's pixels reach the screen unchanged.
        let options = RendererOptions { dithering: false, ..RendererOptions::default() };
        let mut painter = pollster::block_on(Painter::new(ctx.clone(), config, false, options));
        pollster::block_on(painter.set_window(ViewportId::ROOT, Some(Arc::clone(window))))
            .map_err(|error| reason(&error))?;
        let state = painter.render_state().ok_or("the adapter did not start")?;
        let failure = watch(&state.device);
        let description = describe(&state.adapter.get_info());
        let size = window.inner_size().into();
        Ok((Self { painter, size, failure, took_surface, retries: 0 }, description))
    }

    /// Draws and presents a frame. If the display has invalidated the surface, creates a new one and requests
    /// another frame instead.
    fn try_paint(&mut self, frame: WindowFrame<'_>) -> Result<Duration, String> {
        if self.size != frame.size {
            let [width, height] = frame.size.map(NonZeroU32::new);
            if let (Some(width), Some(height)) = (width, height) {
                self.painter.on_window_resized(ViewportId::ROOT, width, height);
                self.size = frame.size;
            }
        }
        let waited = self.painter.paint_and_update_textures(
            ViewportId::ROOT,
            frame.pixels_per_point,
            frame.ground.to_normalized_gamma_f32(),
            &frame.primitives,
            frame.delta,
            frame.screenshots,
            frame.window,
        );
        if self.took_surface.swap(false, Ordering::Relaxed) {
            self.retries += 1;
            if self.retries >= PATIENCE {
                return Err("the display gives no surface".to_owned());
            }
            let window = Arc::clone(frame.window);
            let painter = &mut self.painter;
            pollster::block_on(async {
                painter.set_window(ViewportId::ROOT, None).await?;
                painter.set_window(ViewportId::ROOT, Some(window)).await
            })
            .map_err(|error| error.to_string())?;
            frame.window.request_redraw();
        } else {
            self.retries = 0;
        }
        Ok(Duration::try_from_secs_f32(waited).unwrap_or_default())
    }
}

impl WindowSurface for Gpu {
    fn max_texture_side(&self) -> Option<usize> {
        self.painter.max_texture_side()
    }

    fn paint(&mut self, frame: WindowFrame<'_>) -> Result<Duration, String> {
        // On a lost device, egui's painter panics.
        let painted = without_panic(|| self.try_paint(frame)).flatten();
        let failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner).take();
        failure.map_or(painted, Err).map_err(|reason| innermost(&reason))
    }
}

/// Returns the last line of an error message, which names the innermost cause.
fn innermost(message: &str) -> String {
    let last = message.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default();
    last.trim().trim_end_matches('.').to_owned()
}

/// Returns the reason why there is no adapter, in words for the user.
fn reason(error: &WgpuError) -> String {
    match error {
        WgpuError::CustomNativeAdapterSelectionError(reason) => reason.clone(),
        // Without any driver, wgpu's own message is an empty list.
        WgpuError::CreateSurfaceError(_) => "no graphics driver found".to_owned(),
        error => innermost(&error.to_string()),
    }
}

/// Makes the device store its first error in the returned [`Failure`]; by default, wgpu panics.
fn watch(device: &wgpu::Device) -> Failure {
    let failure = Failure::default();
    let keep = |failure: &Failure| {
        let failure = Arc::clone(failure);
        move |text: String| {
            failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(text);
        }
    };
    let (on_error, on_loss) = (keep(&failure), keep(&failure));
    device.on_uncaptured_error(Arc::new(move |error| on_error(error.to_string())));
    device.set_device_lost_callback(move |reason, text| {
        // This is also called at the end, when the device is destroyed normally.
        if reason != wgpu::DeviceLostReason::Destroyed {
            on_loss(text);
        }
    });
    failure
}

/// Returns the best adapter for a window's surface: hardware rather than software, then the fastest
/// kind, then the system's native interface rather than OpenGL.
fn best(
    adapters: &[Adapter],
    surface: Option<&wgpu::Surface<'_>>,
    software: bool,
) -> Result<Adapter, String> {
    let fits = |adapter: &&Adapter| surface.is_none_or(|s| adapter.is_surface_supported(s));
    let all: Vec<_> = adapters.iter().filter(fits).collect();
    let allowed = all.iter().filter(|a| software || !is_software(&a.get_info()));
    if let Some(adapter) = allowed.min_by_key(|adapter| rank(&adapter.get_info())) {
        return Ok((*adapter).clone());
    }
    Err(match all.first() {
        Some(adapter) => format!("only a software adapter: {}", describe(&adapter.get_info())),
        None => "no graphics adapter found".to_owned(),
    })
}

fn is_software(info: &AdapterInfo) -> bool {
    let name = format!("{} {} {}", info.name, info.driver, info.driver_info).to_lowercase();
    info.device_type == DeviceType::Cpu || SOFTWARE.iter().any(|word| name.contains(word))
}

/// Returns the rank of an adapter; smaller is better.
fn rank(info: &AdapterInfo) -> (bool, u8, bool) {
    let kind = match info.device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        // GL reports this for hardware of unknown kind.
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    };
    (is_software(info), kind, info.backend == Backend::Gl)
}

fn describe(info: &AdapterInfo) -> String {
    let driver = [info.driver.as_str(), info.driver_info.as_str()].join(" ");
    let driver = driver.trim();
    if driver.is_empty() || info.name.contains(driver) {
        format!("{}, {}", info.name, info.backend)
    } else {
        format!("{}, {}, {}", info.name, info.backend, driver)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn info(name: &str, kind: DeviceType, backend: Backend) -> AdapterInfo {
        AdapterInfo { name: name.to_owned(), ..AdapterInfo::new(kind, backend) }
    }

    #[test]
    fn software_is_known_by_kind_and_by_name() {
        let (cpu, other) = (DeviceType::Cpu, DeviceType::Other);
        assert!(is_software(&info("anything", cpu, Backend::Vulkan)));
        let zink = "zink Vulkan 1.3(llvmpipe (LLVM 15.0.6, 256 bits))";
        assert!(is_software(&info(zink, other, Backend::Gl)));
        assert!(!is_software(&info("AMD Radeon 780M", DeviceType::IntegratedGpu, Backend::Vulkan)));
        assert!(!is_software(&info("virgl", other, Backend::Gl)));
    }

    #[test]
    fn hardware_is_ranked_before_software_and_discrete_before_integrated() {
        let ranks = [
            info("a card", DeviceType::DiscreteGpu, Backend::Vulkan),
            info("a card", DeviceType::DiscreteGpu, Backend::Gl),
            info("a chip", DeviceType::IntegratedGpu, Backend::Vulkan),
            info("a chip", DeviceType::Other, Backend::Gl),
            info("llvmpipe", DeviceType::Cpu, Backend::Vulkan),
            info("llvmpipe", DeviceType::Cpu, Backend::Gl),
        ]
        .map(|info| rank(&info));
        assert!(ranks.is_sorted(), "{ranks:?}");
    }
}
