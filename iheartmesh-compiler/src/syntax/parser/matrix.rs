//! Matrices: rows of cells, which blanks or commas separate.

use super::super::ast::{Expr, ExprKind};
use super::super::token::Kind;
use super::expression::make;
use super::{Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

const HELP: &str = "cells are separated by blanks or commas, rows by `;` or line breaks";

impl Parser<'_> {
    /// `[a b; c d]`.
    pub(super) fn matrix(&mut self) -> Parsed<Expr> {
        self.within(Context::PLAIN, Self::matrix_inside)
    }

    fn matrix_inside(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let close = self.partner();
        self.advance();
        let mut rows: Vec<Vec<Expr>> = Vec::new();
        while self.kind() != Kind::RightBracket {
            let row = self.row(close)?;
            if let Some(first) = rows.first()
                && first.len() != row.len()
            {
                self.ragged(&row, first.len(), start);
                return self.close_matrix(close, start);
            }
            rows.push(row);
            if !self.eat(Kind::Row) && self.kind() != Kind::RightBracket {
                return self.expected("a cell, `;` or `]`", HELP);
            }
        }
        self.advance();
        if rows.is_empty() {
            return self.without_cells(start);
        }
        Ok(make(ExprKind::Matrix(rows), self.since(start)))
    }

    /// Reports a row that has not as many cells as the first one.
    #[cold]
    #[inline(never)]
    fn ragged(&mut self, row: &[Expr], wanted: usize, start: Span) {
        let span = row.iter().map(|cell| cell.span).reduce(|a, b| a.to(b));
        let found = row.len();
        let cells = if found == 1 { "cell" } else { "cells" };
        let message = format!("this row has {found} {cells}, but the first row has {wanted}");
        let error = Diagnostic::error(span.unwrap_or(start), message);
        self.report(error.help("blanks separate cells: put a sum or product in parentheses, or write it without blanks"));
    }

    #[cold]
    #[inline(never)]
    fn without_cells<T>(&mut self, start: Span) -> Parsed<T> {
        let error = Diagnostic::error(self.since(start), "a matrix has at least one cell");
        self.fail(error.help("write `0_n,m` for a matrix of zeros"))
    }

    /// Goes on behind a matrix with a mistake that says nothing about what follows.
    fn close_matrix(&mut self, close: Option<usize>, start: Span) -> Parsed<Expr> {
        match close {
            Some(close) => self.at = close + 1,
            None => return Err(super::Failed),
        }
        Ok(make(ExprKind::Error, self.since(start)))
    }

    fn row(&mut self, close: Option<usize>) -> Parsed<Vec<Expr>> {
        let bar = self.row_bar(close);
        let mut context = Context {
            cell: true,
            ..Context::PLAIN
        };
        if let Some(bar) = bar {
            self.advance();
            context.row_bar = bar;
        }
        let mut cells = Vec::new();
        self.within(context, |parser| {
            loop {
                cells.push(parser.cell()?);
                let comma = parser.eat(Kind::Comma);
                let ends = matches!(parser.kind(), Kind::Row | Kind::RightBracket | Kind::End);
                if ends || parser.at >= parser.context.row_bar {
                    return match comma {
                        true => parser.expected("a cell", HELP),
                        false => Ok(()),
                    };
                }
                if !comma && !parser.token(0).space {
                    return parser.expected("a cell, `;` or `]`", HELP);
                }
            }
        })?;
        if bar.is_some() {
            self.expect(Kind::Bar, "`|`", "close the row with a bar")?;
        }
        Ok(cells)
    }

    fn cell(&mut self) -> Parsed<Expr> {
        match self.kind() {
            Kind::Comma | Kind::Row => self.expected("a cell", HELP),
            _ => self.expression(),
        }
    }

    /// The bar that closes the row if bars stand around it: exactly two of them, first and last.
    fn row_bar(&mut self, close: Option<usize>) -> Option<usize> {
        let close = close?;
        if self.kind() != Kind::Bar || self.ahead(1) == Kind::Bar && self.tight(1) {
            return None;
        }
        let mut index = self.at + 1;
        while index < close && self.tokens[index].kind != Kind::Row {
            self.steps += 1;
            if self.tokens[index].kind == Kind::Bar {
                let after = index + 1 == close || self.tokens[index + 1].kind == Kind::Row;
                return after.then_some(index);
            }
            let partner = self.partners[index];
            let jump = partner != super::NONE && partner as usize > index;
            index = if jump { partner as usize } else { index } + 1;
        }
        None
    }
}
