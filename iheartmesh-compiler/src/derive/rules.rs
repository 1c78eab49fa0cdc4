//! What each operation hands back to its operands. `a̅` is the adjoint of `a`.

use super::Trouble;
use super::algebra::SMALL;
use super::normal::is_vector;
use super::reverse::Reverse;
use crate::ir::{Binary, Block, Elementary, ExprId, Fold, Kind, Layout, Range, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::{Shape, Type};

impl Reverse<'_, '_> {
    /// Hands the adjoint `d` of an expression to its operands.
    pub(super) fn rule(&mut self, e: ExprId, region: usize, d: ExprId) -> Result<(), Trouble> {
        // what comes from outside may hold the same loop
        let kind = self.algebra().kind(e);
        let kind = self.normal.rebound(kind);
        if let Kind::Fold {
            range: Range::Set(set),
            ..
        } = kind
            && self.is_active(set)
        {
            return Err(self.trouble(e, "the members of a set of numbers have no derivatives"));
        }
        match kind {
            Kind::Unary(op, a) => self.unary(e, op, a, region, d)?,
            Kind::Binary(op, a, b) => self.binary(e, op, (a, b), region, d)?,
            Kind::Vector(items) => {
                for (k, item) in items.into_iter().enumerate() {
                    let entry = self.algebra().component(d, k as i64 + 1);
                    self.give(item, region, entry);
                }
            }
            Kind::Component(vector, k) => {
                let number = match self.algebra().kind(k) {
                    Kind::Integer(k) => Some(k),
                    _ => None,
                };
                let fixed = self.algebra().fixed(vector).filter(|(n, _)| *n <= SMALL);
                let ty = self.algebra().dense(vector);
                let adjoint = match (number, fixed) {
                    (Some(number), Some((n, _))) => {
                        let zero = self.algebra().real(0.0);
                        let entry = |i| if i == number { d } else { zero };
                        let items = (1..=n).map(entry).collect();
                        self.algebra().arena.add(Kind::Vector(items), ty)
                    }
                    _ => {
                        let sizes = vec![self.algebra().size(vector, 0)];
                        self.placed(sizes, (vec![k], Vec::new(), d), ty)
                    }
                };
                self.give(vector, region, adjoint);
            }
            Kind::At(a, i, j) => self.give_matrix(a, region, (vec![i], vec![j], d)),
            Kind::RowOf(a, i) => {
                let one = self.algebra().arena.integer(1);
                let row = self.algebra().transpose(d);
                self.give_matrix(a, region, (vec![i], vec![one], row));
            }
            Kind::ColumnOf(a, j) => {
                let one = self.algebra().arena.integer(1);
                self.give_matrix(a, region, (vec![one], vec![j], d));
            }
            Kind::Blocks(rows) => self.blocks(rows, region, d),
            Kind::Filled(value, sizes) => {
                let one = self.algebra().real(1.0);
                let ty = self.algebra().dense(e);
                let ones = self.algebra().arena.add(Kind::Filled(one, sizes), ty);
                let sum = self.algebra().inner(d, ones);
                self.give(value, region, sum);
            }
            Kind::Tabulate {
                layout,
                variables,
                sizes,
                body,
            } => {
                let mut inner = region;
                let first = variables[0];
                let one = self.algebra().arena.integer(1);
                let mut places = Vec::new();
                for (variable, size) in variables.into_iter().zip(sizes) {
                    let range = match self.algebra().arena.variable_type(variable).clone() {
                        ty @ Type::Element(element) => {
                            let all = Kind::AllElements(element);
                            Range::Set(self.algebra().arena.add(all, Type::set_of(ty)))
                        }
                        _ => Range::Integers(one, size),
                    };
                    inner = self.inside_of_loop(inner, variable, range, None);
                    let index = self.algebra().arena.variable(variable);
                    places.push(self.algebra().place(index));
                }
                let ty = self.algebra().dense(body);
                let i = places[0];
                let adjoint = match layout {
                    Layout::Vector => self.algebra().entry_of_adjoint(d, &[i]),
                    Layout::Matrix | Layout::Sparse => {
                        self.algebra().entry_of_adjoint(d, &[i, places[1]])
                    }
                    Layout::Diagonal => self.algebra().entry_of_adjoint(d, &[i, i]),
                    Layout::Rows => self.algebra().arena.add(Kind::RowOf(d, i), ty),
                    Layout::Columns => self.algebra().arena.add(Kind::ColumnOf(d, i), ty),
                    Layout::Sequence => {
                        let index = self.algebra().arena.variable(first);
                        self.algebra().arena.add(Kind::Item(d, index), ty)
                    }
                };
                self.give(body, inner, adjoint);
            }
            Kind::Scatter {
                variable,
                set,
                place: [i, j],
                body,
                ..
            } => {
                let inside = self.inside_of_loop(region, variable, Range::Set(set), None);
                let adjoint = self.algebra().entry_of_adjoint(d, &[i, j]);
                self.give(body, inside, adjoint);
            }
            Kind::Sequence(items) => {
                for (k, item) in items.into_iter().enumerate() {
                    let ty = self.algebra().dense(item);
                    let k = self.algebra().arena.integer(k as i64 + 1);
                    let adjoint = self.algebra().arena.add(Kind::Item(d, k), ty);
                    self.give(item, region, adjoint);
                }
            }
            Kind::Assemble { blocks, .. } => {
                for block in blocks {
                    let adjoint = self.piece(d, &block);
                    self.give(block.value, region, adjoint);
                }
            }
            Kind::If(condition, a, b) => {
                let (then, otherwise) = self.branches(region, condition);
                self.give(a, then, d);
                self.give(b, otherwise, d);
            }
            Kind::Agree(_, _, value) => self.give(value, region, d),
            Kind::Fail => {}
            Kind::Fold {
                op: Fold::Sum,
                variable,
                range,
                condition,
                body,
            } => {
                let inside = self.inside_of_loop(region, variable, range, condition);
                self.give(body, inside, d);
            }
            Kind::Fold {
                op: Fold::Product, ..
            } => self.product_over(&kind, region, d),
            Kind::Fold {
                op: Fold::Min | Fold::Max,
                ..
            } => self.extreme_over(e, &kind, region, d),
            Kind::Fold { .. } => return Err(self.trouble(e, "a set has no derivative")),
            Kind::Integral { .. } | Kind::Optimum { .. } => {
                return Err(self.trouble(e, "integrals and optima have no derivatives here"));
            }
            Kind::HostCall(..) => {
                return Err(self.trouble(e, "a function of Rust has no derivative here"));
            }
            _ => return Err(self.trouble(e, "the derivative of this is not known")),
        }
        Ok(())
    }

    fn trouble(&self, e: ExprId, what: &str) -> Trouble {
        Trouble::new(
            self.normal.program.arena.origin(e),
            what.to_owned(),
            "what is differentiated may hold sums, cases, norms, products, inverses and elementary functions",
        )
    }

    fn placed(
        &mut self,
        sizes: Vec<ExprId>,
        (rows, columns, value): (Vec<ExprId>, Vec<ExprId>, ExprId),
        ty: Type,
    ) -> ExprId {
        let blocks = vec![Block {
            rows,
            columns,
            value,
            core: None,
        }];
        self.algebra()
            .arena
            .add(Kind::Assemble { sizes, blocks }, ty)
    }

    fn give_matrix(&mut self, a: ExprId, region: usize, block: (Vec<ExprId>, Vec<ExprId>, ExprId)) {
        let sizes = vec![self.algebra().size(a, 0), self.algebra().size(a, 1)];
        let ty = self.algebra().dense(a);
        let adjoint = self.placed(sizes, block, ty);
        self.give(a, region, adjoint);
    }

    fn unary(
        &mut self,
        e: ExprId,
        op: Unary,
        a: ExprId,
        region: usize,
        d: ExprId,
    ) -> Result<(), Trouble> {
        let ty = self.algebra().dense(a);
        let mut algebra = self.algebra();
        let adjoint = match op {
            Unary::Negate => algebra.negate(d),
            Unary::Absolute => {
                let zero = algebra.real(0.0);
                let (greater, less) = (
                    algebra.compare(CompareOp::Greater, a, zero),
                    algebra.compare(CompareOp::Less, a, zero),
                );
                let negative = algebra.negate(d);
                let below = algebra.choose(less, negative, zero);
                algebra.choose(greater, d, below)
            }
            Unary::SquareRoot => {
                let half = algebra.real(0.5);
                let half = algebra.scale(half, d);
                let slope = algebra.divide(half, e);
                algebra.unless_zero(e, slope)
            }
            Unary::Norm => {
                let slope = algebra.divide(d, e);
                let slope = algebra.unless_zero(e, slope);
                algebra.scale(slope, a)
            }
            Unary::NormZero | Unary::Rank => return Ok(()),
            Unary::NormNuclear => {
                let Some((n, m)) = (match ty.shape() {
                    Some(Shape::Matrix(n, m)) if n == m => Some((n, m)),
                    _ => None,
                }) else {
                    let what = "the derivative of `‖A‖_*` is known for square matrices only";
                    return Err(self.trouble(e, what));
                };
                let square = Type::real_matrix(n.clone(), m);
                let items = vec![square.clone(), Type::real_vector(n), square.clone()];
                let parts = algebra.unary(Unary::SingularValues, a, Type::Tuple(items));
                let left = algebra.arena.add(Kind::Project(parts, 0), square.clone());
                let right = algebra.arena.add(Kind::Project(parts, 2), square.clone());
                let right = algebra.transpose(right);
                let polar = algebra.product(left, right, &square);
                algebra.scale(d, polar)
            }
            Unary::Transpose => algebra.transpose(d),
            Unary::Inverse => {
                let back = algebra.transpose(e);
                let left = algebra.product(back, d, &ty);
                let product = algebra.product(left, back, &ty);
                algebra.negate(product)
            }
            Unary::PseudoInverse => {
                self.pseudo_inverse(e, a, region, d);
                return Ok(());
            }
            Unary::Determinant => {
                let inverse = algebra.unary(Unary::Inverse, a, ty.clone());
                if let Some(span) = algebra.arena.origin(e) {
                    algebra.arena.note_origin(inverse, span);
                }
                let cofactors = algebra.transpose(inverse);
                let factor = algebra.scale(d, e);
                algebra.scale(factor, cofactors)
            }
            Unary::Trace => {
                let n = algebra.size(a, 0);
                let one = algebra.arena.add(Kind::Identity(n), ty);
                algebra.scale(d, one)
            }
            Unary::Diagonal => algebra.unary(Unary::Diagonal, d, ty),
            Unary::Stack => {
                let ty = match ty {
                    Type::Sequence {
                        item,
                        length,
                        index,
                    } => Type::Sequence {
                        item: Box::new(item.with_reals()),
                        length,
                        index,
                    },
                    ty => ty,
                };
                algebra.binary(Binary::Unstack, a, d, ty)
            }
            Unary::Reshape => algebra.represented(d, &ty),
            Unary::Apply(function) => {
                let slope = self.slope(function, a, e);
                self.algebra().scale(d, slope)
            }
            Unary::PositivePart | Unary::AbsolutePart => {
                return Err(self.trouble(e, "`psd` has no derivative"));
            }
            _ => return Err(self.trouble(e, "the derivative of this is not known")),
        };
        self.give(a, region, adjoint);
        Ok(())
    }

    fn binary(
        &mut self,
        e: ExprId,
        op: Binary,
        (a, b): (ExprId, ExprId),
        region: usize,
        d: ExprId,
    ) -> Result<(), Trouble> {
        let (ta, tb) = (self.algebra().dense(a), self.algebra().dense(b));
        let active = (self.is_active(a), self.is_active(b));
        let mut s = self.algebra();
        let (left, right) = match op {
            Binary::Add => (d, d),
            Binary::Subtract => (d, s.negate(d)),
            Binary::Multiply => (s.inner(d, b), s.scale(a, d)),
            Binary::Divide => {
                let value = s.inner(d, e);
                let slope = s.divide(value, b);
                (s.divide(d, b), s.negate(slope))
            }
            Binary::Power => self.power(e, (a, b), active, d),
            Binary::Dot | Binary::Frobenius => (s.scale(d, b), s.scale(d, a)),
            Binary::Cross => (
                s.binary(Binary::Cross, b, d, ta.clone()),
                s.binary(Binary::Cross, d, a, tb.clone()),
            ),
            Binary::Atan2 => {
                let (y, x) = (s.scale(a, a), s.scale(b, b));
                let square = s.add(x, y);
                let slope = s.divide(d, square);
                let slope = s.unless_zero(square, slope);
                let right = s.scale(slope, a);
                (s.scale(slope, b), s.negate(right))
            }
            Binary::Min | Binary::Max => {
                let first = match op {
                    Binary::Min => s.compare(CompareOp::LessOrEqual, a, b),
                    _ => s.compare(CompareOp::GreaterOrEqual, a, b),
                };
                let (then, otherwise) = self.branches(region, first);
                self.give(a, then, d);
                self.give(b, otherwise, d);
                return Ok(());
            }
            Binary::Product => {
                let (across, back) = (s.transpose(b), s.transpose(a));
                let left = match active.0 {
                    true => s.product(d, across, &ta),
                    false => d,
                };
                (left, s.product(back, d, &tb))
            }
            Binary::Hadamard => (s.hadamard(d, b), s.hadamard(d, a)),
            Binary::Solve => {
                let back = s.transpose(a);
                let right = s.binary(Binary::Solve, back, d, tb);
                if let Some(span) = s.arena.origin(e) {
                    s.arena.note_origin(right, span);
                }
                let across = s.transpose(e);
                let left = match active.0 {
                    true => s.product(right, across, &ta),
                    false => right,
                };
                (s.negate(left), right)
            }
            Binary::Unstack => {
                let stacked = match is_vector(&self.algebra().ty(e)) {
                    true => d,
                    false => self.algebra().unary(Unary::Stack, d, tb),
                };
                self.give(b, region, stacked);
                return Ok(());
            }
            Binary::Kronecker => {
                self.kronecker(a, b, region, d);
                return Ok(());
            }
            Binary::MatrixPower => {
                let what = "powers of matrices are differentiated for integers in the text only";
                return Err(self.trouble(e, what));
            }
            _ => return Err(self.trouble(e, "the derivative of this is not known")),
        };
        if active.0 {
            self.give(a, region, left);
        }
        if active.1 {
            self.give(b, region, right);
        }
        Ok(())
    }

    /// `a^b`: `b a^(b - 1)` and `a^b ln(a)`; 0 where `a` is 0 and the derivative is infinite or not defined.
    fn power(
        &mut self,
        e: ExprId,
        (a, b): (ExprId, ExprId),
        active: (bool, bool),
        d: ExprId,
    ) -> (ExprId, ExprId) {
        let mut s = self.algebra();
        let zero = s.real(0.0);
        let exponent = s.number(b);
        let left = match (exponent, active.0) {
            (_, false) => zero,
            (Some(p), _) => {
                let less = s.real(p - 1.0);
                let power = match p {
                    0.0 => zero,
                    1.0 => s.real(1.0),
                    2.0 => a,
                    _ => s.binary(Binary::Power, a, less, Type::REAL),
                };
                let slope = s.scale(b, power);
                match p < 1.0 && p != 0.0 {
                    true => s.unless_zero(a, slope),
                    false => slope,
                }
            }
            (None, _) => {
                let one = s.real(1.0);
                let less = s.subtract(b, one);
                let power = s.binary(Binary::Power, a, less, Type::REAL);
                let slope = s.scale(b, power);
                let slope_there = s.compare(CompareOp::Greater, b, one);
                let is_one = s.compare(CompareOp::Equal, b, one);
                let apart = s.unless_zero(a, slope);
                let below = s.choose(is_one, one, apart);
                s.choose(slope_there, slope, below)
            }
        };
        let right = match active.1 {
            true => {
                let logarithm = s.unary(Unary::Apply(Elementary::Ln), a, Type::REAL);
                let slope = s.scale(e, logarithm);
                s.unless_zero(a, slope)
            }
            false => zero,
        };
        (s.scale(d, left), s.scale(d, right))
    }
}
