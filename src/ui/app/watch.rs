//! Noticing that another program has changed the scene's file.

use crate::model::files::Stamp;

/// What was seen of the file.
#[derive(Default)]
pub(super) struct Watch {
    /// The file at the last look, if it was changed.
    seen: Option<Stamp>,
    /// The file that was told about.
    told: Option<Stamp>,
}

impl Watch {
    /// Takes the stamp of a file that was changed. Returns true if that is to be told: not before the file
    /// rests from one look to the next, for it may still be written to; and only once.
    pub(super) fn is_news(&mut self, touched: Option<Stamp>, may_tell: bool) -> bool {
        let rests = touched.is_some() && touched == self.seen;
        self.seen = touched;
        let is_news = rests && may_tell && touched != self.told;
        if is_news {
            self.told = touched;
        }
        is_news
    }
}
