//! Second derivatives of numbers.

use super::jacobian::jacobian;
use super::normal::Normal;
use super::stencil::{self, Stencil, Wanted};
use super::{Trouble, count, gradient, size, sparse};
use crate::ir::{Binary, ExprId, Fold, Kind, Range, Unary};
use crate::types::{Dimension, Type};

/// The second derivatives of a number in normal form. Sparse where it is a sum of terms of a few items each.
pub(super) fn second(
    normal: &mut Normal<'_>,
    y: ExprId,
    a: ExprId,
    b: ExprId,
) -> Result<ExprId, Trouble> {
    if !is_sum(normal, y, &[a, b])
        && let Some(found) = in_parts(normal, y, a, b)?
    {
        return Ok(found);
    }
    whole(normal, y, a, b)
}

/// Those of a sum of numbers, where those of each are a sparse matrix.
fn in_parts(
    normal: &mut Normal<'_>,
    y: ExprId,
    a: ExprId,
    b: ExprId,
) -> Result<Option<ExprId>, Trouble> {
    match normal.kind(y) {
        Kind::Binary(op @ (Binary::Add | Binary::Subtract), left, right)
            if normal.is_active(left) && normal.is_active(right) =>
        {
            let (Some(left), Some(right)) = (
                in_parts(normal, left, a, b)?,
                in_parts(normal, right, a, b)?,
            ) else {
                return Ok(None);
            };
            let mut s = normal.algebra();
            Ok(Some(match op {
                Binary::Add => s.add(left, right),
                _ => s.subtract(left, right),
            }))
        }
        Kind::Binary(Binary::Multiply, k, inner) if !normal.is_active(k) => {
            let inner = in_parts(normal, inner, a, b)?;
            Ok(inner.map(|inner| normal.algebra().scale(k, inner)))
        }
        Kind::Binary(Binary::Divide, inner, k) if !normal.is_active(k) => {
            let inner = in_parts(normal, inner, a, b)?;
            Ok(inner.map(|inner| normal.algebra().divide(inner, k)))
        }
        Kind::Unary(Unary::Negate, inner) => {
            let inner = in_parts(normal, inner, a, b)?;
            Ok(inner.map(|inner| normal.algebra().negate(inner)))
        }
        _ if is_sum(normal, y, &[a, b]) => {
            let found = whole(normal, y, a, b)?;
            Ok(normal.algebra().ty(found).is_sparse().then_some(found))
        }
        _ => {
            let slope = gradient(normal, y, a)?;
            let slope = normal.expr(slope)?;
            let found = sparse::of(normal, slope, b)?;
            let sizes = [a, b].map(|x| count(&normal.algebra().ty(x)));
            Ok(match (found, sizes) {
                (Some(found), [Some(n), Some(m)]) => {
                    let ty = sparse::sparse_matrix(n, m);
                    Some(sparse::of_type(normal, found, &ty))
                }
                _ => None,
            })
        }
    }
}

/// Those of a number at once.
fn whole(normal: &mut Normal<'_>, y: ExprId, a: ExprId, b: ExprId) -> Result<ExprId, Trouble> {
    let sparse = is_sum(normal, y, &[a, b]);
    let by_rows = |normal: &mut Normal<'_>, term| {
        let slope = gradient(normal, term, a)?;
        let slope = normal.expr(slope)?;
        jacobian(normal, slope, b, sparse)
    };
    if a == b && sparse && stencil::has_items(&normal.algebra(), a) {
        let size = size(normal, a);
        let width = count(&normal.algebra().ty(a)).unwrap_or_else(|| Dimension::known(0));
        let is_fixed = width.value().is_some();
        let mut ty = Type::real_matrix(width.clone(), width);
        if let Type::Matrix { sparse: stored, .. } = &mut ty {
            *stored = !is_fixed;
        }
        let mut stencil = Stencil {
            normal,
            x: a,
            wanted: Wanted::Second,
            sizes: vec![size; 2],
            ty,
            otherwise: by_rows,
        };
        return stencil.of(y);
    }
    by_rows(normal, y)
}

/// Whether a number is a sum of terms each of which takes a few items of the variables.
fn is_sum(normal: &mut Normal<'_>, e: ExprId, variables: &[ExprId]) -> bool {
    large_term(normal, e, variables).is_none()
}

/// The first term of a sum that takes more than a few items of the variables.
pub(super) fn large_term(
    normal: &mut Normal<'_>,
    e: ExprId,
    variables: &[ExprId],
) -> Option<ExprId> {
    if !normal.is_active(e) {
        return None;
    }
    match normal.kind(e) {
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) | Kind::If(_, a, b) => {
            large_term(normal, a, variables).or_else(|| large_term(normal, b, variables))
        }
        Kind::Binary(Binary::Multiply, k, a) if !normal.is_active(k) => {
            large_term(normal, a, variables)
        }
        Kind::Binary(Binary::Multiply | Binary::Divide, a, k) if !normal.is_active(k) => {
            large_term(normal, a, variables)
        }
        Kind::Unary(Unary::Negate, a) => large_term(normal, a, variables),
        Kind::Fold {
            op: Fold::Sum,
            body,
            ..
        } => large_term(normal, body, variables),
        _ => (!is_local(normal, e, variables)).then_some(e),
    }
}

/// Whether a term takes items of the variables only: not all of one, and none in a loop that runs over everything.
pub(super) fn is_local(normal: &mut Normal<'_>, e: ExprId, variables: &[ExprId]) -> bool {
    if !normal.is_active(e) {
        return true;
    }
    if variables.contains(&e) {
        return false;
    }
    let known = (e, variables.to_vec());
    if let Some(known) = normal.local.get(&known) {
        return *known;
    }
    let found = is_made_of_items(normal, e, variables);
    normal.local.insert(known, found);
    found
}

fn is_made_of_items(normal: &mut Normal<'_>, e: ExprId, variables: &[ExprId]) -> bool {
    let kind = normal.kind(e);
    match &kind {
        Kind::Item(x, _) | Kind::Component(x, _) | Kind::At(x, ..) if variables.contains(x) => true,
        Kind::ColumnOf(x, _) | Kind::RowOf(x, _) if variables.contains(x) => true,
        Kind::Scatter { .. } => false,
        Kind::Fold { range, body, .. } => {
            let arena = &normal.program.arena;
            let few = match range {
                Range::Set(set) => !arena.node(*set).free.is_empty(),
                Range::Integers(from, to) => {
                    let known = |e: &ExprId| {
                        matches!(arena.kind(*e), Kind::Integer(_))
                            || !arena.node(*e).free.is_empty()
                    };
                    known(from) && known(to)
                }
                Range::Rows { .. } => false,
            };
            few && is_local(normal, *body, variables)
        }
        Kind::Tabulate { sizes, body, .. } => {
            let few = sizes
                .iter()
                .all(|s| matches!(normal.program.arena.kind(*s), Kind::Integer(_)));
            few && is_local(normal, *body, variables)
        }
        _ => {
            let mut all = true;
            kind.operands(|operand| all = all && is_local(normal, operand, variables));
            all
        }
    }
}
