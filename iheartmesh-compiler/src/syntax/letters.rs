//! Characters: letters with their marks, blanks, and the spellings that take several characters.

use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::is_combining_mark;

use super::spelling;

/// One letter of a name with its combining marks: its length in the text and its spelling in NFC.
pub(super) fn letter(text: &str) -> Option<(usize, String)> {
    let first = text.chars().next()?;
    if first.is_ascii() {
        if first == '\\' {
            let (length, sign) = escape(text)?;
            return is_letter(sign).then(|| (length, sign.to_string()));
        }
        if !first.is_ascii_alphabetic() {
            return None;
        }
    }
    let rest = &text[first.len_utf8()..];
    // a sign of the language with a mark, such as π̂, is a letter as any other
    let is_marked = || rest.starts_with(is_combining_mark);
    if !(first.is_ascii() || is_letter(first) || is_sign(first) && is_marked()) {
        return None;
    }
    if rest.as_bytes().first().is_none_or(u8::is_ascii) {
        let piece: String = first.nfc().collect();
        return Some((first.len_utf8(), piece));
    }
    let marks = rest.chars().take_while(|c| is_combining_mark(*c));
    let length = first.len_utf8() + marks.map(char::len_utf8).sum::<usize>();
    Some((length, text[..length].nfc().collect()))
}

/// A backslash with a name of the table: its length and the sign.
pub(super) fn escape(text: &str) -> Option<(usize, char)> {
    let rest = text.strip_prefix('\\')?;
    if let Some((length, sign)) = spelling::fraction_named(rest) {
        return Some((length + 1, sign));
    }
    let end = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
    let sign = spelling::sign(&rest[..end.min(16)])?;
    (end <= 16).then_some((end + 1, sign))
}

/// Whether a name may contain this character: a letter, but no modifier letter and no sign of the language.
fn is_letter(c: char) -> bool {
    if c.is_ascii() {
        return c.is_ascii_alphabetic();
    }
    let modifier = matches!(c,
        '\u{2b0}'..='\u{2ff}' | '\u{1d2c}'..='\u{1d6a}' | '\u{1d78}' | '\u{1d9b}'..='\u{1dbf}'
        | '\u{2071}' | '\u{207f}' | '\u{2090}'..='\u{209c}' | '\u{2c7c}' | '\u{2c7d}'
        | '\u{2160}'..='\u{2188}' | '\u{24b6}'..='\u{24e9}');
    c.is_alphabetic() && !modifier && !is_sign(c) && !is_combining_mark(c)
}

/// Whether a letter is a sign of the language, when it stands without marks.
fn is_sign(c: char) -> bool {
    matches!(c, 'ℝ' | 'ℤ' | 'π' | 'Δ' | '𝕕')
}

/// `^(-1)` or `^-1`, unless the number goes on: the length.
pub(super) fn inverse(rest: &str) -> Option<usize> {
    if rest.starts_with("^(-1)") {
        return Some(5);
    }
    let after = rest.strip_prefix("^-1")?;
    let mut bytes = after.bytes();
    let first = bytes.next();
    let exponent = first == Some(b'E')
        && bytes
            .next()
            .is_some_and(|b| b.is_ascii_digit() || b == b'-' || b == b'+');
    let goes_on = exponent || matches!(first, Some(b'0'..=b'9' | b'.'));
    (!goes_on).then_some(3)
}

/// Blanks inside a line.
pub(super) fn is_blank(c: char) -> bool {
    c == '\u{feff}' || c == '\u{200b}' || c.is_whitespace() && !is_break(c)
}

/// Ends of lines.
pub(super) fn is_break(c: char) -> bool {
    matches!(
        c,
        '\n' | '\r' | '\u{c}' | '\u{85}' | '\u{2028}' | '\u{2029}'
    )
}

/// Most characters of a text in quotes.
const LONGEST_QUOTATION: usize = 200;

/// The length of a text in quotes that closes on its line.
pub(super) fn quotation(rest: &str) -> Option<usize> {
    let first = rest.chars().next()?;
    let close = match first {
        '\'' | '"' => first,
        '‘' => '’',
        '“' => '”',
        _ => return None,
    };
    let inside = &rest[first.len_utf8()..];
    let mut letters = inside.char_indices().take(LONGEST_QUOTATION);
    let (end, last) = letters.find(|(_, c)| *c == close || is_break(*c))?;
    (last == close).then(|| first.len_utf8() + end + close.len_utf8())
}
