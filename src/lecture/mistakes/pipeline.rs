//! A model of a student's program (its pipeline), and the rays that it generates. The model consists of
//! choices, such as the vector that is used as w; a mistake changes one or more of them.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{Basis, Camera, CameraError, DVec2, DVec3, Orientation, Pixel, ResolvedCamera};

/// The choices that a program makes on the way from a camera's numbers to a hit. [`Pipeline::RIGHT`]
/// makes the right ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pipeline {
    pub(crate) basis: BasisChoices,
    pub(crate) distance: Distance,
    /// True if a ray's direction leads from the viewport back to the eye.
    pub(crate) reversed: bool,
    /// True if the position of the viewport's point is used as the direction, without subtracting the
    /// eye.
    pub(crate) eye_added: bool,
    /// The offsets that are added to the column and the row for the point through which a pixel's ray
    /// passes; 0.5 for the pixel's centre.
    pub(crate) in_pixel: [f64; 2],
    /// True if columns and rows are divided by `W - 1` and `H - 1`, so that the first pixel's ray
    /// passes through one edge of the viewport and the last pixel's through the other.
    pub(crate) edge_to_edge: bool,
    /// True if rows and columns are counted from 1, so that the last row is H and the last column W,
    /// the image's size.
    pub(crate) from_one: bool,
    pub(crate) rows: Rows,
    pub(crate) swap: Swap,
    pub(crate) extent: Extent,
    /// True if every number is an `f32`.
    pub(crate) single: bool,
    pub(crate) quadratic: Quadratic,
    pub(crate) root: WhichRoot,
    pub(crate) sign: Sign,
    pub(crate) measure: Measure,
    /// True if objects are counted from 1.
    pub(crate) objects_from_one: bool,
}

/// One variant of a mistake, as a change to the pipeline.
pub(crate) type Way = fn(&mut Pipeline);

/// The choices in the calculation of u, v and w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BasisChoices {
    /// True if w points along the view direction.
    pub(crate) w_forwards: bool,
    /// True if w is not normalized, so that it has the view's length.
    pub(crate) w_raw: bool,
    /// True if u is not normalized, so that it has the length of `up x w`.
    pub(crate) u_raw: bool,
    /// True if v is normalized, whatever the lengths of w and u.
    pub(crate) v_unit: bool,
    /// True if u is calculated from `w x up`.
    pub(crate) u_swapped: bool,
    /// True if v is calculated from `u x w`.
    pub(crate) v_swapped: bool,
    pub(crate) up_as_v: UpAsV,
}

/// Whether up is used as v, and in which form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum UpAsV {
    No,
    AsGiven,
    /// Up is used after it has been normalized.
    Unit,
}

/// The number that is used as the viewport's distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Distance {
    Right,
    One,
    /// The component along w is left out.
    LeftOut,
    /// The component along w is added instead of subtracted.
    Plus,
}

/// The end from which rows are counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rows {
    FromTop,
    /// Rows are counted from the bottom, by giving the scalar v the opposite sign.
    SignOfV,
    /// Rows are counted from the bottom, by using `H - 1 - i` for row i.
    FromLast,
}

/// The ways in which rows and columns are exchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Swap {
    No,
    /// Row i and column j are exchanged: `i / W` is used for u, and `j / H` for v.
    Indices,
    /// The fractions of row i and column j are exchanged: `i / H` is used for u, and `j / W` for v.
    Shares,
    /// The image's height and width are exchanged: `j / H` is used for u, and `i / W` for v.
    Counts,
}

/// The numbers that are used as the viewport's width and height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    Right,
    WidthForHeight,
    HeightForWidth,
    /// 1 is used for both, if the width and the height differ.
    Ones,
    /// The width is calculated from the height and the image's aspect ratio, W / H.
    WidthByImage,
    /// The height is calculated from the width and the image's aspect ratio, W / H.
    HeightByImage,
    /// The height is used as the width, and the width as the height.
    Swapped,
    Half,
    Twice,
}

/// A right or wrong formula for the t at which a ray `p + t d` meets a sphere, `t = (-numerator b -+
/// sqrt(square b^2 - product a c)) / (denominator a)`, with `a = d . d`, `b = d . (p - center)` and `c
/// = |p - center|^2 - r^2`. It is right if all four factors are 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quadratic {
    numerator: f64,
    square: f64,
    product: f64,
    denominator: f64,
    /// True if `a` is assumed to be 1.
    pub(crate) a_left_out: bool,
    pub(crate) offset: Offset,
    /// True if r is used instead of its square.
    pub(crate) radius_unsquared: bool,
    pub(crate) square_root: SquareRoot,
}

/// The vector that is used as `p - center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Offset {
    Right,
    /// p.
    CenterLeftOut,
    /// `-center`.
    OriginLeftOut,
}

/// The number that is used as the square root of the discriminant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SquareRoot {
    Right,
    /// 0, so that both roots coincide.
    LeftOut,
    /// The discriminant itself, without taking its root.
    NotTaken,
}

/// The root that is used as an object's hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WhichRoot {
    Near,
    Far,
    /// The largest root of all objects.
    Farthest,
    /// The root of that object, of those that the ray hits, that comes last in the scene.
    Last,
    /// The root of the object whose hit is farthest away.
    FarthestObject,
}

/// The values of t that count as hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sign {
    Positive,
    /// All values; the smallest one counts as the first hit.
    Any,
    /// All values; the one with the smallest magnitude counts as the first hit.
    Nearest,
}

/// The numbers that are reported as t and as the hit point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    /// t, and `p + t d`.
    Right,
    /// `t |d|`, and `p + t d`.
    Distance,
    /// t, and `p + t d/|d|`.
    PointOfUnit,
    /// `t |d|` as t, and `p + t |d| d` as the point.
    PointOfDistance,
}

impl BasisChoices {
    pub(crate) const RIGHT: BasisChoices = BasisChoices {
        w_forwards: false,
        w_raw: false,
        u_raw: false,
        v_unit: false,
        u_swapped: false,
        v_swapped: false,
        up_as_v: UpAsV::No,
    };

    /// Omits the normalization of w if `w` is true, and that of u if `u` is true. v is calculated from
    /// these vectors and, if `v_unit` is true, normalized.
    pub(crate) fn set_raw(&mut self, w: bool, u: bool, v_unit: bool) {
        (self.w_raw, self.u_raw, self.v_unit) = (w, u, v_unit);
    }

    /// Exchanges the factors of both cross products, those for u and for v. A second call restores
    /// them.
    pub(crate) fn swap_both(&mut self) {
        self.u_swapped ^= true;
        self.v_swapped ^= true;
    }
}

impl Distance {
    /// Returns the number that is used for this distance.
    pub(crate) fn taken_for(self, distance: f64) -> f64 {
        match self {
            Distance::Right => distance,
            Distance::One => 1.0,
            Distance::LeftOut => 0.0,
            Distance::Plus => -distance,
        }
    }
}

impl Quadratic {
    const RIGHT: Quadratic = Quadratic {
        numerator: 1.0,
        square: 1.0,
        product: 1.0,
        denominator: 1.0,
        a_left_out: false,
        offset: Offset::Right,
        radius_unsquared: false,
        square_root: SquareRoot::Right,
    };

    pub(crate) fn set(&mut self, numerator: f64, square: f64, product: f64, denominator: f64) {
        *self = Quadratic { numerator, square, product, denominator, ..*self };
    }

    /// Returns true if the roots of this formula are the right ones.
    pub(crate) fn is_right(&self) -> bool {
        *self == Quadratic::RIGHT
    }

    /// Returns true if the discriminant is the right one or a multiple of it, so that the formula has
    /// roots exactly for those spheres that the ray's line meets.
    pub(crate) fn meets_what_is_met(&self) -> bool {
        let Quadratic { square, product, a_left_out, offset, radius_unsquared, .. } = *self;
        square == product && !a_left_out && offset == Offset::Right && !radius_unsquared
    }

    /// Returns the vector that is used as `p - center`.
    pub(crate) fn offset(&self, p: DVec3, center: DVec3) -> DVec3 {
        match self.offset {
            Offset::Right => p - center,
            Offset::CenterLeftOut => p,
            Offset::OriginLeftOut => -center,
        }
    }

    /// Returns the number that is used as `c = |p - center|^2 - r^2`.
    pub(crate) fn c(&self, away_squared: f64, radius: f64) -> f64 {
        away_squared - if self.radius_unsquared { radius } else { radius * radius }
    }

    /// Returns the number that is used as `a = d . d`.
    pub(crate) fn a(&self, a: f64) -> f64 {
        if self.a_left_out { 1.0 } else { a }
    }

    /// Returns the t of both roots for a discriminant of 0, which is midway between them otherwise. `a`
    /// is the result of [`Quadratic::a`].
    pub(crate) fn vertex(&self, a: f64, b: f64) -> f64 {
        -self.numerator * b / (self.denominator * a)
    }

    /// Returns the roots, the smaller one first; `None` if the discriminant is negative.
    /// `a` is the result of [`Quadratic::a`].
    pub(crate) fn roots(&self, a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
        let discriminant = self.square * b * b - self.product * a * c;
        let root = match self.square_root {
            SquareRoot::Right => discriminant.sqrt(),
            SquareRoot::LeftOut => 0.0,
            SquareRoot::NotTaken => discriminant,
        };
        let half = root / (self.denominator * a);
        let vertex = self.vertex(a, b);
        (discriminant >= 0.0).then_some([vertex - half, vertex + half])
    }
}

impl Pipeline {
    /// The pipeline without any mistake.
    pub(crate) const RIGHT: Pipeline = Pipeline {
        basis: BasisChoices::RIGHT,
        distance: Distance::Right,
        reversed: false,
        eye_added: false,
        in_pixel: [0.5; 2],
        edge_to_edge: false,
        from_one: false,
        rows: Rows::FromTop,
        swap: Swap::No,
        extent: Extent::Right,
        single: false,
        quadratic: Quadratic::RIGHT,
        root: WhichRoot::Near,
        sign: Sign::Positive,
        measure: Measure::Right,
        objects_from_one: false,
    };

    /// Returns the direction of the ray through the point `uv` of the viewport, for these vectors u, v
    /// and w, and this distance of the viewport.
    pub(crate) fn direction(&self, [u, v, w]: [DVec3; 3], distance: f64, uv: DVec2) -> DVec3 {
        let direction = uv.x * u + uv.y * v - self.distance.taken_for(distance) * w;
        if self.reversed { -direction } else { direction }
    }

    /// Returns the pipeline with one more change.
    pub(crate) fn with(mut self, way: Way) -> Pipeline {
        way(&mut self);
        self
    }

    /// Moves the point at which each ray passes through its pixel by this many pixels to the right and
    /// down.
    pub(crate) fn move_in_pixel(&mut self, across: f64, down: f64) {
        self.in_pixel[0] += across;
        self.in_pixel[1] += down;
    }

    /// Counts rows and columns from 1, up to H and W, and uses `j - 0.5` for column j, so that the
    /// pixels' centres are right.
    pub(crate) fn count_pixels_from_one(&mut self) {
        self.move_in_pixel(-1.0, -1.0);
        self.from_one = true;
    }

    /// Counts objects from 1.
    pub(crate) fn count_objects_from_one(&mut self) {
        self.objects_from_one = true;
    }

    /// Counts rows, columns and objects from 1.
    pub(crate) fn count_all_from_one(&mut self) {
        self.count_pixels_from_one();
        self.count_objects_from_one();
    }
}

/// A camera without mistakes, with the values from which pipelines with mistakes calculate theirs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GivenCamera {
    pub(crate) resolved: ResolvedCamera,
    pub(crate) view: DVec3,
    pub(crate) up: DVec3,
    /// `|up/|up| x w|` for the right w: the sine of the angle between up and w.
    sine: f64,
    /// True if the camera is given by u, v and w themselves, so that no mistake is possible in
    /// calculating them.
    pub(crate) by_hand: bool,
    /// Bound on the relative error of a ray's direction, as a multiple of the rounding error of one
    /// operation.
    roundings: f64,
}

/// Upper bound, with a large margin, of the number of roundings on the way from a camera's numbers to a
/// ray's direction. Each rounding changes a number by at most one unit in the last place.
const ROUNDINGS: f64 = 16.0;

impl GivenCamera {
    pub(crate) fn new(camera: &Camera) -> Result<GivenCamera, CameraError> {
        let resolved = camera.resolve()?;
        let (view, up) = (camera.view(), camera.up());
        let conditioning = camera.up_angle().map_or(1.0, |angle| angle.conditioning);
        // at - eye loses digits by cancellation if both points are far from the origin.
        let lost = match camera.orientation {
            Orientation::At { at, .. } => (length(at) + length(camera.eye)) / length(view),
            _ => 0.0,
        };
        Ok(GivenCamera {
            resolved,
            view,
            up,
            sine: unit(up).cross(resolved.basis().w).length(),
            by_hand: !camera.orientation.has_up(),
            roundings: ROUNDINGS * (1.0 + lost) * conditioning,
        })
    }

    /// Returns the camera that a pipeline calculates.
    pub(crate) fn camera_of(&self, pipeline: Pipeline) -> PipelineCamera {
        let Basis { u, v, w } = *self.resolved.basis();
        let factors = self.factors(&pipeline);
        let up_as_v = match pipeline.basis.up_as_v {
            UpAsV::No => None,
            UpAsV::AsGiven => Some(self.up),
            UpAsV::Unit => Some(unit(self.up)),
        };
        let epsilon = if pipeline.single { f64::from(f32::EPSILON) } else { f64::EPSILON };
        PipelineCamera {
            pipeline,
            eye: self.resolved.eye(),
            u: factors.x * u,
            v: up_as_v.unwrap_or(factors.y * v),
            w: factors.z * w,
            factors,
            up_as_v,
            distance: self.resolved.viewport().distance,
            extent: self.extent(pipeline.extent),
            count: [self.resolved.image().width(), self.resolved.image().height()].map(f64::from),
            epsilon,
            off: self.roundings * epsilon,
            nearest: None,
        }
    }

    /// Returns the factors by which the pipeline's u, v and w are multiples of the right vectors.
    /// Multiplying the right vectors by them loses no digits, even if up is close to the view.
    fn factors(&self, pipeline: &Pipeline) -> DVec3 {
        if self.by_hand {
            return DVec3::ONE;
        }
        let basis = pipeline.basis;
        let sign = |is_negative: bool| if is_negative { -1.0 } else { 1.0 };
        let w_length = if basis.w_raw { length(self.view) } else { 1.0 };
        let w = sign(basis.w_forwards) * w_length;
        let u_length = if basis.u_raw { w_length * length(self.up) * self.sine } else { 1.0 };
        let u = sign(basis.w_forwards != basis.u_swapped) * u_length;
        let v = sign(basis.v_swapped) * w * u;
        DVec3::new(u, if basis.v_unit { v.signum() } else { v }, w)
    }

    fn extent(&self, extent: Extent) -> [f64; 2] {
        let viewport = self.resolved.viewport();
        let (width, height) = (viewport.width, viewport.height);
        match extent {
            Extent::Ones if width != height => [1.0, 1.0],
            Extent::Right | Extent::Ones => [width, height],
            Extent::WidthForHeight => [width, width],
            Extent::HeightForWidth => [height, height],
            Extent::WidthByImage => [height * self.resolved.image().aspect(), height],
            Extent::HeightByImage => [width, width / self.resolved.image().aspect()],
            Extent::Swapped => [height, width],
            Extent::Half => [0.5 * width, 0.5 * height],
            Extent::Twice => [2.0 * width, 2.0 * height],
        }
    }
}

/// The camera that a pipeline calculates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PipelineCamera {
    pub(crate) pipeline: Pipeline,
    pub(crate) eye: DVec3,
    pub(crate) u: DVec3,
    pub(crate) v: DVec3,
    pub(crate) w: DVec3,
    /// The factors by which u, v and w are multiples of the right vectors.
    pub(crate) factors: DVec3,
    /// The vector v if up is used as v; otherwise `None`.
    pub(crate) up_as_v: Option<DVec3>,
    /// The viewport's distance.
    distance: f64,
    /// The width and the height of the viewport, as the pipeline uses them.
    pub(crate) extent: [f64; 2],
    /// W and H, the image's size in pixels.
    count: [f64; 2],
    /// The spacing of the pipeline's number format at 1.
    pub(crate) epsilon: f64,
    /// Bound on the relative error of a ray's direction that is due to rounding.
    pub(crate) off: f64,
    /// The t of the nearest hit, which is white in a picture shaded by t; `None` if it is not known.
    pub(crate) nearest: Option<f64>,
}

impl PipelineCamera {
    /// Returns true if the pipeline has a pixel with these row and column numbers.
    pub(crate) fn answers_for(&self, pixel: Pixel) -> bool {
        let [w, h] = self.count;
        let is_inside = f64::from(pixel.column) < w && f64::from(pixel.row) < h;
        is_inside || self.pipeline.from_one
    }

    /// Returns the (u, v) that the pipeline calculates from these row and column numbers.
    pub(crate) fn uv(&self, row: f64, column: f64) -> DVec2 {
        let Pipeline { rows, swap, in_pixel, edge_to_edge, .. } = self.pipeline;
        let [w, h] = self.count;
        let row = if rows == Rows::FromLast { h - 1.0 - row } else { row };
        let ((across, columns), (down, height)) = match swap {
            Swap::No => ((column, w), (row, h)),
            Swap::Indices => ((row, w), (column, h)),
            Swap::Shares => ((row, h), (column, w)),
            Swap::Counts => ((column, h), (row, w)),
        };
        // The expression is that of the right camera, whose numerator is exact.
        let share = |index: f64, count: f64, in_pixel: f64| {
            let steps = if edge_to_edge { count - 1.0 } else { count };
            (2.0 * (index + in_pixel) - count) / (2.0 * steps)
        };
        let side = if rows == Rows::SignOfV { -1.0 } else { 1.0 };
        DVec2::new(
            self.extent[0] * share(across, columns, in_pixel[0]),
            side * self.extent[1] * (0.0 - share(down, height, in_pixel[1])),
        )
    }

    /// Returns the viewport's distance that the rays use.
    pub(crate) fn distance_taken(&self) -> f64 {
        self.pipeline.distance.taken_for(self.distance)
    }

    /// Returns the pipeline's direction through a point (u, v).
    pub(crate) fn direction_at(&self, uv: DVec2) -> DVec3 {
        let direction = self.pipeline.direction([self.u, self.v, self.w], self.distance, uv);
        if self.pipeline.eye_added { self.eye + direction } else { direction }
    }

    /// Returns the direction that the pipeline calculates from these row and column numbers.
    pub(crate) fn direction(&self, row: f64, column: f64) -> DVec3 {
        self.direction_at(self.uv(row, column))
    }
}
