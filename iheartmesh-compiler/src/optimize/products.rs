//! A product of a sum of blocks and a vector becomes a sum of products: the matrix is not formed.
//!
//! ```text
//! (∑_f  A_f at rows, columns) v    ⟶  ∑_f  (A_f v[columns]) at rows
//! (∑_f  A_f at rows, columns)ᵀ v   ⟶  ∑_f  (A_fᵀ v[rows]) at columns
//! vᵀ H                             ⟶  (Hᵀ v)ᵀ
//! ```
//!
//! Both sides are equal since products are linear; they round in another order. The loops and conditions stay those of
//! the matrix, and so do the places, so that what fails for one fails for the other.
//!
//! Fires where the matrix is of unknown size and has fixed blocks, also by its name, if all that the program makes of the
//! named matrix are such products: one that is factored or has its entries read is formed anyway. What is added to such
//! sums outside of loops keeps a product of its own. Blocks with replaced eigenvalues stay: parts of theirs may be at one
//! place, which is known only from values.

use std::collections::{BTreeSet, HashMap};

use super::rewrite;
use crate::ir::{Arena, Binary, Block, ExprId, Global, GlobalId, Kind, Program, Unary, unproven};
use crate::span::Span;
use crate::types::{Dimension, Shape, Type};

/// Blocks with more rows or columns than this stay matrices.
const LARGEST_BLOCK: i64 = 64;

/// Rewrites all products that qualify.
pub fn run(program: &mut Program) {
    let mut pass = Pass {
        values: program.globals.iter().map(|global| global.value).collect(),
        formed: formed(program),
        vectors: Vec::new(),
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
    for value in pass.vectors {
        program.globals.push(Global {
            name: "factor".to_owned(),
            value,
            span: Span::default(),
        });
    }
}

/// A product of a matrix and a vector.
#[derive(Clone, Copy)]
struct Sides {
    matrix: ExprId,
    vector: ExprId,
    transposed: bool,
}

/// The sides of a product of a matrix of unknown size and a vector, on either side.
fn sides(arena: &Arena, e: ExprId) -> Option<Sides> {
    let Kind::Binary(Binary::Product, a, b) = *arena.kind(e) else {
        return None;
    };
    let is_vector = |e: ExprId| {
        matches!(arena.ty(e).shape(), Some(Shape::Vector(_))) && !arena.ty(e).is_sparse()
    };
    let is_matrix = |e: ExprId| {
        matches!(arena.ty(e).shape(), Some(Shape::Matrix(..))) && !arena.ty(e).is_fixed()
    };
    let (matrix, vector, transposed) = match *arena.kind(a) {
        Kind::Unary(Unary::Transpose, v) if is_vector(v) => (b, v, true),
        _ => (a, b, false),
    };
    (is_matrix(matrix) && is_vector(vector)).then_some(Sides {
        matrix,
        vector,
        transposed,
    })
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
        on_the_way.extend(sides(arena, e).map(|sides| sides.matrix));
        // the transpose of a vector is no use of a matrix
        arena
            .kind(e)
            .operands(|operand| open.push((operand, on_the_way.contains(&operand))));
    }
    formed
}

struct Pass {
    /// What each definition is.
    values: Vec<ExprId>,
    /// The definitions that are asked for as matrices.
    formed: BTreeSet<GlobalId>,
    /// Vectors that get a definition of their own: they are computed once, not in each term.
    vectors: Vec<ExprId>,
}

impl Pass {
    fn rule(&mut self, arena: &mut Arena, e: ExprId) -> Option<ExprId> {
        let Sides {
            matrix,
            vector,
            transposed,
        } = sides(arena, e)?;
        if !unproven(arena, e).is_empty() || !self.has_blocks(arena, matrix) {
            return None;
        }
        let ty = arena.ty(e).clone();
        let length = match (ty.shape()?, transposed) {
            (Shape::Vector(length), false) | (Shape::Matrix(_, length), true) => length,
            _ => return None,
        };
        let named = self.named(arena, vector)?;
        let mut product = Product {
            pass: self,
            arena,
            vector: named,
            origin: e,
            ty: Type::real_vector(length),
        };
        let mut done = product.of(matrix, transposed, None, false)?;
        // a loop of the matrix is now written twice: each variable keeps one binder
        done = rewrite::substitute(arena, done, &HashMap::new());
        if transposed {
            done = arena.add(Kind::Unary(Unary::Transpose, done), ty);
        }
        if let Some(span) = arena.origin(e) {
            arena.note_origin(done, span);
        }
        Some(done)
    }

    /// A vector by a name. One that depends on variables other than parameters has none.
    fn named(&mut self, arena: &mut Arena, vector: ExprId) -> Option<ExprId> {
        if let Kind::Global(_) | Kind::Input(_) | Kind::Variable(_) = arena.kind(vector) {
            return Some(vector);
        }
        if !arena.node(vector).free.is_empty() {
            return None;
        }
        let place = self.vectors.iter().position(|other| *other == vector);
        let place = place.unwrap_or_else(|| {
            self.vectors.push(vector);
            self.vectors.len() - 1
        });
        let ty = arena.ty(vector).clone();
        let id = GlobalId((self.values.len() + place) as u32);
        Some(arena.add(Kind::Global(id), ty))
    }

    /// Whether some part of a matrix is a sum of blocks.
    fn has_blocks(&self, arena: &Arena, e: ExprId) -> bool {
        match arena.kind(e) {
            Kind::Assemble { blocks, .. } => !blocks.is_empty(),
            Kind::Global(id) => {
                let value = self.values.get(id.0 as usize);
                value.is_some_and(|e| !self.formed.contains(id) && self.has_blocks(arena, *e))
            }
            Kind::Fold { body, .. } => self.has_blocks(arena, *body),
            _ => linear(arena, e).iter().any(|e| self.has_blocks(arena, *e)),
        }
    }
}

/// Makes the product of a vector and the parts of a matrix.
struct Product<'a> {
    pass: &'a Pass,
    arena: &'a mut Arena,
    vector: ExprId,
    /// The product as it is written.
    origin: ExprId,
    ty: Type,
}

impl Product<'_> {
    /// The product of a part of the matrix, times a factor, and the vector.
    fn of(
        &mut self,
        e: ExprId,
        transposed: bool,
        factor: Option<ExprId>,
        in_loop: bool,
    ) -> Option<ExprId> {
        match self.arena.kind(e).clone() {
            Kind::Global(id) if !in_loop && self.pass.has_blocks(self.arena, e) => {
                self.of(self.pass.values[id.0 as usize], transposed, factor, in_loop)
            }
            Kind::Assemble { sizes, blocks } => {
                let mut all: Vec<Block> = Vec::new();
                for block in &blocks {
                    let block = self.block(block, transposed, factor)?;
                    let ty = self.arena.ty(block.value).clone();
                    let same =
                        |b: &&mut Block| b.rows == block.rows && *self.arena.ty(b.value) == ty;
                    match all.iter_mut().find(same) {
                        Some(other) => {
                            let sum = Kind::Binary(Binary::Add, other.value, block.value);
                            other.value = self.arena.add(sum, ty);
                        }
                        None => all.push(block),
                    }
                }
                let kind = Kind::Assemble {
                    sizes: vec![*sizes.get(usize::from(transposed))?],
                    blocks: all,
                };
                Some(self.like(e, kind))
            }
            Kind::Unary(Unary::Transpose, a) => self.of(a, !transposed, factor, in_loop),
            Kind::Unary(Unary::Negate, a) => {
                let factor = self.negated(factor);
                self.of(a, transposed, Some(factor), in_loop)
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let factor = match factor {
                    Some(factor) => self.number(Binary::Multiply, factor, k),
                    None => k,
                };
                self.of(a, transposed, Some(factor), in_loop)
            }
            Kind::Binary(Binary::Divide, a, k) => {
                let factor = factor.unwrap_or_else(|| self.arena.real(1.0));
                let factor = self.number(Binary::Divide, factor, k);
                self.of(a, transposed, Some(factor), in_loop)
            }
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                let a = self.of(a, transposed, factor, in_loop)?;
                let factor = match op {
                    Binary::Add => factor,
                    _ => Some(self.negated(factor)),
                };
                let b = self.of(b, transposed, factor, in_loop)?;
                Some(self.like(e, Kind::Binary(Binary::Add, a, b)))
            }
            Kind::If(condition, a, b) => {
                let a = self.of(a, transposed, factor, in_loop)?;
                let b = self.of(b, transposed, factor, in_loop)?;
                Some(self.like(e, Kind::If(condition, a, b)))
            }
            Kind::Fold {
                op,
                variable,
                range,
                condition,
                body,
            } if self.pass.has_blocks(self.arena, body) => {
                let body = self.of(body, transposed, factor, true)?;
                let kind = Kind::Fold {
                    op,
                    variable,
                    range,
                    condition,
                    body,
                };
                Some(self.like(e, kind))
            }
            _ if in_loop => None,
            _ => self.plain(e, transposed, factor),
        }
    }

    /// The product of a matrix that is no sum of blocks.
    fn plain(&mut self, e: ExprId, transposed: bool, factor: Option<ExprId>) -> Option<ExprId> {
        let mut matrix = e;
        if transposed {
            let mut ty = self.arena.ty(e).clone();
            let Type::Matrix { rows, columns, .. } = &mut ty else {
                return None;
            };
            std::mem::swap(rows, columns);
            matrix = self.arena.add(Kind::Unary(Unary::Transpose, e), ty);
        }
        let kind = Kind::Binary(Binary::Product, matrix, self.vector);
        let product = self.like(self.origin, kind);
        Some(match factor {
            Some(k) => self.like(e, Kind::Binary(Binary::Multiply, k, product)),
            None => product,
        })
    }

    /// The block of the result that a block of the matrix gives.
    fn block(&mut self, block: &Block, transposed: bool, factor: Option<ExprId>) -> Option<Block> {
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
        if let Some(k) = factor {
            value = self.arena.add(Kind::Binary(Binary::Multiply, k, value), ty);
        }
        Some(Block {
            rows: into.clone(),
            columns: Vec::new(),
            value,
            core: None,
        })
    }

    /// The entries of the vector at places, `width` of them divided evenly.
    fn items(&mut self, places: &[ExprId], width: i64) -> Option<Vec<ExprId>> {
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
                let kind = Kind::Component(self.vector, at);
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
    fn number(&mut self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        let ty = self.arena.ty(a).clone();
        self.arena.add(Kind::Binary(op, a, b), ty)
    }

    fn negated(&mut self, factor: Option<ExprId>) -> ExprId {
        match factor {
            Some(k) => self.arena.add(Kind::Unary(Unary::Negate, k), Type::REAL),
            None => self.arena.real(-1.0),
        }
    }

    /// A part of the result, in the place of a part of the matrix.
    fn like(&mut self, e: ExprId, kind: Kind) -> ExprId {
        let done = self.arena.add(kind, self.ty.clone());
        if let Some(span) = self.arena.origin(e) {
            self.arena.note_origin(done, span);
        }
        done
    }
}
