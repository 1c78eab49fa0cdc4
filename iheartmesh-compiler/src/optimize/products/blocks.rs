//! The product of a vector or a dense matrix and the parts of a matrix that is put together from blocks.

use super::{Finder, is_local};
use crate::ir::{Arena, Binary, Block, ExprId, Fold, Kind, Layout, Range, Unary};
use crate::types::{Dimension, Shape, Type};

/// Blocks with more rows or columns than this stay matrices.
pub(super) const LARGEST_BLOCK: i64 = 64;

/// Up to so many columns, those of a product are written one by one.
const FEW_COLUMNS: i64 = 8;

/// The columns of a factor.
#[derive(Clone, Copy)]
pub(super) enum Columns {
    /// It is a vector.
    None,
    /// A matrix with a few columns.
    Few(i64),
    /// A matrix with this number of columns.
    Many(ExprId),
}

impl Columns {
    /// Those of a matrix with this number of them.
    pub(super) fn of(arena: &mut Arena, matrix: ExprId, number: &Dimension) -> Self {
        match number.value() {
            Some(n) if n <= FEW_COLUMNS => Self::Few(n),
            Some(n) => Self::Many(arena.integer(n)),
            None => {
                let is_parameter = matches!(arena.kind(matrix), Kind::Variable(_));
                let kind = match is_parameter || number.is_dynamic() {
                    true => Kind::Extent(matrix, 1),
                    false => Kind::Size(number.clone()),
                };
                Self::Many(arena.add(kind, Type::INTEGER))
            }
        }
    }
}

/// Makes the product of a factor and the parts of a matrix.
pub(super) struct Product<'a> {
    pub(super) finder: &'a Finder,
    pub(super) arena: &'a mut Arena,
    /// The vector or dense matrix, by a name.
    pub(super) factor: ExprId,
    pub(super) columns: Columns,
    /// The number of the column at hand.
    pub(super) column: Option<ExprId>,
    /// Where the row of a matrix is at hand: its place, and how many there are.
    pub(super) row: Option<(ExprId, ExprId)>,
    /// The product as it is written.
    pub(super) origin: ExprId,
    /// The type of the product, the factor on the right.
    pub(super) ty: Type,
}

impl Product<'_> {
    /// The product of a part of the matrix, times a number, and the times.
    pub(super) fn of(
        &mut self,
        e: ExprId,
        transposed: bool,
        times: Option<ExprId>,
        in_loop: bool,
    ) -> Option<ExprId> {
        match self.arena.kind(e).clone() {
            Kind::Global(id) if !in_loop && self.finder.has_blocks(self.arena, e) => self.of(
                self.finder.values[id.0 as usize],
                transposed,
                times,
                in_loop,
            ),
            Kind::Assemble { sizes, blocks } => {
                if let Some(row) = self.row {
                    return self.pieces_of_row(e, row, &sizes, &blocks, transposed, times);
                }
                let sizes = self.sizes(*sizes.get(usize::from(transposed))?);
                let mut all: Vec<Block> = Vec::new();
                let columns = match self.columns {
                    Columns::None => vec![None],
                    Columns::Few(n) => (1..=n).map(|k| Some(self.arena.integer(k))).collect(),
                    _ if blocks.is_empty() => Vec::new(),
                    Columns::Many(last) => {
                        return self.each_column(e, last, sizes, &blocks, transposed, times);
                    }
                };
                for column in columns {
                    self.column = column;
                    self.blocks(&blocks, transposed, times, &mut all)?;
                }
                Some(self.like(e, Kind::Assemble { sizes, blocks: all }))
            }
            Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a)
                if self.arena.ty(e).is_sparse() && is_local(self.arena, a) =>
            {
                // symmetric; beside it the size of the result
                let size = self.first_size(a)?;
                let kind = Kind::Assemble {
                    sizes: self.sizes(size),
                    blocks: Vec::new(),
                };
                let zeros = self.like(e, kind);
                let kind = Kind::Binary(Binary::Product, e, self.factor);
                let mut product = self.like(e, kind);
                if let Some(k) = times {
                    product = self.like(e, Kind::Binary(Binary::Multiply, k, product));
                }
                Some(self.like(e, Kind::Binary(Binary::Add, zeros, product)))
            }
            Kind::Unary(Unary::Transpose, a) => self.of(a, !transposed, times, in_loop),
            Kind::Unary(Unary::Negate, a) => {
                let times = self.negated(times);
                self.of(a, transposed, Some(times), in_loop)
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let times = match times {
                    Some(times) => self.number(Binary::Multiply, times, k),
                    None => k,
                };
                self.of(a, transposed, Some(times), in_loop)
            }
            Kind::Binary(Binary::Divide, a, k) => {
                let times = times.unwrap_or_else(|| self.arena.real(1.0));
                let times = self.number(Binary::Divide, times, k);
                self.of(a, transposed, Some(times), in_loop)
            }
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                let a = self.of(a, transposed, times, in_loop)?;
                let times = match op {
                    Binary::Add => times,
                    _ => Some(self.negated(times)),
                };
                let b = self.of(b, transposed, times, in_loop)?;
                Some(self.like(e, Kind::Binary(Binary::Add, a, b)))
            }
            Kind::If(condition, a, b) => {
                let a = self.of(a, transposed, times, in_loop)?;
                let b = self.of(b, transposed, times, in_loop)?;
                Some(self.like(e, Kind::If(condition, a, b)))
            }
            Kind::Fold {
                op,
                variable,
                range,
                condition,
                body,
            } if self.finder.has_blocks(self.arena, body) => {
                let body = self.of(body, transposed, times, true)?;
                let kind = Kind::Fold {
                    op,
                    variable,
                    range,
                    condition,
                    body,
                };
                Some(self.like(e, kind))
            }
            Kind::Tabulate {
                layout: Layout::Rows,
                variables,
                sizes,
                body,
            } if !in_loop && self.finder.has_blocks(self.arena, body) => {
                let row = (*variables.first()?, *sizes.first()?);
                self.by_rows(e, row, body, transposed, times)
            }
            _ if in_loop => None,
            _ => self.plain(e, transposed, times),
        }
    }

    /// The product of a matrix that is no sum of blocks.
    fn plain(&mut self, e: ExprId, transposed: bool, times: Option<ExprId>) -> Option<ExprId> {
        let mut matrix = e;
        if transposed {
            let mut ty = self.arena.ty(e).clone();
            let Type::Matrix { rows, columns, .. } = &mut ty else {
                return None;
            };
            std::mem::swap(rows, columns);
            matrix = self.arena.add(Kind::Unary(Unary::Transpose, e), ty);
        }
        let kind = Kind::Binary(Binary::Product, matrix, self.factor);
        let product = self.like(self.origin, kind);
        Some(match times {
            Some(k) => self.like(e, Kind::Binary(Binary::Multiply, k, product)),
            None => product,
        })
    }

    /// The sizes of the product; this is its number of rows.
    fn sizes(&mut self, rows: ExprId) -> Vec<ExprId> {
        match self.columns {
            Columns::None => vec![rows],
            Columns::Few(n) => vec![rows, self.arena.integer(n)],
            Columns::Many(n) => vec![rows, n],
        }
    }

    /// The number of rows of a matrix that is made of blocks.
    fn first_size(&self, e: ExprId) -> Option<ExprId> {
        match self.arena.kind(e) {
            Kind::Assemble { sizes, .. } => sizes.first().copied(),
            Kind::Binary(_, a, b) | Kind::If(_, a, b) => {
                self.first_size(*a).or_else(|| self.first_size(*b))
            }
            Kind::Fold { body, .. } => self.first_size(*body),
            _ => None,
        }
    }

    /// A loop over the columns of the factor.
    fn each_column(
        &mut self,
        e: ExprId,
        last: ExprId,
        sizes: Vec<ExprId>,
        blocks: &[Block],
        transposed: bool,
        times: Option<ExprId>,
    ) -> Option<ExprId> {
        let variable = self.arena.new_variable("column", Type::INTEGER);
        self.column = Some(self.arena.variable(variable));
        let mut all = Vec::new();
        self.blocks(blocks, transposed, times, &mut all)?;
        let body = self.like(e, Kind::Assemble { sizes, blocks: all });
        let first = self.arena.integer(1);
        let kind = Kind::Fold {
            op: Fold::Sum,
            variable,
            range: Range::Integers(first, last),
            condition: None,
            body,
        };
        Some(self.like(e, kind))
    }

    /// The blocks of the result that those of the matrix give, those at one place added.
    fn blocks(
        &mut self,
        blocks: &[Block],
        transposed: bool,
        times: Option<ExprId>,
        all: &mut Vec<Block>,
    ) -> Option<()> {
        for block in blocks {
            let block = self.block(block, transposed, times)?;
            let ty = self.arena.ty(block.value).clone();
            let same = |b: &&mut Block| {
                b.rows == block.rows && b.columns == block.columns && *self.arena.ty(b.value) == ty
            };
            match all.iter_mut().find(same) {
                Some(other) => {
                    let sum = Kind::Binary(Binary::Add, other.value, block.value);
                    other.value = self.arena.add(sum, ty);
                }
                None => all.push(block),
            }
        }
        Some(())
    }

    /// The block of the result that a block of the matrix gives.
    fn block(&mut self, block: &Block, transposed: bool, times: Option<ExprId>) -> Option<Block> {
        let own = self.arena.ty(block.value).clone();
        let known = |n: Dimension| n.value().filter(|n| (1..=LARGEST_BLOCK).contains(n));
        let (rows, columns) = match own.shape()? {
            _ if own.is_sparse() || own.is_integer() => return None,
            Shape::Scalar => (1, 1),
            Shape::Vector(n) => (known(n)?, 1),
            Shape::Matrix(n, m) => (known(n)?, known(m)?),
        };
        let (height, width, into, from) = match transposed {
            false => (rows, columns, &block.rows, &block.columns),
            true => (columns, rows, &block.columns, &block.rows),
        };
        let items = self.items(from, width)?;
        let gathered = self
            .arena
            .add(Kind::Vector(items.clone()), Type::vector(width));
        let ty = match height {
            1 => Type::REAL,
            _ => Type::vector(height),
        };
        let kind = match own.shape()? {
            Shape::Scalar => Kind::Binary(Binary::Multiply, block.value, items[0]),
            Shape::Vector(_) if transposed => Kind::Binary(Binary::Dot, block.value, gathered),
            Shape::Vector(_) => Kind::Binary(Binary::Multiply, items[0], block.value),
            Shape::Matrix(n, m) => {
                let matrix = match transposed {
                    false => block.value,
                    true => {
                        let ty = Type::real_matrix(m, n);
                        self.arena
                            .add(Kind::Unary(Unary::Transpose, block.value), ty)
                    }
                };
                Kind::Binary(Binary::Product, matrix, gathered)
            }
        };
        // a vector with one entry keeps its type
        let ty = match own.shape()? {
            Shape::Vector(_) if !transposed => own,
            _ => ty,
        };
        let mut value = self.arena.add(kind, ty.clone());
        if let Some(k) = times {
            value = self.arena.add(Kind::Binary(Binary::Multiply, k, value), ty);
        }
        Some(Block {
            rows: into.clone(),
            columns: self.column.into_iter().collect(),
            value,
            core: None,
        })
    }

    /// The entry of the factor, a vector, at a place.
    pub(super) fn entry(&mut self, place: ExprId) -> ExprId {
        let at = match self.arena.ty(place).is_element() {
            true => self
                .arena
                .add(Kind::Unary(Unary::ToInteger, place), Type::INTEGER),
            false => place,
        };
        let item = self.arena.add(Kind::Component(self.factor, at), Type::REAL);
        if let Some(span) = self.arena.origin(self.origin) {
            self.arena.note_origin(item, span);
        }
        item
    }

    /// The entries of the factor at places, `width` of them divided evenly, in the column at hand.
    pub(super) fn items(&mut self, places: &[ExprId], width: i64) -> Option<Vec<ExprId>> {
        let count = i64::try_from(places.len()).ok().filter(|n| *n > 0)?;
        if width % count != 0 {
            return None;
        }
        let height = width / count;
        let mut items = Vec::new();
        for place in places {
            let place = match self.arena.ty(*place).is_element() {
                true => self
                    .arena
                    .add(Kind::Unary(Unary::ToInteger, *place), Type::INTEGER),
                false => *place,
            };
            let one = self.arena.integer(1);
            let start = match height {
                1 => place,
                _ => {
                    let before = self.number(Binary::Subtract, place, one);
                    let height = self.arena.integer(height);
                    self.number(Binary::Multiply, before, height)
                }
            };
            for k in 1..=height {
                let at = match height {
                    1 => start,
                    _ => {
                        let k = self.arena.integer(k);
                        self.number(Binary::Add, start, k)
                    }
                };
                let kind = match self.column {
                    None => Kind::Component(self.factor, at),
                    Some(column) => Kind::At(self.factor, at, column),
                };
                let item = self.arena.add(kind, Type::REAL);
                if let Some(span) = self.arena.origin(self.origin) {
                    self.arena.note_origin(item, span);
                }
                items.push(item);
            }
        }
        Some(items)
    }

    /// An operation of numbers of one type.
    pub(super) fn number(&mut self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        let ty = self.arena.ty(a).clone();
        self.arena.add(Kind::Binary(op, a, b), ty)
    }

    fn negated(&mut self, times: Option<ExprId>) -> ExprId {
        match times {
            Some(k) => self.arena.add(Kind::Unary(Unary::Negate, k), Type::REAL),
            None => self.arena.real(-1.0),
        }
    }

    /// A part of the result, in the place of a part of the matrix.
    pub(super) fn like(&mut self, e: ExprId, kind: Kind) -> ExprId {
        let done = self.arena.add(kind, self.ty.clone());
        if let Some(span) = self.arena.origin(e) {
            self.arena.note_origin(done, span);
        }
        done
    }
}
