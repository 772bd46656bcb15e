//! How far the mouse reaches, and how far a key, the wheel or a snapped drag moves.

/// Maximum distance from a handle at which the mouse grabs it, in points.
pub const HANDLE_REACH: f64 = 11.0;
/// Maximum distance from the point on the selected ray at which the mouse grabs it, in points.
pub const RAY_POINT_REACH: f32 = 14.0;
/// Maximum distance from a mark at which the mouse hovers it, in points.
pub const MARK_REACH: f32 = 8.0;
/// Movement during a press on a handle, in points, below which it is a click.
pub const CLICK: f32 = 2.0;

/// Least length, in points, of a step to which values snap and by which keys move a handle.
pub const STEP_POINTS: f64 = 10.0;
/// Step to which angles snap, in degrees.
pub const STEP_DEGREES: f64 = 15.0;

/// Angle by which a key turns the camera or the observer, in radians.
pub const KEY_TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Angle by which a key rolls the camera, in degrees.
pub const KEY_ROLL: f64 = 5.0;
/// Step of a key that dollies or zooms the camera: the logarithm of its factor.
pub const KEY_NEARER: f64 = 0.1;
/// Share of the picture's height by which a key pans the observer.
pub const KEY_PAN: f64 = 0.05;
/// Factor by which a key takes the observer nearer.
pub const KEY_ZOOM: f64 = 1.15;

/// Logarithm of the zoom factor of the observer and of the lab of lines, per point that the wheel scrolls.
pub const WHEEL_ZOOM: f32 = 0.004;
/// Scrolling that takes the loupe a step closer, in points.
pub const LOUPE_SCROLL: f32 = 40.0;

/// Time after the last input of wheel or keys during which their effect is shown, and Escape takes
/// it back; in seconds.
pub const PAUSE: f64 = 1.2;
