//! Settles what brackets match and what each line break and `;` means: nothing, the end of an item, of a matrix
//! row, or of a branch.

use std::cell::Cell;

use super::token::{Kind, Token};

/// No partner.
pub(super) const NONE: u32 = u32::MAX;

/// For each bracket its partner; [`NONE`] for unmatched brackets and everything else.
pub(super) fn partners(tokens: &[Token]) -> Vec<u32> {
    let mut partners = vec![NONE; tokens.len()];
    let mut open: Vec<(usize, Kind)> = Vec::new();
    let mut counts = [0u32; 3];
    for (index, token) in tokens.iter().enumerate() {
        if let Some(class) = opening(token.kind) {
            open.push((index, token.kind));
            counts[class] += 1;
        } else if let Some(class) = closing(token.kind)
            && counts[class] > 0
        {
            while let Some((start, kind)) = open.pop() {
                let this = opening(kind).unwrap_or(class);
                counts[this] -= 1;
                if this == class {
                    partners[start] = index as u32;
                    partners[index] = start as u32;
                    break;
                }
            }
        }
    }
    partners
}

fn opening(kind: Kind) -> Option<usize> {
    match kind {
        Kind::LeftParen => Some(0),
        Kind::LeftBracket => Some(1),
        Kind::LeftBrace => Some(2),
        _ => None,
    }
}

fn closing(kind: Kind) -> Option<usize> {
    match kind {
        Kind::RightParen => Some(0),
        Kind::RightBracket => Some(1),
        Kind::RightBrace => Some(2),
        _ => None,
    }
}

/// Turns each `{` that opens a piecewise value into [`Kind::Piecewise`]: it meets an `if` before anything that
/// only a set has.
fn find_piecewise(tokens: &mut [Token]) {
    let mut open: Vec<(usize, Kind)> = Vec::new();
    for index in 0..tokens.len() {
        let kind = tokens[index].kind;
        let top = open.last().copied();
        match (kind, top) {
            (Kind::If | Kind::Otherwise, Some((brace, Kind::LeftBrace))) => {
                tokens[brace].kind = Kind::Piecewise;
                open.pop();
            }
            (Kind::Bar, Some((brace, Kind::LeftBrace))) if is_builder_bar(tokens, index) => {
                open.pop();
                open.push((brace, Kind::For));
            }
            (Kind::For, Some((brace, Kind::LeftBrace))) => {
                open.pop();
                open.push((brace, Kind::For));
            }
            (Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace, _) => open.push((index, kind)),
            (Kind::RightBrace, Some((_, Kind::LeftBrace | Kind::For)))
            | (Kind::RightParen, Some((_, Kind::LeftParen)))
            | (Kind::RightBracket, Some((_, Kind::LeftBracket))) => {
                open.pop();
            }
            _ => {}
        }
    }
}

/// Whether names and `∈` follow a `|`: it stands for `for` in a set builder.
fn is_builder_bar(tokens: &[Token], bar: usize) -> bool {
    let rest = tokens[bar + 1..].iter().take(32);
    let mut names = rest
        .skip_while(|token| matches!(token.kind, Kind::Word(_) | Kind::Quoted(_) | Kind::Comma));
    let is_name = |token: &Token| matches!(token.kind, Kind::Word(_) | Kind::Quoted(_));
    tokens.get(bar + 1).is_some_and(is_name) && names.next().is_some_and(|t| t.kind == Kind::In)
}

/// What a line break may separate besides items.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Items,
    Branches,
    Constraints,
    Initial,
}

struct Layout<'a> {
    raw: &'a [Token],
    partners: Vec<u32>,
    out: Vec<Token>,
    mode: Mode,
    /// Whether this is in a branch of a piecewise value.
    branches: bool,
    /// The open brackets that are closed somewhere.
    open: Vec<Kind>,
    /// Number of tokens looked at.
    steps: Cell<usize>,
}

/// Drops the line breaks that mean nothing and names the others; also tells the number of steps.
pub(super) fn lay_out(mut raw: Vec<Token>) -> (Vec<Token>, usize) {
    find_piecewise(&mut raw);
    let mut layout = Layout {
        partners: partners(&raw),
        raw: &raw,
        out: Vec::with_capacity(raw.len()),
        mode: Mode::Items,
        branches: false,
        open: Vec::new(),
        steps: Cell::new(0),
    };
    let mut index = 0;
    while index < raw.len() {
        let token = raw[index];
        index += 1;
        match token.kind {
            Kind::Newline | Kind::Semicolon => {
                let mut semicolon = (token.kind == Kind::Semicolon).then_some(token);
                while matches!(raw[index].kind, Kind::Newline | Kind::Semicolon) {
                    if raw[index].kind == Kind::Semicolon {
                        semicolon = Some(raw[index]);
                    }
                    index += 1;
                }
                if let Some(kind) = layout.separator(semicolon.is_some(), index) {
                    let token = semicolon.unwrap_or(token);
                    layout.out.push(Token { kind, ..token });
                }
            }
            _ => layout.plain(index - 1),
        }
    }
    (layout.out, layout.steps.get())
}

impl Layout<'_> {
    fn plain(&mut self, index: usize) {
        self.steps.update(|steps| steps + 1);
        let token = self.raw[index];
        if self.partners[index] != NONE {
            match opening(token.kind) {
                Some(_) => self.open.push(token.kind),
                None => drop(self.open.pop()),
            }
        }
        if self.open.is_empty() {
            match token.kind {
                Kind::Piecewise => self.branches = true,
                Kind::Where => self.branches = false,
                _ => {}
            }
            self.mode = match token.kind {
                Kind::Piecewise => Mode::Branches,
                Kind::If | Kind::Otherwise if self.branches => Mode::Branches,
                Kind::Where => Mode::Items,
                Kind::SuchThat => Mode::Constraints,
                Kind::Initial => Mode::Initial,
                Kind::Optimise(_) => Mode::Items,
                _ => self.mode,
            };
        }
        self.out.push(token);
    }

    /// What a run of line breaks and semicolons before the token `next` means.
    fn separator(&mut self, semicolon: bool, next: usize) -> Option<Kind> {
        let before = self.out.last().map_or(Kind::Newline, |token| token.kind);
        let after = self.raw[next].kind;
        match self.open.last() {
            Some(Kind::LeftParen | Kind::LeftBrace) => return semicolon.then_some(Kind::Semicolon),
            Some(_) => {
                let outer = matches!(before, Kind::LeftBracket) || after == Kind::RightBracket;
                let nothing = outer || !semicolon && before.continues();
                return (!nothing).then_some(Kind::Row);
            }
            None => {}
        }
        if before == Kind::Newline {
            return None;
        }
        // `ℝ; ℤ → ℝ`: no item begins with a type
        if semicolon && matches!(after, Kind::Reals | Kind::Integers) {
            return Some(Kind::Semicolon);
        }
        if !semicolon && before.continues() {
            return None;
        }
        if !semicolon {
            match after {
                Kind::Where => {
                    let alone = matches!(self.raw[next + 1].kind, Kind::Newline | Kind::End);
                    if !alone {
                        return None;
                    }
                }
                Kind::With | Kind::SuchThat => return None,
                Kind::If | Kind::Otherwise if self.branches => return None,
                Kind::Optimise(_) if self.mode == Mode::Initial => return None,
                _ => {}
            }
        }
        let found = match self.mode {
            Mode::Items => false,
            Mode::Branches => self.begins_branch(next),
            // what follows a restriction may be the next branch
            Mode::Constraints if self.branches && self.begins_branch(next) => true,
            Mode::Constraints if semicolon => self.first(next, |_| false, Kind::is_relation),
            // no definition begins like this, and no type
            Mode::Constraints
                if !matches!(after, Kind::Word(_) | Kind::Quoted(_) | Kind::Partial) =>
            {
                self.first(next, |_| false, Kind::is_relation)
            }
            Mode::Constraints if self.is_in_interval(next) => true,
            Mode::Constraints => {
                let stop = |kind| matches!(kind, Kind::Assign | Kind::In | Kind::Colon);
                self.first(next, stop, Kind::is_strict_relation)
            }
            Mode::Initial => semicolon,
        };
        if found {
            return Some(Kind::Branch);
        }
        self.mode = Mode::Items;
        self.branches = false;
        Some(Kind::Newline)
    }

    fn begins_branch(&self, from: usize) -> bool {
        self.first(from, Kind::starts_no_branch, |kind| {
            matches!(kind, Kind::If | Kind::Otherwise)
        })
    }

    /// Whether a line says that something is in an interval, `… ∈ [a, b]`.
    fn is_in_interval(&self, from: usize) -> bool {
        let stop = |kind| matches!(kind, Kind::Assign | Kind::Colon | Kind::Subset);
        self.position(from, stop, |kind| kind == Kind::In)
            .is_some_and(|index| self.raw[index + 1].kind == Kind::LeftBracket)
    }

    /// Whether `wanted` comes before `stop` in the rest of the line, outside brackets.
    fn first(&self, from: usize, stop: fn(Kind) -> bool, wanted: fn(Kind) -> bool) -> bool {
        self.position(from, stop, wanted).is_some()
    }

    /// Where `wanted` stands, if it comes before `stop` in the rest of the line, outside brackets.
    fn position(
        &self,
        from: usize,
        stop: fn(Kind) -> bool,
        wanted: fn(Kind) -> bool,
    ) -> Option<usize> {
        let mut index = from;
        loop {
            self.steps.update(|steps| steps + 1);
            let kind = self.raw[index].kind;
            if wanted(kind) {
                return Some(index);
            }
            let is_end = match kind {
                Kind::Newline => !matches!(
                    self.raw[index + 1].kind,
                    Kind::SuchThat | Kind::If | Kind::Otherwise
                ),
                Kind::Semicolon | Kind::End => true,
                _ => stop(kind),
            };
            if is_end {
                return None;
            }
            let partner = self.partners[index];
            let jump = partner != NONE && partner as usize > index;
            index = if jump { partner as usize } else { index } + 1;
        }
    }
}

impl Kind {
    /// A sign that no branch has before its `if`.
    fn starts_no_branch(self) -> bool {
        matches!(
            self,
            Kind::Assign | Kind::AddAssign | Kind::In | Kind::Subset | Kind::From
        )
    }
}
