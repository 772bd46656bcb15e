//! Interaction constants: how close the mouse must be to grab something, and the step sizes of keys,
//! the wheel and snapped drags.

/// Maximum distance, in points, at which the mouse grabs a handle.
pub const HANDLE_REACH: f64 = 11.0;
/// Maximum distance, in points, at which a finger grabs a handle: half the width of what a finger can touch.
pub const FINGER_REACH: f64 = 22.0;
/// Maximum distance, in points, at which the mouse grabs the point on the selected ray.
pub const RAY_POINT_REACH: f32 = 14.0;
/// Maximum distance, in points, at which the mouse pointer counts as being over a mark.
pub const MARK_REACH: f32 = 8.0;
/// Maximum distance, in points, at which the dragged tip of up snaps to the line of view.
pub const VIEW_LINE_REACH: f64 = 9.0;
/// Maximum movement, in points, for which a press on a handle counts as a click.
pub const CLICK: f32 = 2.0;

/// Minimum length on the screen, in points, of the steps by which keys move a handle and to which a drag
/// snaps.
pub const STEP_POINTS: f64 = 10.0;

/// Angle by which one key press turns the camera or the observer, in radians.
pub const KEY_TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Logarithm of the factor by which one key press dollies or zooms the camera.
pub const KEY_NEARER: f64 = 0.1;
/// Distance by which one key press pans the observer, as a fraction of the picture's height.
pub const KEY_PAN: f64 = 0.05;
/// Factor by which one key press divides the observer's distance to move it nearer.
pub const KEY_ZOOM: f64 = 1.15;

/// Logarithm of the zoom factor per point of wheel scrolling, for the world view's observer and for the
/// page *Lines*.
pub const WHEEL_ZOOM: f32 = 0.004;
/// Minimum distance of the observer from the camera or the sphere that it is zoomed at, as a fraction of that
/// thing's size.
pub const NEAREST: f64 = 0.25;
/// Minimum distance of the observer from any other point, as a fraction of the viewport's size.
pub const NEAREST_GROUND: f64 = 0.02;
/// Maximum distance of a zoomed observer, in distances at which it sees everything.
pub const FARTHEST: f64 = 20.0;
/// Scroll distance, in points, that increases the loupe's magnification by one step.
pub const LOUPE_SCROLL: f32 = 40.0;

/// Time in seconds after the last wheel or key input for which its effect is displayed and Escape undoes
/// it.
pub const PAUSE: f64 = 1.2;
