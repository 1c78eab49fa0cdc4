//! Boundary matrices and indicator vectors: as what they are, whose products are traversals of the mesh, and as the matrices
//! and vectors of numbers that they are to everything else.

use super::Checker;
use super::builtin::Builtin;
use crate::ir::{Binary, Boundary, ExprId, Fold, Kind, Range, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::{Atom, Dimension, ELEMENT_KINDS, Element, Number, Type};

const CHAIN: &str = "a vector with an entry for each element of a kind, such as a product of boundary matrices and an indicator vector";

impl<'a> Checker<'a> {
    /// Whether a value is a boundary matrix or a chain.
    pub(super) fn is_of_elements(&self, e: ExprId) -> bool {
        matches!(
            self.ty(e),
            Type::Matrix {
                spaces: Some(_),
                ..
            } | Type::Vector { space: Some(_), .. }
        )
    }

    /// A boundary matrix as a sparse matrix of numbers, a chain as a vector of numbers; anything else as it is.
    pub(super) fn in_numbers(&mut self, e: ExprId) -> ExprId {
        let ty = match self.ty(e).clone() {
            Type::Matrix {
                rows,
                columns,
                spaces: Some(_),
                ..
            } => Type::sparse_matrix(rows, columns),
            Type::Vector {
                length,
                space: Some(_),
                ..
            } => Type::real_vector(length),
            _ => return e,
        };
        self.add(Kind::Unary(Unary::ToReal, e), ty)
    }

    /// The same, where it stands beside something that has numbers.
    pub(super) fn in_numbers_beside(&mut self, e: ExprId, other: &Type) -> ExprId {
        let has_numbers = match other {
            Type::Sequence { item, .. } => item.is_scalar(),
            Type::Matrix { .. } | Type::Vector { .. } | Type::Scalar(_) => true,
            _ => false,
        };
        match has_numbers {
            true => self.in_numbers(e),
            false => e,
        }
    }

    /// Both operands in numbers, unless they are a boundary matrix and a chain.
    pub(super) fn both_in_numbers(
        &mut self,
        a: ExprId,
        b: ExprId,
        is_product: bool,
    ) -> (ExprId, ExprId) {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        // of which elements the rows and columns are is compared where products are
        if is_product
            && matches!(ta, Type::Matrix { .. })
            && self.is_of_elements(a)
            && self.is_of_elements(b)
        {
            return (a, b);
        }
        (
            self.in_numbers_beside(a, &tb),
            self.in_numbers_beside(b, &ta),
        )
    }

    /// A boundary matrix as a value.
    pub(super) fn boundary(&mut self, boundary: Boundary) -> ExprId {
        let (rows, columns) = self.boundary_spaces(boundary);
        let count = |element| Dimension::atom(Atom::Count(element));
        let ty = Type::Matrix {
            number: Number::Integer,
            rows: count(rows),
            columns: count(columns),
            sparse: true,
            spaces: Some((rows, columns)),
        };
        self.add(Kind::Boundary(boundary), ty)
    }

    /// What the rows and the columns of a boundary matrix stand for.
    fn boundary_spaces(&self, boundary: Boundary) -> (Element, Element) {
        let element = |dimension: u8| Element {
            kind: ELEMENT_KINDS[dimension as usize],
            mesh: boundary.mesh,
        };
        let (rows, columns) = (element(boundary.dimension - 1), element(boundary.dimension));
        if boundary.transposed {
            (columns, rows)
        } else {
            (rows, columns)
        }
    }

    /// The product of a boundary matrix, or of a product of such, and a chain: as products of one matrix and a chain each, in
    /// whatever way it is written. `None` where it is another product, or the elements do not fit.
    pub(super) fn applied(&mut self, a: ExprId, chain: ExprId) -> Option<ExprId> {
        let Type::Vector {
            space: Some(space), ..
        } = *self.ty(chain)
        else {
            return None;
        };
        match *self.program.arena.kind(a) {
            Kind::Boundary(boundary) => {
                let (_, columns) = self.boundary_spaces(boundary);
                (columns == space).then(|| self.apply(boundary, chain))
            }
            Kind::Unary(Unary::ToReal, matrix) => self.applied(matrix, chain),
            Kind::Binary(Binary::Product, left, right) => {
                let first = self.applied(right, chain)?;
                self.applied(left, first)
            }
            _ => None,
        }
    }

    /// The product of a boundary matrix and a chain.
    fn apply(&mut self, boundary: Boundary, chain: ExprId) -> ExprId {
        let (rows, _) = self.boundary_spaces(boundary);
        let ty = self.chain(rows);
        self.add(Kind::Apply(boundary, chain), ty)
    }

    /// The type of chains of these elements.
    fn chain(&self, space: Element) -> Type {
        Type::Vector {
            number: Number::Integer,
            length: Dimension::atom(Atom::Count(space)),
            sparse: true,
            space: Some(space),
        }
    }

    pub(super) fn indicator(&mut self, call: &Builtin<'_, 'a>) -> ExprId {
        if !self.takes(call, 1) {
            return self.error();
        }
        match self.ty(call.values[0]).element_of_set() {
            Some(element) => {
                let ty = self.chain(element);
                self.add(Kind::Indicator(call.values[0]), ty)
            }
            None => self.wrong(call, 0, "a set of elements of a mesh"),
        }
    }

    /// `NonZeros(x)`, `ValueSet(x, k)`.
    pub(super) fn elements_by_value(&mut self, call: &Builtin<'_, 'a>, is_value: bool) -> ExprId {
        if !self.takes(call, 1 + usize::from(is_value)) {
            return self.error();
        }
        let x = call.values[0];
        let space = match self.ty(x) {
            Type::Vector {
                space: Some(space), ..
            } => Some(*space),
            _ => None,
        };
        let Some(element) = space.or_else(|| self.indexing_elements(x)) else {
            return self.wrong(call, 0, CHAIN);
        };
        let value = match call.values.get(1) {
            Some(&value) if *self.ty(value) == Type::INTEGER => Some(value),
            Some(&value) if space.is_none() && self.ty(value).is_scalar() => Some(value),
            Some(_) if space.is_none() => {
                return self.wrong(call, 1, "a number as its second argument");
            }
            Some(_) => return self.wrong(call, 1, "an integer as its second argument"),
            None => None,
        };
        let ty = Type::set_of(Type::Element(element));
        if space.is_some() {
            let kind = match value {
                Some(value) => Kind::ValueSet(x, value),
                None => Kind::NonZeros(x),
            };
            return self.add(kind, ty);
        }
        let variable = self
            .program
            .arena
            .new_variable("member", Type::Element(element));
        let member = self.program.arena.variable(variable);
        let entry = match self.ty(x).clone() {
            Type::Sequence { item, .. } => self.add(Kind::Item(x, member), *item),
            ty => {
                let number = self.add(Kind::Unary(Unary::ToInteger, member), Type::INTEGER);
                let number_type = match ty {
                    Type::Vector { number, .. } => number,
                    _ => Number::Real,
                };
                self.add(Kind::Component(x, number), Type::Scalar(number_type))
            }
        };
        let zero = self.program.arena.integer(0);
        let (entry, wanted) = self.common(entry, value.unwrap_or(zero));
        let op = match is_value {
            true => CompareOp::Equal,
            false => CompareOp::NotEqual,
        };
        let condition = self.add(Kind::Compare(op, entry, wanted), Type::Boolean);
        let all = self.add(Kind::AllElements(element), ty.clone());
        self.add(
            Kind::Fold {
                op: Fold::Collect,
                variable,
                range: Range::Set(all),
                condition: Some(condition),
                body: member,
            },
            ty,
        )
    }

    /// The elements for each of which a vector, or a sequence of numbers, has an entry.
    fn indexing_elements(&self, x: ExprId) -> Option<Element> {
        let length = match self.ty(x) {
            Type::Vector { length, .. } => length,
            Type::Sequence { item, index, .. } if item.is_scalar() => return *index,
            _ => return None,
        };
        match length.as_atom() {
            Some(Atom::Count(element)) => Some(*element),
            _ => None,
        }
    }
}
