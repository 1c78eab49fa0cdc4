//! How many blanks stand between two pieces on a line.

use super::super::token::Kind;
use super::Care;
use super::pieces::Piece;
use super::roles::Role;

/// Blanks before each piece, if it does not begin a line.
pub(super) fn spaces(pieces: &[Piece]) -> Vec<usize> {
    let mut spacer = Spacer {
        pieces,
        partners: vec![None; pieces.len()],
        open: Vec::new(),
        subscript: false,
        symmetric: vec![None; pieces.len()],
    };
    spacer.find_partners();
    (0..pieces.len())
        .map(|index| spacer.before(index))
        .collect()
}

struct Spacer<'a> {
    pieces: &'a [Piece<'a>],
    /// The piece that opens or closes what this one closes or opens.
    partners: Vec<Option<usize>>,
    /// The open brackets and bars before the current piece.
    open: Vec<usize>,
    /// Whether the piece before the current one is part of `_i,j`.
    subscript: bool,
    /// The blanks on the left of operators, which are those on the right.
    symmetric: Vec<Option<usize>>,
}

impl Spacer<'_> {
    fn find_partners(&mut self) {
        let mut open: Vec<usize> = Vec::new();
        for (index, piece) in self.pieces.iter().enumerate() {
            if opens(piece) {
                open.push(index);
            } else if closes(piece) {
                // the brackets of a text without mistakes match; the brace of a piecewise value has no partner
                if let Some(start) = open.pop() {
                    self.partners[start] = Some(index);
                    self.partners[index] = Some(start);
                }
            }
        }
    }

    fn before(&mut self, index: usize) -> usize {
        let blanks = match index {
            0 => 0,
            _ => {
                let blanks = self.between(index - 1, index);
                match self.pieces[index].apart {
                    true => blanks.max(1),
                    false => blanks,
                }
            }
        };
        self.follow(index);
        blanks
    }

    /// Keeps track of brackets and subscripts.
    fn follow(&mut self, index: usize) {
        let piece = &self.pieces[index];
        if closes(piece) {
            self.open.pop();
        } else if opens(piece) {
            self.open.push(index);
        }
        let small = matches!(
            piece.kind,
            Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_)
        );
        let before = index.checked_sub(1).map(|before| self.pieces[before].kind);
        let part = matches!(
            piece.kind,
            Kind::Name(_) | Kind::Function(_) | Kind::Integer(_) | Kind::Star | Kind::Comma
        );
        self.subscript = small
            || piece.kind == Kind::Underscore
            || part && self.subscript && piece.gap.is_tight() && before.is_some();
    }

    /// Whether the current place is directly in a row of a matrix.
    fn in_cell(&self) -> bool {
        let inner = self.open.last();
        inner.is_some_and(|open| self.pieces[*open].role == Role::Matrix)
    }

    fn between(&mut self, left: usize, right: usize) -> usize {
        let (before, piece) = (&self.pieces[left], &self.pieces[right]);
        let gap = &piece.gap;
        let written = gap.blanks + gap.breaks as usize;
        let kept = written.min(1);
        if before.care.max(piece.care) >= Care::Blanks {
            return match self.in_cell() {
                true => written,
                false => kept,
            };
        }
        let after_comma = before.kind == Kind::Comma || gap.semicolon;
        if piece.kind == Kind::Comma {
            return 0;
        }
        if after_comma {
            let listed = self.subscript && gap.is_tight() && is_subscript(piece.kind);
            return match self.in_cell() && !gap.semicolon {
                _ if listed => 0,
                true => written.max(1),
                false => 1,
            };
        }
        let bars = if self.in_cell() { written } else { kept };
        if let Some(blanks) = self.brackets(left, right, bars) {
            return blanks;
        }
        if self.in_cell() {
            // an operator with a name has a blank on both sides
            let named = |piece: &Piece| {
                piece.text.starts_with('\\') && matches!(piece.role, Role::Loose | Role::Close)
            };
            return written.max((named(before) || named(piece)) as usize);
        }
        let loose = |piece: &Piece| piece.role == Role::Loose || is_loose(piece);
        if loose(before) || loose(piece) {
            return 1;
        }
        if is_close(piece) {
            let after = self
                .pieces
                .get(right + 1)
                .is_some_and(|next| !next.gap.is_tight());
            let named = piece.text.starts_with('\\');
            let blanks = (kept > 0 || after || named) as usize;
            self.symmetric[right] = Some(blanks);
            return blanks;
        }
        if is_close(before)
            && let Some(blanks) = self.symmetric[left]
        {
            return blanks;
        }
        let negates = before.role == Role::Negate;
        let line = |kind| matches!(kind, Kind::Caret | Kind::Underscore);
        if negates || line(before.kind) || line(piece.kind) {
            return 0;
        }
        self.after_prefix(left).unwrap_or(kept)
    }

    /// Blanks after a sign that stands directly before its operand, such as `√`, or `∂` with its order.
    fn after_prefix(&self, index: usize) -> Option<usize> {
        let sign = |index: usize| self.pieces[index].kind;
        let differential = |index: Option<usize>| {
            index.is_some_and(|index| matches!(sign(index), Kind::Partial | Kind::Total))
        };
        match sign(index) {
            Kind::Hash | Kind::Root | Kind::Partial | Kind::Total => Some(0),
            // `∂²y`, but `\partial^2 y`
            Kind::SuperscriptNumber(_) if differential(index.checked_sub(1)) => {
                Some(self.pieces[index].text.starts_with('^') as usize)
            }
            Kind::Integer(_) if differential(index.checked_sub(2)) => {
                (sign(index - 1) == Kind::Caret).then_some(1)
            }
            _ => None,
        }
    }

    /// Next to brackets: none inside of them, except for braces, where the author decides.
    fn brackets(&self, left: usize, right: usize, bars: usize) -> Option<usize> {
        let (before, piece) = (&self.pieces[left], &self.pieces[right]);
        if is_bar(before) && is_bar(piece) {
            return Some(bars);
        }
        if before.kind == Kind::Piecewise {
            return Some(1);
        }
        if opens(before) {
            return Some(match before.kind {
                Kind::LeftBrace => self.brace(left, self.partners[left]),
                _ => 0,
            });
        }
        if closes(piece) {
            return Some(match piece.kind {
                Kind::RightBrace => {
                    self.partners[right].map_or(0, |open| self.brace(open, Some(right)))
                }
                _ => 0,
            });
        }
        None
    }

    /// Blanks inside of `{ … }`: on both sides or on neither.
    fn brace(&self, open: usize, close: Option<usize>) -> usize {
        let tight = |index: Option<usize>| {
            let piece = index.and_then(|index| self.pieces.get(index));
            piece.is_none_or(|piece| piece.gap.is_tight())
        };
        !(tight(Some(open + 1)) && tight(close)) as usize
    }
}

/// Whether a piece opens something that is closed.
pub(super) fn opens(piece: &Piece) -> bool {
    matches!(
        piece.kind,
        Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace
    ) || matches!(piece.role, Role::OpenBar | Role::OpenAngle)
}

/// Whether a piece closes something.
pub(super) fn closes(piece: &Piece) -> bool {
    matches!(
        piece.kind,
        Kind::RightParen | Kind::RightBracket | Kind::RightBrace
    ) || matches!(
        piece.role,
        Role::CloseBar | Role::CloseDoubleBar | Role::CloseAngle
    )
}

fn is_bar(piece: &Piece) -> bool {
    matches!(piece.kind, Kind::Bar | Kind::DoubleBar)
}

/// What may follow a comma without a blank in `_i,j`.
fn is_subscript(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Name(_)
            | Kind::Function(_)
            | Kind::Integer(_)
            | Kind::Star
            | Kind::SubscriptNumber(_)
            | Kind::SubscriptLetter(_)
    )
}

/// Signs and words with a blank on both sides.
fn is_loose(piece: &Piece) -> bool {
    let angle = matches!(piece.role, Role::OpenAngle | Role::CloseAngle);
    !angle && piece.kind.is_relation()
        || matches!(
            piece.kind,
            Kind::AddAssign
                | Kind::Subset
                | Kind::Arrow
                | Kind::Vee
                | Kind::Colon
                | Kind::Description
                | Kind::Where
                | Kind::With
                | Kind::Initial
                | Kind::For
                | Kind::If
                | Kind::Otherwise
                | Kind::And
                | Kind::Or
                | Kind::From
                | Kind::SuchThat
        )
}

/// Products, also between types and sizes.
fn is_close(piece: &Piece) -> bool {
    piece.role == Role::Close || piece.kind == Kind::Cross
}
