//! Checks that a program keeps the rules of the intermediate language; run after every pass in tests and in
//! builds with debug assertions.

use super::{Binary, ExprId, Fold, Kind, Neighbor, Program, Range, Restriction};
use crate::types::{ElementKind, Shape, Type};

/// The first broken rule, if there is one.
///
/// # Errors
/// Names the expression and the rule. This is always a bug of the compiler.
pub fn validate(program: &Program) -> Result<(), String> {
    for global in &program.globals {
        let free = &program.arena.node(global.value).free;
        if !free.is_empty() {
            return Err(format!("`{}` has free variables", global.name));
        }
        tree(program, global.value)?;
    }
    for function in &program.functions {
        let free = &program.arena.node(function.body).free;
        let bound = |v| function.parameters.iter().any(|p| p.variable == v);
        if let Some(v) = free.iter().find(|v| !bound(**v)) {
            return Err(format!(
                "`{}` has the free variable `{}`",
                function.name,
                program.arena.variable_name(*v)
            ));
        }
        tree(program, function.body)?;
    }
    Ok(())
}

fn tree(program: &Program, e: ExprId) -> Result<(), String> {
    let mut seen = std::collections::BTreeSet::new();
    let mut open = vec![e];
    while let Some(e) = open.pop() {
        if !seen.insert(e) {
            continue;
        }
        node(program, e).map_err(|rule| format!("{rule}: {}", super::expression(program, e)))?;
        program.arena.kind(e).operands(|operand| open.push(operand));
    }
    Ok(())
}

fn node(program: &Program, e: ExprId) -> Result<(), String> {
    let arena = &program.arena;
    let ty = |e: ExprId| arena.ty(e);
    let check = |holds: bool, rule: &str| if holds { Ok(()) } else { Err(rule.to_owned()) };
    let mut order = Ok(());
    arena.kind(e).operands(|operand| {
        if operand >= e {
            order = Err("an operand comes after its use".to_owned());
        }
    });
    order?;
    match arena.kind(e) {
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) => check(
            are_alike(ty(*a), ty(*b)) && are_alike(ty(*a), ty(e)),
            "a sum of different types",
        ),
        Kind::Binary(Binary::Multiply, a, b) => check(
            ty(*a).is_scalar() && ty(*b) == ty(e),
            "a product without a number on the left",
        ),
        Kind::Binary(Binary::Divide, a, b) => check(
            *ty(*b) == Type::REAL && ty(*a) == ty(e),
            "a quotient by something other than a real number",
        ),
        Kind::If(condition, a, b) => check(
            *ty(*condition) == Type::Boolean && [a, b].iter().all(|x| is_case(ty(**x), ty(e))),
            "a choice between different types",
        ),
        Kind::Neighbor(neighbor, a, b) => {
            let kinds = match neighbor {
                Neighbor::EdgeBetween(_) => [ElementKind::Vertex, ElementKind::Vertex],
                Neighbor::VertexInFace(..) => [ElementKind::Face, ElementKind::Vertex],
                Neighbor::FaceWith(..) | Neighbor::FaceWithout(..) => {
                    [ElementKind::Edge, ElementKind::Vertex]
                }
            };
            check(
                [a, b]
                    .into_iter()
                    .zip(kinds)
                    .all(|(x, kind)| matches!(ty(*x), Type::Element(of) if of.kind == kind)),
                "a neighbour of other elements",
            )
        }
        Kind::SetOp(_, a, b) => check(ty(*a) == ty(*b), "an operation on different sets"),
        Kind::Call(id, arguments) => check(
            program.function(*id).parameters.len() == arguments.len(),
            "a call with a wrong number of arguments",
        ),
        Kind::Fold {
            range: Range::Set(set),
            ..
        }
        | Kind::Scatter { set, .. } => check(
            matches!(ty(*set), Type::Set(_)),
            "a loop over something other than a set",
        ),
        Kind::Fold {
            op: Fold::ArgMin | Fold::ArgMax,
            body,
            ..
        } => check(
            matches!(ty(*body), Type::Tuple(items) if items.len() == 2 && items[0].is_scalar() && items[1] == *ty(e)),
            "a search for a member without a number",
        ),
        Kind::Optimum {
            variables,
            start,
            restrictions,
            objective,
            ..
        } => {
            let knows = |e: ExprId| variables.iter().any(|v| arena.depends_on(e, *v));
            let typed = variables
                .iter()
                .zip(start)
                .all(|(v, s)| arena.variable_type(*v) == ty(*s));
            let outside = restrictions.iter().all(|r| match r {
                Restriction::Equal(_) | Restriction::AtMost(_) => true,
                Restriction::Lower(k, bound) | Restriction::Upper(k, bound) => {
                    (*k as usize) < variables.len() && !knows(*bound)
                }
            });
            check(
                typed
                    && variables.len() == start.len()
                    && outside
                    && !start.iter().any(|s| knows(*s)),
                "an optimum whose start values or bounds do not fit its variables",
            )?;
            check(
                *ty(*objective) == Type::REAL,
                "an optimum of no real number",
            )
        }
        Kind::Assemble { blocks, .. } => {
            let is_square = |e: ExprId| match ty(e).shape() {
                Some(Shape::Matrix(n, m)) => n == m,
                // of one row
                Some(Shape::Scalar) => true,
                _ => false,
            };
            check(
                blocks.iter().all(|b| {
                    b.core
                        .is_none_or(|core| is_square(core) && is_square(b.value))
                }),
                "a block that is not square with a core, or a core that is not",
            )
        }
        Kind::Integral {
            variable,
            from,
            to,
            body,
        } => check(
            [ty(*from), ty(*to), ty(*body)]
                .iter()
                .all(|t| **t == Type::REAL)
                && !arena.depends_on(*from, *variable)
                && !arena.depends_on(*to, *variable),
            "an integral of no real number",
        ),
        _ => Ok(()),
    }
}

/// Whether two types are the same, but for sizes that are known only at run time.
fn are_alike(a: &Type, b: &Type) -> bool {
    match (a, b) {
        (Type::Vector { length: n, .. }, Type::Vector { length: m, .. }) => {
            !n.differs(m) && a.is_fixed() == b.is_fixed() && a.is_sparse() == b.is_sparse()
        }
        (
            Type::Matrix { rows, columns, .. },
            Type::Matrix {
                rows: n,
                columns: m,
                ..
            },
        ) => {
            !rows.differs(n)
                && !columns.differs(m)
                && a.is_fixed() == b.is_fixed()
                && a.is_sparse() == b.is_sparse()
        }
        _ => a == b,
    }
}

/// Whether a value of this type may be a case of a choice: the cases may be sequences of different lengths.
fn is_case(case: &Type, choice: &Type) -> bool {
    match (case, choice) {
        (Type::Sequence { item: a, .. }, Type::Sequence { item: b, .. }) => a == b,
        _ => case == choice,
    }
}
