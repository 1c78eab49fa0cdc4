//! Lines and numbers of text formats.

use std::fmt::Write;

use glam::DVec3;

use super::error::{Malformed, Place};

/// The tokens of one line, and where it stands.
pub(super) struct Line<'a> {
    number: usize,
    tokens: std::str::SplitAsciiWhitespace<'a>,
}

impl<'a> Line<'a> {
    pub(super) fn new(number: usize, text: &'a str) -> Self {
        Line {
            number,
            tokens: text.split_ascii_whitespace(),
        }
    }

    pub(super) fn place(&self) -> Place {
        Place::Line(self.number)
    }

    /// An error in this line.
    pub(super) fn error(&self, problem: impl Into<String>, help: &'static str) -> Malformed {
        Malformed {
            place: self.place(),
            problem: problem.into(),
            help,
        }
    }

    pub(super) fn token(&mut self) -> Option<&'a str> {
        self.tokens.next()
    }

    /// How many tokens are left.
    pub(super) fn remaining(&self) -> usize {
        self.tokens.clone().count()
    }

    /// The next token as a number, which may be infinite or NaN.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, Malformed> {
        let Some(token) = self.token() else {
            return Err(self.error(format!("{what} is missing"), "the line ends too early"));
        };
        token.parse().map_err(|_| {
            self.error(
                format!("{what} `{}` is no number", shorten(token)),
                "write it as 1.5e-3",
            )
        })
    }

    /// The next token as a whole number.
    pub(super) fn integer(&mut self, what: &str) -> Result<i64, Malformed> {
        let Some(token) = self.token() else {
            return Err(self.error(format!("{what} is missing"), "the line ends too early"));
        };
        token.parse().map_err(|_| {
            self.error(
                format!("{what} `{}` is no whole number", shorten(token)),
                "write it as 17",
            )
        })
    }

    /// The next three tokens as a finite position.
    pub(super) fn position(&mut self) -> Result<DVec3, Malformed> {
        let mut position = DVec3::ZERO;
        for (axis, what) in ["coordinate x", "coordinate y", "coordinate z"]
            .into_iter()
            .enumerate()
        {
            position[axis] = self.number(what)?;
        }
        if !position.is_finite() {
            return Err(self.error("the position is not finite", "positions are real numbers"));
        }
        Ok(position)
    }

    /// All remaining tokens as a colour of three components, a fourth (opacity) is left out: 0 to 255 each, or 0 to 1
    /// if `is_unit` or if any is written with a decimal point. `None` if there are neither three nor four.
    pub(super) fn color(&mut self, is_unit: bool) -> Result<Option<[u8; 3]>, Malformed> {
        if !matches!(self.remaining(), 3 | 4) {
            return Ok(None);
        }
        let is_unit = is_unit || self.tokens.clone().any(|token| token.contains('.'));
        let mut color = [0; 3];
        for component in &mut color {
            let value = self.number("colour component")? * if is_unit { 255.0 } else { 1.0 };
            // Saturates, and takes NaN to 0.
            *component = value.round() as u8;
        }
        Ok(Some(color))
    }
}

/// A token as it can stand in a message: short, and without control characters.
pub(super) fn shorten(token: &str) -> String {
    let mut shown: String = token
        .chars()
        .filter(|character| !character.is_control())
        .take(25)
        .collect();
    if shown.chars().count() > 24 {
        shown.pop();
        shown.push('…');
    }
    shown
}

/// A name as it is meant where `%20` stands for a blank.
pub(super) fn percent_decoded(name: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = name.as_bytes();
    while let Some((&first, others)) = rest.split_first() {
        let code = others.first_chunk::<2>().and_then(|digits| {
            // without this, `%+1` is a number, too
            let all_digits = digits.iter().all(u8::is_ascii_hexdigit);
            let digits = std::str::from_utf8(digits).ok().filter(|_| all_digits)?;
            u8::from_str_radix(digits, 16).ok()
        });
        (rest, _) = match (first, code) {
            (b'%', Some(code)) => (&others[2..], bytes.push(code)),
            _ => (others, bytes.push(first)),
        };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// A name as one word from which [`percent_decoded`] makes the name again.
pub(super) fn percent_encoded(name: &str) -> String {
    let mut word = String::with_capacity(name.len());
    for character in name.chars() {
        if character.is_whitespace() || character.is_control() || matches!(character, '%' | '"') {
            let mut bytes = [0; 4];
            for byte in character.encode_utf8(&mut bytes).bytes() {
                // Writing into a `String` cannot fail.
                let _ = write!(word, "%{byte:02X}");
            }
        } else {
            word.push(character);
        }
    }
    word
}
