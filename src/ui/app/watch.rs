//! Noticing that another program has changed the scene's files.

use crate::model::files::Stamps;

/// The stamps that were seen.
#[derive(Default)]
pub(super) struct Watch {
    /// The files at the last look, if one was changed.
    seen: Option<Stamps>,
    /// The files that were told about.
    told: Option<Stamps>,
}

impl Watch {
    /// Takes the stamps of files of which one was changed. Returns true if that is to be told: not before it
    /// rests from one look to the next, for it may still be written to; and only once.
    pub(super) fn is_news(&mut self, touched: Option<Stamps>, may_tell: bool) -> bool {
        let rests = touched.is_some() && touched == self.seen;
        self.seen = touched;
        let is_news = rests && may_tell && touched != self.told;
        if is_news {
            self.told = touched;
        }
        is_news
    }
}
