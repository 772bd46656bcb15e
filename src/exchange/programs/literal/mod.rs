//! Cameras of pasted text, where every number is literal: `gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)`.
//!
//! No name is followed and nothing is worked out but a quotient such as 4.0 / 3.0 and an angle's
//! `radians(45)`. A text is understood to its end or refused at the line at fault: each statement must be
//! one that gives the camera.

pub(super) mod numbers;
mod statements;

use pinhole_core::DVec3;

use crate::FileError;
use crate::error::one_line;
use crate::format::Input;

pub(crate) use statements::{Argument, Statement, last_segment};

/// The statements of a text, and how its faults are told.
pub(crate) struct Source<'a> {
    text: &'a Input<'a>,
    pub(crate) statements: Vec<Statement>,
}

impl<'a> Source<'a> {
    /// Splits a text into its statements; `right` is what each of them must be.
    ///
    /// # Errors
    /// Returns the first position that is no statement.
    pub(crate) fn new(text: &'a Input<'a>, right: &str) -> Result<Self, FileError> {
        let refused = |plain: &str, (at, right): (usize, &str)| {
            let rest = plain[at..].split([';', '\n']).next().unwrap_or_default();
            text.error_at(at, refusal(rest, right))
        };
        let plain =
            statements::without_comments(text.text).map_err(|fault| refused(text.text, fault))?;
        let statements =
            statements::statements(&plain, right).map_err(|fault| refused(&plain, fault))?;
        Ok(Source { text, statements })
    }

    /// `statement: right`, at its position.
    pub(crate) fn refused(&self, statement: &Statement, right: &str) -> FileError {
        self.text.error_at(statement.at, refusal(&statement.text, right))
    }

    /// `field is value: right`, at the value's place.
    pub(crate) fn fault(&self, field: &str, argument: &Argument, right: &str) -> FileError {
        self.text.error_at(argument.at, format!("{field} is {}: {right}", one_line(&argument.text)))
    }

    pub(crate) fn missing(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.text.path, format!("{field} is missing: {right}"))
    }

    /// Refuses what is given a second time.
    pub(crate) fn once<T>(
        &self,
        given: &mut Option<T>,
        value: T,
        statement: &Statement,
    ) -> Result<(), FileError> {
        match given.replace(value) {
            None => Ok(()),
            Some(_) => Err(self.refused(statement, "it is given twice: leave in the camera's")),
        }
    }

    pub(crate) fn numbers(&self, field: &str, argument: &Argument) -> Result<Vec<f64>, FileError> {
        argument.numbers.clone().ok_or_else(|| {
            self.fault(
                field,
                argument,
                "it must be given by numbers, without names or calculations",
            )
        })
    }

    pub(crate) fn number(&self, field: &str, argument: &Argument) -> Result<f64, FileError> {
        match self.numbers(field, argument)?[..] {
            [number] => Ok(number),
            _ => Err(self.fault(field, argument, "it must be one number")),
        }
    }

    pub(crate) fn vector(&self, field: &str, argument: &Argument) -> Result<DVec3, FileError> {
        match self.numbers(field, argument)?[..] {
            [x, y, z] => Ok(DVec3::new(x, y, z)),
            _ => Err(self.fault(field, argument, "it must be three numbers")),
        }
    }

    /// The numbers of all arguments together.
    pub(crate) fn all_numbers<const N: usize>(
        &self,
        statement: &Statement,
    ) -> Result<[f64; N], FileError> {
        let mut all = Vec::new();
        for argument in &statement.arguments {
            all.extend(self.numbers(&statement.called, argument)?);
        }
        all.try_into().map_err(|_| self.refused(statement, &format!("it must have {N} numbers")))
    }
}

/// Returns `statement: right`, with the statement in one line and without a colon of its own.
fn refusal(statement: &str, right: &str) -> String {
    format!("{}: {right}", one_line(statement).trim_end_matches(':'))
}

/// Three vectors of nine numbers.
pub(crate) fn three([a, b, c, d, e, f, g, h, i]: [f64; 9]) -> [DVec3; 3] {
    [DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i)]
}
