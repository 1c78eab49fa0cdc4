//! Cells of matrices: blocks, and numbers and identities that fill a block of any size.

use super::Checker;
use super::operator::extents;
use crate::diagnostic::Diagnostic;
use crate::ir::ExprId;
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, UnaryOp};
use crate::types::Dimension;

/// A cell of a matrix.
pub(super) enum Cell {
    /// A block with its rows and columns.
    Block(ExprId, Dimension, Dimension),
    /// `0` or `1`: fills a block of any size.
    Filling(f64),
    /// `I`, `-I`, `a I`: a multiple of an identity of any size.
    Identity(Option<ExprId>),
}

impl<'a> Checker<'a> {
    /// The factor in front of an `I` without a size; `None` for what is no such product.
    fn factor_of_identity(&mut self, cell: &'a Expr) -> Option<Option<ExprId>> {
        let is_identity = |e: &Expr| matches!(&e.kind, ExprKind::Name(name) if name.text == "I");
        match &cell.kind {
            _ if is_identity(cell) => Some(None),
            ExprKind::Unary {
                op: UnaryOp::Negate,
                operand,
            } => {
                let factor = self.factor_of_identity(operand)?;
                let factor = factor.unwrap_or_else(|| self.program.arena.real(1.0));
                Some(Some(self.negate(factor)))
            }
            ExprKind::Binary {
                op: BinaryOp::Juxtapose | BinaryOp::Dot,
                left,
                right,
                ..
            } if is_identity(right) => {
                let factor = self.expr(left);
                if self.is_error(factor) {
                    return Some(None);
                }
                let is_number = self.ty(factor).is_scalar();
                is_number.then(|| Some(self.real(factor)))
            }
            _ => None,
        }
    }

    pub(super) fn cell(&mut self, cell: &'a Expr, is_block: bool) -> Option<Cell> {
        if let ExprKind::Integer(value @ (0 | 1)) = &cell.kind {
            return Some(Cell::Filling(*value as f64));
        }
        if is_block
            && !self.is_bound("I")
            && let Some(factor) = self.factor_of_identity(cell)
        {
            return Some(Cell::Identity(factor));
        }
        let value = self.expr(cell);
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
