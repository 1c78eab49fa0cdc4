//! Words and binary numbers of formats that have both.

use std::borrow::Cow;

use super::error::{Malformed, Place};
use super::text::shorten;

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// The type of a binary number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Scalar {
    /// Number of bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::I64 | Scalar::U64 | Scalar::F64 => 8,
        }
    }
}

/// The contents of a file, read from the front.
pub(super) struct Stream<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The line at which `at` stands, from 1.
    line: usize,
    /// Where the last word or number began.
    place: Place,
    /// The sign after which the rest of a line is a comment.
    comment: Option<u8>,
    /// Whether places are bytes: lines mean nothing in a file with binary parts.
    pub(super) is_binary: bool,
    /// Number of bytes that may still be taken for what is not written out in the file.
    allowance: usize,
    /// How the numbers of [`Stream::value`] and [`Stream::whole`] are written; words are always text.
    pub(super) encoding: Encoding,
}

impl<'a> Stream<'a> {
    pub(super) fn new(bytes: &'a [u8], comment: Option<u8>) -> Self {
        Stream {
            bytes,
            at: 0,
            line: 1,
            place: Place::Line(1),
            comment,
            is_binary: false,
            allowance: bytes.len().saturating_mul(32).saturating_add(1 << 16),
            encoding: Encoding::Text,
        }
    }

    /// An error where the last word or number began.
    pub(super) fn error(&self, problem: impl Into<String>, help: &'static str) -> Malformed {
        Malformed {
            place: self.place,
            problem: problem.into(),
            help,
        }
    }

    /// The line, or the byte in a file with binary parts, where the last word or number began.
    pub(super) fn place(&self) -> usize {
        match self.place {
            Place::Line(number) | Place::Byte(number) | Place::Entry(_, number) => number,
        }
    }

    /// An error at a [`place`](Self::place).
    pub(super) fn error_at(
        &self,
        place: usize,
        problem: impl Into<String>,
        help: &'static str,
    ) -> Malformed {
        let place = match self.is_binary {
            true => Place::Byte(place),
            false => Place::Line(place),
        };
        Malformed {
            place,
            problem: problem.into(),
            help,
        }
    }

    fn truncated(&self, what: &str) -> Malformed {
        self.error(
            format!("the file ends before {what}"),
            "it may be truncated",
        )
    }

    fn here(&self) -> Place {
        match self.is_binary {
            true => Place::Byte(self.at),
            false => Place::Line(self.line),
        }
    }

    fn skip_blanks(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if Some(byte) == self.comment {
                while self.bytes.get(self.at).is_some_and(|&byte| byte != b'\n') {
                    self.at += 1;
                }
                continue;
            }
            if !byte.is_ascii_whitespace() {
                break;
            }
            self.line += usize::from(byte == b'\n');
            self.at += 1;
        }
    }

    /// The next word, or `None` at the end.
    pub(super) fn next(&mut self) -> Option<Cow<'a, str>> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let is_end = |&byte: &u8| byte.is_ascii_whitespace() || Some(byte) == self.comment;
        let length = rest.iter().position(is_end).unwrap_or(rest.len());
        if length == 0 {
            return None;
        }
        self.place = self.here();
        self.at += length;
        Some(String::from_utf8_lossy(&rest[..length]))
    }

    /// The next word without reading it.
    pub(super) fn peek(&mut self) -> Option<Cow<'a, str>> {
        let before = (self.at, self.line, self.place);
        let word = self.next();
        (self.at, self.line, self.place) = before;
        word
    }

    pub(super) fn word(&mut self, what: &str) -> Result<Cow<'a, str>, Malformed> {
        self.next().ok_or_else(|| self.truncated(what))
    }

    /// What is left of the line, without blanks at both ends.
    pub(super) fn rest_of_line(&mut self) -> Cow<'a, str> {
        self.place = self.here();
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|&byte| byte == b'\n');
        self.at += length.map_or(rest.len(), |length| length + 1);
        self.line += usize::from(length.is_some());
        String::from_utf8_lossy(rest[..length.unwrap_or(rest.len())].trim_ascii())
    }

    /// Reads on past the line that is this word, and whatever stands before it.
    pub(super) fn skip_to(&mut self, word: &str) -> Result<(), Malformed> {
        let rest = &self.bytes[self.at..];
        let found = rest
            .windows(word.len().max(1))
            .position(|window| window == word.as_bytes());
        let Some(found) = found else {
            return Err(self.truncated(&format!("`{word}`")));
        };
        let length = found + word.len();
        self.line += rest[..length].iter().filter(|&&byte| byte == b'\n').count();
        self.at += length;
        Ok(())
    }

    /// A whole number as a word.
    pub(super) fn integer(&mut self, what: &str) -> Result<i64, Malformed> {
        let word = self.word(what)?;
        word.parse().map_err(|_| {
            self.error(
                format!("{what} `{}` is no whole number", shorten(&word)),
                "write it as 17",
            )
        })
    }

    /// A number as a word; it may be infinite or NaN.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, Malformed> {
        let word = self.word(what)?;
        word.parse().map_err(|_| {
            self.error(
                format!("{what} `{}` is no number", shorten(&word)),
                "write it as 1.5e-3",
            )
        })
    }

    fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], Malformed> {
        self.place = Place::Byte(self.at);
        let bytes = self.bytes[self.at..].first_chunk::<N>();
        let Some(&(mut bytes)) = bytes else {
            return Err(self.truncated(what));
        };
        self.at += N;
        // little-endian from here on
        if self.encoding == Encoding::BigEndian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// A whole number in the encoding of the file; `scalar` is its type in binary files.
    pub(super) fn whole(&mut self, what: &str, scalar: Scalar) -> Result<i64, Malformed> {
        if self.encoding == Encoding::Text {
            return self.integer(what);
        }
        Ok(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.array(what)?).into(),
            Scalar::U8 => u8::from_le_bytes(self.array(what)?).into(),
            Scalar::I16 => i16::from_le_bytes(self.array(what)?).into(),
            Scalar::U16 => u16::from_le_bytes(self.array(what)?).into(),
            Scalar::I32 => i32::from_le_bytes(self.array(what)?).into(),
            Scalar::U32 => u32::from_le_bytes(self.array(what)?).into(),
            Scalar::I64 => i64::from_le_bytes(self.array(what)?),
            Scalar::U64 => i64::try_from(u64::from_le_bytes(self.array(what)?)).unwrap_or(i64::MAX),
            Scalar::F32 | Scalar::F64 => {
                let value = self.value(what, scalar)?;
                if value.fract() != 0.0 || value.abs() > 2_f64.powi(53) {
                    return Err(self.error(
                        format!("{what} {value} is no whole number"),
                        "write it as 17",
                    ));
                }
                value as i64
            }
        })
    }

    /// A number in the encoding of the file; `scalar` is its type in binary files.
    pub(super) fn value(&mut self, what: &str, scalar: Scalar) -> Result<f64, Malformed> {
        if self.encoding == Encoding::Text {
            return self.number(what);
        }
        Ok(match scalar {
            Scalar::F32 => f32::from_le_bytes(self.array(what)?).into(),
            Scalar::F64 => f64::from_le_bytes(self.array(what)?),
            Scalar::U64 => u64::from_le_bytes(self.array(what)?) as f64,
            _ => self.whole(what, scalar)? as f64,
        })
    }

    /// Three numbers that are a position.
    pub(super) fn position(&mut self, scalar: Scalar) -> Result<glam::DVec3, Malformed> {
        let mut position = glam::DVec3::ZERO;
        for axis in 0..3 {
            position[axis] = self.value("a coordinate", scalar)?;
        }
        match position.is_finite() {
            true => Ok(position),
            false => Err(self.error("the position is not finite", "positions are real numbers")),
        }
    }

    /// Values that a file gives for some elements only, or once for many, take more memory than they have bytes there.
    pub(super) fn take_memory(&mut self, n_bytes: usize, name: &str) -> Result<(), Malformed> {
        match self.allowance.checked_sub(n_bytes) {
            Some(allowance) => {
                self.allowance = allowance;
                Ok(())
            }
            None => Err(self.error(
                format!(
                    "the values `{}` and those before take far more memory than the file",
                    shorten(name)
                ),
                "give values of all elements",
            )),
        }
    }

    /// That `count` is a number of entries that the file can hold, if each takes this many words, or bytes in
    /// binary files. (A word takes two bytes, the last one may lack its blank.)
    pub(super) fn check_count(
        &self,
        list: &str,
        count: i64,
        words: usize,
        bytes: usize,
    ) -> Result<usize, Malformed> {
        let least = match self.encoding {
            Encoding::Text => words.saturating_mul(2),
            _ => bytes,
        };
        match usize::try_from(count) {
            Ok(count) if u32::try_from(count).is_err() && count <= self.bytes.len() => {
                let problem = format!("the number of {list} is {count}, more than 32 bits count");
                Err(self.error(problem, "divide the mesh"))
            }
            Ok(count) if count.saturating_mul(least) <= self.bytes.len() + 1 => Ok(count),
            Ok(_) => Err(self.error(
                format!("the number of {list} is {count}, more than the file can hold"),
                "it may be truncated",
            )),
            Err(_) => Err(self.error(
                format!("the number of {list} is {count}"),
                "it cannot be negative",
            )),
        }
    }
}
