//! How well arguments fit parameters, and the sizes that they bring along.

use std::collections::{BTreeMap, BTreeSet};

use super::Checker;
use super::function::Signature;
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use crate::types::{Atom, Dimension, Shape, Type};

/// How well an argument fits a parameter: the lesser the better.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fit {
    Exact,
    /// An integer as a real number, or a sparse matrix as a dense one.
    Promoted,
    /// Sizes that the argument brings along.
    Template,
    /// A matrix with one column as a vector, a 1×1 matrix as a number, or the other way round.
    Reshaped,
}

/// How an argument fits a parameter, whatever sizes it brings along.
pub(super) fn fit_alone(parameter: &Type, argument: &Type) -> Option<Fit> {
    fit(parameter, argument, &|_| true, &mut Sizes::default())
}

/// Sizes that arguments bring along.
pub(super) type Sizes = BTreeMap<String, Dimension>;

pub(super) fn fits(
    signature: &Signature,
    types: &[Type],
    is_template: &dyn Fn(&str) -> bool,
) -> Option<(Fit, Sizes)> {
    if signature.parameters.len() != types.len() {
        return None;
    }
    let mut sizes = Sizes::default();
    let mut worst = Fit::Exact;
    for (p, t) in signature.parameters.iter().zip(types) {
        worst = worst.max(fit(p, t, is_template, &mut sizes)?);
    }
    Some((worst, sizes))
}

pub(super) fn fit(
    parameter: &Type,
    argument: &Type,
    is_template: &dyn Fn(&str) -> bool,
    sizes: &mut Sizes,
) -> Option<Fit> {
    if parameter == argument {
        return Some(Fit::Exact);
    }
    if let (Some(a), Some(b)) = (parameter.shape(), argument.shape()) {
        if parameter.is_integer() && !argument.is_integer()
            || parameter.is_sparse() && !argument.is_sparse()
        {
            return None;
        }
        let promoted = parameter.is_integer() != argument.is_integer()
            || parameter.is_sparse() != argument.is_sparse();
        let fit = match (a, b) {
            (Shape::Scalar, Shape::Scalar) => Fit::Exact,
            (Shape::Vector(n), Shape::Vector(m)) => fit_size(&n, &m, is_template, sizes)?,
            (Shape::Matrix(n, m), Shape::Matrix(p, q)) => {
                fit_size(&n, &p, is_template, sizes)?.max(fit_size(&m, &q, is_template, sizes)?)
            }
            (Shape::Vector(n), Shape::Matrix(m, one)) if one == Dimension::known(1) => {
                fit_size(&n, &m, is_template, sizes)?;
                Fit::Reshaped
            }
            (Shape::Matrix(m, one), Shape::Vector(n)) if one == Dimension::known(1) => {
                fit_size(&m, &n, is_template, sizes)?;
                Fit::Reshaped
            }
            (Shape::Matrix(n, m), Shape::Scalar)
                if n.value() == Some(1) && m.value() == Some(1) =>
            {
                Fit::Reshaped
            }
            (Shape::Scalar, Shape::Matrix(n, m))
                if n == Dimension::known(1) && m == Dimension::known(1) =>
            {
                Fit::Reshaped
            }
            _ => return None,
        };
        return Some(if promoted {
            fit.max(Fit::Promoted)
        } else {
            fit
        });
    }
    match (parameter, argument) {
        // the letters of two sequences, or their index sets, do not make them different arguments
        (
            Type::Sequence {
                item: a, length: n, ..
            },
            Type::Sequence {
                item: b, length: m, ..
            },
        ) => {
            if let Some(crate::types::Atom::Length(letter)) = n.as_atom() {
                sizes.entry(letter.clone()).or_insert_with(|| m.clone());
            }
            fit(a, b, is_template, sizes)
        }
        (Type::Tuple(a), Type::Tuple(b)) if a.len() == b.len() => {
            let mut worst = Fit::Exact;
            for (a, b) in a.iter().zip(b) {
                worst = worst.max(fit(a, b, is_template, sizes)?);
            }
            Some(worst)
        }
        (Type::Set(a), Type::Set(b)) if **a == Type::REAL && **b == Type::INTEGER => {
            Some(Fit::Promoted)
        }
        (Type::Set(a), Type::Set(b)) if a.shape().is_some() && a.is_integer() == b.is_integer() => {
            fit(a, b, is_template, sizes)
        }
        (
            Type::Function {
                parameters: a,
                result: x,
            },
            Type::Function {
                parameters: b,
                result: y,
            },
        ) if a.len() == b.len() => {
            let mut worst = Fit::Exact;
            for (a, b) in a.iter().chain([&**x]).zip(b.iter().chain([&**y])) {
                // what the host hands in takes and gives values of these types in Rust
                if a.is_integer() != b.is_integer()
                    || a.is_sparse() != b.is_sparse()
                    || !has_sizes_like(a, b)
                {
                    return None;
                }
                worst = worst.max(fit(a, b, is_template, sizes)?);
            }
            Some(worst)
        }
        (Type::Set(_), Type::Set(item)) if **item == Type::Error => Some(Fit::Promoted),
        (Type::CellularSet(a), Type::CellularSet(b)) if a.is_none() || b.is_none() => {
            Some(Fit::Exact)
        }
        _ => None,
    }
}

/// A size that an argument has where the parameter has this one.
pub(super) fn fit_size(
    parameter: &Dimension,
    argument: &Dimension,
    is_template: &dyn Fn(&str) -> bool,
    sizes: &mut Sizes,
) -> Option<Fit> {
    let symbol = match parameter.as_atom() {
        Some(Atom::Symbol(name)) if argument.is_ragged() && is_template(name) => return None,
        Some(Atom::Symbol(name)) => Some(name),
        // any sizes will do where each item may have its own
        Some(Atom::Item(of, None)) => match &**of {
            Atom::Symbol(name) => Some(name),
            _ => None,
        },
        _ => None,
    };
    if let Some(name) = symbol
        && is_template(name)
    {
        return match sizes.get(name) {
            Some(known) if known.differs(argument) => None,
            Some(_) => Some(Fit::Template),
            None => {
                sizes.insert(name.clone(), argument.clone());
                Some(Fit::Template)
            }
        };
    }
    if parameter.is_ragged() {
        let parameter = substituted(parameter, sizes);
        return (parameter == *argument).then_some(Fit::Exact);
    }
    let parameter = substituted(parameter, sizes);
    (!parameter.differs(argument)).then_some(Fit::Exact)
}

pub(super) fn substituted(dimension: &Dimension, sizes: &Sizes) -> Dimension {
    dimension.substitute(&|atom| match atom {
        Atom::Symbol(name) | Atom::Length(name) => sizes.get(name).cloned(),
        Atom::Item(of, None) => match &**of {
            Atom::Symbol(name) => sizes.get(name).cloned(),
            _ => None,
        },
        _ => None,
    })
}

/// A type with the sizes that the arguments of a call bring along.
pub(super) fn with_sizes(ty: &Type, sizes: &Sizes) -> Type {
    ty.with_sizes(&|size| substituted(size, sizes))
}

impl Checker<'_> {
    /// Reports symbols in the sizes of the module's parameters that get their values from no parameter.
    pub(super) fn check_sizes(&mut self) {
        let mut given = BTreeSet::new();
        for input in &self.program.inputs {
            if input.ty == Type::INTEGER {
                given.insert(input.name.clone());
            }
            for size in own_sizes(&input.ty) {
                if let Some(name) = size.as_atom().and_then(symbol) {
                    given.insert(name.to_owned());
                }
            }
        }
        let places: Vec<(Type, Span)> = self
            .program
            .inputs
            .iter()
            .map(|input| (input.ty.clone(), input.span))
            .collect();
        for (ty, span) in places {
            self.report_sizes(&ty, span, &mut given);
        }
        self.given = given;
    }

    /// Whether all sizes of a variable of this type are known; what is not is reported.
    pub(super) fn are_sizes_known(&mut self, ty: &Type, span: Span) -> bool {
        let mut given = self.given.clone();
        given.extend(self.templates.keys().cloned());
        let before = given.len();
        self.report_sizes(ty, span, &mut given);
        let Type::Sequence { length, .. } = ty else {
            return given.len() == before;
        };
        let is_known = self.program.inputs.iter().any(
            |input| matches!(&input.ty, Type::Sequence { length: other, .. } if other == length),
        );
        if !is_known && length.value().is_none() {
            self.report(
                Diagnostic::error(span, "the length of this sequence is not known")
                    .here(format!("this is {}", ty.described()))
                    .help("it is as long as a parameter with the same subscript letter"),
            );
        }
        given.len() == before && is_known
    }

    /// Reports symbols in the sizes of a type that are not `given`, each once.
    pub(super) fn report_sizes(&mut self, ty: &Type, span: Span, given: &mut BTreeSet<String>) {
        let mut sizes = Vec::new();
        all_sizes(ty, &mut sizes);
        for size in sizes {
            for atom in size.atoms() {
                if let Some(name) = symbol(atom)
                    && given.insert(name.to_owned())
                {
                    let example = match atom {
                        Atom::Item(..) => format!("`x_i ∈ ℝ^({name}_i)` or `{name}_i ∈ ℤ`"),
                        _ => format!("`v ∈ ℝ^{name}` or `{name} ∈ ℤ`"),
                    };
                    self.report(
                        Diagnostic::error(span, format!("the size `{name}` is not known"))
                            .here(format!("this is {}", ty.described()))
                            .help(format!(
                                "a parameter gives it where it stands alone, as in {example}"
                            )),
                    );
                }
            }
        }
    }
}

/// The symbol that stands for a size, or for the sizes of items.
pub(super) fn symbol(atom: &Atom) -> Option<&str> {
    match atom {
        Atom::Symbol(name) => Some(name),
        Atom::Item(of, _) => symbol(of),
        _ => None,
    }
}

/// The sizes that a value of a type has itself.
fn own_sizes(ty: &Type) -> Vec<&Dimension> {
    match ty {
        Type::Vector { length, .. } => vec![length],
        Type::Matrix { rows, columns, .. } => vec![rows, columns],
        Type::Sequence { item, .. } => match **item {
            Type::Sequence { .. } => Vec::new(),
            _ => own_sizes(item),
        },
        _ => Vec::new(),
    }
}

/// All sizes in a type.
fn all_sizes<'t>(ty: &'t Type, sizes: &mut Vec<&'t Dimension>) {
    sizes.extend(own_sizes(ty));
    match ty {
        Type::Set(item) => all_sizes(item, sizes),
        Type::Tuple(items) => items.iter().for_each(|item| all_sizes(item, sizes)),
        Type::Function { parameters, result } => {
            parameters.iter().for_each(|ty| all_sizes(ty, sizes));
            all_sizes(result, sizes);
        }
        _ => {}
    }
}

/// Whether the sizes of one type are known when the program is compiled where those of the other are.
pub(super) fn has_sizes_like(a: &Type, b: &Type) -> bool {
    match (a, b) {
        (Type::Tuple(a), Type::Tuple(b)) => a.iter().zip(b).all(|(a, b)| has_sizes_like(a, b)),
        _ => a.is_fixed() == b.is_fixed(),
    }
}
