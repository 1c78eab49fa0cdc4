//! Declarations, types and dimensions.

use super::super::ast::*;
use super::super::token::Kind;
use super::expression::{TERM, make};
use super::{Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

/// Most scalars in `{ℝ^3}`.
const MOST_ITEMS: i64 = 64;

const TYPE_HELP: &str =
    "types are ℝ, ℤ, ℝ^n, ℝ^(n×m), {T}, T × U, T → U, FaceMesh and the like, or the name of a set";

impl Parser<'_> {
    /// `x, y_i ∈ type attribute : text`.
    pub(super) fn declaration(&mut self) -> Parsed<Declaration> {
        self.declaration_with(Self::declared_type)
    }

    /// A declaration with this way to read its type.
    pub(super) fn declaration_with(
        &mut self,
        read: impl FnOnce(&mut Self) -> Parsed<Type>,
    ) -> Parsed<Declaration> {
        let start = self.here();
        let help = "a declaration is `x ∈ type`, `x_i ∈ type` for a sequence, or `s ⊂ S`";
        let mut targets = Vec::new();
        loop {
            let name = self.name("a name", help)?;
            let at = self.here();
            let subscript = match self.subscripts()? {
                None => None,
                Some(list) => Some(self.sequence_letter(list, self.since(at))?),
            };
            targets.push(Target { name, subscript });
            if !self.eat(Kind::Comma) {
                break;
            }
        }
        let relation = match self.kind() {
            Kind::In => Relation::Member,
            Kind::Colon => Relation::Colon,
            Kind::Subset => Relation::Subset,
            _ => return self.expected("`∈`, `:` or `⊂`", help),
        };
        self.advance();
        let ty = read(self)?;
        let attribute = self.attribute();
        let mut description = None;
        if self.kind() == Kind::Colon {
            self.advance();
            if self.kind() == Kind::Description {
                description = Some(self.token_text().to_owned());
                self.advance();
            }
        }
        Ok(Declaration {
            targets,
            relation,
            ty,
            attribute,
            description,
            span: self.since(start),
        })
    }

    /// The one letter that a sequence is declared with.
    fn sequence_letter(&mut self, mut list: Vec<Subscript>, span: Span) -> Parsed<Name> {
        let is_one = list.len() == 1;
        let mut is_number = false;
        if let Some(Subscript::Expr(Expr { kind, .. })) = list.pop()
            && is_one
        {
            match kind {
                ExprKind::Name(name) => return Ok(name),
                kind => is_number = matches!(kind, ExprKind::Integer(_)),
            }
        }
        let error = Diagnostic::error(span, "a sequence is declared with one subscript letter");
        self.fail(error.help(match is_number {
            true => "a name with a number in it stands between back-ticks",
            false => "write `x_i ∈ type`; several dimensions go into the type",
        }))
    }

    /// The type of a declaration.
    pub(super) fn declared_type(&mut self) -> Parsed<Type> {
        self.nested(Self::type_with_arrow)
    }

    /// The type of a variable of an optimisation, or the set that it is a member of.
    pub(super) fn type_or_set(&mut self) -> Parsed<Type> {
        let is_type = match self.kind() {
            Kind::Reals | Kind::Integers => true,
            Kind::Name(_) | Kind::Function(_) if self.type_follows(0) => true,
            Kind::Name(_) => matches!(self.ahead(1), Kind::Comma | Kind::RightParen),
            _ => false,
        };
        if is_type {
            return self.declared_type();
        }
        let start = self.here();
        let set = Box::new(self.within(Context::PLAIN, Self::expression)?);
        Ok(self.ty(TypeKind::Members(set), start))
    }

    fn type_with_arrow(&mut self) -> Parsed<Type> {
        let start = self.here();
        let empty = match self.kind() {
            Kind::Empty => 1,
            Kind::LeftBrace if self.ahead(1) == Kind::RightBrace => 2,
            _ => 0,
        };
        let mut parameters = Vec::new();
        if empty > 0 {
            for _ in 0..empty {
                self.advance();
            }
        } else {
            parameters.push(self.tuple_type()?);
            while matches!(self.kind(), Kind::Comma | Kind::Semicolon) && self.type_follows(1) {
                self.advance();
                parameters.push(self.tuple_type()?);
            }
        }
        if self.kind() != Kind::Arrow {
            let single = parameters.len() == 1;
            return match parameters.pop() {
                Some(ty) if single => Ok(ty),
                _ => self.expected("`→`", "the result of a function type follows after `→`"),
            };
        }
        self.advance();
        if let [
            Type {
                kind: TypeKind::Named(from),
                ..
            },
        ] = parameters.as_slice()
        {
            let from = from.clone();
            let to = Box::new(self.tuple_type()?);
            let kind = TypeKind::Mapping { from, to };
            return Ok(self.ty(kind, start));
        }
        let mut results = vec![self.tuple_type()?];
        while matches!(self.kind(), Kind::Comma | Kind::Semicolon) && self.type_follows(1) {
            self.advance();
            results.push(self.tuple_type()?);
        }
        let kind = TypeKind::Function {
            parameters,
            results,
        };
        Ok(self.ty(kind, start))
    }

    fn ty(&self, kind: TypeKind, start: Span) -> Type {
        Type {
            kind,
            span: self.since(start),
        }
    }

    /// Whether a type that is no bare name begins here, so that a comma before it is inside a function type.
    fn type_follows(&mut self, ahead: usize) -> bool {
        match self.ahead(ahead) {
            Kind::Reals | Kind::Integers | Kind::LeftBrace => true,
            Kind::Name(id) | Kind::Function(id) => {
                let word = self.texts.get(id).to_owned();
                let next = self.ahead(ahead + 1);
                let used = match word.as_str() {
                    "vector" | "matrix" => next == Kind::LeftParen,
                    "scalar" => true,
                    _ => type_word(&word).is_some(),
                };
                used && !matches!(next, Kind::In | Kind::Colon | Kind::Subset | Kind::Assign)
            }
            _ => false,
        }
    }

    fn tuple_type(&mut self) -> Parsed<Type> {
        let start = self.here();
        let first = self.simple_type()?;
        if self.kind() != Kind::Cross {
            return Ok(first);
        }
        self.sizes_in_parentheses(&first)?;
        let mut parts = vec![first];
        while self.eat(Kind::Cross) {
            parts.push(self.simple_type()?);
        }
        Ok(self.ty(TypeKind::Tuple(parts), start))
    }

    /// `ℝ^n×m` is meant for a matrix: a size is no type that a tuple may go on with.
    fn sizes_in_parentheses(&mut self, first: &Type) -> Parsed<()> {
        let is_size = match self.ahead(1) {
            Kind::Integer(_) => true,
            Kind::Name(id) => {
                let word = self.texts.get(id);
                type_word(word).is_none() && !["scalar", "vector", "matrix"].contains(&word)
            }
            _ => false,
        };
        if !is_size || !matches!(first.kind, TypeKind::Vector { .. }) {
            return Ok(());
        }
        self.advance();
        let span = first.span.to(self.here());
        let error = Diagnostic::error(span, "the sizes of a matrix stand in parentheses");
        self.fail(error.help("write `ℝ^(n×m)`"))
    }

    fn simple_type(&mut self) -> Parsed<Type> {
        let start = self.here();
        let kind = match self.kind() {
            Kind::Reals => self.numbers(Number::Real)?,
            Kind::Integers => self.numbers(Number::Integer)?,
            Kind::LeftBrace => self.nested(Self::set_type)?,
            Kind::LeftParen => {
                self.advance();
                let inner = self.nested(Self::type_with_arrow)?;
                self.expect(Kind::RightParen, "`)`", "close the parenthesis")?;
                return Ok(inner);
            }
            Kind::Name(id) | Kind::Function(id) => {
                let word = self.texts.get(id).to_owned();
                match word.as_str() {
                    "scalar" => {
                        self.advance();
                        TypeKind::Scalar(Number::Real)
                    }
                    "vector" | "matrix" if self.ahead(1) == Kind::LeftParen => self.spelt_out()?,
                    _ => {
                        self.advance();
                        type_word(&word).unwrap_or(TypeKind::Named(Name {
                            text: word,
                            span: start,
                        }))
                    }
                }
            }
            _ => return self.expected("a type", TYPE_HELP),
        };
        Ok(self.ty(kind, start))
    }

    /// `ℝ^3x3` and `ℝ^(3x3)` are meant for a matrix.
    fn no_letter_between_sizes(&mut self) -> Parsed<()> {
        let open = (self.kind() == Kind::LeftParen) as usize;
        let (rows, sizes) = (self.token(open), self.token(open + 1));
        let text = &self.text[sizes.start as usize..sizes.end as usize];
        let columns = text.strip_prefix('x').filter(|digits| {
            !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit())
        });
        let (Kind::Integer(number), Some(columns), false) = (rows.kind, columns, sizes.space)
        else {
            return Ok(());
        };
        let help = format!("write `ℝ^({number}×{columns})`, or `ℝ^({number},{columns})`");
        let span = self.span(rows).to(self.span(sizes));
        let error = Diagnostic::error(span, "between the sizes of a matrix stands `×`, not `x`");
        self.fail(error.help(help))
    }

    /// `ℝ`, `ℝ^n`, `ℝ³`, `ℝ^(n×m)`.
    fn numbers(&mut self, number: Number) -> Parsed<TypeKind> {
        self.advance();
        let span = self.here();
        if self.token(0).space {
            return Ok(TypeKind::Scalar(number));
        }
        let length = match self.kind() {
            Kind::SuperscriptNumber(size) => {
                self.advance();
                make(ExprKind::Integer(size), span)
            }
            Kind::SuperscriptLetter(id) => {
                self.advance();
                make(ExprKind::Name(self.name_of(id, span)), span)
            }
            Kind::Caret => {
                self.advance();
                self.no_letter_between_sizes()?;
                if self.kind() == Kind::LeftParen {
                    self.advance();
                    let rows = self.dimension()?;
                    let columns = match self.eat(Kind::Cross) || self.eat(Kind::Comma) {
                        true => Some(self.dimension()?),
                        false => None,
                    };
                    let help = "a dimension is `n`, `(n×m)` or arithmetic over names";
                    self.expect(Kind::RightParen, "`×` or `)`", help)?;
                    return Ok(self.array(number, rows, columns));
                }
                self.bare_dimension()?
            }
            _ => return Ok(TypeKind::Scalar(number)),
        };
        Ok(self.array(number, length, None))
    }

    fn array(&mut self, number: Number, rows: Expr, columns: Option<Expr>) -> TypeKind {
        let sparse = self.word("sparse");
        let rows = Box::new(rows);
        match columns {
            None => TypeKind::Vector {
                number,
                length: rows,
                sparse,
            },
            Some(columns) => TypeKind::Matrix {
                number,
                rows,
                columns: Box::new(columns),
                sparse,
            },
        }
    }

    /// Reads a word that means something here only.
    fn word(&mut self, word: &str) -> bool {
        let found = match self.kind() {
            Kind::Name(id) | Kind::Function(id) => self.texts.get(id) == word,
            _ => false,
        };
        if found {
            self.advance();
        }
        found
    }

    /// `vector(n)`, `matrix(n, m)`.
    fn spelt_out(&mut self) -> Parsed<TypeKind> {
        let matrix = self.token_text() == "matrix";
        self.advance();
        self.advance();
        let rows = self.dimension()?;
        let mut columns = None;
        if matrix {
            if !self.eat(Kind::Cross) {
                self.expect(Kind::Comma, "`,`", "write `matrix(rows, columns)`")?;
            }
            columns = Some(self.dimension()?);
        }
        self.expect(
            Kind::RightParen,
            "`)`",
            "write `vector(n)` or `matrix(n, m)`",
        )?;
        Ok(self.array(Number::Real, rows, columns))
    }

    /// A dimension in parentheses: arithmetic.
    fn dimension(&mut self) -> Parsed<Expr> {
        let context = Context {
            dimension: true,
            ..Context::PLAIN
        };
        self.within(context, Self::expression)
    }

    /// A dimension without parentheses: a number, a name, or a product written without blanks.
    fn bare_dimension(&mut self) -> Parsed<Expr> {
        let context = Context {
            dimension: true,
            cell: true,
            ..Context::PLAIN
        };
        self.within(context, |parser| match parser.kind() {
            Kind::Minus => parser.expected("a dimension", "a dimension is positive"),
            _ => parser.climb(TERM),
        })
    }

    /// `{ℝ}`, `{ℤ×ℤ}`, `{ℤ²}`, `{T ∨ U}`.
    fn set_type(&mut self) -> Parsed<TypeKind> {
        self.advance();
        let help = "a set type is `{T}` or `{T × U}`";
        if let Some((number, count)) = self.repeated() {
            let span = self.here();
            if !(1..=MOST_ITEMS).contains(&count) {
                let error =
                    Diagnostic::error(span, format!("a tuple of {count} numbers is not supported"));
                return self.fail(error.help("write `{ℝ^(n)}` for a set of vectors"));
            }
            let length = 2 + (self.ahead(1) == Kind::Caret) as usize;
            for _ in 0..length {
                self.advance();
            }
            let ty = Type {
                kind: TypeKind::Scalar(number),
                span,
            };
            self.expect(Kind::RightBrace, "`}`", help)?;
            return Ok(TypeKind::Set(vec![ty; count as usize]));
        }
        let mut parts = vec![self.simple_type()?];
        let separator = self.kind();
        if matches!(separator, Kind::Cross | Kind::Vee) {
            while self.eat(separator) {
                parts.push(self.simple_type()?);
            }
        }
        self.expect(Kind::RightBrace, "`}`", help)?;
        match separator {
            Kind::Vee => Ok(TypeKind::SetOfAlternatives(parts)),
            _ => Ok(TypeKind::Set(parts)),
        }
    }

    /// `ℝ^3}` or `ℝ³}`: as many scalars.
    fn repeated(&mut self) -> Option<(Number, i64)> {
        let number = match self.kind() {
            Kind::Reals => Number::Real,
            Kind::Integers => Number::Integer,
            _ => return None,
        };
        let (count, length) = match (self.ahead(1), self.ahead(2)) {
            (Kind::SuperscriptNumber(count), _) => (count, 2),
            (Kind::Caret, Kind::Integer(count)) => (count, 3),
            _ => return None,
        };
        (self.ahead(length) == Kind::RightBrace).then_some((number, count))
    }

    /// `index`, `vertices` and the like after a type.
    pub(super) fn attribute(&mut self) -> Option<(Attribute, Span)> {
        let span = self.here();
        let word = match self.kind() {
            Kind::Name(id) | Kind::Function(id) => self.texts.get(id),
            _ => return None,
        };
        let attribute = match word {
            "index" => Attribute::Index,
            "vertices" => Attribute::Vertices,
            "edges" => Attribute::Edges,
            "faces" => Attribute::Faces,
            "tets" | "cells" => Attribute::Cells,
            _ => return None,
        };
        self.advance();
        Some((attribute, span))
    }
}

/// The type that a word of its own stands for.
fn type_word(word: &str) -> Option<TypeKind> {
    Some(match word.to_ascii_lowercase().as_str() {
        "edgemesh" => TypeKind::Mesh(MeshKind::EdgeMesh),
        "facemesh" => TypeKind::Mesh(MeshKind::FaceMesh),
        "cellmesh" => TypeKind::Mesh(MeshKind::CellMesh),
        "vertexset" => TypeKind::ElementSet(ElementKind::Vertex),
        "edgeset" => TypeKind::ElementSet(ElementKind::Edge),
        "faceset" => TypeKind::ElementSet(ElementKind::Face),
        "cellset" => TypeKind::ElementSet(ElementKind::Cell),
        "cellularset" => TypeKind::CellularSet,
        _ => return None,
    })
}
