//! Derivatives: from the expression of a value to that of its derivative, before anything is optimised.
//!
//! What is differentiated is brought to a normal form (`normal`), then reverse mode goes back from it to the variable
//! (`reverse`), each expression once, with one rule for each operation (`rules`, `loops`). Equal expressions are one
//! expression, so that a derivative shares what it can with the value.
//!
//! What comes of it is put together by [`Kind::Assemble`]: a loop over elements adds a block for each item that its terms
//! use. The second derivative of a sum over elements is the sum of those of its terms, a sparse matrix.
//!
//! **Order of entries:** that of `vec`: a vector as it is, a matrix column by column, a sequence item by item.

mod adjoint;
mod algebra;
mod bound;
mod elementary;
mod entries;
mod extent;
mod hessian;
mod jacobian;
mod loops;
mod normal;
mod reductions;
mod reverse;
mod rules;
mod sparse;
mod stencil;

use crate::ir::{Binary, ExprId, Kind, Layout, Program};
use crate::span::Span;
use crate::types::{Dimension, Shape, Type};

use normal::Normal;
use reverse::{Reverse, Target};
use stencil::{Stencil, Wanted};

/// Why something cannot be differentiated.
#[derive(Clone, Debug)]
pub struct Trouble {
    /// Where, if that is known.
    pub span: Option<Span>,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: String,
}

impl Trouble {
    fn new(span: Option<Span>, message: String, help: &str) -> Self {
        Self {
            span,
            message,
            help: help.to_owned(),
        }
    }
}

/// The number of numbers in a value, `None` for what has no derivatives.
pub fn count(ty: &Type) -> Option<Dimension> {
    if !normal::is_differentiable(ty) {
        return None;
    }
    match ty {
        Type::Sequence { item, length, .. } => match **item {
            Type::Sequence { .. } => None,
            _ => count(item)?.multiply(length),
        },
        _ => match ty.shape()? {
            Shape::Scalar => Some(Dimension::known(1)),
            Shape::Vector(n) => Some(n),
            Shape::Matrix(n, m) => n.multiply(&m),
        },
    }
}

/// The first derivative of a number or vector `y` by `x`, an input or a parameter of a function.
///
/// # Errors
/// Says what cannot be differentiated.
pub fn first(program: &mut Program, y: ExprId, x: ExprId) -> Result<ExprId, Trouble> {
    let mut normal = Normal::new(program, &[x]);
    let y = normal.expr(y)?;
    match normal.algebra().ty(y).is_scalar() {
        true if stencil::has_items(&normal.algebra(), x) => {
            let size = size(&mut normal, x);
            let length = count(&normal.algebra().ty(x)).unwrap_or_else(|| Dimension::known(0));
            let mut stencil = Stencil {
                normal: &mut normal,
                x,
                wanted: Wanted::First,
                sizes: vec![size],
                ty: Type::real_vector(length),
                otherwise: |normal: &mut Normal<'_>, term| gradient(normal, term, x),
            };
            stencil.of(y)
        }
        true => gradient(&mut normal, y, x),
        false => jacobian::jacobian(&mut normal, y, x, false),
    }
}

/// The second derivative of a number `y`: rows by `a`, columns by `b`.
///
/// # Errors
/// Says what cannot be differentiated.
pub fn second(program: &mut Program, y: ExprId, a: ExprId, b: ExprId) -> Result<ExprId, Trouble> {
    let mut normal = Normal::new(program, &[a, b]);
    let y = normal.expr(y)?;
    // by the number first: the rest is a gradient
    let (a, b) = match normal.algebra().ty(a).is_scalar() {
        true => (a, b),
        false if normal.algebra().ty(b).is_scalar() => (b, a),
        false => return hessian::second(&mut normal, y, a, b),
    };
    let slope = gradient(&mut normal, y, a)?;
    let slope = normal.expr(slope)?;
    gradient(&mut normal, slope, b)
}

/// A number in the form that it has in its derivatives by `x`, with which it shares what it can then. It stays as it is where
/// it has no such form.
pub fn value(program: &mut Program, y: ExprId, x: ExprId) -> ExprId {
    let mut normal = Normal::new(program, &[x]);
    let Ok(in_form) = normal.expr(y) else {
        return y;
    };
    if !stencil::has_items(&normal.algebra(), x) {
        return y;
    }
    let mut stencil = Stencil {
        normal: &mut normal,
        x,
        wanted: Wanted::Value,
        sizes: Vec::new(),
        ty: Type::REAL,
        otherwise: |_: &mut Normal<'_>, term| Ok(term),
    };
    stencil.of(in_form).unwrap_or(y)
}

/// The number of numbers in an input, as a derivative by it has it among its sizes.
pub fn length(program: &mut Program, x: ExprId) -> ExprId {
    size(&mut Normal::new(program, &[x]), x)
}

/// Why the second derivatives of a number by the items of `a` and `b` are a dense matrix: the place of a term that takes
/// all items, or many, if that is known. `None` where they are not dense because of what is differentiated.
pub fn dense_because(
    program: &mut Program,
    y: ExprId,
    a: ExprId,
    b: ExprId,
) -> Option<Option<Span>> {
    let mut normal = Normal::new(program, &[a, b]);
    let y = normal.expr(y).ok()?;
    let term = hessian::large_term(&mut normal, y, &[a, b])?;
    Some(normal.program.arena.origin(term))
}

/// The derivative of a number in normal form.
fn gradient(normal: &mut Normal<'_>, y: ExprId, x: ExprId) -> Result<ExprId, Trouble> {
    let target = match normal.algebra().ty(x) {
        Type::Scalar(_) => Target::Number,
        ty => {
            let size = size(normal, x);
            let length = count(&ty).unwrap_or_else(|| Dimension::known(0));
            Target::Vector(size, Type::real_vector(length))
        }
    };
    Reverse::of(normal, y, x, target)
}

/// The number of numbers in `x`, as a value.
fn size(normal: &mut Normal<'_>, x: ExprId) -> ExprId {
    let ty = normal.algebra().ty(x);
    let Type::Sequence { item, .. } = &ty else {
        let mut s = normal.algebra();
        let (n, m) = (s.size(x, 0), s.size(x, 1));
        return s.count(Binary::Multiply, n, m);
    };
    let each = count(item).unwrap_or_else(|| Dimension::known(1));
    let arena = &mut normal.program.arena;
    let each = match each.value() {
        Some(n) => arena.integer(n),
        None => arena.add(Kind::Size(each), Type::INTEGER),
    };
    let mut s = normal.algebra();
    let length = s.size(x, 0);
    s.count(Binary::Multiply, length, each)
}

/// A vector or matrix made of one value for each index.
fn tabulated(
    normal: &mut Normal<'_>,
    layout: Layout,
    size: ExprId,
    ty: Type,
    value: impl FnOnce(&mut Normal<'_>, ExprId) -> Result<ExprId, Trouble>,
) -> Result<ExprId, Trouble> {
    let (variable, index) = normal.index("k");
    let body = value(normal, index)?;
    let kind = Kind::Tabulate {
        layout,
        variables: vec![variable],
        sizes: vec![size],
        body,
    };
    Ok(normal.program.arena.add(kind, ty))
}
