//! Vectors and matrices by their entries and blocks.

use super::Checker;
use super::cell::Cell;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind};
use crate::span::Span;
use crate::syntax::ast::{Expr, ExprKind};
use crate::types::{Dimension, Type};

impl<'a> Checker<'a> {
    /// `(a, b, c)`.
    pub(super) fn vector(&mut self, items: &'a [Expr]) -> ExprId {
        let mut blocks = Vec::new();
        let mut length = Dimension::known(0);
        let mut only_numbers = true;
        for item in items {
            let value = self.expr(item);
            let ty = self.ty(value).clone();
            if ty.is_error() {
                return value;
            }
            let rows = match &ty {
                Type::Scalar(_) => Dimension::known(1),
                Type::Vector {
                    length,
                    space: None,
                    ..
                } => {
                    only_numbers = false;
                    length.clone()
                }
                _ => {
                    let given = ty.described();
                    return self.report(
                        Diagnostic::error(item.span, format!("{given} cannot be an entry of a vector"))
                            .here(format!("this is {given}"))
                            .help("the entries of `(a, b, c)` are numbers and vectors; write `tuple(a, b)` for a tuple"),
                    );
                }
            };
            length = length.add(&rows).unwrap_or_else(|| self.new_dimension());
            blocks.push(value);
        }
        let blocks: Vec<ExprId> = blocks.into_iter().map(|b| self.real(b)).collect();
        let ty = Type::real_vector(length);
        match only_numbers {
            true => self.add(Kind::Vector(blocks), ty),
            false => self.add(
                Kind::Blocks(blocks.into_iter().map(|b| vec![b]).collect()),
                ty,
            ),
        }
    }

    /// `0_n,m`, `1_n`.
    pub(super) fn number_matrix(
        &mut self,
        span: Span,
        ones: bool,
        rows: &'a Expr,
        columns: Option<&'a Expr>,
    ) -> ExprId {
        let value = self.program.arena.real(if ones { 1.0 } else { 0.0 });
        let Some((rows, n)) = self.written_size(rows) else {
            return self.error();
        };
        let Some(columns) = columns else {
            return self.add_at(span, Kind::Filled(value, vec![n]), Type::real_vector(rows));
        };
        let Some((columns, m)) = self.written_size(columns) else {
            return self.error();
        };
        self.add_at(
            span,
            Kind::Filled(value, vec![n, m]),
            Type::real_matrix(rows, columns),
        )
    }

    /// `I_n`.
    pub(super) fn identity(&mut self, span: Span, size: &'a Expr) -> ExprId {
        let Some((dimension, n)) = self.written_size(size) else {
            return self.error();
        };
        self.add_at(
            span,
            Kind::Identity(n),
            Type::real_matrix(dimension.clone(), dimension),
        )
    }

    /// A size written in an expression: a number or a symbol.
    pub(super) fn written_size(&mut self, e: &'a Expr) -> Option<(Dimension, ExprId)> {
        if matches!(e.kind, ExprKind::Binary { .. })
            && let Some(dimension) = self.symbolic(e)
            && let Some(value) = self.size(&dimension)
        {
            return Some((dimension, value));
        }
        let value = self.expr(e);
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return None;
        }
        if ty != Type::INTEGER {
            let diagnostic = Diagnostic::error(
                e.span,
                format!("a size cannot be {}", ty.described()),
            )
            .here(format!("this is {}", ty.described()))
            .help("sizes are integers, such as `3`, `n` with `n ∈ ℤ`, or the `n` of `v ∈ ℝ^n`");
            let diagnostic = self.with_origins(diagnostic, &[e]);
            self.report(diagnostic);
            return None;
        }
        let dimension = match (self.program.arena.kind(value), &e.kind) {
            (Kind::Integer(n), _) => Dimension::known(*n),
            (Kind::Size(size), _) => size.clone(),
            // a symbol of this module's sizes, or of those that the arguments of a function bring along
            (kind, ExprKind::Name(name))
                if matches!(kind, Kind::Input(_))
                    || self.templates.get(&name.text) == Some(&value) =>
            {
                Dimension::atom(crate::types::Atom::Symbol(name.text.clone()))
            }
            _ => self.new_dimension(),
        };
        Some((dimension, value))
    }

    /// `[a b; c d]`.
    pub(super) fn matrix(&mut self, e: &'a Expr, rows: &'a [Vec<Expr>]) -> ExprId {
        let mut cells: Vec<Vec<Cell>> = Vec::new();
        let is_block = rows.iter().flatten().count() > 1;
        for row in rows {
            let mut list = Vec::new();
            for cell in row {
                match self.cell(cell, is_block) {
                    Some(cell) => list.push(cell),
                    None => return self.error(),
                }
            }
            cells.push(list);
        }
        // a stack of blocks that all fill a whole row need not have the same number of columns
        let widest = cells.iter().map(Vec::len).max().unwrap_or(0);
        let Some((heights, widths)) = self.block_sizes(e, rows, &cells, widest) else {
            return self.error();
        };
        self.fill_blocks(e, rows, cells, &heights, &widths)
    }

    pub(super) fn is_bound(&self, name: &str) -> bool {
        self.scopes.iter().any(|s| s.names.contains_key(name))
            || self.resolved.module(self.module).symbols.contains_key(name)
    }

    /// Heights of the rows of blocks, and widths of the columns where these are the same in all rows.
    fn block_sizes(
        &mut self,
        e: &'a Expr,
        rows: &'a [Vec<Expr>],
        cells: &[Vec<Cell>],
        widest: usize,
    ) -> Option<(Vec<Dimension>, Vec<Vec<Dimension>>)> {
        let mut heights = Vec::new();
        for (list, row) in cells.iter().zip(rows) {
            let mut height: Option<(Dimension, usize)> = None;
            for (k, cell) in list.iter().enumerate() {
                if let Cell::Block(_, rows, _) = cell {
                    match &height {
                        None => height = Some((rows.clone(), k)),
                        Some((known, first)) if known.differs(rows) => {
                            let message = format!("blocks of one row have {known} and {rows} rows");
                            let diagnostic = Diagnostic::error(row[k].span, message)
                                .here(format!("this has {}", count_of(rows, "row")))
                                .label(
                                    row[*first].span,
                                    format!("this has {}", count_of(known, "row")),
                                )
                                .help(
                                    "all blocks in a row of a matrix have the same number of rows",
                                );
                            let diagnostic =
                                self.with_origins(diagnostic, &[&row[k], &row[*first]]);
                            self.report(diagnostic);
                            return None;
                        }
                        Some(_) => {}
                    }
                }
            }
            heights.push(height.map(|(h, _)| h));
        }
        let mut widths: Vec<Option<Dimension>> = vec![None; widest];
        let regular = cells.iter().all(|list| list.len() == widest);
        for list in cells.iter().filter(|_| regular) {
            for (k, cell) in list.iter().enumerate() {
                if let Cell::Block(_, _, columns) = cell
                    && widths[k].is_none()
                {
                    widths[k] = Some(columns.clone());
                }
            }
        }
        // an identity is square: its column gives its row a height, and the other way round
        for (r, list) in cells.iter().enumerate() {
            for (k, cell) in list.iter().enumerate() {
                if matches!(cell, Cell::Identity(_)) && regular {
                    match (&heights[r], &widths[k]) {
                        (None, Some(width)) => heights[r] = Some(width.clone()),
                        (Some(height), None) => widths[k] = Some(height.clone()),
                        _ => {}
                    }
                }
            }
        }
        let one = Dimension::known(1);
        let heights: Vec<Dimension> = heights
            .into_iter()
            .map(|h| h.unwrap_or_else(|| one.clone()))
            .collect();
        let total: Option<Dimension> = match regular {
            true => None,
            false => cells.iter().find_map(|list| {
                list.iter()
                    .try_fold(Dimension::known(0), |sum, cell| match cell {
                        Cell::Block(_, _, columns) => sum.add(columns),
                        _ => None,
                    })
            }),
        };
        let all = cells
            .iter()
            .enumerate()
            .map(|(r, list)| {
                let known = |k: usize, cell: &Cell| match cell {
                    Cell::Block(_, _, columns) => Some(columns.clone()),
                    Cell::Identity(_) => Some(
                        widths
                            .get(k)
                            .cloned()
                            .flatten()
                            .unwrap_or_else(|| heights[r].clone()),
                    ),
                    Cell::Filling(_) => widths.get(k).cloned().flatten().filter(|_| regular),
                };
                // in a matrix with rows of different numbers of blocks, one filling takes what is left
                let rest = total.as_ref().and_then(|total| {
                    let sum = list
                        .iter()
                        .enumerate()
                        .filter_map(|(k, cell)| known(k, cell))
                        .try_fold(Dimension::known(0), |sum, d| sum.add(&d))?;
                    total.add(&sum.negate()?)
                });
                let unknown = list
                    .iter()
                    .enumerate()
                    .filter(|(k, c)| known(*k, c).is_none())
                    .count();
                list.iter()
                    .enumerate()
                    .map(|(k, cell)| {
                        known(k, cell).unwrap_or_else(|| match (&rest, unknown) {
                            (Some(rest), 1) => rest.clone(),
                            _ => one.clone(),
                        })
                    })
                    .collect::<Vec<_>>()
            })
            .collect::<Vec<_>>();
        self.check_widths(e, rows, &all)?;
        Some((heights, all))
    }

    fn check_widths(
        &mut self,
        e: &Expr,
        rows: &'a [Vec<Expr>],
        all: &[Vec<Dimension>],
    ) -> Option<()> {
        let sum = |list: &[Dimension]| {
            list.iter()
                .try_fold(Dimension::known(0), |sum, d| sum.add(d))
        };
        let first = sum(all.first()?)?;
        for (list, row) in all.iter().zip(rows).skip(1) {
            let width = sum(list)?;
            if width.differs(&first) {
                let place = match (row.first(), row.last()) {
                    (Some(first), Some(last)) => first.span.to(last.span),
                    _ => e.span,
                };
                let message = format!("rows of a matrix have {first} and {width} columns");
                let above = rows
                    .first()
                    .and_then(|row| Some(row.first()?.span.to(row.last()?.span)));
                self.report(
                    Diagnostic::error(place, message)
                        .here(format!("this row has {}", count_of(&width, "column")))
                        .label(
                            above.unwrap_or(e.span),
                            format!("this row has {}", count_of(&first, "column")),
                        )
                        .help("all rows of a matrix have the same number of columns"),
                );
                return None;
            }
        }
        Some(())
    }

    fn fill_blocks(
        &mut self,
        e: &'a Expr,
        rows: &'a [Vec<Expr>],
        cells: Vec<Vec<Cell>>,
        heights: &[Dimension],
        widths: &[Vec<Dimension>],
    ) -> ExprId {
        let any_sparse = cells
            .iter()
            .flatten()
            .any(|cell| matches!(cell, Cell::Block(value, ..) if self.ty(*value).is_sparse()));
        // what fills a sparse matrix with zeros must not store them
        let filling = |rows, columns, zero: bool| match any_sparse && zero {
            true => Type::sparse_matrix(rows, columns),
            false => Type::real_matrix(rows, columns),
        };
        let mut blocks = Vec::new();
        for (r, list) in cells.iter().enumerate() {
            let mut row = Vec::new();
            for (k, cell) in list.iter().enumerate() {
                let (height, width) = (heights[r].clone(), widths[r][k].clone());
                let one = Dimension::known(1);
                row.push(match cell {
                    Cell::Block(value, own, _) if *own == height => *value,
                    Cell::Block(value, ..) => match self.block_size(&cells, &height) {
                        Some(size) => self.sized(rows[r][k].span, *value, 0, (&height, size)),
                        None => *value,
                    },
                    Cell::Filling(value) if height == one && width == one => {
                        self.program.arena.real(*value)
                    }
                    Cell::Filling(value) => {
                        let zero = *value == 0.0;
                        let value = self.program.arena.real(*value);
                        let sizes = (
                            self.block_size(&cells, &height),
                            self.block_size(&cells, &width),
                        );
                        match sizes {
                            (Some(n), Some(m)) => self.add(
                                Kind::Filled(value, vec![n, m]),
                                filling(height, width, zero),
                            ),
                            _ => {
                                return self.unsupported(
                                    rows[r][k].span,
                                    "blocks of a size known only at run time are",
                                );
                            }
                        }
                    }
                    Cell::Identity(factor) => {
                        if height.differs(&width) {
                            let message =
                                format!("an identity cannot fill a block of {height}×{width}");
                            return self.report(
                                Diagnostic::error(rows[r][k].span, message)
                                    .help("an identity matrix is square"),
                            );
                        }
                        match self.block_size(&cells, &height) {
                            Some(n) => {
                                let ty = filling(height, width, true);
                                let identity = self.add(Kind::Identity(n), ty.clone());
                                match *factor {
                                    None => identity,
                                    Some(factor) => {
                                        let product =
                                            Kind::Binary(Binary::Multiply, factor, identity);
                                        self.add(product, ty)
                                    }
                                }
                            }
                            None => {
                                return self.unsupported(
                                    rows[r][k].span,
                                    "blocks of a size known only at run time are",
                                );
                            }
                        }
                    }
                });
            }
            blocks.push(row);
        }
        self.agreeing_rows(rows, widths, &mut blocks);
        let mut rows = Dimension::known(0);
        for height in heights {
            rows = rows.add(height).unwrap_or_else(|| self.new_dimension());
        }
        let mut columns = Dimension::known(0);
        for width in widths.first().into_iter().flatten() {
            columns = columns.add(width).unwrap_or_else(|| self.new_dimension());
        }
        let ty = filling(rows, columns, true);
        let matrix = self.add(Kind::Blocks(blocks), ty);
        self.program.arena.note_origin(matrix, e.span);
        matrix
    }
}

impl Checker<'_> {
    /// A size of a row or column of blocks as a value: known, or that of a block which has it.
    fn block_size(&mut self, cells: &[Vec<Cell>], wanted: &Dimension) -> Option<ExprId> {
        if let Some(size) = self.size(wanted) {
            return Some(size);
        }
        let found = cells.iter().flatten().find_map(|cell| match cell {
            Cell::Block(value, rows, _) if rows == wanted => Some((*value, 0)),
            Cell::Block(value, _, columns) if columns == wanted => Some((*value, 1)),
            _ => None,
        });
        found.map(|(value, axis)| self.extent(value, axis))
    }
}

/// How many rows or columns: `1 row`, `n columns`.
fn count_of(size: &Dimension, what: &str) -> String {
    match size.value() {
        Some(1) => format!("1 {what}"),
        _ => format!("{size} {what}s"),
    }
}
