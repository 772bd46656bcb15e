//! A student's program as a set of choices. A mistake is a change to it.

use pinhole_core::{DVec2, DVec3};

/// The choices on the way from eye, view and up to a hit: [`Pipeline::RIGHT`] is the lecture's own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pipeline {
    pub(crate) basis: BasisChoices,
    pub(crate) distance: Distance,
    /// The direction leads back to the eye.
    pub(crate) reversed: bool,
    /// The viewport's point is the direction: the eye is added to it.
    pub(crate) eye_added: bool,
    /// Added to column and row: 0.5 is the pixel's centre.
    pub(crate) in_pixel: [f64; 2],
    /// Divided by `W - 1` and `H - 1`: the first pixel's ray on one edge, the last one's on the
    /// other.
    pub(crate) edge_to_edge: bool,
    /// The last row and column are H and W.
    pub(crate) from_one: bool,
    pub(crate) rows: Rows,
    pub(crate) swap: Swap,
    pub(crate) extent: Extent,
    /// Every number in `f32`.
    pub(crate) single: bool,
    pub(crate) quadratic: Quadratic,
    pub(crate) root: WhichRoot,
    pub(crate) sign: Sign,
    pub(crate) measure: Measure,
    /// Objects are counted from 1.
    pub(crate) objects_from_one: bool,
}

/// One way to make a mistake: a change to the pipeline.
pub(crate) type Way = fn(&mut Pipeline);

/// The choices on the way to u, v and w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BasisChoices {
    /// w along the view.
    pub(crate) w_forwards: bool,
    /// w of the view's length.
    pub(crate) w_raw: bool,
    /// u as long as `up x w`.
    pub(crate) u_raw: bool,
    /// v is normalized, whatever w and u are.
    pub(crate) v_unit: bool,
    /// `w x up`.
    pub(crate) u_swapped: bool,
    /// `u x w`.
    pub(crate) v_swapped: bool,
    pub(crate) up_as_v: UpAsV,
}

/// up in v's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum UpAsV {
    No,
    AsGiven,
    /// Normalized.
    Unit,
}

/// The number in place of the viewport's distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Distance {
    Right,
    One,
    /// There is no part along w.
    LeftOut,
    /// It is added.
    Plus,
}

/// The end from which rows count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rows {
    FromTop,
    /// v has the other sign.
    SignOfV,
    /// The row is `H - 1 - i`.
    FromLast,
}

/// Rows and columns exchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Swap {
    No,
    /// `i / W` and `j / H`.
    Indices,
    /// `i / H` and `j / W`, for u and v.
    Shares,
    /// `j / H` and `i / W`.
    Counts,
}

/// The numbers in place of the viewport's width and height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    Right,
    WidthForHeight,
    HeightForWidth,
    /// 1 and 1, where they differ.
    Ones,
    /// The width made of the height, and the image's W / H.
    WidthByImage,
    /// The height made of the width, and the image's H / W.
    HeightByImage,
    /// The height for the width, and the width for the height.
    Swapped,
    Half,
    Twice,
}

/// `t = (-numerator b -+ sqrt(square b^2 - product a c)) / (denominator a)`, with
/// `b = d . (p - center)` and `c = |p - center|^2 - r^2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quadratic {
    numerator: f64,
    square: f64,
    product: f64,
    denominator: f64,
    /// `a` is taken as 1.
    pub(crate) a_left_out: bool,
    pub(crate) offset: Offset,
    /// r stands for its square.
    pub(crate) radius_unsquared: bool,
    pub(crate) square_root: SquareRoot,
}

/// The vector in place of `p - center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Offset {
    Right,
    /// p.
    CenterLeftOut,
    /// `-center`.
    OriginLeftOut,
}

/// The number in place of the discriminant's root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SquareRoot {
    Right,
    /// 0: both roots meet.
    LeftOut,
    /// The discriminant itself.
    NotTaken,
}

/// The root that is an object's hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WhichRoot {
    Near,
    Far,
    /// The largest of all roots of all objects.
    Farthest,
    /// That of the last object in the scene that is hit at all.
    Last,
    /// That of the object whose hit is the farthest.
    FarthestObject,
}

/// The t that count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sign {
    Positive,
    /// All, the smallest first.
    Any,
    /// All, the smallest in size first.
    Nearest,
}

/// The numbers that are given as t and point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    /// t, and `p + t d`.
    Right,
    /// `t |d|`, and `p + t d`.
    Distance,
    /// t, and `p + t d/|d|`.
    PointOfUnit,
    /// `t |d|`, and `p + t |d| d`.
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

    /// Leaves w, u or both as they are before they are normalized, and v as it follows from them.
    pub(crate) fn set_raw(&mut self, w: bool, u: bool) {
        (self.w_raw, self.u_raw, self.v_unit) = (w, u, false);
    }

    /// Leaves w, u or both as they are before they are normalized, and normalizes v.
    pub(crate) fn set_raw_but_v(&mut self, w: bool, u: bool) {
        (self.w_raw, self.u_raw, self.v_unit) = (w, u, true);
    }

    /// Exchanges the factors of both cross products. Exchanged twice, they are right.
    pub(crate) fn swap_both(&mut self) {
        self.u_swapped ^= true;
        self.v_swapped ^= true;
    }
}

impl Distance {
    /// The number taken for this distance.
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

    /// Returns whether the roots are the right ones.
    pub(crate) fn is_right(&self) -> bool {
        *self == Quadratic::RIGHT
    }

    /// Returns whether the discriminant is the right one, or a multiple of it: a line meets the
    /// spheres that it should.
    pub(crate) fn meets_what_is_met(&self) -> bool {
        let Quadratic { square, product, a_left_out, offset, radius_unsquared, .. } = *self;
        square == product && !a_left_out && offset == Offset::Right && !radius_unsquared
    }

    /// The vector taken for `p - center`.
    pub(crate) fn offset(&self, p: DVec3, center: DVec3) -> DVec3 {
        match self.offset {
            Offset::Right => p - center,
            Offset::CenterLeftOut => p,
            Offset::OriginLeftOut => -center,
        }
    }

    /// The number taken for `c = |p - center|^2 - r^2`.
    pub(crate) fn c(&self, away_squared: f64, radius: f64) -> f64 {
        away_squared - if self.radius_unsquared { radius } else { radius * radius }
    }

    /// The number taken for `a = d . d`.
    pub(crate) fn a(&self, a: f64) -> f64 {
        if self.a_left_out { 1.0 } else { a }
    }

    /// The t at which both roots meet, of the [`Quadratic::a`] that is taken.
    pub(crate) fn vertex(&self, a: f64, b: f64) -> f64 {
        -self.numerator * b / (self.denominator * a)
    }

    /// The roots, the smaller first, of the [`Quadratic::a`] that is taken; `None` where the number
    /// below the root is negative.
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

    /// The direction through a (u, v), from these u, v and w and the viewport's distance.
    pub(crate) fn direction(&self, [u, v, w]: [DVec3; 3], distance: f64, uv: DVec2) -> DVec3 {
        let direction = uv.x * u + uv.y * v - self.distance.taken_for(distance) * w;
        if self.reversed { -direction } else { direction }
    }

    /// The pipeline with one mistake more.
    pub(crate) fn with(mut self, way: Way) -> Pipeline {
        way(&mut self);
        self
    }

    /// Moves where in a pixel its ray passes, in pixels to the right and down.
    pub(crate) fn move_in_pixel(&mut self, across: f64, down: f64) {
        self.in_pixel[0] += across;
        self.in_pixel[1] += down;
    }

    /// `j - 0.5`: the first row and column are 1, and so the last ones H and W.
    pub(crate) fn count_pixels_from_one(&mut self) {
        self.move_in_pixel(-1.0, -1.0);
        self.from_one = true;
    }

    /// The first object is 1.
    pub(crate) fn count_objects_from_one(&mut self) {
        self.objects_from_one = true;
    }

    /// The first row, column and object are 1.
    pub(crate) fn count_all_from_one(&mut self) {
        self.count_pixels_from_one();
        self.count_objects_from_one();
    }
}
