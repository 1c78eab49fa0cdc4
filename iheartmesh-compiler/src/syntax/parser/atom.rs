//! What operators work on: names, calls, numbers, vectors, sets.

use super::super::ast::{BinaryOp, Expr, ExprKind, Name, Subscript, UnaryOp};
use super::super::token::{Kind, Token};
use super::expression::make;
use super::{Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl Parser<'_> {
    /// An atom with its subscripts.
    pub(super) fn atom(&mut self) -> Parsed<Expr> {
        let token = self.token(0);
        let start = self.span(token);
        let base = match token.kind {
            Kind::Name(id) => {
                self.advance();
                make(ExprKind::Name(self.name_of(id, start)), start)
            }
            Kind::Function(_) => match self.function()? {
                (call, true) => call,
                (done, false) => return Ok(done),
            },
            Kind::Unknown | Kind::Word(_) => return self.unknown(),
            Kind::Integer(number @ (0 | 1)) if self.has_size() => return self.number_matrix(number == 1),
            Kind::Ones => return self.number_matrix(true),
            Kind::Integer(number) => return Ok(self.literal(ExprKind::Integer(number))),
            Kind::Real(number) => return Ok(self.literal(ExprKind::Real(number))),
            Kind::Pi => return Ok(self.literal(ExprKind::Pi)),
            Kind::Infinity => return Ok(self.literal(ExprKind::Infinity)),
            Kind::Empty => return Ok(self.literal(ExprKind::Set(Vec::new()))),
            Kind::LeftParen => self.parentheses()?,
            Kind::LeftBracket => self.matrix()?,
            Kind::LeftBrace => self.set()?,
            Kind::Piecewise => return self.misplaced("a piecewise value"),
            Kind::Optimise(_) => return self.misplaced("an optimisation"),
            Kind::Bar | Kind::DoubleBar => return self.norm(),
            Kind::LeftAngle | Kind::Less => return self.inner(),
            Kind::Hash => {
                self.advance();
                let operand = Box::new(self.nested(Self::atom)?);
                let op = UnaryOp::Size;
                return Ok(make(ExprKind::Unary { op, operand }, self.since(start)));
            }
            Kind::Minus => {
                let help = "put the operand with its sign in parentheses, as in `(-b)`";
                return self.expected("an operand", help);
            }
            _ => return self.expected("an operand", "write a name, a number or a bracket here"),
        };
        match self.subscripts()? {
            Some(subscripts) => {
                let base = Box::new(base);
                let kind = ExprKind::Subscript { base, subscripts };
                Ok(make(kind, self.since(start)))
            }
            None => Ok(base),
        }
    }

    fn literal(&mut self, kind: ExprKind) -> Expr {
        let span = self.here();
        self.advance();
        make(kind, span)
    }

    fn misplaced(&mut self, what: &str) -> Parsed<Expr> {
        let span = self.here();
        let message = format!("{what} is no operand");
        let help = "make it the whole right-hand side of a definition of its own";
        self.fail(Diagnostic::error(span, message).help(help))
    }

    /// A word that has no meaning, with everything that would be its subscripts and arguments.
    fn unknown(&mut self) -> Parsed<Expr> {
        let token = self.advance();
        let start = self.span(token);
        if let Kind::Word(id) = token.kind {
            let message = format!("unknown name `{}`", self.texts.get(id));
            let help = "declare it, or separate the letters to multiply them";
            self.report(Diagnostic::error(start, message).help(help));
        }
        self.subscripts()?;
        if self.kind() == Kind::LeftParen && self.tight(0) {
            self.arguments()?;
        }
        Ok(make(ExprKind::Error, self.since(start)))
    }

    /// A function: called if `(` follows at once or it has subscripts. The second value says whether subscripts of
    /// the result may follow.
    fn function(&mut self) -> Parsed<(Expr, bool)> {
        let start = self.here();
        let function = self.name("a function", "")?;
        let mut subscripts = Vec::new();
        for subscript in self.subscripts()?.unwrap_or_default() {
            match subscript {
                Subscript::Expr(expr) => subscripts.push(expr),
                Subscript::All(span) => {
                    let error = Diagnostic::error(span, "`*` is no argument of a function");
                    return self.fail(error.help("write a name or a number"));
                }
            }
        }
        let power = self.power_before_arguments();
        if let Some((exponent, length)) = power {
            for _ in 0..length {
                self.advance();
            }
            let arguments = self.arguments()?;
            let call = self.call(function, subscripts, arguments, start);
            let (left, right) = (Box::new(call), Box::new(exponent));
            let op_span = right.span;
            let op = BinaryOp::Power;
            let kind = ExprKind::Binary {
                op,
                left,
                right,
                op_span,
            };
            self.grow(start)?;
            return Ok((make(kind, self.since(start)), false));
        }
        if self.kind() == Kind::LeftParen {
            if self.tight(0) {
                let arguments = self.arguments()?;
                return Ok((self.call(function, subscripts, arguments, start), true));
            }
            if subscripts.is_empty() && !self.context.cell {
                let message = format!("`{}` is multiplied, not called", function.text);
                let help = "remove the blank before `(` to call it";
                let warning = Diagnostic::warning(function.span, message);
                self.report(warning.help(help));
            }
        }
        if subscripts.is_empty() {
            let span = function.span;
            return Ok((make(ExprKind::Name(function), span), false));
        }
        Ok((self.call(function, subscripts, Vec::new(), start), false))
    }

    fn call(&self, function: Name, subscripts: Vec<Expr>, arguments: Vec<Expr>, start: Span) -> Expr {
        let kind = ExprKind::Call {
            function,
            subscripts,
            arguments,
        };
        make(kind, self.since(start))
    }

    /// `²` or `^2` between a function and its arguments: the exponent and its number of tokens.
    fn power_before_arguments(&mut self) -> Option<(Expr, usize)> {
        let power = self.token(0);
        let (number, length) = match (power.kind, self.ahead(1)) {
            (Kind::SuperscriptNumber(number), _) => (number, 1),
            (Kind::Caret, Kind::Integer(number)) if self.tight(1) => (number, 2),
            _ => return None,
        };
        let called = self.ahead(length) == Kind::LeftParen && self.tight(length);
        if !called || power.space || number < 0 {
            return None;
        }
        let at = self.token(length - 1);
        Some((make(ExprKind::Integer(number), self.span(at)), length))
    }

    /// `(a, b)`; `;` separates as well.
    pub(super) fn arguments(&mut self) -> Parsed<Vec<Expr>> {
        self.advance();
        let mut arguments = Vec::new();
        if self.eat(Kind::RightParen) {
            return Ok(arguments);
        }
        loop {
            arguments.push(self.bracketed()?);
            if !self.eat(Kind::Comma) && !self.eat(Kind::Semicolon) {
                break;
            }
        }
        self.expect(Kind::RightParen, "`,` or `)`", "close the list of arguments")?;
        Ok(arguments)
    }

    fn parentheses(&mut self) -> Parsed<Expr> {
        let start = self.here();
        self.advance();
        let first = self.bracketed()?;
        let mut list = Vec::new();
        while self.eat(Kind::Comma) {
            list.push(self.bracketed()?);
        }
        self.expect(Kind::RightParen, "`)`", "close the parenthesis")?;
        if list.is_empty() {
            return Ok(first);
        }
        list.insert(0, first);
        Ok(make(ExprKind::Vector(list), self.since(start)))
    }

    /// The subscripts that follow at once, if any.
    pub(super) fn subscripts(&mut self) -> Parsed<Option<Vec<Subscript>>> {
        if self.token(0).space {
            return Ok(None);
        }
        match self.kind() {
            Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_) => Ok(Some(self.small_subscripts())),
            Kind::Underscore => {
                self.advance();
                if self.kind() == Kind::LeftParen && self.tight(0) {
                    return self.expression_subscripts().map(Some);
                }
                self.plain_subscripts().map(Some)
            }
            _ => Ok(None),
        }
    }

    fn small_subscript(&mut self, token: Token) -> Option<Subscript> {
        let span = self.span(token);
        let kind = match token.kind {
            Kind::SubscriptNumber(number) => ExprKind::Integer(number),
            Kind::SubscriptLetter(id) => ExprKind::Name(self.name_of(id, span)),
            _ => return None,
        };
        Some(Subscript::Expr(make(kind, span)))
    }

    fn small_subscripts(&mut self) -> Vec<Subscript> {
        let mut list = Vec::new();
        loop {
            let token = self.token(0);
            let comma = token.kind == Kind::Comma && !list.is_empty();
            let token = self.token(comma as usize);
            if token.space || self.token(0).space {
                return list;
            }
            let Some(subscript) = self.small_subscript(token) else {
                return list;
            };
            list.push(subscript);
            self.at += comma as usize;
            self.advance();
        }
    }

    /// `_(a + 1, b)`.
    fn expression_subscripts(&mut self) -> Parsed<Vec<Subscript>> {
        self.advance();
        let mut list = Vec::new();
        loop {
            list.push(match self.kind() {
                Kind::Star => {
                    let star = self.advance();
                    Subscript::All(self.span(star))
                }
                _ => Subscript::Expr(self.bracketed()?),
            });
            if !self.eat(Kind::Comma) {
                break;
            }
        }
        self.expect(Kind::RightParen, "`,` or `)`", "close the subscript")?;
        Ok(list)
    }

    /// `_i,j`: no blank after the commas, which may be left out.
    fn plain_subscripts(&mut self) -> Parsed<Vec<Subscript>> {
        let mut list = Vec::new();
        loop {
            let comma = self.kind() == Kind::Comma && !list.is_empty();
            let token = self.token(comma as usize);
            if token.space || self.token(0).space {
                break;
            }
            let span = self.span(token);
            let subscript = match token.kind {
                Kind::Name(id) | Kind::Function(id) => {
                    Subscript::Expr(make(ExprKind::Name(self.name_of(id, span)), span))
                }
                Kind::Integer(number) => Subscript::Expr(make(ExprKind::Integer(number), span)),
                Kind::Star => Subscript::All(span),
                Kind::Unknown => Subscript::Expr(make(ExprKind::Error, span)),
                _ => break,
            };
            list.push(subscript);
            self.at += comma as usize;
            self.advance();
        }
        if list.is_empty() {
            let help = "write a name, a number or `*`, or an expression in parentheses: `x_(i+1)`";
            return self.expected("a subscript", help);
        }
        Ok(list)
    }

    /// Whether `0` or `1` here is the matrix `0_n` or `1_n`.
    fn has_size(&mut self) -> bool {
        let next = self.token(1);
        let small = matches!(next.kind, Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_));
        !next.space && (small || next.kind == Kind::Underscore)
    }

    fn number_matrix(&mut self, ones: bool) -> Parsed<Expr> {
        let start = self.here();
        self.advance();
        let crossed = self.kind() == Kind::Underscore && self.ahead(1) == Kind::LeftParen;
        let mut sizes = Vec::new();
        if crossed {
            self.advance();
            self.advance();
            let context = Context {
                dimension: true,
                ..Context::PLAIN
            };
            loop {
                sizes.push(self.within(context, Self::expression)?);
                if !self.eat(Kind::Comma) && !self.eat(Kind::Cross) {
                    break;
                }
            }
            self.expect(Kind::RightParen, "`,` or `)`", "close the size")?;
        } else {
            for subscript in self.subscripts()?.unwrap_or_default() {
                if let Subscript::Expr(size) = subscript {
                    sizes.push(size);
                }
            }
        }
        let span = self.since(start);
        let mut sizes = sizes.into_iter();
        let (Some(rows), columns, None) = (sizes.next(), sizes.next(), sizes.next()) else {
            let error = Diagnostic::error(span, "a matrix of zeros or ones has one or two sizes");
            return self.fail(error.help("write `1_n` or `1_n,m`"));
        };
        let (rows, columns) = (Box::new(rows), columns.map(Box::new));
        let kind = ExprKind::NumberMatrix {
            ones,
            rows,
            columns,
        };
        Ok(make(kind, span))
    }
}
