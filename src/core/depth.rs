//! What a frame keeps `t` in, and how a row's answers go into it.

use fearless_simd::Simd;

/// What a frame keeps `t` in: `f64`, within half an ulp and 2^-40 of one, or `f32`, within half an
/// ulp and 2^-15 of one at less than half the time.
pub trait Depth: Copy + PartialOrd + Send + Sync + std::fmt::Debug + sealed::Sealed {
    /// 0
    #[doc(hidden)]
    const ZERO: Self;
    /// Where nothing is hit.
    const NONE: Self;
    /// How exact the row kernels' `t` must be, as a share.
    #[doc(hidden)]
    const DOUBT: f64;
    /// Whether that takes double-double.
    #[doc(hidden)]
    const IS_FINE: bool;

    /// The nearest one; infinite or the smallest positive one where it is beyond the range.
    #[doc(hidden)]
    fn of(t: f64) -> Self;

    /// As `f64`, exactly.
    fn widened(self) -> f64;

    /// Takes over what is nearer than what is there, and tells whether anything
    /// [is in doubt](Depth::is_in_doubt), which it leaves as it is.
    #[doc(hidden)]
    fn blend<S: Simd>(
        simd: S,
        found: &[f64],
        t: &mut [Self],
        object: &mut [u32],
        index: u32,
    ) -> bool;

    /// Whether a blended pixel is in doubt: the kernel could not give its `t`, that is close to the
    /// ends of the range, or closer to what is there than their rounding.
    #[doc(hidden)]
    fn is_in_doubt(found: f64, t: Self, object: u32, index: u32) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for f32 {}
}

macro_rules! depth {
    ($real:ident, $bits:ident, $doubt:expr, $is_fine:expr, $range:expr) => {
        impl Depth for $real {
            const ZERO: $real = 0.0;
            const NONE: $real = $real::INFINITY;
            const DOUBT: f64 = $doubt;
            const IS_FINE: bool = $is_fine;

            #[inline(always)]
            fn of(t: f64) -> $real {
                (t as $real).max($real::from_bits(1))
            }

            #[inline(always)]
            fn widened(self) -> f64 {
                self.into()
            }

            #[inline(always)]
            fn blend<S: Simd>(
                _: S,
                found: &[f64],
                t: &mut [$real],
                object: &mut [u32],
                index: u32,
            ) -> bool {
                let mut in_doubt = 0;
                for ((found, t), object) in found.iter().zip(t).zip(object) {
                    let (x, known) = (*found as $real, *t);
                    let is_sure = is_sure_beside(x, known);
                    // Masks instead of branches: a select before a store becomes a masked store,
                    // which is slow on many processors.
                    let take = $bits::from((x < known) & is_sure).wrapping_neg();
                    let bits = known.to_bits();
                    *t = $real::from_bits(bits ^ ((bits ^ x.to_bits()) & take));
                    *object ^= (*object ^ index) & (take as u32);
                    in_doubt |= $bits::from(!is_sure);
                }
                return in_doubt != 0;

                #[inline(always)]
                fn is_sure_beside(x: $real, known: $real) -> bool {
                    // Two t may be in the wrong order for their rounding.
                    const TIE: $real = 4.0 * $real::EPSILON;
                    let is_plain = (x > $range.0) & (x < $range.1);
                    (x == $real::INFINITY) | (is_plain & ((x - known).abs() > TIE * x))
                }
            }

            #[inline(always)]
            fn is_in_doubt(found: f64, t: $real, object: u32, index: u32) -> bool {
                const TIE: $real = 4.0 * $real::EPSILON;
                let x = found as $real;
                let is_plain = (x > $range.0) & (x < $range.1);
                let is_sure = (x == $real::INFINITY) | (is_plain & ((x - t).abs() > TIE * x));
                // What was just taken over is there itself.
                !is_sure && object != index
            }
        }
    };
}

// 2^-39 of f32 makes 2^-15 of an ulp.
depth!(f32, u32, 1.0 / (1_u64 << 39) as f64, false, (1e-37, 1e38));
depth!(f64, u64, crate::precise::T_DOUBT, true, (1e-290, 1e290));
