//! Operators: sums, terms, set operators, products of vectors, prefixes and postfixes.

use super::super::ast::{BinaryOp, Expr, ExprKind, UnaryOp};
use super::super::token::Kind;
use super::{Bars, Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

/// Binding strengths, from loose to tight; tighter operators are not climbed.
pub(super) const SUM: u8 = 1;
pub(super) const TERM: u8 = 3;
const UNION: u8 = 5;
const INTERSECTION: u8 = 7;

/// Makes an expression node.
pub(super) fn make(kind: ExprKind, span: Span) -> Expr {
    Expr { kind, span }
}

fn binary(op: BinaryOp, left: Expr, right: Expr, op_span: Span) -> Expr {
    let span = left.span.to(right.span);
    let (left, right) = (Box::new(left), Box::new(right));
    let kind = ExprKind::Binary {
        op,
        left,
        right,
        op_span,
    };
    make(kind, span)
}

/// As [`binary`]; `A⁻¹ b` is `A \ b`.
fn product(op: BinaryOp, mut left: Expr, right: Expr, op_span: Span) -> Expr {
    let implicit = op == BinaryOp::Solve && op_span.start == op_span.end;
    if implicit && let ExprKind::Unary { operand, .. } = left.kind {
        left = Expr {
            span: left.span,
            ..*operand
        };
    }
    binary(op, left, right, op_span)
}

impl Parser<'_> {
    /// An expression in brackets of its own: blanks, bars and relations mean what they mean anywhere.
    pub(super) fn bracketed(&mut self) -> Parsed<Expr> {
        let context = Context {
            dimension: self.context.dimension,
            ..Context::PLAIN
        };
        self.within(context, |parser| parser.climb(SUM))
    }

    /// An expression.
    pub(super) fn expression(&mut self) -> Parsed<Expr> {
        self.climb(SUM)
    }

    /// Operators that bind at least as tightly as `least`, with an optional `-` in front.
    pub(super) fn climb(&mut self, least: u8) -> Parsed<Expr> {
        self.nested(|parser| {
            let start = parser.here();
            let mut left = match parser.kind() {
                Kind::Minus if least <= TERM => {
                    parser.advance();
                    if parser.kind() == Kind::Minus {
                        let help = "put the inner one in parentheses, or remove both";
                        return parser.expected("an operand", help);
                    }
                    let operand = parser.climb_from(TERM)?;
                    parser.grow(start)?;
                    let span = start.to(operand.span);
                    let operand = Box::new(operand);
                    let op = UnaryOp::Negate;
                    make(ExprKind::Unary { op, operand }, span)
                }
                _ => parser.products()?,
            };
            parser.operators(&mut left, least)?;
            Ok(left)
        })
    }

    /// As [`Self::climb`] but in the scope of its caller and without a `-`.
    fn climb_from(&mut self, least: u8) -> Parsed<Expr> {
        let mut left = self.products()?;
        self.operators(&mut left, least)?;
        Ok(left)
    }

    fn operators(&mut self, left: &mut Expr, least: u8) -> Parsed<()> {
        while let Some((op, strength, written)) = self.operator() {
            if strength < least {
                break;
            }
            let op_span = self.between(left.span, written);
            if written {
                self.advance();
            }
            let height = std::mem::take(&mut self.height);
            let right = self.right_operand(op, strength)?;
            self.height = self.height.max(height);
            self.grow(op_span)?;
            let placeholder = make(ExprKind::Error, left.span);
            let taken = std::mem::replace(left, placeholder);
            *left = binary(op, taken, right, op_span);
        }
        Ok(())
    }

    fn right_operand(&mut self, op: BinaryOp, strength: u8) -> Parsed<Expr> {
        if self.kind() == Kind::Minus {
            return self.signed_operand(op);
        }
        match strength {
            SUM => self.climb(TERM),
            TERM => self.climb_tight(UNION),
            _ => self.climb_tight(strength + 2),
        }
    }

    #[cold]
    #[inline(never)]
    fn signed_operand<T>(&mut self, op: BinaryOp) -> Parsed<T> {
        let written = match op {
            BinaryOp::Add => "a + (-b)",
            BinaryOp::Subtract => "a - (-b)",
            _ => "a ⋅ (-b)",
        };
        let help = format!("put the operand with its sign in parentheses, as in `{written}`");
        self.expected("an operand", &help)
    }

    fn climb_tight(&mut self, least: u8) -> Parsed<Expr> {
        if self.depth >= super::MOST_NESTING {
            let span = self.here();
            return self.too_deep(span);
        }
        self.depth += 1;
        let result = self.climb_from(least);
        self.depth -= 1;
        result
    }

    /// The place of an operator, or the empty place after the left operand of a juxtaposition.
    fn between(&mut self, left: Span, written: bool) -> Span {
        match written {
            true => self.here(),
            false => Span {
                start: left.end,
                ..left
            },
        }
    }

    /// The operator at this place with its strength, and whether a token stands for it.
    fn operator(&mut self) -> Option<(BinaryOp, u8, bool)> {
        let token = self.token(0);
        if self.at >= self.context.row_bar {
            return None;
        }
        let cell = self.context.cell && token.space;
        let written = match token.kind {
            Kind::Plus => (BinaryOp::Add, SUM),
            Kind::Minus => (BinaryOp::Subtract, SUM),
            Kind::PlusMinus => (BinaryOp::PlusMinus, SUM),
            Kind::Dot => (BinaryOp::Dot, TERM),
            Kind::Slash => (BinaryOp::Divide, TERM),
            Kind::Union => (BinaryOp::Union, UNION),
            Kind::Intersection => (BinaryOp::Intersection, INTERSECTION),
            _ => {
                let juxtaposed = !cell && self.starts_operand();
                return juxtaposed.then_some((BinaryOp::Juxtapose, TERM, false));
            }
        };
        if token.kind == Kind::Union && self.ahead(1) == Kind::Underscore {
            return None;
        }
        if cell && token.kind == Kind::Minus && self.tight(1) {
            return None;
        }
        Some((written.0, written.1, true))
    }

    /// Whether what stands here, after an operand, begins a further one.
    fn starts_operand(&mut self) -> bool {
        match self.kind() {
            Kind::Bar => match self.context.bars {
                Bars::Single => false,
                Bars::Double => self.ahead(1) != Kind::Bar || !self.tight(1),
                Bars::None => !(self.context.builder && self.is_builder_bar()),
            },
            Kind::DoubleBar => self.context.bars != Bars::Double,
            Kind::Less => !self.context.condition && self.completes_inner(),
            Kind::Total => !(self.is_name(1) && self.ahead(2) != Kind::Slash),
            kind => kind.starts_operand(),
        }
    }

    /// Level 1c: `×`, `∘`, `⊗`, `:`, `\` and `A⁻¹ b`, which do not mix.
    fn products(&mut self) -> Parsed<Expr> {
        let first = self.prefix()?;
        match self.product_operator() {
            None => Ok(first),
            Some(_) => self.product_chain(first),
        }
    }

    fn product_chain(&mut self, first: Expr) -> Parsed<Expr> {
        let mut chain: Vec<(BinaryOp, Span, Expr)> = Vec::new();
        while let Some((op, written)) = self.product_operator() {
            let left = chain.last().map_or(first.span, |(_, _, right)| right.span);
            let op_span = self.between(left, written);
            if written {
                self.advance();
            }
            if self.kind() == Kind::Minus {
                let help = "put the operand with its sign in parentheses, as in `a × (-b)`";
                return self.expected("an operand", help);
            }
            if let Some((before, at, _)) = chain.last()
                && (*before != op || op == BinaryOp::Cross)
            {
                let message = match op == *before {
                    true => "a chain of `×` has no agreed meaning",
                    false => "these operators are not ordered among each other",
                };
                let error = Diagnostic::error(op_span, message).label(*at, "");
                return self.fail(error.help("put one of the products in parentheses"));
            }
            let height = std::mem::take(&mut self.height);
            let right = self.prefix()?;
            self.height = self.height.max(height);
            self.grow(op_span)?;
            chain.push((op, op_span, right));
        }
        let Some((mut op, mut op_span, mut right)) = chain.pop() else {
            return Ok(first);
        };
        while let Some((next_op, next_span, left)) = chain.pop() {
            right = product(op, left, right, op_span);
            (op, op_span) = (next_op, next_span);
        }
        Ok(product(op, first, right, op_span))
    }

    fn product_operator(&mut self) -> Option<(BinaryOp, bool)> {
        if self.context.dimension || self.at >= self.context.row_bar {
            return None;
        }
        let op = match self.kind() {
            Kind::Cross => BinaryOp::Cross,
            Kind::Hadamard => BinaryOp::Hadamard,
            Kind::Kronecker => BinaryOp::Kronecker,
            Kind::Colon => BinaryOp::Frobenius,
            Kind::Backslash => BinaryOp::Solve,
            _ => {
                let cell = self.context.cell && self.token(0).space;
                let solved = self.after_inverse == self.at && !cell && self.starts_operand();
                return solved.then_some((BinaryOp::Solve, false));
            }
        };
        Some((op, true))
    }

    /// Level 1b: `√`, derivatives, sums; and everything tighter.
    pub(super) fn prefix(&mut self) -> Parsed<Expr> {
        match self.kind() {
            Kind::Root => self.nested(|parser| {
                let start = parser.here();
                parser.advance();
                let operand = Box::new(parser.prefix()?);
                let op = UnaryOp::SquareRoot;
                Ok(make(ExprKind::Unary { op, operand }, parser.since(start)))
            }),
            Kind::Nabla | Kind::Laplace => self.nested(Self::gradient),
            Kind::Partial | Kind::Total => self.nested(Self::derivative),
            Kind::Sum | Kind::Product | Kind::Union => self.nested(Self::big),
            Kind::Integral => self.nested(Self::integral),
            _ => self.power(),
        }
    }

    /// Level 1a: an atom with its superscripts.
    pub(super) fn power(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let base = self.atom()?;
        self.postfixes(base, start)
    }

    fn postfixes(&mut self, mut base: Expr, start: Span) -> Parsed<Expr> {
        loop {
            let token = self.token(0);
            if token.space && (token.kind != Kind::Caret || self.context.cell) {
                return Ok(base);
            }
            let (op, tokens) = match token.kind {
                Kind::Transpose => (UnaryOp::Transpose, 1),
                Kind::Inverse => (UnaryOp::Inverse, 1),
                Kind::PseudoInverse => (UnaryOp::PseudoInverse, 1),
                Kind::Caret => match self.caret_sign() {
                    Some(found) => {
                        if self.names_t && self.ahead(1) != Kind::Top {
                            self.warn_of_letter();
                        }
                        found
                    }
                    None => {
                        base = self.raised(base, start)?;
                        continue;
                    }
                },
                Kind::SuperscriptNumber(_) | Kind::SuperscriptLetter(_) => {
                    base = self.raised(base, start)?;
                    continue;
                }
                Kind::Underscore | Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_) => {
                    let ExprKind::Binary { left, .. } = &mut base.kind else {
                        return Ok(base);
                    };
                    let ExprKind::Norm { subscript, .. } = &mut left.kind else {
                        return Ok(base);
                    };
                    if subscript.is_some() {
                        return Ok(base);
                    }
                    *subscript = self.norm_subscript()?;
                    base.span = self.since(start);
                    continue;
                }
                _ => return Ok(base),
            };
            for _ in 0..tokens {
                self.advance();
            }
            self.grow(start)?;
            let operand = Box::new(base);
            base = make(ExprKind::Unary { op, operand }, self.since(start));
            if op == UnaryOp::Inverse {
                self.after_inverse = self.at;
            }
        }
    }

    /// `^T`, `^⊤`: the operator and its number of tokens.
    fn caret_sign(&mut self) -> Option<(UnaryOp, usize)> {
        match self.ahead(1) {
            Kind::Top => Some((UnaryOp::Transpose, 2)),
            Kind::Name(id) if self.texts.get(id) == "T" => {
                if self.ahead(2) == Kind::Underscore && self.tight(2) {
                    return None;
                }
                Some((UnaryOp::Transpose, 2))
            }
            _ => None,
        }
    }

    /// `^T` where `T` is a name.
    #[cold]
    #[inline(never)]
    fn warn_of_letter(&mut self) {
        let warning = Diagnostic::warning(self.here(), "`^T` transposes, although `T` is a name");
        self.report(warning.help("write `ᵀ` to transpose, `^(T)` for the power"));
    }

    /// `base^exponent` or `base²`.
    fn raised(&mut self, base: Expr, start: Span) -> Parsed<Expr> {
        let op_span = self.here();
        let height = std::mem::take(&mut self.height);
        let right = self.exponent()?;
        self.height = self.height.max(height);
        self.grow(op_span)?;
        if is_minus_one(&right) {
            self.after_inverse = self.at;
            let op = UnaryOp::Inverse;
            let operand = Box::new(base);
            return Ok(make(ExprKind::Unary { op, operand }, self.since(start)));
        }
        let (left, right) = (Box::new(base), Box::new(right));
        let op = BinaryOp::Power;
        let kind = ExprKind::Binary {
            op,
            left,
            right,
            op_span,
        };
        Ok(make(kind, self.since(start)))
    }

    /// An exponent with its sign `^`, or superscript characters; one atom, to the right of which `^` goes on.
    fn exponent(&mut self) -> Parsed<Expr> {
        let start = self.here();
        match self.kind() {
            Kind::SuperscriptNumber(number) => {
                self.advance();
                Ok(signed(number, start))
            }
            Kind::SuperscriptLetter(id) => {
                self.advance();
                Ok(make(ExprKind::Name(self.name_of(id, start)), start))
            }
            _ => {
                self.advance();
                self.nested(Self::caret_exponent)
            }
        }
    }

    fn caret_exponent(&mut self) -> Parsed<Expr> {
        let start = self.here();
        if self.eat(Kind::Minus) {
            let operand = Box::new(self.nested(Self::caret_exponent)?);
            let op = UnaryOp::Negate;
            return Ok(make(ExprKind::Unary { op, operand }, self.since(start)));
        }
        let base = self.atom()?;
        let raised = match self.kind() {
            Kind::Caret => self.caret_sign().is_none(),
            Kind::SuperscriptNumber(_) | Kind::SuperscriptLetter(_) => true,
            _ => false,
        };
        if !raised || !self.tight(0) || is_norm(&base) && self.subscript_after_power() {
            return Ok(base);
        }
        self.raised(base, start)
    }

    fn subscript_after_power(&mut self) -> bool {
        self.ahead(1) == Kind::Underscore
    }
}

fn is_minus_one(expr: &Expr) -> bool {
    let ExprKind::Unary { op, operand } = &expr.kind else {
        return false;
    };
    *op == UnaryOp::Negate && operand.kind == ExprKind::Integer(1)
}

fn is_norm(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Norm { .. })
}

/// An integer, which the tree writes without a sign.
fn signed(number: i64, span: Span) -> Expr {
    let literal = make(ExprKind::Integer(number.saturating_abs()), span);
    if number >= 0 {
        return literal;
    }
    let op = UnaryOp::Negate;
    let operand = Box::new(literal);
    make(ExprKind::Unary { op, operand }, span)
}

impl Kind {
    /// Whether this token can only begin an operand.
    fn starts_operand(self) -> bool {
        matches!(
            self,
            Kind::Name(_)
                | Kind::Function(_)
                | Kind::Unknown
                | Kind::Word(_)
                | Kind::Integer(_)
                | Kind::Real(_)
                | Kind::Pi
                | Kind::Infinity
                | Kind::LeftParen
                | Kind::LeftBracket
                | Kind::LeftBrace
                | Kind::LeftAngle
                | Kind::Hash
                | Kind::Root
                | Kind::Partial
                | Kind::Nabla
                | Kind::Laplace
                | Kind::Sum
                | Kind::Product
                | Kind::Integral
                | Kind::Ones
                | Kind::Empty
        )
    }
}
