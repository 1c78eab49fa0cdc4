//! The parser proper: recursive descent over prepared tokens, with precedence climbing for operators.

mod ahead;
mod atom;
mod big;
mod condition;
mod derivative;
mod expression;
mod item;
mod matrix;
mod norm;
mod types;

use std::collections::BTreeSet;

use super::ast::{Import, ItemKind, Module, Name};
use super::layout::{NONE, partners};
use super::lexer::Texts;
use super::names::ItemNames;
use super::spelling::{look_alike, look_alike_help};
use super::split::{Prepared, prepare};
use super::token::{Kind, TextId, Token};
use super::{ImportedNames, MOST_ERRORS, MOST_HEIGHT, MOST_NESTING, NoImports};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::span::{SourceId, Span};

/// A mistake that has been reported already.
#[derive(Clone, Copy, Debug)]
struct Failed;

type Parsed<T> = Result<T, Failed>;

/// Which bars are open innermost.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bars {
    None,
    Single,
    Double,
}

/// What the surroundings of an expression change in its meaning.
#[derive(Clone, Copy, Debug)]
struct Context {
    /// Directly inside a matrix row, where blanks separate cells.
    cell: bool,
    bars: Bars,
    /// The token that closes the row of a matrix between bars.
    row_bar: usize,
    /// In a condition, where `<` compares.
    condition: bool,
    /// In the element of a set builder, where `|` may stand for `for`.
    builder: bool,
    /// In a dimension of a type.
    dimension: bool,
    /// In what is integrated.
    integral: bool,
}

impl Context {
    const PLAIN: Context = Context {
        cell: false,
        bars: Bars::None,
        row_bar: usize::MAX,
        condition: false,
        builder: false,
        dimension: false,
        integral: false,
    };
}

struct Parser<'a> {
    text: &'a str,
    source: SourceId,
    tokens: Vec<Token>,
    partners: Vec<u32>,
    texts: Texts,
    at: usize,
    context: Context,
    /// Number of calls that are nested.
    depth: usize,
    /// Height of the highest tree finished in the current scope.
    height: usize,
    /// The place after the last `⁻¹`; what follows it is solved for.
    after_inverse: usize,
    /// Whether the module has a name `T`, which `^T` might be meant to be.
    names_t: bool,
    diagnostics: Diagnostics,
    count: usize,
    /// Where the text could not even be split into tokens, in order.
    damaged: Vec<Span>,
    steps: usize,
}

/// Reads a text; also tells the number of steps.
pub(super) fn parse(
    text: &str,
    source: SourceId,
    imports: &dyn ImportedNames,
) -> (Module, Diagnostics, usize) {
    let (mut parser, items) = begin(text, source, imports);
    let module = parser.module(&items);
    (module, parser.diagnostics, parser.steps)
}

/// The imports of a text.
pub(super) fn imports(text: &str, source: SourceId) -> Vec<Import> {
    let (mut parser, mut items) = begin(text, source, &NoImports);
    items.retain(|item| item.import);
    let items = parser.module(&items).items.into_iter();
    let imports = items.filter_map(|item| match item.kind {
        ItemKind::Import(import) => Some(import),
        _ => None,
    });
    imports.collect()
}

fn begin<'a>(
    text: &'a str,
    source: SourceId,
    imports: &dyn ImportedNames,
) -> (Parser<'a>, Vec<ItemNames>) {
    // Places are counted in 32 bits.
    let fits = u32::try_from(text.len()).is_ok();
    let text = if fits { text } else { "" };
    let Prepared {
        tokens,
        texts,
        errors,
        items,
        names_t,
        damaged,
        steps,
    } = prepare(text, source, imports);
    let mut parser = Parser {
        text,
        source,
        partners: partners(&tokens),
        tokens,
        texts,
        at: 0,
        context: Context::PLAIN,
        depth: 0,
        height: 0,
        after_inverse: usize::MAX,
        names_t,
        diagnostics: Diagnostics::default(),
        count: 0,
        damaged,
        steps,
    };
    if !fits {
        let span = Span::new(source, 0, 0);
        let error = Diagnostic::error(span, "this text is larger than four gigabytes");
        parser.report(error.help("split it into modules"));
    }
    for error in errors {
        parser.report(error);
    }
    (parser, items)
}

impl Parser<'_> {
    fn token(&mut self, ahead: usize) -> Token {
        self.steps += 1;
        let last = self.tokens.len() - 1;
        self.tokens[(self.at + ahead).min(last)]
    }

    fn kind(&mut self) -> Kind {
        self.token(0).kind
    }

    /// Kind of a token further on.
    fn ahead(&mut self, ahead: usize) -> Kind {
        self.token(ahead).kind
    }

    /// Whether no blank stands before a token further on.
    fn tight(&mut self, ahead: usize) -> bool {
        !self.token(ahead).space
    }

    fn advance(&mut self) -> Token {
        let token = self.token(0);
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
        token
    }

    fn eat(&mut self, kind: Kind) -> bool {
        let found = self.kind() == kind;
        if found {
            self.advance();
        }
        found
    }

    /// The bracket that closes the one at the current place.
    fn partner(&self) -> Option<usize> {
        match self.partners[self.at] {
            NONE => None,
            partner => Some(partner as usize),
        }
    }

    fn span(&self, token: Token) -> Span {
        Span::new(self.source, token.start as usize, token.end as usize)
    }

    fn here(&mut self) -> Span {
        let token = self.token(0);
        self.span(token)
    }

    /// From a first byte to the end of the token before the current one.
    fn since(&self, start: Span) -> Span {
        let end = match self.at {
            0 => start.end,
            at => self.tokens[at - 1].end,
        };
        Span {
            end: end.max(start.start),
            ..start
        }
    }

    fn name_of(&self, id: TextId, span: Span) -> Name {
        Name {
            text: self.texts.get(id).to_owned(),
            span,
        }
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        // a warning leaves the item as it is
        if diagnostic.severity != Severity::Error {
            self.diagnostics.push(diagnostic);
        } else if self.count < MOST_ERRORS {
            self.count += 1;
            self.diagnostics.push(diagnostic);
        }
    }

    /// Whether the text of an item has a mistake below the level of tokens.
    fn is_damaged(&self, item: &ItemNames) -> bool {
        let first = self.tokens[item.range.start].start;
        let end = self.tokens[item.range.end].start;
        let before = self.damaged.partition_point(|span| span.start < first);
        self.damaged
            .get(before)
            .is_some_and(|span| span.start < end)
    }

    fn lose(&self, item: &ItemNames, lost: &mut BTreeSet<String>) {
        for token in &self.tokens[item.range.start..item.range.end.max(self.at)] {
            if let Kind::Name(id) | Kind::Function(id) = token.kind {
                lost.insert(self.texts.get(id).to_owned());
            }
        }
    }

    fn fail<T>(&mut self, diagnostic: Diagnostic) -> Parsed<T> {
        self.report(diagnostic);
        Err(Failed)
    }

    /// How a message calls the current token.
    fn found(&mut self) -> String {
        let token = self.token(0);
        match token.kind.description() {
            Some(text) => text.to_owned(),
            None => {
                let text = &self.text[token.start as usize..token.end as usize];
                format!("`{}`", text.chars().take(40).collect::<String>())
            }
        }
    }

    /// The error that something else was expected here.
    fn expected<T>(&mut self, what: &str, help: &str) -> Parsed<T> {
        let found = self.found();
        let mut span = self.here();
        let kind = self.kind();
        if matches!(kind, Kind::Newline | Kind::Row) {
            // the break itself, without the start of the next line
            span.end = span.start;
        }
        if kind == Kind::Unknown {
            return Err(Failed);
        }
        let unmatched = self.partner().is_none();
        let defined = matches!(self.ahead(1), Kind::In | Kind::Colon | Kind::Assign);
        let special = match kind {
            kind if kind.is_word() && defined => {
                Some("this word has a meaning of its own; between back-ticks it is a name")
            }
            Kind::Transpose | Kind::Inverse | Kind::PseudoInverse if !self.tight(0) => {
                Some("a superscript follows its operand without a blank")
            }
            Kind::Stray if self.token_text() == "'" => {
                Some("a prime is part of a name only in back-ticks, as in `x'` between back-ticks")
            }
            Kind::Stray if look_alike(self.token_text()).is_some() => None,
            Kind::Stray if is_rare_subscript(self.token_text()) => {
                Some("there is no such subscript character in the language; write `x_r`")
            }
            Kind::Stray if self.token_text() == "⁻" => Some(
                "an exponent with a sign is a number, as in `a⁻²`, or stands after `^`, as in `a^-n`; \
                 the transpose of an inverse is `(A⁻¹)ᵀ`",
            ),
            Kind::Stray => Some("this character means nothing in the language; remove it"),
            Kind::RightBrace if unmatched => {
                Some("a piecewise value has no closing brace; remove it")
            }
            Kind::Assign if self.is_compound() => {
                Some("only `+=` changes what is defined above: write `y += (-a)`")
            }
            _ => None,
        };
        let is_sign = kind == Kind::Stray
            || what.contains('∈')
                && look_alike(self.token_text()).is_some_and(|(sign, _)| sign == "∈");
        let alike = look_alike_help(self.token_text()).filter(|_| is_sign);
        let message = match kind {
            Kind::Stray => format!("unexpected character {found}"),
            _ => format!("expected {what}, found {found}"),
        };
        let help = alike.unwrap_or_else(|| special.unwrap_or(help).to_owned());
        self.fail(Diagnostic::error(span, message).help(help))
    }

    /// Whether the `=` here belongs to a sign such as `-=`.
    fn is_compound(&mut self) -> bool {
        let before = self.at.checked_sub(1).map(|at| self.tokens[at].kind);
        self.tight(0) && matches!(before, Some(Kind::Minus | Kind::Star | Kind::Slash))
    }

    fn token_text(&mut self) -> &str {
        let token = self.token(0);
        &self.text[token.start as usize..token.end as usize]
    }

    fn expect(&mut self, kind: Kind, what: &str, help: &str) -> Parsed<Token> {
        if self.kind() == kind {
            return Ok(self.advance());
        }
        if kind == Kind::RightParen
            && matches!(self.kind(), Kind::Newline | Kind::End)
            && let Some(open) = self.unclosed()
        {
            let error = Diagnostic::error(self.span(open), "this `(` is not closed");
            return self.fail(error.help(help));
        }
        self.expected(what, help)
    }

    /// The last `(` of this line that nothing closes.
    fn unclosed(&mut self) -> Option<Token> {
        let mut index = self.at;
        while index > 0 && self.tokens[index - 1].kind != Kind::Newline {
            index -= 1;
            self.steps += 1;
            let token = self.tokens[index];
            if token.kind == Kind::LeftParen && self.partners[index] == NONE {
                return Some(token);
            }
        }
        None
    }

    /// A name, function or not.
    fn name(&mut self, what: &str, help: &str) -> Parsed<Name> {
        match self.kind() {
            Kind::Name(id) | Kind::Function(id) => {
                let span = self.here();
                self.advance();
                Ok(self.name_of(id, span))
            }
            _ => self.expected(what, help),
        }
    }

    fn is_name(&mut self, ahead: usize) -> bool {
        matches!(self.ahead(ahead), Kind::Name(_) | Kind::Function(_))
    }

    /// Runs `inner` in other surroundings.
    fn within<T>(&mut self, context: Context, inner: impl FnOnce(&mut Self) -> T) -> T {
        let outer = std::mem::replace(&mut self.context, context);
        let result = inner(self);
        self.context = outer;
        result
    }

    /// Runs `inner` one level deeper, and counts what it builds as one level higher.
    fn nested<T>(&mut self, inner: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        let span = self.here();
        if self.depth >= MOST_NESTING {
            return self.too_deep(span);
        }
        self.depth += 1;
        let outer = std::mem::take(&mut self.height);
        let result = inner(self);
        self.depth -= 1;
        self.height += 1;
        if result.is_ok() && self.height > MOST_HEIGHT {
            self.height = outer;
            return self.too_high(span);
        }
        self.height = self.height.max(outer);
        result
    }

    /// The tree built so far in this scope becomes an operand: it grows by one.
    fn grow(&mut self, span: Span) -> Parsed<()> {
        self.height += 1;
        match self.height > MOST_HEIGHT {
            true => self.too_high(span),
            false => Ok(()),
        }
    }

    #[cold]
    #[inline(never)]
    fn too_high<T>(&mut self, span: Span) -> Parsed<T> {
        let message = format!("more than {MOST_HEIGHT} operators follow one another here");
        self.fail(Diagnostic::error(span, message).help("give parts of it names of their own"))
    }

    #[cold]
    #[inline(never)]
    fn too_deep<T>(&mut self, span: Span) -> Parsed<T> {
        let message = format!("this is nested deeper than {MOST_NESTING} levels");
        self.fail(Diagnostic::error(span, message).help("give parts of it names of their own"))
    }
}

/// Letters that Unicode has as subscripts, but the language has not.
fn is_rare_subscript(text: &str) -> bool {
    matches!(text, "ᵣ" | "ᵤ" | "ᵥ" | "ᵦ" | "ᵧ" | "ᵨ" | "ᵩ" | "ᵪ")
}
