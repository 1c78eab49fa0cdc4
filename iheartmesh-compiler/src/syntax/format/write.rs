//! Lines: where they begin, how far they are indented, and their comments.

use unicode_normalization::char::is_combining_mark;

use super::super::token::Kind;
use super::gap::Gap;
use super::pieces::Piece;
use super::space::spaces;

/// How far a line that goes on is indented.
const INDENT: usize = 4;

struct Line {
    text: String,
    /// A comment behind the text.
    comment: String,
}

/// An open bracket.
struct Open {
    /// The column after it.
    column: usize,
    /// The indentation of its line.
    indent: usize,
    /// Whether it ends its line.
    hangs: bool,
}

struct Writer {
    lines: Vec<Line>,
    indent: usize,
    open: Vec<Open>,
    /// The column of branches, constraints or initial values; `None` outside of them.
    branches: Option<usize>,
    /// Whether the next piece is the first branch.
    first_branch: bool,
    /// Whether a `where` has been written in this item.
    locals: bool,
    /// Whether this item begins with `where`, alone on its line.
    block: bool,
}

/// Writes the pieces of a text.
pub(super) fn write(pieces: &[Piece]) -> String {
    let mut writer = Writer {
        lines: Vec::new(),
        indent: 0,
        open: Vec::new(),
        branches: None,
        first_branch: false,
        locals: false,
        block: false,
    };
    let spaces = spaces(pieces);
    for (index, piece) in pieces.iter().enumerate() {
        let before = index.checked_sub(1).map(|before| &pieces[before]);
        writer.piece(piece, before, spaces[index]);
    }
    writer.finish()
}

/// The number of columns that a text takes.
fn width(text: &str) -> usize {
    text.chars().filter(|c| !is_combining_mark(*c)).count()
}

impl Writer {
    fn column(&self) -> usize {
        self.lines.last().map_or(0, |line| width(&line.text))
    }

    fn push(&mut self, text: &str) {
        if let Some(line) = self.lines.last_mut() {
            line.text += text;
        }
    }

    fn line(&mut self, indent: usize, text: &str) {
        self.lines.push(Line {
            text: " ".repeat(indent) + text,
            comment: String::new(),
        });
        self.indent = indent;
    }

    fn empty_line(&mut self, wanted: bool) {
        if wanted && !self.lines.is_empty() {
            self.lines.push(Line {
                text: String::new(),
                comment: String::new(),
            });
        }
    }

    fn piece(&mut self, piece: &Piece, before: Option<&Piece>, blanks: usize) {
        let gap = &piece.gap;
        let item =
            piece.separator == Some(Kind::Newline) || before.is_none() || piece.kind == Kind::End;
        if gap.semicolon && before.is_some() {
            self.push(";");
        }
        if item {
            self.open.clear();
            (self.branches, self.first_branch) = (None, false);
            (self.locals, self.block) = (false, false);
        } else if piece.kind == Kind::Where || self.begins_local(piece, before, blanks) {
            self.branches = None;
        }
        if gap.breaks || before.is_none() {
            let indent = match item {
                true => 0,
                false => self.continuation(piece, before),
            };
            self.comments(gap, indent, before.is_none());
            if piece.kind == Kind::End {
                return;
            }
            self.empty_line(gap.empty_line);
            self.line(indent, "");
        } else if piece.kind != Kind::End {
            self.push(&" ".repeat(blanks));
        }
        let column = self.column();
        if self.first_branch {
            self.branches = Some(column);
            self.first_branch = false;
        }
        self.push(&piece.text);
        self.follow(piece, item);
    }

    /// Whether a comma before this piece ends a local definition; those between subscripts have no blank.
    fn begins_local(&self, piece: &Piece, before: Option<&Piece>, blanks: usize) -> bool {
        let comma = before.is_some_and(|before| before.kind == Kind::Comma);
        comma && (blanks > 0 || piece.gap.breaks) && self.locals && self.open.is_empty()
    }

    fn comments(&mut self, gap: &Gap, indent: usize, first: bool) {
        for comment in &gap.comments {
            if comment.own_line || first {
                self.empty_line(comment.after_empty_line);
                self.line(indent, comment.text);
            } else if let Some(line) = self.lines.last_mut() {
                line.comment = comment.text.to_owned();
            }
        }
    }

    /// The indentation of a line that begins inside of an item.
    fn continuation(&mut self, piece: &Piece, before: Option<&Piece>) -> usize {
        let before = before.map(|before| before.kind);
        if before.is_some_and(is_opening)
            && let Some(open) = self.open.last_mut()
        {
            open.hangs = true;
        }
        let closes = matches!(
            piece.kind,
            Kind::RightParen | Kind::RightBracket | Kind::RightBrace
        );
        if let Some(open) = self.open.last() {
            return match (open.hangs, closes) {
                (true, true) => open.indent,
                (true, false) => open.indent + INDENT,
                (false, true) => open.column - 1,
                (false, false) => open.column,
            };
        }
        if before == Some(Kind::Where) && self.block {
            return 0;
        }
        let inner = if self.locals { 2 * INDENT } else { INDENT };
        match piece.kind {
            Kind::Where | Kind::With | Kind::SuchThat | Kind::Optimise(_) => INDENT,
            _ if self.first_branch => inner,
            _ if piece.separator == Some(Kind::Branch) => self.branches.unwrap_or(inner),
            _ if before == Some(Kind::Comma) || before == Some(Kind::Where) => INDENT,
            _ => self.branches.map_or(inner, |column| column + INDENT),
        }
    }

    fn follow(&mut self, piece: &Piece, item: bool) {
        match piece.kind {
            Kind::Piecewise | Kind::SuchThat | Kind::Initial => {
                self.first_branch = true;
                self.branches = None;
            }
            Kind::Where => {
                self.locals = true;
                self.block = item;
            }
            Kind::Optimise(_) => self.branches = None,
            kind if is_opening(kind) => self.open.push(Open {
                column: self.column(),
                indent: self.indent,
                hangs: false,
            }),
            Kind::RightParen | Kind::RightBracket | Kind::RightBrace => drop(self.open.pop()),
            _ => {}
        }
    }

    fn finish(self) -> String {
        let mut text = String::new();
        let mut index = 0;
        while index < self.lines.len() {
            // the comments of neighbouring lines begin at the same column
            let rest = &self.lines[index..];
            let count = rest
                .iter()
                .take_while(|line| !line.comment.is_empty())
                .count();
            let most = rest[..count]
                .iter()
                .map(|line| width(&line.text))
                .max()
                .unwrap_or(0);
            for line in &rest[..count] {
                let blanks = most + 1 - width(&line.text);
                text += &format!("{}{}{}\n", line.text, " ".repeat(blanks), line.comment);
            }
            if count == 0 {
                text += rest[0].text.trim_end();
                text.push('\n');
            }
            index += count.max(1);
        }
        text
    }
}

fn is_opening(kind: Kind) -> bool {
    matches!(kind, Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace)
}
