//! Sums, products, big unions, integrals, optimisation, piecewise values.

use super::super::ast::*;
use super::super::token::Kind;
use super::condition::BUILDER_HELP;
use super::expression::{TERM, make};
use super::{Context, Failed, Parsed, Parser};
use crate::diagnostic::Diagnostic;

const HEAD_HELP: &str = "write `∑_i`, `∑_(i ∈ S)`, `∑_(i for condition)` or `∑_(i = a)^b`";

impl Parser<'_> {
    /// `∑_… term where locals`.
    pub(super) fn big(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let op = match self.advance().kind {
            Kind::Sum => BigOp::Sum,
            Kind::Product => BigOp::Product,
            _ => BigOp::Union,
        };
        let line = self.eat(Kind::Underscore);
        let head = match self.kind() {
            Kind::LeftParen => self.head()?,
            Kind::Name(_) | Kind::Function(_) if line => {
                let index = self.name("an index", HEAD_HELP)?;
                let follows = self.token(0);
                if matches!(follows.kind, Kind::In | Kind::Assign) {
                    return self.unparenthesised(op, &index.text);
                }
                let plain = follows.space || follows.kind == Kind::LeftParen;
                if !plain {
                    return self.expected("a blank after the index", HEAD_HELP);
                }
                Head::Index(index)
            }
            _ => return self.expected("an index", HEAD_HELP),
        };
        let body = Box::new(self.climb(TERM)?);
        let mut locals = Vec::new();
        let mine = match self.kind() {
            Kind::With => true,
            Kind::Where => {
                self.at += 1;
                let sign = self.statement_sign();
                self.at -= 1;
                matches!(sign, Some(Kind::Assign | Kind::AddAssign))
            }
            _ => false,
        };
        if mine {
            self.advance();
            self.locals(&mut locals)?;
        }
        let kind = ExprKind::Big {
            op,
            head,
            body,
            locals,
        };
        Ok(make(kind, self.since(start)))
    }

    /// `∑_v ∈ S`, `∑_i = 1^n`.
    fn unparenthesised<T>(&mut self, op: BigOp, index: &str) -> Parsed<T> {
        let sign = match op {
            BigOp::Sum => "∑",
            BigOp::Product => "∏",
            BigOp::Union => "∪",
        };
        let head = match self.kind() {
            Kind::In => format!("{sign}_({index} ∈ S)"),
            _ => format!("{sign}_({index} = 1)^n"),
        };
        let message = format!("what `{index}` runs over stands in parentheses");
        let error = Diagnostic::error(self.here(), message);
        self.fail(error.help(format!("write `{head}`")))
    }

    /// Definitions of a sum, up to something that is none.
    fn locals(&mut self, locals: &mut Vec<Definition>) -> Parsed<()> {
        loop {
            let context = Context {
                bars: self.context.bars,
                ..Context::PLAIN
            };
            let definition = self.within(context, |parser| parser.definition(true))?;
            if definition.add {
                let error = Diagnostic::error(
                    definition.span,
                    "`+=` adds to definitions of the module only",
                );
                self.report(error.help("write the whole sum in one definition"));
            }
            locals.push(definition);
            if self.kind() != Kind::Comma {
                return Ok(());
            }
            self.at += 1;
            if self.statement_sign() != Some(Kind::Assign) {
                self.at -= 1;
                return Ok(());
            }
        }
    }

    /// `(i ∈ S)`, `(i for condition)`, `(i = a)^b`.
    fn head(&mut self) -> Parsed<Head> {
        self.within(Context::PLAIN, Self::head_inside)
    }

    fn head_inside(&mut self) -> Parsed<Head> {
        self.advance();
        let mut names = self.bound_names("an index", HEAD_HELP)?;
        let single = names.len() == 1;
        let head = match self.kind() {
            Kind::In => {
                self.advance();
                let range = Box::new(self.expression()?);
                Head::Members(names, range)
            }
            Kind::For if single => {
                self.advance();
                let condition = Box::new(self.condition()?);
                Head::Filtered(names.remove(0), condition)
            }
            Kind::Assign if single => {
                self.advance();
                let from = Box::new(self.expression()?);
                self.expect(Kind::RightParen, "`)`", HEAD_HELP)?;
                self.expect(Kind::Caret, "`^` and the last index", HEAD_HELP)?;
                let to = Box::new(self.bound()?);
                return Ok(Head::Range(names.remove(0), from, to));
            }
            _ => {
                self.no_look_alike(&names)?;
                return self.expected("`∈`, `for` or `=`", HEAD_HELP);
            }
        };
        self.expect(Kind::RightParen, "`)`", HEAD_HELP)?;
        Ok(head)
    }

    /// A bound of a sum or an integral: a number, a name, `∞`, or anything in parentheses.
    fn bound(&mut self) -> Parsed<Expr> {
        let start = self.here();
        match self.kind() {
            Kind::LeftParen => {
                self.advance();
                let bound = self.bracketed()?;
                self.expect(Kind::RightParen, "`)`", "close the bound")?;
                Ok(bound)
            }
            Kind::Minus => {
                self.advance();
                let operand = Box::new(self.nested(Self::bound)?);
                let op = UnaryOp::Negate;
                Ok(make(ExprKind::Unary { op, operand }, self.since(start)))
            }
            _ => self.atom(),
        }
    }

    /// `∫_[a,b] body 𝕕t`, `∫_a^b body 𝕕t`.
    pub(super) fn integral(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let help = "write `∫_[a,b] value 𝕕t` or `∫_a^b value 𝕕t`";
        self.advance();
        self.expect(Kind::Underscore, "`_` and the bounds", help)?;
        let (from, to);
        if self.eat(Kind::LeftBracket) {
            from = self.bracketed()?;
            self.expect(Kind::Comma, "`,`", help)?;
            to = self.bracketed()?;
            self.expect(Kind::RightBracket, "`]`", help)?;
        } else {
            from = self.bound()?;
            self.expect(Kind::Caret, "`^` and the upper bound", help)?;
            to = self.bound()?;
        }
        let (from, to) = (Box::new(from), Box::new(to));
        let context = Context {
            cell: false,
            integral: true,
            ..self.context
        };
        let body = Box::new(self.within(context, Self::expression)?);
        self.expect(Kind::Total, "`𝕕` and the variable", help)?;
        let variable = self.name("the variable of the integral", help)?;
        let kind = ExprKind::Integral {
            variable,
            from,
            to,
            body,
        };
        Ok(make(kind, self.since(start)))
    }

    /// `min_(x ∈ ℝ^n) value s.t. conditions`.
    pub(super) fn optimise(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let mut initial = Vec::new();
        if self.eat(Kind::Initial) {
            initial.push(self.definition(true)?);
            while self.eat(Kind::Branch) {
                initial.push(self.definition(true)?);
            }
        }
        let help = "write `min_(x ∈ ℝ^n) value s.t. condition`";
        let Kind::Optimise(kind) = self.kind() else {
            return self.expected("`min_(`, `max_(`, `argmin_(` or `argmax_(`", help);
        };
        self.advance();
        self.expect(Kind::Underscore, "`_`", help)?;
        self.expect(Kind::LeftParen, "`(`", help)?;
        let mut variables = vec![self.declaration_with(Self::type_or_set)?];
        while self.eat(Kind::Comma) {
            variables.push(self.declaration_with(Self::type_or_set)?);
        }
        self.expect(Kind::RightParen, "`,` or `)`", help)?;
        let objective = Box::new(self.expression()?);
        let mut constraints = Vec::new();
        if self.eat(Kind::SuchThat) {
            constraints.push(self.condition()?);
            while self.eat(Kind::Branch) {
                constraints.push(self.condition()?);
            }
        }
        let kind = ExprKind::Optimise {
            kind,
            variables,
            objective,
            constraints,
            initial,
        };
        Ok(make(kind, self.since(start)))
    }

    /// `{ a if p; b otherwise`.
    pub(super) fn piecewise(&mut self) -> Parsed<Expr> {
        let start = self.here();
        self.advance();
        let mut branches = Vec::new();
        let mut otherwise = None;
        loop {
            match self.branch() {
                Ok((value, Some(condition))) => branches.push((value, condition)),
                Ok((value, None)) => {
                    otherwise = Some(Box::new(value));
                    break;
                }
                Err(Failed) => {
                    while !matches!(
                        self.kind(),
                        Kind::Branch | Kind::Newline | Kind::Where | Kind::End
                    ) {
                        self.advance();
                    }
                    if self.kind() != Kind::Branch {
                        return Err(Failed);
                    }
                }
            }
            if !self.eat(Kind::Branch) {
                break;
            }
        }
        if self.kind() == Kind::For {
            return self.expected("the next branch", BUILDER_HELP);
        }
        let kind = ExprKind::Piecewise {
            branches,
            otherwise,
        };
        let value = make(kind, self.since(start));
        if self.kind() == Kind::RightBrace {
            let error = Diagnostic::error(self.here(), "a piecewise value has no closing brace");
            self.report(error.help("remove the `}`; the value ends with its last line"));
            self.advance();
        }
        Ok(value)
    }

    /// A value with its condition; without one after `otherwise`.
    fn branch(&mut self) -> Parsed<(Expr, Option<Condition>)> {
        let value = self.right_side()?;
        match self.kind() {
            Kind::If => {
                self.advance();
                Ok((value, Some(self.condition()?)))
            }
            Kind::Otherwise => {
                self.advance();
                Ok((value, None))
            }
            Kind::In => self.expected("`if` or `otherwise`", BUILDER_HELP),
            _ => self.expected(
                "`if` or `otherwise`",
                "a branch is `value if condition` or `value otherwise`",
            ),
        }
    }
}
