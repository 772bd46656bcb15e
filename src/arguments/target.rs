//! What an export is written in, by name.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::code::{LANGUAGES, Language};
use crate::exchange::{FORMATS, Format};

/// What an export is written in.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    /// Another program's words.
    Format(&'static Format),
    /// A language.
    Code(&'static Language),
}

pub(super) fn target() -> impl TypedValueParser<Value = Target> {
    let formats = FORMATS.iter().map(|format| (format.name, format.label));
    let languages = LANGUAGES.iter().map(|language| (language.name, language.label));
    let named = |(name, label)| PossibleValue::new(name).help(label);
    PossibleValuesParser::new(formats.chain(languages).map(named)).map(|name| {
        let language = Language::named(&name).map(Target::Code);
        let format = || Target::Format(Format::named(&name).unwrap_or(&FORMATS[0]));
        language.unwrap_or_else(format)
    })
}

pub(super) fn exchange_format() -> impl TypedValueParser<Value = &'static Format> {
    PossibleValuesParser::new(
        FORMATS.iter().map(|format| PossibleValue::new(format.name).help(format.label)),
    )
    .map(|name| Format::named(&name).unwrap_or(&FORMATS[0]))
}
