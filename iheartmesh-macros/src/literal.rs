//! What a string literal says, and which byte of the token each byte of the text comes from.
//!
//! **Invariant:** this is the only place that knows how Rust writes strings. rustc has accepted the token already,
//! so an escape that cannot be read is left as it stands and never an error.

use proc_macro2::{LineColumn, Literal};

/// The text of a string literal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// The value of the literal.
    pub text: String,
    /// Byte of `text` and byte of the token, wherever the two begin to advance together.
    pub jumps: Vec<(usize, usize)>,
}

impl Decoded {
    /// A text that stands in its token as it is, from byte `start` of the token.
    pub fn verbatim(text: &str, start: usize) -> Self {
        Self {
            text: text.to_string(),
            jumps: vec![(0, start)],
        }
    }

    /// Leaves out one space at the start, which separates `///` from what is written after it.
    pub fn without_first_space(mut self) -> Self {
        if self.text.starts_with(' ') {
            self.text.remove(0);
            self.jumps.retain(|&(text, _)| text != 1);
            for (text, token) in &mut self.jumps {
                *token += usize::from(*text == 0);
                *text = text.saturating_sub(1);
            }
        }
        self
    }

    /// Byte of the token that the byte `offset` of the text comes from.
    pub fn in_token(&self, offset: usize) -> usize {
        let next = self.jumps.partition_point(|&(text, _)| text <= offset);
        match next.checked_sub(1).map(|k| self.jumps[k]) {
            Some((text, token)) => token + (offset - text),
            None => offset,
        }
    }
}

/// The value of a string literal; the error says what it is instead.
pub fn decode(literal: &Literal) -> Result<Decoded, &'static str> {
    let token = literal.to_string();
    let prefix = token.find(['"', '\'']).unwrap_or(0);
    let kind = token[..prefix].trim_end_matches('#');
    match (kind, token[prefix..].chars().next()) {
        ("", Some('"')) => {
            let end = closing_quote(&token, 1);
            no_suffix(&token[end + 1..])?;
            Ok(unescape(&token[..end], 1))
        }
        ("r", Some('"')) => {
            let start = prefix + 1;
            let hashes = prefix - 1;
            let end = token.rfind('"').unwrap_or(start).max(start);
            no_suffix(token[end..].get(1 + hashes..).unwrap_or(""))?;
            Ok(Decoded::verbatim(&token[start..end], start))
        }
        ("b" | "br", Some('"')) => Err("a byte string"),
        ("c" | "cr", Some('"')) => Err("a C string"),
        (_, Some('\'')) => Err("a character"),
        _ => Err("a number"),
    }
}

fn no_suffix(rest: &str) -> Result<(), &'static str> {
    match rest {
        "" => Ok(()),
        _ => Err("a string with a suffix"),
    }
}

/// Byte of the quote that closes an escaped string whose text starts at `start`.
fn closing_quote(token: &str, start: usize) -> usize {
    let mut escaped = false;
    for (k, c) in token[start..].char_indices() {
        match c {
            '"' if !escaped => return start + k,
            _ => escaped = c == '\\' && !escaped,
        }
    }
    token.len() - 1
}

/// The text of `token[start..]` with its escapes replaced.
fn unescape(token: &str, start: usize) -> Decoded {
    let mut decoded = Decoded::verbatim("", start);
    let mut at = start;
    while let Some(c) = token[at..].chars().next() {
        if c != '\\' {
            decoded.text.push(c);
            at += c.len_utf8();
            continue;
        }
        let (value, length) = escape(&token[at..]);
        decoded.text.extend(value);
        at += length;
        let jump = (decoded.text.len(), at);
        match decoded.jumps.last_mut() {
            Some(last) if last.0 == jump.0 => *last = jump,
            _ => decoded.jumps.push(jump),
        }
    }
    decoded
}

/// The character that an escape at the start of `rest` stands for, and the escape's length.
fn escape(rest: &str) -> (Option<char>, usize) {
    let hexadecimal = |digits: &str| {
        u32::from_str_radix(&digits.replace('_', ""), 16)
            .ok()
            .and_then(char::from_u32)
    };
    match rest[1..].chars().next() {
        Some('n') => (Some('\n'), 2),
        Some('r') => (Some('\r'), 2),
        Some('t') => (Some('\t'), 2),
        Some('0') => (Some('\0'), 2),
        Some(c @ ('\\' | '\'' | '"')) => (Some(c), 2),
        Some('x') => (rest.get(2..4).and_then(hexadecimal), 4.min(rest.len())),
        Some('u') => match (rest.find('{'), rest.find('}')) {
            (Some(open), Some(close)) if open < close => {
                (hexadecimal(&rest[open + 1..close]), close + 1)
            }
            _ => (Some('\\'), 1),
        },
        // a line continuation: the line break and the white space after it are not part of the text
        Some('\n') => {
            let more = rest[1..].trim_start_matches([' ', '\n', '\r', '\t']);
            (None, rest.len() - more.len())
        }
        _ => (Some('\\'), 1),
    }
}

/// Line and column, both from 1 and in characters, of the byte `at` of a token that starts at `start`.
pub fn place_in_file(start: LineColumn, token: &str, at: usize) -> (u32, u32) {
    let mut at = at.min(token.len());
    while !token.is_char_boundary(at) {
        at -= 1;
    }
    let before = &token[..at];
    let column = before.rsplit('\n').next().unwrap_or("").chars().count();
    match before.matches('\n').count() {
        0 => (start.line as u32, (start.column + column + 1) as u32),
        lines => ((start.line + lines) as u32, (column + 1) as u32),
    }
}

#[cfg(test)]
mod tests {
    use super::{Decoded, decode, place_in_file};
    use proc_macro2::{LineColumn, Literal};

    fn literal(token: &str) -> Literal {
        token.parse().unwrap()
    }

    fn text(token: &str) -> String {
        decode(&literal(token)).unwrap().text
    }

    #[test]
    fn raw_strings_of_any_number_of_hashes() {
        assert_eq!(text(r#"r"a\n""#), r"a\n");
        assert_eq!(text(r###"r##"say "#x" twice"##"###), r##"say "#x" twice"##);
        assert_eq!(decode(&literal("r##\"ab\"##")).unwrap().in_token(1), 5);
        assert_eq!(text("r\"\""), "");
    }

    #[test]
    fn escapes_are_replaced_and_mapped() {
        let decoded = decode(&literal(r#""a\tb\u{2208}c\x41\"\\d""#)).unwrap();
        assert_eq!(decoded.text, "a\tb∈cA\"\\d");
        let d = decoded.text.find('d').unwrap();
        assert_eq!(decoded.in_token(d), r#""a\tb\u{2208}c\x41\"\\"#.len());
        assert_eq!(decoded.in_token(0), 1);
        assert_eq!(decoded.in_token(1), 2);
        assert_eq!(decoded.in_token(2), 4);
    }

    #[test]
    fn a_line_continuation_leaves_out_the_indentation() {
        let decoded = decode(&literal("\"a\\\n    b\"")).unwrap();
        assert_eq!(decoded.text, "ab");
        assert_eq!(decoded.in_token(1), 8);
    }

    #[test]
    fn what_is_not_a_string_is_named() {
        assert_eq!(decode(&literal("b\"x\"")), Err("a byte string"));
        assert_eq!(decode(&literal("br#\"x\"#")), Err("a byte string"));
        assert_eq!(decode(&literal("c\"x\"")), Err("a C string"));
        assert_eq!(decode(&literal("'\"'")), Err("a character"));
        assert_eq!(decode(&literal("1.5")), Err("a number"));
        assert_eq!(decode(&literal("\"x\"km")), Err("a string with a suffix"));
        assert_eq!(
            decode(&literal("r#\"x\"#km")),
            Err("a string with a suffix")
        );
    }

    #[test]
    fn the_space_after_the_slashes_is_not_text() {
        let stripped = Decoded::verbatim(" x = 1", 0).without_first_space();
        assert_eq!(stripped, Decoded::verbatim("x = 1", 1));
        let untouched = Decoded::verbatim("x = 1", 0).without_first_space();
        assert_eq!(untouched, Decoded::verbatim("x = 1", 0));
    }

    #[test]
    fn places_count_characters_and_lines() {
        let start = LineColumn { line: 3, column: 8 };
        assert_eq!(place_in_file(start, "\"∑x\ny\"", 4), (3, 11));
        assert_eq!(place_in_file(start, "\"∑x\ny\"", 6), (4, 1));
        assert_eq!(place_in_file(start, "\"∑x\"", 2), (3, 10));
    }
}
