//! Builds expressions of real numbers, vectors and matrices, simplifying what needs no computation: `0 a`, `1 a`, `a + 0`.

use crate::ir::{Arena, Binary, Block, ExprId, Kind, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::{Dimension, Shape, Type};

/// Vectors and matrices with at most so many entries are written entry by entry where one entry changes.
pub(super) const SMALL: i64 = 16;

/// Builds expressions in an arena.
pub(super) struct Algebra<'a> {
    pub(super) arena: &'a mut Arena,
}

impl Algebra<'_> {
    pub(super) fn ty(&self, e: ExprId) -> Type {
        self.arena.ty(e).clone()
    }

    pub(super) fn kind(&self, e: ExprId) -> Kind {
        self.arena.kind(e).clone()
    }

    /// The real number that an expression is, if it is one.
    pub(super) fn number(&self, e: ExprId) -> Option<f64> {
        match self.arena.kind(e) {
            Kind::Real(bits) => Some(f64::from_bits(*bits)),
            Kind::Integer(value) => Some(*value as f64),
            Kind::Unary(Unary::Negate | Unary::ToReal, a) => {
                let value = self.number(*a)?;
                Some(match self.arena.kind(e) {
                    Kind::Unary(Unary::Negate, _) => -value,
                    _ => value,
                })
            }
            _ => None,
        }
    }

    /// Whether an expression is known to be 0.
    pub(super) fn is_zero(&self, e: ExprId) -> bool {
        match self.arena.kind(e) {
            Kind::Filled(value, _) => self.is_zero(*value),
            Kind::Vector(items) => items.iter().all(|i| self.is_zero(*i)),
            Kind::Assemble { blocks, .. } => blocks.is_empty(),
            _ => self.number(e) == Some(0.0),
        }
    }

    /// The dense type of a value.
    pub(super) fn dense(&self, e: ExprId) -> Type {
        match self.arena.ty(e).shape() {
            Some(shape) => shape.real(),
            None => self.ty(e),
        }
    }

    /// 0 in the size of a value.
    pub(super) fn zero(&mut self, like: ExprId) -> ExprId {
        let ty = self.dense(like);
        let zero = self.arena.real(0.0);
        match (ty.shape(), self.fixed(like)) {
            (Some(Shape::Scalar), _) => zero,
            (Some(Shape::Vector(_)), Some((n, _))) if n <= SMALL => {
                self.arena.add(Kind::Vector(vec![zero; n as usize]), ty)
            }
            (Some(Shape::Vector(_)), _) => {
                let n = self.size(like, 0);
                self.arena.add(Kind::Filled(zero, vec![n]), ty)
            }
            _ => {
                let sizes = vec![self.size(like, 0), self.size(like, 1)];
                self.arena.add(Kind::Filled(zero, sizes), ty)
            }
        }
    }

    pub(super) fn real(&mut self, value: f64) -> ExprId {
        self.arena.real(value)
    }

    pub(super) fn unary(&mut self, op: Unary, a: ExprId, ty: Type) -> ExprId {
        self.arena.add(Kind::Unary(op, a), ty)
    }

    pub(super) fn binary(&mut self, op: Binary, a: ExprId, b: ExprId, ty: Type) -> ExprId {
        self.arena.add(Kind::Binary(op, a, b), ty)
    }

    /// A value in a representation: of known or of unknown sizes, a vector or a matrix with one column.
    pub(super) fn represented(&mut self, a: ExprId, ty: &Type) -> ExprId {
        let own = self.ty(a);
        let same = own.is_fixed() == ty.is_fixed()
            && own.is_sparse() == ty.is_sparse()
            && own.shape().map(|s| std::mem::discriminant(&s))
                == ty.shape().map(|s| std::mem::discriminant(&s));
        match same || ty.shape().is_none() {
            true => a,
            false => self.unary(Unary::Reshape, a, ty.clone()),
        }
    }

    pub(super) fn negate(&mut self, a: ExprId) -> ExprId {
        if let Some(value) = self.number(a).filter(|_| self.arena.ty(a).is_scalar()) {
            return self.real(-value);
        }
        if self.is_zero(a) {
            return a;
        }
        match self.kind(a) {
            Kind::Unary(Unary::Negate, inner) => inner,
            Kind::Vector(items) => {
                let items = items.into_iter().map(|i| self.negate(i)).collect();
                let ty = self.ty(a);
                self.arena.add(Kind::Vector(items), ty)
            }
            _ => {
                let ty = self.ty(a);
                self.unary(Unary::Negate, a, ty)
            }
        }
    }

    pub(super) fn add(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.number(a), self.number(b)) {
            return self.real(x + y);
        }
        match (self.kind(a), self.kind(b)) {
            (Kind::Vector(x), Kind::Vector(y)) if x.len() == y.len() => {
                let items = x.into_iter().zip(y).map(|(x, y)| self.add(x, y)).collect();
                let ty = self.ty(a);
                self.arena.add(Kind::Vector(items), ty)
            }
            (
                Kind::Assemble { sizes, mut blocks },
                Kind::Assemble {
                    blocks: others,
                    sizes: same,
                },
            ) if sizes == same => {
                for other in others {
                    self.put(&mut blocks, other);
                }
                let ty = self.ty(a);
                self.arena.add(Kind::Assemble { sizes, blocks }, ty)
            }
            _ if a == b => {
                let two = self.real(2.0);
                self.scale(two, a)
            }
            (_, Kind::Unary(Unary::Negate, b)) => self.subtract(a, b),
            (Kind::Unary(Unary::Negate, a), _) => self.subtract(b, a),
            _ => {
                let ty = self.ty(a);
                let b = self.represented(b, &ty);
                self.binary(Binary::Add, a, b, ty)
            }
        }
    }

    /// Adds a block to others, to the one at its place where there is one.
    pub(super) fn put(&mut self, blocks: &mut Vec<Block>, block: Block) {
        let ty = self.ty(block.value);
        let same = blocks.iter_mut().find(|b| {
            b.rows == block.rows && b.columns == block.columns && *self.arena.ty(b.value) == ty
        });
        match same {
            Some(other) => {
                other.value = self.add(other.value, block.value);
                other.core = None;
            }
            None => blocks.push(block),
        }
    }

    pub(super) fn subtract(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return self.negate(b);
        }
        if let (Some(x), Some(y)) = (self.number(a), self.number(b)) {
            return self.real(x - y);
        }
        if a == b {
            return self.zero(a);
        }
        match self.kind(b) {
            Kind::Unary(Unary::Negate, b) => self.add(a, b),
            _ => {
                let ty = self.ty(a);
                let b = self.represented(b, &ty);
                self.binary(Binary::Subtract, a, b, ty)
            }
        }
    }

    /// A number times a number, vector or matrix.
    pub(super) fn scale(&mut self, k: ExprId, a: ExprId) -> ExprId {
        let scalar = self.arena.ty(a).is_scalar();
        match (self.number(k), self.number(a)) {
            (Some(x), Some(y)) if scalar => return self.real(x * y),
            (Some(0.0), _) => return self.zero(a),
            (Some(1.0), _) => return a,
            (Some(-1.0), _) => return self.negate(a),
            (_, Some(y)) if scalar => {
                // numbers stand on the left
                return match y {
                    0.0 => a,
                    1.0 => k,
                    -1.0 => self.negate(k),
                    _ => self.product_of_numbers(a, k),
                };
            }
            _ => {}
        }
        if self.is_zero(a) {
            return a;
        }
        match (self.kind(k), self.kind(a)) {
            (Kind::Unary(Unary::Negate, k), _) => {
                let product = self.scale(k, a);
                self.negate(product)
            }
            (_, Kind::Unary(Unary::Negate, a)) => {
                let product = self.scale(k, a);
                self.negate(product)
            }
            (_, Kind::Vector(items)) if items.iter().any(|i| self.is_zero(*i)) => {
                let items = items.into_iter().map(|i| self.scale(k, i)).collect();
                let ty = self.ty(a);
                self.arena.add(Kind::Vector(items), ty)
            }
            _ if scalar => self.product_of_numbers(k, a),
            _ => {
                let ty = self.ty(a);
                self.binary(Binary::Multiply, k, a, ty)
            }
        }
    }

    /// `2 (3 a)` is `6 a`.
    fn product_of_numbers(&mut self, k: ExprId, a: ExprId) -> ExprId {
        if let (Some(x), Kind::Binary(Binary::Multiply, l, r)) = (self.number(k), self.kind(a))
            && let Some(y) = self.number(l)
        {
            let factor = self.real(x * y);
            return self.scale(factor, r);
        }
        self.binary(Binary::Multiply, k, a, Type::REAL)
    }

    pub(super) fn divide(&mut self, a: ExprId, k: ExprId) -> ExprId {
        if self.is_zero(a) || self.number(k) == Some(1.0) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.number(a), self.number(k))
            && y != 0.0
        {
            return self.real(x / y);
        }
        if let Kind::Unary(Unary::Negate, a) = self.kind(a) {
            let quotient = self.divide(a, k);
            return self.negate(quotient);
        }
        let ty = self.ty(a);
        self.binary(Binary::Divide, a, k, ty)
    }

    /// The sum of the products of the entries.
    pub(super) fn inner(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if self.is_zero(a) || self.is_zero(b) {
            return self.real(0.0);
        }
        match self.ty(a).shape() {
            Some(Shape::Scalar) => self.scale(a, b),
            Some(Shape::Vector(_)) => {
                for (x, y) in [(a, b), (b, a)] {
                    // few entries that are not 0
                    if let Kind::Vector(items) = self.kind(x)
                        && items.iter().any(|i| self.is_zero(*i))
                    {
                        let mut sum = self.real(0.0);
                        for (k, item) in items.into_iter().enumerate() {
                            if !self.is_zero(item) {
                                let entry = self.component(y, k as i64 + 1);
                                let product = self.scale(item, entry);
                                sum = self.add(sum, product);
                            }
                        }
                        return sum;
                    }
                }
                let ty = self.ty(a);
                let b = self.represented(b, &ty);
                self.binary(Binary::Dot, a, b, Type::REAL)
            }
            _ => self.binary(Binary::Frobenius, a, b, Type::REAL),
        }
    }

    /// An entry of a vector, by its number from 1.
    pub(super) fn component(&mut self, a: ExprId, k: i64) -> ExprId {
        match self.kind(a) {
            Kind::Vector(items) => items[k as usize - 1],
            _ if self.is_zero(a) => self.real(0.0),
            _ => {
                let k = self.arena.integer(k);
                self.entry(a, k)
            }
        }
    }

    /// An entry of a vector, by its number from 1.
    pub(super) fn entry(&mut self, a: ExprId, k: ExprId) -> ExprId {
        match (self.kind(a), self.kind(k)) {
            (Kind::Vector(items), Kind::Integer(k)) => items[k as usize - 1],
            _ => self.arena.add(Kind::Component(a, k), Type::REAL),
        }
    }

    /// An entry of a number, vector or matrix, by its numbers from 1.
    pub(super) fn at(&mut self, a: ExprId, row: ExprId, column: ExprId) -> ExprId {
        match self.ty(a).shape() {
            Some(Shape::Scalar) => a,
            Some(Shape::Vector(_)) => self.entry(a, row),
            _ if self.is_zero(a) => self.real(0.0),
            _ => self.arena.add(Kind::At(a, row, column), Type::REAL),
        }
    }

    pub(super) fn hadamard(&mut self, a: ExprId, b: ExprId) -> ExprId {
        match (self.is_zero(a), self.is_zero(b)) {
            (true, _) => a,
            (_, true) => b,
            _ => {
                let ty = self.dense(a);
                self.binary(Binary::Hadamard, a, b, ty)
            }
        }
    }

    /// The transpose of a vector or matrix, as a matrix.
    pub(super) fn transpose(&mut self, a: ExprId) -> ExprId {
        if let Kind::Unary(Unary::Transpose, inner) = self.kind(a) {
            return inner;
        }
        let (rows, columns) = match self.ty(a).shape() {
            Some(Shape::Matrix(n, m)) => (m, n),
            Some(Shape::Vector(n)) => (Dimension::known(1), n),
            _ => return a,
        };
        let sparse = self.arena.ty(a).is_sparse();
        let mut ty = Type::real_matrix(rows, columns);
        if let Type::Matrix { sparse: stored, .. } = &mut ty {
            *stored = sparse;
        }
        self.unary(Unary::Transpose, a, ty)
    }

    /// The product of matrices, vectors among them, as a value of a type.
    pub(super) fn product(&mut self, a: ExprId, b: ExprId, ty: &Type) -> ExprId {
        if self.arena.ty(a).is_scalar() {
            let b = self.represented(b, ty);
            return self.scale(a, b);
        }
        if self.arena.ty(b).is_scalar() {
            let a = self.represented(a, ty);
            return self.scale(b, a);
        }
        let b = match (ty.shape(), self.ty(b).shape()) {
            (Some(Shape::Vector(_)), Some(Shape::Matrix(n, _))) => {
                self.represented(b, &Type::real_vector(n))
            }
            _ => b,
        };
        self.binary(Binary::Product, a, b, ty.clone())
    }

    pub(super) fn compare(&mut self, op: CompareOp, a: ExprId, b: ExprId) -> ExprId {
        self.arena.add(Kind::Compare(op, a, b), Type::Boolean)
    }

    pub(super) fn choose(&mut self, condition: ExprId, a: ExprId, b: ExprId) -> ExprId {
        if a == b || self.is_zero(a) && self.is_zero(b) {
            return a;
        }
        let ty = self.ty(a);
        let b = self.represented(b, &ty);
        self.arena.add(Kind::If(condition, a, b), ty)
    }

    /// `value` where `guard` is not 0, and 0 there.
    pub(super) fn unless_zero(&mut self, guard: ExprId, value: ExprId) -> ExprId {
        let zero = self.real(0.0);
        let differs = self.compare(CompareOp::NotEqual, guard, zero);
        let none = self.zero(value);
        self.choose(differs, value, none)
    }

    /// Integers.
    pub(super) fn count(&mut self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        let known = |s: &Self, e| match s.arena.kind(e) {
            Kind::Integer(k) => Some(*k),
            _ => None,
        };
        match (op, known(self, a), known(self, b)) {
            (Binary::Add, Some(x), Some(y)) => self.arena.integer(x + y),
            (Binary::Subtract, Some(x), Some(y)) => self.arena.integer(x - y),
            (Binary::Multiply, Some(x), Some(y)) => self.arena.integer(x * y),
            (Binary::Add, Some(0), _) | (Binary::Multiply, Some(1), _) => b,
            (Binary::Add | Binary::Subtract, _, Some(0)) | (Binary::Multiply, _, Some(1)) => a,
            _ => self.binary(op, a, b, Type::INTEGER),
        }
    }

    /// A place as an integer from 1: elements have theirs.
    pub(super) fn place(&mut self, index: ExprId) -> ExprId {
        match (self.arena.ty(index).is_element(), self.arena.kind(index)) {
            (true, Kind::Unary(Unary::ToElement, number)) => *number,
            (true, _) => self.unary(Unary::ToInteger, index, Type::INTEGER),
            (false, _) => index,
        }
    }

    /// The element at a place.
    pub(super) fn element(&mut self, place: ExprId, ty: Type) -> ExprId {
        match (self.arena.ty(place).is_element(), self.arena.kind(place)) {
            (true, _) => place,
            (false, Kind::Unary(Unary::ToInteger, element)) => *element,
            (false, _) => self.unary(Unary::ToElement, place, ty),
        }
    }

    /// `(p - 1) n + k`.
    pub(super) fn inside(&mut self, p: ExprId, n: ExprId, k: ExprId) -> ExprId {
        let one = self.arena.integer(1);
        let p = self.place(p);
        let before = self.count(Binary::Subtract, p, one);
        let start = self.count(Binary::Multiply, before, n);
        self.count(Binary::Add, start, k)
    }
}
