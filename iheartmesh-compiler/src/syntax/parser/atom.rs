//! What operators work on: names, calls, numbers, vectors, sets.

use super::super::ast::{BinaryOp, Expr, ExprKind, Name, Subscript, UnaryOp};
use super::super::spelling::look_alike_help;
use super::super::token::{Kind, Token};
use super::expression::make;
use super::{Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl Parser<'_> {
    /// An atom with its subscripts.
    ///
    /// The steps are functions of their own so that nested brackets need little of the stack.
    pub(super) fn atom(&mut self) -> Parsed<Expr> {
        let start = self.here();
        if let Some(literal) = self.literal() {
            return Ok(literal);
        }
        let mut open = false;
        let base = self.primary(&mut open)?;
        match open {
            true => self.subscripted(base, start),
            false => Ok(base),
        }
    }

    fn subscripted(&mut self, base: Expr, start: Span) -> Parsed<Expr> {
        let Some(subscripts) = self.subscripts()? else {
            return Ok(base);
        };
        let base = Box::new(base);
        let kind = ExprKind::Subscript { base, subscripts };
        Ok(make(kind, self.since(start)))
    }

    fn literal(&mut self) -> Option<Expr> {
        let span = self.here();
        let kind = match self.kind() {
            Kind::Integer(0 | 1) if self.has_size() => return None,
            Kind::Integer(number) => ExprKind::Integer(number),
            Kind::Real(number) => ExprKind::Real(number),
            Kind::Pi => ExprKind::Pi,
            Kind::Infinity => ExprKind::Infinity,
            Kind::Empty => ExprKind::Set(Vec::new()),
            _ => return None,
        };
        self.advance();
        Some(make(kind, span))
    }

    /// What is no literal; `open` tells whether subscripts may follow.
    fn primary(&mut self, open: &mut bool) -> Parsed<Expr> {
        *open = matches!(
            self.kind(),
            Kind::Name(_) | Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace
        );
        match self.kind() {
            Kind::Name(_) => self.variable(),
            Kind::Function(_) => self.function(open),
            Kind::Unknown | Kind::Word(_) => self.unknown(),
            Kind::Integer(number) => self.number_matrix(number == 1),
            Kind::Ones => self.number_matrix(true),
            Kind::LeftParen => self.parentheses(),
            Kind::LeftBracket => self.matrix(),
            Kind::LeftBrace => self.set(),
            Kind::Bar | Kind::DoubleBar => self.norm(),
            Kind::LeftAngle | Kind::Less => self.inner(),
            Kind::Hash => self.size(),
            _ => self.no_operand(),
        }
    }

    fn variable(&mut self) -> Parsed<Expr> {
        let name = self.name("a name", "write a name")?;
        let span = name.span;
        Ok(make(ExprKind::Name(name), span))
    }

    fn size(&mut self) -> Parsed<Expr> {
        let start = self.here();
        self.advance();
        let operand = Box::new(self.nested(Self::atom)?);
        let op = UnaryOp::Size;
        Ok(make(ExprKind::Unary { op, operand }, self.since(start)))
    }

    fn no_operand(&mut self) -> Parsed<Expr> {
        let first = self.at == 0 || self.tokens[self.at - 1].kind == Kind::Newline;
        let help = match self.kind() {
            Kind::Piecewise => return self.misplaced("a piecewise value"),
            Kind::Optimise(_) => return self.misplaced("an optimisation"),
            Kind::Minus => "put the operand with its sign in parentheses, as in `(-b)`",
            kind if first && kind.continues() => {
                "an expression goes on over a line break after an operator or in parentheses"
            }
            _ => "write a name, a number or a bracket here",
        };
        self.expected("an operand", help)
    }

    fn misplaced<T>(&mut self, what: &str) -> Parsed<T> {
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

    /// A function: called if `(` follows at once or it has subscripts; `open` tells whether subscripts of the result
    /// may follow.
    fn function(&mut self, open: &mut bool) -> Parsed<Expr> {
        let start = self.here();
        let function = self.name("a function", "")?;
        let subscripts = self.call_subscripts()?;
        if let Some((exponent, length)) = self.power_before_arguments() {
            self.at += length;
            return self.raised_call(function, subscripts, exponent, start);
        }
        if self.kind() == Kind::LeftParen && self.tight(0) {
            *open = true;
            return self.called(function, subscripts, start);
        }
        self.uncalled(function, subscripts, start)
    }

    fn called(&mut self, function: Name, subscripts: Vec<Expr>, start: Span) -> Parsed<Expr> {
        let arguments = self.arguments()?;
        let kind = ExprKind::Call {
            function,
            subscripts,
            arguments,
        };
        Ok(make(kind, self.since(start)))
    }

    /// A function without parentheses.
    fn uncalled(&mut self, function: Name, subscripts: Vec<Expr>, start: Span) -> Parsed<Expr> {
        if self.kind() == Kind::LeftParen && subscripts.is_empty() && !self.context.cell {
            self.warn_of_blank(&function);
        }
        if let (Some(best), [first, ..]) = (extremum(&function.text), subscripts.as_slice()) {
            return self.unparenthesised_optimum(best, first.span);
        }
        if subscripts.is_empty() {
            let span = function.span;
            return Ok(make(ExprKind::Name(function), span));
        }
        let kind = ExprKind::Call {
            function,
            subscripts,
            arguments: Vec::new(),
        };
        Ok(make(kind, self.since(start)))
    }

    /// A blank between a function and its `(`.
    #[cold]
    #[inline(never)]
    fn warn_of_blank(&mut self, function: &Name) {
        let message = format!("`{}` is multiplied, not called", function.text);
        let help = "remove the blank before `(` to call it";
        self.report(Diagnostic::warning(function.span, message).help(help));
    }

    #[cold]
    #[inline(never)]
    fn unparenthesised_optimum<T>(&mut self, best: &str, span: Span) -> Parsed<T> {
        let message = format!("what `{best}` runs over stands in parentheses");
        let help = format!("over a set write `{best}_(x ∈ S) …`; of values, `{best}(a, b)`");
        self.fail(Diagnostic::error(span, message).help(help))
    }

    fn call_subscripts(&mut self) -> Parsed<Vec<Expr>> {
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
        Ok(subscripts)
    }

    /// `sin²(x)` is `(sin(x))²`.
    fn raised_call(
        &mut self,
        function: Name,
        subscripts: Vec<Expr>,
        exponent: Expr,
        start: Span,
    ) -> Parsed<Expr> {
        let left = Box::new(self.called(function, subscripts, start)?);
        self.grow(start)?;
        let right = Box::new(exponent);
        let op_span = right.span;
        let op = BinaryOp::Power;
        let kind = ExprKind::Binary {
            op,
            left,
            right,
            op_span,
        };
        Ok(make(kind, self.since(start)))
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
        let open = self.at;
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
        match self.eat(Kind::RightParen) {
            true => Ok(arguments),
            false => self.unclosed_arguments(open),
        }
    }

    /// The error that the arguments after the parenthesis at this place do not end here.
    #[cold]
    #[inline(never)]
    fn unclosed_arguments<T>(&mut self, open: usize) -> Parsed<T> {
        let before = open.checked_sub(1).map(|at| self.tokens[at].kind);
        let best = match before {
            Some(Kind::Function(id)) => extremum(self.texts.get(id)),
            _ => None,
        };
        let help = match (self.kind(), best) {
            (Kind::In, Some(best)) => {
                format!("over a set write `{best}_(x ∈ S) …`, with `_` before the parenthesis")
            }
            _ => "close the list of arguments".to_owned(),
        };
        self.expect(Kind::RightParen, "`,` or `)`", &help)?;
        Err(super::Failed)
    }

    fn parentheses(&mut self) -> Parsed<Expr> {
        let start = self.here();
        self.advance();
        let first = self.bracketed()?;
        let mut list = Vec::new();
        while self.eat(Kind::Comma) {
            list.push(self.bracketed()?);
        }
        let help = match self.kind() {
            Kind::In => "the index of a sum stands directly after `_`, as in `∑_(j ∈ S)`",
            _ => "close the parenthesis",
        };
        self.expect(Kind::RightParen, "`)`", help)?;
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
            Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_) => {
                Ok(Some(self.small_subscripts()))
            }
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
        let before = self.at.checked_sub(2).map(|at| self.tokens[at].kind);
        let sign = match before {
            Some(Kind::Name(id)) => look_alike_help(self.texts.get(id)),
            _ => None,
        };
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
        if let Some(help) = sign
            && self.kind() != Kind::RightParen
        {
            return self.expected("`,` or `)`", &help);
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
            // `p_i,q_i`: what has a subscript of its own is no subscript
            if comma && self.ahead(2) == Kind::Underscore && self.tight(2) {
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
        let small = matches!(
            next.kind,
            Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_)
        );
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

/// A function that is also an optimum over a set.
fn extremum(function: &str) -> Option<&'static str> {
    ["min", "max"].into_iter().find(|name| *name == function)
}
