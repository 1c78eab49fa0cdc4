//! Matrices that are known by their rows, each a sum of pieces: the derivatives of a vector that has an entry for each
//! element.
//!
//! ```text
//! (A_f as rows, A_f = ∑ a at places)  v   ⟶  ∑_f  (∑ a ⋅ v[places]) at f
//! (A_f as rows, A_f = ∑ a at places)ᵀ v   ⟶  ∑_f  ∑ v_f a at places
//! ```
//!
//! The matrix itself is dense: it has many more entries than its pieces.

use std::collections::HashMap;

use super::Product;
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Unary, VariableId};
use crate::optimize::rewrite;
use crate::types::{Shape, Type};

impl Product<'_> {
    /// The product of a vector and a matrix whose row with a number is `row`.
    pub(super) fn by_rows(
        &mut self,
        e: ExprId,
        (number_of_row, size): (VariableId, ExprId),
        row: ExprId,
        transposed: bool,
        times: Option<ExprId>,
    ) -> Option<ExprId> {
        if !matches!(self.arena.ty(self.factor).shape()?, Shape::Vector(_)) || self.row.is_some() {
            return None;
        }
        let Shape::Matrix(rows, _) = self.arena.ty(e).shape()? else {
            return None;
        };
        let size = match rows.is_dynamic() {
            true => size,
            false => self.arena.add(Kind::Size(rows.clone()), Type::INTEGER),
        };
        let (variable, place, range) = rewrite::each(self.arena, &rows, size);
        let number = match self.arena.ty(place).is_element() {
            true => self
                .arena
                .add(Kind::Unary(Unary::ToInteger, place), Type::INTEGER),
            false => place,
        };
        let row = rewrite::put(
            self.arena,
            row,
            &HashMap::from([(number_of_row, number)]),
            &mut HashMap::new(),
        );
        let row = rewrite::at_elements(self.arena, row);
        self.row = Some((place, size));
        let body = self.of(row, transposed, times, true);
        self.row = None;
        let kind = Kind::Fold {
            op: Fold::Sum,
            variable,
            range,
            condition: None,
            body: body?,
        };
        Some(self.like(e, kind))
    }

    /// What pieces of the row at hand give.
    pub(super) fn pieces_of_row(
        &mut self,
        e: ExprId,
        (place, size): (ExprId, ExprId),
        sizes: &[ExprId],
        blocks: &[Block],
        transposed: bool,
        times: Option<ExprId>,
    ) -> Option<ExprId> {
        let [length] = sizes else {
            return None;
        };
        let kind = match transposed {
            true => {
                let mut factor = self.entry(place);
                if let Some(k) = times {
                    factor = self.number(Binary::Multiply, k, factor);
                }
                let scaled = blocks.iter().map(|block| {
                    let ty = self.arena.ty(block.value).clone();
                    let kind = Kind::Binary(Binary::Multiply, factor, block.value);
                    Block {
                        value: self.arena.add(kind, ty),
                        ..block.clone()
                    }
                });
                Kind::Assemble {
                    blocks: scaled.collect(),
                    sizes: vec![*length],
                }
            }
            false => {
                let mut sum: Option<ExprId> = None;
                for block in blocks {
                    let value = self.along(block)?;
                    sum = Some(match sum {
                        Some(sum) => self.number(Binary::Add, sum, value),
                        None => value,
                    });
                }
                let blocks = sum.map(|mut value| {
                    if let Some(k) = times {
                        value = self.number(Binary::Multiply, k, value);
                    }
                    Block {
                        rows: vec![place],
                        columns: Vec::new(),
                        value,
                        core: None,
                    }
                });
                Kind::Assemble {
                    blocks: blocks.into_iter().collect(),
                    sizes: vec![size],
                }
            }
        };
        Some(self.like(e, kind))
    }

    /// The product of a piece of a row and what the factor has at its places.
    fn along(&mut self, block: &Block) -> Option<ExprId> {
        let ty = self.arena.ty(block.value).clone();
        if ty.is_sparse() || ty.is_integer() {
            return None;
        }
        let length = match ty.shape()? {
            Shape::Scalar => 1,
            Shape::Vector(n) => n.value()?,
            Shape::Matrix(n, m) => n.value()?.checked_mul(m.value()?)?,
        };
        if !(1..=super::blocks::LARGEST_BLOCK).contains(&length) {
            return None;
        }
        let items = self.items(&block.rows, length)?;
        let kind = match ty.shape()? {
            Shape::Scalar => Kind::Binary(Binary::Multiply, block.value, items[0]),
            shape => {
                let mut value = block.value;
                // column by column
                if let Shape::Matrix(..) = shape {
                    let kind = Kind::Unary(Unary::Stack, value);
                    value = self.arena.add(kind, Type::vector(length));
                }
                let gathered = Kind::Vector(items);
                let gathered = self.arena.add(gathered, Type::vector(length));
                Kind::Binary(Binary::Dot, value, gathered)
            }
        };
        Some(self.arena.add(kind, Type::REAL))
    }
}
