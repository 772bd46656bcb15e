//! The image: how many pixels the viewport is cut into.

use std::fmt;

/// The image's width W and height H in pixels, 1 to [`ImageSize::MAX`] each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ImageSize {
    width: u32,
    height: u32,
}

/// A pixel by row (0 on top) and column (0 at the left).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pixel {
    /// Row, from 0 at the top to H - 1.
    pub row: u32,
    /// Column, from 0 at the left to W - 1.
    pub column: u32,
}

/// An image measure outside 1 to [`ImageSize::MAX`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ImageError {
    /// `width` or `height`.
    pub field: &'static str,
    /// The value.
    pub value: u32,
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ImageError { field, value } = self;
        write!(f, "image {field} is {value}: it must be 1 to {} pixels", ImageSize::MAX)
    }
}

impl std::error::Error for ImageError {}

impl ImageSize {
    /// The largest width and height.
    pub const MAX: u32 = 16_384;

    /// An image of `width` x `height` pixels.
    ///
    /// # Errors
    /// Returns an error if one of them is 0 or above [`ImageSize::MAX`].
    pub const fn new(width: u32, height: u32) -> Result<ImageSize, ImageError> {
        ImageSize::within(ImageSize::MAX, width, height)
    }

    /// An image of which only some rows and columns are ever traced, [`ImageSize::MAX`] of each at
    /// most: it may be up to four times as large. The margins of [`crate::render::outline::extent`]
    /// allow for that.
    #[doc(hidden)]
    pub const fn partly_traced(width: u32, height: u32) -> Result<ImageSize, ImageError> {
        ImageSize::within(4 * ImageSize::MAX, width, height)
    }

    const fn within(most: u32, width: u32, height: u32) -> Result<ImageSize, ImageError> {
        if width == 0 || width > most {
            return Err(ImageError { field: "width", value: width });
        }
        if height == 0 || height > most {
            return Err(ImageError { field: "height", value: height });
        }
        Ok(ImageSize { width, height })
    }

    /// W, in pixels.
    pub fn width(self) -> u32 {
        self.width
    }

    /// H, in pixels.
    pub fn height(self) -> u32 {
        self.height
    }

    /// W / H.
    pub fn aspect(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    /// Number of pixels: W H.
    pub fn pixel_count(self) -> u64 {
        u64::from(self.width()) * u64::from(self.height())
    }

    /// Returns whether the pixel lies in the image.
    pub fn contains(self, pixel: Pixel) -> bool {
        pixel.row < self.height && pixel.column < self.width
    }
}
