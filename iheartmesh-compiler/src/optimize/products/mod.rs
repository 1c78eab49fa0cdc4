//! A product of a sum of blocks and a vector, or a dense matrix, becomes a sum of products: the sum is not formed.
//!
//! ```text
//! (∑_f  A_f at rows, columns) v    ⟶  ∑_f  (A_f v[columns]) at rows
//! (∑_f  A_f at rows, columns)ᵀ v   ⟶  ∑_f  (A_fᵀ v[rows]) at columns
//! (∑_f  psd(A_f)) v                ⟶  ∑_f  psd(A_f) v
//! vᵀ H                             ⟶  (Hᵀ v)ᵀ
//! H [v₁ … v_k]                     ⟶  ∑_f  the products of a block with all columns
//! ```
//!
//! Matrices that are known by their rows, as derivatives of vectors are, likewise: see [`rows`]; and `JᵀJ`: see [`gram`].
//!
//! Both sides are equal since products are linear; they round in another order. The loops and conditions stay those of
//! the matrix, and so do the places, so that what fails for one fails for the other.
//!
//! Fires where the matrix is of unknown size and has fixed blocks, also by its name, if all that the program makes of the
//! named matrix are such products: one that is factored or has its entries read is formed anyway. What is added to such
//! sums outside of loops keeps a product of its own. Of blocks with replaced eigenvalues parts may be at one place, which is
//! known only from values: their products are written as products of sparse matrices, and emitted as additions like blocks,
//! of the small matrix that replacing the eigenvalues gives.

use std::collections::{BTreeSet, HashMap};

mod blocks;
mod gram;
mod rows;

use super::rewrite;
use crate::ir::{
    Arena, Binary, ExprId, Fold, Global, GlobalId, Kind, Layout, Program, Unary, unproven,
};
use crate::span::Span;
use crate::types::{Shape, Type};

use blocks::{Columns, Product};

/// Rewrites all products that qualify.
pub fn run(program: &mut Program) {
    let mut pass = Pass {
        finder: Finder {
            values: program.globals.iter().map(|global| global.value).collect(),
            formed: formed(program),
            made: BTreeSet::new(),
        },
        factors: Vec::new(),
    };
    let mut rule = |arena: &mut Arena, e| pass.rule(arena, e).unwrap_or(e);
    // with a memory of its own each: a loop of a product in two of them is written twice
    for global in &mut program.globals {
        let arena = &mut program.arena;
        global.value = rewrite::upward(arena, global.value, &mut HashMap::new(), &mut rule);
    }
    for function in &mut program.functions {
        let arena = &mut program.arena;
        function.body = rewrite::upward(arena, function.body, &mut HashMap::new(), &mut rule);
    }
    for value in pass.factors {
        program.globals.push(Global {
            name: "factor".to_owned(),
            value,
            span: Span::default(),
        });
    }
}

/// A product of a matrix that is put together from blocks, and what it is multiplied with: a vector or a dense matrix.
#[derive(Clone, Copy)]
struct Sides {
    matrix: ExprId,
    factor: ExprId,
    /// Whether the factor stands on the left.
    is_left: bool,
}

/// Finds sums of blocks.
struct Finder {
    /// What each definition is.
    values: Vec<ExprId>,
    /// The definitions that are asked for as matrices.
    formed: BTreeSet<GlobalId>,
    /// Products with several columns that were made: matrices that are formed.
    made: BTreeSet<ExprId>,
}

impl Finder {
    /// The sides of a product with a sum of blocks.
    fn sides(&self, arena: &Arena, e: ExprId) -> Option<Sides> {
        let Kind::Binary(Binary::Product, a, b) = *arena.kind(e) else {
            return None;
        };
        let is_dense = |e: ExprId| match arena.ty(e).shape() {
            Some(Shape::Vector(_) | Shape::Matrix(..)) => {
                !arena.ty(e).is_sparse() && !arena.ty(e).is_integer()
            }
            _ => false,
        };
        let is_matrix = |e: ExprId| {
            matches!(arena.ty(e).shape(), Some(Shape::Matrix(..))) && !arena.ty(e).is_fixed()
        };
        let sides = [(a, b, false), (b, a, true)].map(|(matrix, factor, is_left)| Sides {
            matrix,
            factor,
            is_left,
        });
        // several columns of a dense matrix at a time are what products of dense matrices do as well
        let is_column = |e: ExprId| match arena.kind(e) {
            Kind::Unary(Unary::Transpose, a) => {
                matches!(arena.ty(*a).shape(), Some(Shape::Vector(_)))
            }
            _ => matches!(arena.ty(e).shape(), Some(Shape::Vector(_))),
        };
        sides.into_iter().find(|sides| {
            is_matrix(sides.matrix)
                && is_dense(sides.factor)
                && (arena.ty(sides.matrix).is_sparse() || is_column(sides.factor))
                && self.has_blocks(arena, sides.matrix)
        })
    }

    /// What an expression is, by its name or not.
    fn value(&self, arena: &Arena, e: ExprId) -> ExprId {
        match arena.kind(e) {
            Kind::Global(id) => match self.values.get(id.0 as usize) {
                Some(value) => self.value(arena, *value),
                None => e,
            },
            _ => e,
        }
    }

    /// Whether some part of a matrix is a sum of blocks.
    fn has_blocks(&self, arena: &Arena, e: ExprId) -> bool {
        match arena.kind(e) {
            _ if self.made.contains(&e) => false,
            Kind::Assemble { blocks, .. } => !blocks.is_empty(),
            Kind::Global(id) => {
                let value = self.values.get(id.0 as usize);
                value.is_some_and(|e| !self.formed.contains(id) && self.has_blocks(arena, *e))
            }
            Kind::Fold { body, .. }
            | Kind::Tabulate {
                layout: Layout::Rows,
                body,
                ..
            } => self.has_blocks(arena, *body),
            Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a) => {
                arena.ty(e).is_sparse() && is_local(arena, *a) && self.has_blocks(arena, *a)
            }
            _ => linear(arena, e).iter().any(|e| self.has_blocks(arena, *e)),
        }
    }
}

/// Whether a matrix is made of blocks and nothing else, none of them by its name.
fn is_local(arena: &Arena, e: ExprId) -> bool {
    match arena.kind(e) {
        Kind::Assemble { .. } => true,
        Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => {
            is_local(arena, *a) && is_local(arena, *b)
        }
        Kind::Binary(Binary::Multiply, _, a) => is_local(arena, *a),
        Kind::Fold {
            op: Fold::Sum,
            body,
            ..
        } => is_local(arena, *body),
        _ => false,
    }
}

/// The operands of an expression that its value as a matrix is linear in.
fn linear(arena: &Arena, e: ExprId) -> Vec<ExprId> {
    match *arena.kind(e) {
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) | Kind::If(_, a, b) => vec![a, b],
        Kind::Binary(Binary::Multiply, _, a)
        | Kind::Binary(Binary::Divide, a, _)
        | Kind::Unary(Unary::Negate | Unary::Transpose, a) => vec![a],
        _ => Vec::new(),
    }
}

/// The definitions that something other than products with vectors and definitions linear in them is made of.
fn formed(program: &Program) -> BTreeSet<GlobalId> {
    let arena = &program.arena;
    let finder = Finder {
        values: program.globals.iter().map(|global| global.value).collect(),
        formed: BTreeSet::new(),
        made: BTreeSet::new(),
    };
    let mut formed = BTreeSet::new();
    let mut seen = BTreeSet::new();
    let definitions = program.globals.iter().map(|global| (global.value, true));
    let bodies = program.functions.iter().map(|f| (f.body, false));
    let mut open: Vec<(ExprId, bool)> = definitions.chain(bodies).collect();
    while let Some((e, is_linear)) = open.pop() {
        if !seen.insert((e, is_linear)) {
            continue;
        }
        if let (Kind::Global(id), false) = (arena.kind(e), is_linear) {
            formed.insert(*id);
        }
        let mut on_the_way = match is_linear {
            true => linear(arena, e),
            false => Vec::new(),
        };
        on_the_way.extend(finder.sides(arena, e).map(|sides| sides.matrix));
        if let Some(gram) = gram::find(&finder, arena, e) {
            on_the_way.extend([gram.left, gram.right]);
        }
        arena
            .kind(e)
            .operands(|operand| open.push((operand, on_the_way.contains(&operand))));
    }
    formed
}

struct Pass {
    finder: Finder,
    /// Factors that get a definition of their own: they are computed once, not in each term.
    factors: Vec<ExprId>,
}

impl Pass {
    fn rule(&mut self, arena: &mut Arena, e: ExprId) -> Option<ExprId> {
        if !unproven(arena, e).is_empty() {
            return None;
        }
        if let Some(gram) = gram::find(&self.finder, arena, e) {
            return gram::sum_of_blocks(arena, e, gram);
        }
        let Sides {
            matrix,
            factor,
            is_left,
        } = self.finder.sides(arena, e)?;
        let ty = arena.ty(e).clone();
        let length = match (ty.shape()?, is_left) {
            (Shape::Vector(length) | Shape::Matrix(length, _), false)
            | (Shape::Matrix(_, length), true) => length,
            _ => return None,
        };
        let right = match (is_left, arena.kind(factor)) {
            (false, _) => factor,
            (true, Kind::Unary(Unary::Transpose, a)) => *a,
            (true, _) => {
                let Shape::Matrix(rows, columns) = arena.ty(factor).shape()? else {
                    return None;
                };
                let ty = Type::real_matrix(columns, rows);
                arena.add(Kind::Unary(Unary::Transpose, factor), ty)
            }
        };
        let shape = arena.ty(right).shape()?;
        let named = self.named(arena, right)?;
        let (ty_of_product, columns) = match shape {
            Shape::Vector(_) => (Type::real_vector(length), Columns::None),
            Shape::Matrix(_, k) => {
                let columns = Columns::of(arena, named, &k);
                (Type::real_matrix(length, k), columns)
            }
            Shape::Scalar => return None,
        };
        let mut product = Product {
            finder: &self.finder,
            arena,
            factor: named,
            columns,
            column: None,
            row: None,
            origin: e,
            ty: ty_of_product,
        };
        let mut done = product.of(matrix, is_left, None, false)?;
        // a loop of the matrix is now written twice: each variable keeps one binder
        done = rewrite::substitute(arena, done, &HashMap::new());
        self.finder.made.insert(done);
        if is_left {
            done = arena.add(Kind::Unary(Unary::Transpose, done), ty);
        }
        if let Some(span) = arena.origin(e) {
            arena.note_origin(done, span);
        }
        Some(done)
    }

    /// A factor by a name. One that depends on variables other than parameters has none.
    fn named(&mut self, arena: &mut Arena, factor: ExprId) -> Option<ExprId> {
        if let Kind::Global(_) | Kind::Input(_) | Kind::Variable(_) = arena.kind(factor) {
            return Some(factor);
        }
        if !arena.node(factor).free.is_empty() {
            return None;
        }
        let place = self.factors.iter().position(|other| *other == factor);
        let place = place.unwrap_or_else(|| {
            self.factors.push(factor);
            self.factors.len() - 1
        });
        let ty = arena.ty(factor).clone();
        let id = GlobalId((self.finder.values.len() + place) as u32);
        Some(arena.add(Kind::Global(id), ty))
    }
}
