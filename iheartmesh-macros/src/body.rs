//! The source text of one module, from whatever spelling the user chose for it.
//!
//! | spelling | what rustc's own marker covers |
//! | --- | --- |
//! | `r#"…"#` or `"…"` | the whole literal |
//! | `include "file.hlang"` | the name of the file |
//! | `{ "one line" "next line" }` | the line's literal |
//! | `{ /// one line` … `}` | the line |

use crate::error::Error;
use crate::literal::{Decoded, decode, place_in_file};
use iheartmesh_compiler::source::{Place, Source};
use proc_macro2::{Delimiter, Group, LineColumn, Literal, Span, TokenStream, TokenTree};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A module's source, and the tokens that it was read from.
#[derive(Debug)]
pub struct Body {
    /// The text and its place.
    pub source: Source,
    /// The tokens, in the order of their texts.
    pieces: Vec<Piece>,
    /// The file that an `include` names, as it is written there.
    pub included: Option<String>,
}

/// One token of a body.
#[derive(Debug)]
struct Piece {
    /// What it contributes to the text.
    range: Range<usize>,
    literal: Literal,
    /// Where each byte of that contribution stands in the token; none for doc comments and file names.
    decoded: Option<Decoded>,
}

impl Body {
    /// A body of one string literal.
    pub fn of_literal(literal: Literal) -> Result<Self, Error> {
        let mut lines = Lines::default();
        lines.push_literal(literal)?;
        Ok(lines.finish())
    }

    /// A body of string literals or doc comments in braces, one line each.
    pub fn of_lines(group: &Group) -> Result<Self, Error> {
        let mut lines = Lines::default();
        let mut tokens = flat(group.stream()).into_iter();
        while let Some(token) = tokens.next() {
            match &token {
                TokenTree::Literal(literal) => lines.push_literal(literal.clone())?,
                TokenTree::Punct(hash) if hash.as_char() == '#' => {
                    let attribute = tokens.next();
                    let Some(literal) = attribute.as_ref().and_then(doc_text) else {
                        return Err(not_a_line(hash.span()));
                    };
                    lines.push_doc(literal, hash.span().start())?;
                }
                other => return Err(not_a_line(other.span())),
            }
        }
        if lines.pieces.is_empty() {
            return Err(not_a_line(group.span()));
        }
        Ok(lines.finish())
    }

    /// A body that stands in a file of its own; `name` is relative to the package of the crate being compiled.
    pub fn of_file(name: Literal) -> Result<Self, Error> {
        let written = decode(&name)
            .map_err(|found| {
                let expected = format!("expected the name of a file in quotes, not {found}");
                Error::new(name.span(), expected)
            })?
            .text;
        let path = package_directory().join(&written);
        let text = std::fs::read_to_string(&path).map_err(|reason| {
            let message = format!("cannot read `{}`: {reason}", path.display());
            Error::new(name.span(), message).help(
                "the name of the file is relative to the directory of the package's `Cargo.toml`",
            )
        })?;
        let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
        Ok(Self {
            pieces: vec![Piece {
                range: 0..text.len(),
                literal: name,
                decoded: None,
            }],
            source: Source::file(shown(&path), text),
            included: Some(written),
        })
    }

    /// The tokens that hold the byte `start` of the text, narrowed to `start..end` where the compiler offers it.
    pub fn span(&self, start: usize, end: usize) -> Span {
        let holding = |piece: &&Piece| start <= piece.range.end;
        let Some(piece) = self.pieces.iter().find(holding).or(self.pieces.last()) else {
            return Span::call_site();
        };
        let whole = piece.literal.span();
        let Some(decoded) = &piece.decoded else {
            return whole;
        };
        let inside = |offset: usize| {
            decoded.in_token(offset.clamp(piece.range.start, piece.range.end) - piece.range.start)
        };
        let range = inside(start)..inside(end.max(start));
        piece.literal.subspan(range).unwrap_or(whole)
    }
}

fn not_a_line(span: Span) -> Error {
    let message = "expected lines of source: string literals or `///` comments";
    Error::new(span, message)
}

/// Tokens without the invisible groups that a `macro_rules!` fragment such as `$text:literal` leaves.
pub fn flat(tokens: TokenStream) -> Vec<TokenTree> {
    let mut list = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                list.extend(flat(group.stream()));
            }
            other => list.push(other),
        }
    }
    list
}

/// The literal of `[doc = "…"]`.
fn doc_text(token: &TokenTree) -> Option<Literal> {
    let TokenTree::Group(group) = token else {
        return None;
    };
    match flat(group.stream()).as_slice() {
        [
            TokenTree::Ident(doc),
            TokenTree::Punct(equals),
            TokenTree::Literal(text),
        ] if doc == "doc" && equals.as_char() == '=' => Some(text.clone()),
        _ => None,
    }
}

/// Gathers the tokens of a body, one after the other, with a line break in between.
#[derive(Default)]
struct Lines {
    text: String,
    pieces: Vec<Piece>,
    places: Vec<Place>,
}

impl Lines {
    fn push_literal(&mut self, literal: Literal) -> Result<(), Error> {
        let decoded = decode(&literal).map_err(|found| {
            let expected = format!("the source of a module is a string, not {found}");
            Error::new(literal.span(), expected)
        })?;
        let token = literal.to_string();
        let start = literal.span().start();
        self.push(literal, decoded, &token, start, true);
        Ok(())
    }

    /// `start` is where the attribute starts: at the literal's own place if it is a `///` comment.
    fn push_doc(&mut self, literal: Literal, start: LineColumn) -> Result<(), Error> {
        let Ok(decoded) = decode(&literal) else {
            return Err(not_a_line(literal.span()));
        };
        if start == literal.span().start() {
            let line = decoded.text;
            let start = LineColumn {
                line: start.line,
                column: start.column + "///".len(),
            };
            let decoded = Decoded::verbatim(&line, 0).without_first_space();
            self.push(literal, decoded, &line, start, false);
        } else {
            let token = literal.to_string();
            let start = literal.span().start();
            let decoded = decoded.without_first_space();
            self.push(literal, decoded, &token, start, true);
        }
        Ok(())
    }

    fn push(
        &mut self,
        literal: Literal,
        decoded: Decoded,
        token: &str,
        start: LineColumn,
        exact: bool,
    ) {
        if !self.pieces.is_empty() {
            self.text.push('\n');
        }
        let offset = self.text.len();
        self.text += &decoded.text;
        for &(in_text, in_token) in &decoded.jumps {
            let (line, column) = place_in_file(start, token, in_token);
            self.places.push(Place {
                offset: (offset + in_text) as u32,
                line,
                column,
            });
        }
        self.pieces.push(Piece {
            range: offset..self.text.len(),
            literal,
            decoded: exact.then_some(decoded),
        });
    }

    fn finish(self) -> Body {
        let first = self.places.first().copied();
        let simple = self.places.len() == 1;
        Body {
            source: Source {
                file: self.pieces.first().map_or_else(String::new, |piece| {
                    shown(Path::new(&piece.literal.span().file()))
                }),
                text: self.text,
                first_line: first.map_or(1, |place| place.line),
                indents: first.map(|place| place.column - 1).into_iter().collect(),
                places: if simple { Vec::new() } else { self.places },
            },
            pieces: self.pieces,
            included: None,
        }
    }
}

fn package_directory() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(PathBuf::new, PathBuf::from)
}

/// A path as rustc shows it: relative to the directory that rustc was started in, where it is below that.
fn shown(path: &Path) -> String {
    let relative = std::env::current_dir()
        .ok()
        .and_then(|here| Some(path.strip_prefix(here).ok()?.to_path_buf()));
    relative
        .unwrap_or_else(|| path.to_path_buf())
        .display()
        .to_string()
}

#[cfg(test)]
mod tests {
    use super::Body;
    use proc_macro2::{Group, TokenStream, TokenTree};

    fn group(text: &str) -> Group {
        let tokens: TokenStream = text.parse().unwrap();
        match tokens.into_iter().next() {
            Some(TokenTree::Group(group)) => group,
            other => panic!("{other:?}"),
        }
    }

    fn of_literal(text: &str) -> Body {
        let tokens: TokenStream = text.parse().unwrap();
        match tokens.into_iter().last() {
            Some(TokenTree::Literal(literal)) => Body::of_literal(literal).unwrap(),
            other => panic!("{other:?}"),
        }
    }

    fn place(body: &Body, of: &str) -> (u32, u32) {
        let offset = body.source.text.find(of).unwrap();
        body.source.line_column(offset as u32)
    }

    #[test]
    fn a_raw_literal_starts_in_the_middle_of_a_line() {
        let body = of_literal("\n  x r#\"a ∈ V\n   b\"#");
        assert_eq!(place(&body, "a"), (2, 8));
        assert_eq!(place(&body, "V"), (2, 12));
        assert_eq!(place(&body, "b"), (3, 4));
        assert!(body.source.places.is_empty());
    }

    #[test]
    fn escapes_shift_columns_and_lines() {
        let body = of_literal(" x \"\\u{2208}a\\nb\\\n  c\nd\"");
        assert_eq!(body.source.text, "∈a\nbc\nd");
        assert_eq!(place(&body, "∈"), (1, 5));
        assert_eq!(place(&body, "a"), (1, 13));
        assert_eq!(place(&body, "b"), (1, 16));
        assert_eq!(place(&body, "c"), (2, 3));
        assert_eq!(place(&body, "d"), (3, 1));
    }

    #[test]
    fn lines_of_literals_stand_where_they_are() {
        let body = Body::of_lines(&group("{\n  \"a\"\n\n    r\"b c\" \"d\"\n}")).unwrap();
        assert_eq!(body.source.text, "a\nb c\nd");
        assert_eq!(place(&body, "a"), (2, 4));
        assert_eq!(place(&body, "c"), (4, 9));
        assert_eq!(place(&body, "d"), (4, 13));
        let c = body.source.text.find('c').unwrap();
        assert_eq!(body.span(c, c + 1).start().line, 4);
    }

    #[test]
    fn lines_of_doc_comments_lose_one_space() {
        let body = Body::of_lines(&group("{\n  /// a \"q\"\n  ///b\n  ///\n  ///   c\n}")).unwrap();
        assert_eq!(body.source.text, "a \"q\"\nb\n\n  c");
        assert_eq!(place(&body, "a"), (2, 7));
        assert_eq!(place(&body, "q"), (2, 10));
        assert_eq!(place(&body, "b"), (3, 6));
        assert_eq!(place(&body, "c"), (5, 9));
        let written = Body::of_lines(&group("{ #[doc = \" a\"] }")).unwrap();
        assert_eq!(place(&written, "a"), (1, 13));
    }

    #[test]
    fn anything_else_in_the_braces_is_an_error() {
        for wrong in ["{ }", "{ x }", "{ 1 }", "{ #[cfg(x)] }", "{ \"a\", \"b\" }"] {
            assert!(Body::of_lines(&group(wrong)).is_err(), "{wrong}");
        }
    }
}
