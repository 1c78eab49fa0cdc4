//! Cells of matrices: blocks, and numbers and identities that fill a block of any size.

use super::Checker;
use super::operator::extents;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind};
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, UnaryOp};
use crate::types::{Dimension, Type};

/// A cell of a matrix.
pub(super) enum Cell {
    /// A block with its rows and columns.
    Block(ExprId, Dimension, Dimension),
    /// `0` or `1`: fills a block of any size.
    Filling(f64),
    /// `I`, `-I`, `a I`, `I/a`: a multiple of an identity of any size.
    Identity(Option<ExprId>),
}

/// Whether a cell is `I`, or `I` with a sign, a factor in front or a divisor behind.
fn holds_identity(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Name(name) => name.text == "I",
        ExprKind::Unary {
            op: UnaryOp::Negate,
            operand,
        } => holds_identity(operand),
        ExprKind::Binary {
            op, left, right, ..
        } => match op {
            BinaryOp::Juxtapose | BinaryOp::Dot => holds_identity(right),
            BinaryOp::Divide => holds_identity(left),
            _ => false,
        },
        _ => false,
    }
}

impl<'a> Checker<'a> {
    /// The factor of an `I` without a size in a cell that [`holds_identity`]; `None` where it is multiplied by more
    /// than numbers.
    fn factor_of_identity(&mut self, cell: &'a Expr) -> Option<Option<ExprId>> {
        let (op, number, rest) = match &cell.kind {
            ExprKind::Unary { operand, .. } => {
                let factor = self.factor_of_identity(operand)?;
                let factor = factor.unwrap_or_else(|| self.program.arena.real(1.0));
                return Some(Some(self.negate(factor)));
            }
            ExprKind::Binary {
                op: BinaryOp::Divide,
                left,
                right,
                ..
            } => (Binary::Divide, right, left),
            ExprKind::Binary { left, right, .. } => (Binary::Multiply, left, right),
            _ => return Some(None),
        };
        let number = self.expr(number);
        if self.is_error(number) {
            return Some(None);
        }
        if !self.ty(number).is_scalar() {
            return None;
        }
        let number = self.real(number);
        let kind = match (op, self.factor_of_identity(rest)?) {
            (Binary::Divide, None) => Kind::Binary(op, self.program.arena.real(1.0), number),
            (_, None) => return Some(Some(number)),
            (Binary::Divide, Some(factor)) => Kind::Binary(op, factor, number),
            (_, Some(factor)) => Kind::Binary(op, number, factor),
        };
        Some(Some(self.add_at(cell.span, kind, Type::REAL)))
    }

    pub(super) fn cell(&mut self, cell: &'a Expr, is_block: bool) -> Option<Cell> {
        if let ExprKind::Integer(value @ (0 | 1)) = &cell.kind {
            return Some(Cell::Filling(*value as f64));
        }
        if is_block
            && holds_identity(cell)
            && !self.is_bound("I")
            && let Some(factor) = self.factor_of_identity(cell)
        {
            return Some(Cell::Identity(factor));
        }
        let value = self.expr(cell);
        let value = self.in_numbers(value);
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return None;
        }
        match ty.shape().and_then(extents) {
            Some((rows, columns)) => Some(Cell::Block(self.real(value), rows, columns)),
            None => {
                let given = ty.described();
                let message = format!("{given} cannot be a block of a matrix");
                let diagnostic = Diagnostic::error(cell.span, message)
                    .here(format!("this is {given}"))
                    .help("the blocks of a matrix are numbers, vectors and matrices");
                let diagnostic = self.with_origins(diagnostic, &[cell]);
                self.report(diagnostic);
                None
            }
        }
    }
}
