//! A student's program as a set of choices, and how each known mistake changes them.

use super::KnownMistake;
use super::diagnosis::OtherSlip;

/// The choices on the way from eye, view and up to a hit. [`Program::RIGHT`] is the lecture's own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Program {
    /// w along the view.
    pub(super) w_forwards: bool,
    /// w of the view's length.
    pub(super) w_raw: bool,
    /// u as long as `up x w`.
    pub(super) u_raw: bool,
    /// v is normalized, whatever w and u are.
    pub(super) v_unit: bool,
    /// `w x up`.
    pub(super) u_swapped: bool,
    /// `u x w`.
    pub(super) v_swapped: bool,
    /// up in v's place, and whether it is normalized.
    pub(super) up_as_v: Option<bool>,
    pub(super) distance: Distance,
    /// The direction leads back to the eye.
    pub(super) reversed: bool,
    pub(super) place: Place,
    /// What is added to row and column.
    pub(super) shift: f64,
    /// The last row and column are H and W.
    pub(super) from_one: bool,
    pub(super) bottom: Bottom,
    pub(super) swap: Swap,
    pub(super) extent: Extent,
    /// Every number in `f32`.
    pub(super) single: bool,
    pub(super) quadratic: Quadratic,
    pub(super) root: WhichRoot,
    pub(super) sign: Sign,
    pub(super) measure: Measure,
    /// Objects are counted from 1.
    pub(super) objects_from_one: bool,
}

/// What stands for the viewport's distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Distance {
    Right,
    One,
    /// There is no part along w.
    LeftOut,
    /// It is added.
    Plus,
}

/// Where in a pixel its ray passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    Centre,
    /// `j / W`.
    Corner,
    /// `j / W`, and `(i + 0.5) / H`.
    CornerAcross,
    /// `(j + 0.5) / W`, and `i / H`.
    CornerDown,
    /// `j / (W - 1)`: the first pixel on one edge, the last on the other.
    EdgeToEdge,
}

/// Where rows count from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bottom {
    /// The top.
    No,
    /// v has the other sign.
    SignOfV,
    /// The row is `H - 1 - i`.
    LastRow,
}

/// Which index is which.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Swap {
    No,
    /// `i / W` and `j / H`.
    Indices,
    /// `i / H` and `j / W`, for u and v.
    Shares,
    /// `j / H` and `i / W`.
    Counts,
}

/// What stands for the viewport's width and height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Extent {
    Right,
    WidthForHeight,
    HeightForWidth,
    /// 1 and 1, where they differ.
    Ones,
    /// The width made of the height, and the image's W / H.
    WidthByImage,
    /// The height made of the width, and the image's H / W.
    HeightByImage,
}

/// `t = (-numerator b -+ sqrt(square b^2 - product a c)) / (denominator a)`, with
/// `b = d . (p - center)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quadratic {
    pub(super) numerator: f64,
    pub(super) square: f64,
    pub(super) product: f64,
    pub(super) denominator: f64,
    /// `a` is taken as 1.
    pub(super) a_left_out: bool,
}

/// Which root is an object's hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WhichRoot {
    Near,
    Far,
    /// Of all roots of all objects, the largest.
    Farthest,
    /// The last object's that is hit at all.
    Last,
}

/// Which t count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sign {
    Positive,
    /// All, the smallest first.
    Any,
    /// All, the smallest in size first.
    Nearest,
}

/// What t and point are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measure {
    /// t, and `p + t d`.
    Right,
    /// `t |d|`, and `p + t d`.
    Distance,
    /// t, and `p + t d/|d|`.
    PointOfUnit,
    /// `t |d|`, and `p + t |d| d`.
    PointOfDistance,
}

impl Quadratic {
    const RIGHT: Quadratic = Quadratic::of(1.0, 1.0, 1.0, 1.0);

    const fn of(numerator: f64, square: f64, product: f64, denominator: f64) -> Quadratic {
        Quadratic { numerator, square, product, denominator, a_left_out: false }
    }

    /// Whether the roots are the right ones.
    pub(super) fn is_right(&self) -> bool {
        *self == Quadratic::RIGHT
    }
}

/// One way to make a mistake.
#[derive(Clone, Copy, Debug)]
pub(super) enum Change {
    WForwards,
    VSwapped,
    USwapped,
    BothSwapped,
    Raw { w: bool, u: bool, v_unit: bool },
    ALeftOut,
    UpAsV { unit: bool },
    Distance(Distance),
    Place(Place),
    Shift(f64),
    LoopFromOne,
    ObjectsFromOne,
    AllFromOne,
    Bottom(Bottom),
    Swap(Swap),
    Extent(Extent),
    Single,
    Quadratic(Quadratic),
    Root(WhichRoot),
    Sign(Sign),
    Measure(Measure),
}

impl KnownMistake {
    /// The ways to make it, the usual one first.
    pub(super) fn ways(self) -> &'static [Change] {
        use Change::*;
        const fn raw(w: bool, u: bool, v_unit: bool) -> Change {
            Raw { w, u, v_unit }
        }
        match self {
            KnownMistake::WAsPrinted => &[WForwards],
            KnownMistake::VIsUCrossW => &[VSwapped],
            KnownMistake::NotNormalized => {
                const WAYS: [Change; 7] = [
                    raw(false, true, false),
                    raw(true, false, false),
                    raw(true, true, false),
                    raw(false, true, true),
                    raw(true, false, true),
                    raw(true, true, true),
                    ALeftOut,
                ];
                &WAYS
            }
            KnownMistake::UpAsV => &[UpAsV { unit: false }, UpAsV { unit: true }],
            KnownMistake::DistanceDropped => {
                &[Distance(self::Distance::One), Distance(self::Distance::LeftOut)]
            }
            KnownMistake::PixelCorner => {
                use self::Place as P;
                &[
                    Place(P::Corner),
                    Place(P::EdgeToEdge),
                    Place(P::CornerAcross),
                    Place(P::CornerDown),
                ]
            }
            KnownMistake::RowsFromBottom => {
                &[Bottom(self::Bottom::SignOfV), Bottom(self::Bottom::LastRow)]
            }
            KnownMistake::RowsColumnsSwapped => {
                &[Swap(self::Swap::Indices), Swap(self::Swap::Shares), Swap(self::Swap::Counts)]
            }
            KnownMistake::CountedFromOne => {
                &[Shift(-1.0), LoopFromOne, Shift(1.0), ObjectsFromOne, AllFromOne]
            }
            KnownMistake::AspectDropped => &[
                Extent(self::Extent::WidthForHeight),
                Extent(self::Extent::HeightForWidth),
                Extent(self::Extent::Ones),
                Extent(self::Extent::WidthByImage),
                Extent(self::Extent::HeightByImage),
            ],
            KnownMistake::LeftHanded => &[BothSwapped, USwapped],
            KnownMistake::SinglePrecision => &[Single],
            KnownMistake::BForHalfB => {
                const WAYS: [Change; 7] = [
                    Quadratic(self::Quadratic::of(2.0, 4.0, 1.0, 1.0)),
                    Quadratic(self::Quadratic::of(1.0, 1.0, 4.0, 2.0)),
                    Quadratic(self::Quadratic::of(2.0, 4.0, 4.0, 1.0)),
                    Quadratic(self::Quadratic::of(1.0, 1.0, 1.0, 2.0)),
                    Quadratic(self::Quadratic::of(2.0, 1.0, 1.0, 1.0)),
                    Quadratic(self::Quadratic::of(1.0, 4.0, 4.0, 2.0)),
                    Quadratic(self::Quadratic::of(2.0, 4.0, 1.0, 2.0)),
                ];
                &WAYS
            }
            KnownMistake::FarRoot => {
                &[Root(WhichRoot::Far), Root(WhichRoot::Farthest), Root(WhichRoot::Last)]
            }
            KnownMistake::NegativeT => &[Sign(self::Sign::Any), Sign(self::Sign::Nearest)],
            KnownMistake::TForDistance => &[
                Measure(self::Measure::Distance),
                Measure(self::Measure::PointOfUnit),
                Measure(self::Measure::PointOfDistance),
            ],
        }
    }
}

impl Program {
    /// Without any mistake.
    pub(super) const RIGHT: Program = Program {
        w_forwards: false,
        w_raw: false,
        u_raw: false,
        v_unit: false,
        u_swapped: false,
        v_swapped: false,
        up_as_v: None,
        distance: Distance::Right,
        reversed: false,
        place: Place::Centre,
        shift: 0.0,
        from_one: false,
        bottom: Bottom::No,
        swap: Swap::No,
        extent: Extent::Right,
        single: false,
        quadratic: Quadratic::RIGHT,
        root: WhichRoot::Near,
        sign: Sign::Positive,
        measure: Measure::Right,
        objects_from_one: false,
    };

    /// Right but for one slip that is none of the known mistakes, and what is said of it.
    pub(super) const OTHER_SLIPS: [(Program, OtherSlip); 2] = [
        (Program { reversed: true, ..Program::RIGHT }, OtherSlip::RayReversed),
        (Program { distance: Distance::Plus, ..Program::RIGHT }, OtherSlip::DistanceAdded),
    ];

    /// The program with one mistake more.
    pub(super) fn with(mut self, change: Change) -> Program {
        match change {
            Change::WForwards => self.w_forwards = true,
            // Two exchanges are none.
            Change::VSwapped => self.v_swapped = !self.v_swapped,
            Change::USwapped => self.u_swapped = !self.u_swapped,
            Change::BothSwapped => {
                self.u_swapped = !self.u_swapped;
                self.v_swapped = !self.v_swapped;
            }
            Change::Raw { w, u, v_unit } => {
                (self.w_raw, self.u_raw, self.v_unit) = (w, u, v_unit);
            }
            Change::ALeftOut => self.quadratic.a_left_out = true,
            Change::UpAsV { unit } => self.up_as_v = Some(unit),
            Change::Distance(distance) => self.distance = distance,
            Change::Place(place) => self.place = place,
            // The first one is 1, so that the last one is H or W.
            Change::Shift(shift) => (self.shift, self.from_one) = (shift, shift < 0.0),
            Change::LoopFromOne => self.from_one = true,
            Change::ObjectsFromOne => self.objects_from_one = true,
            Change::AllFromOne => {
                (self.shift, self.from_one, self.objects_from_one) = (-1.0, true, true);
            }
            Change::Bottom(bottom) => self.bottom = bottom,
            Change::Swap(swap) => self.swap = swap,
            Change::Extent(extent) => self.extent = extent,
            Change::Single => self.single = true,
            Change::Quadratic(quadratic) => {
                self.quadratic = Quadratic { a_left_out: self.quadratic.a_left_out, ..quadratic };
            }
            Change::Root(root) => self.root = root,
            Change::Sign(sign) => self.sign = sign,
            Change::Measure(measure) => self.measure = measure,
        }
        self
    }
}
