//! Calls: which function is meant, whether its arguments fit.

use std::collections::BTreeMap;

use super::Checker;
use super::function::Signature;
use super::scope::Found;
use super::subscript::with_article;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, FunctionId, Kind};
use crate::resolve::symbols::count;
use crate::resolve::{Meaning, ModuleId};
use crate::span::Span;
use crate::syntax::ast::{Expr, Name};
use crate::types::{Dimension, Shape, Type};

/// How well an argument fits a parameter: the lesser the better.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    Exact,
    Promoted,
    Template,
}

impl<'a> Checker<'a> {
    pub(super) fn call(
        &mut self,
        span: Span,
        function: &'a Name,
        subscripts: &'a [Expr],
        arguments: &'a [Expr],
    ) -> ExprId {
        let meanings = match self.find(function) {
            Found::Functions(meanings) => meanings,
            Found::Error => {
                // the arguments may hold mistakes of their own
                for argument in subscripts.iter().chain(arguments) {
                    self.expr(argument);
                }
                return self.error();
            }
            Found::Value(value) => {
                let ty = self.ty(value).clone();
                if ty.is_error() {
                    return value;
                }
                if let (Type::Function { parameters, result }, Kind::Input(id)) =
                    (&ty, self.program.arena.kind(value).clone())
                {
                    let arguments: Vec<&'a Expr> = subscripts.iter().chain(arguments).collect();
                    return self.host_call(span, function, id, (parameters, result), &arguments);
                }
                return self.report(
                    Diagnostic::error(
                        function.span,
                        format!("`{}` is not a function", function.text),
                    )
                    .here(format!("this is {}", with_article(&ty)))
                    .help(
                        "a product with a number in parentheses needs a space or `⋅` between them",
                    ),
                );
            }
            Found::Dimension => {
                return self.report(
                    Diagnostic::error(
                        function.span,
                        format!("`{}` is a size, not a function", function.text),
                    )
                    .help("a product needs a space or `⋅` between its factors"),
                );
            }
        };
        let arguments: Vec<&'a Expr> = subscripts.iter().chain(arguments).collect();
        if let [(_, Meaning::Builtin(name))] = meanings.as_slice() {
            let name = name.clone();
            return self.builtin(span, function, &name, &arguments);
        }
        let values: Vec<ExprId> = arguments.iter().map(|a| self.expr(a)).collect();
        let call = Call {
            span,
            name: function,
            arguments: &arguments,
            values: &values,
        };
        let mut candidates = Vec::new();
        for (module, meaning) in &meanings {
            if let Meaning::Functions(items) = meaning {
                for &item in items {
                    if let Some(signature) = self.signature(*module, item) {
                        candidates.push((*module, item, signature));
                    }
                }
            }
        }
        self.resolve_call(&call, candidates)
    }

    /// A call of a function that the host hands in.
    fn host_call(
        &mut self,
        span: Span,
        name: &'a Name,
        id: crate::ir::InputId,
        (parameters, result): (&[Type], &Type),
        arguments: &[&'a Expr],
    ) -> ExprId {
        let values: Vec<ExprId> = arguments.iter().map(|a| self.expr(a)).collect();
        if values.iter().any(|v| self.is_error(*v)) {
            return self.error();
        }
        let shown: Vec<String> = parameters.iter().map(with_article).collect();
        let help = format!("`{}` takes ({})", name.text, shown.join(", "));
        if values.len() != parameters.len() {
            let message = format!(
                "`{}` takes {} but is given {}",
                name.text,
                count(parameters.len(), "argument"),
                values.len()
            );
            return self.report(Diagnostic::error(span, message).help(help));
        }
        let mut sizes = Sizes::default();
        for (k, (value, parameter)) in values.iter().zip(parameters).enumerate() {
            let ty = self.ty(*value).clone();
            if fit(parameter, &ty, &|_| false, &mut sizes).is_none() {
                let given = with_article(&ty);
                let message = format!(
                    "`{}` takes {} but is given {given}",
                    name.text,
                    with_article(parameter)
                );
                return self.report(
                    Diagnostic::error(arguments[k].span, message)
                        .here(format!("this is {given}"))
                        .help(help),
                );
            }
        }
        let values = values
            .iter()
            .zip(parameters)
            .map(|(v, ty)| self.convert(*v, ty))
            .collect();
        self.add(Kind::HostCall(id, values), result.clone())
    }

    /// Whether a symbol of a size is of the function being called, and takes the size of its argument.
    fn is_template(&self, module: ModuleId) -> impl Fn(&str) -> bool + use<'a> {
        let symbols = &self.resolved.module(module).symbols;
        move |name: &str| !symbols.contains_key(name)
    }

    fn resolve_call(
        &mut self,
        call: &Call<'_, 'a>,
        candidates: Vec<(ModuleId, usize, Signature)>,
    ) -> ExprId {
        if call.values.iter().any(|v| self.is_error(*v)) {
            // which overload is meant may not be known, but often it does not matter
            if let [(module, item, _)] = candidates.as_slice() {
                let id = self.function(*module, *item);
                let ty = self.result(id);
                if !ty.is_error() {
                    return self.add(Kind::Fail, Type::Error);
                }
            }
            return self.error();
        }
        let types: Vec<Type> = call.values.iter().map(|v| self.ty(*v).clone()).collect();
        let mut best: Vec<(Fit, ModuleId, usize)> = Vec::new();
        for (module, item, signature) in &candidates {
            if let Some((fit, _)) = fits(signature, &types, &self.is_template(*module)) {
                match best.first() {
                    Some((f, ..)) if *f < fit => {}
                    Some((f, ..)) if *f == fit => best.push((fit, *module, *item)),
                    _ => best = vec![(fit, *module, *item)],
                }
            }
        }
        match best.as_slice() {
            [(_, module, item)] => {
                let (module, item) = (*module, *item);
                let id = self.function(module, item);
                let sizes = candidates
                    .iter()
                    .find(|(m, i, _)| (*m, *i) == (module, item))
                    .and_then(|(_, _, s)| fits(s, &types, &self.is_template(module)))
                    .map_or_else(Sizes::default, |(_, sizes)| sizes);
                self.call_function(call, id, &sizes)
            }
            [] => self.no_candidate(call, &types, &candidates),
            _ => {
                let shown: Vec<_> = candidates
                    .iter()
                    .map(|(_, _, s)| format!("`{}`", s.shown))
                    .collect();
                self.report(
                    Diagnostic::error(
                        call.span,
                        format!("the call of `{}` is ambiguous", call.name.text),
                    )
                    .help(format!("it may mean {}", shown.join(" or "))),
                )
            }
        }
    }

    fn call_function(&mut self, call: &Call<'_, 'a>, id: FunctionId, sizes: &Sizes) -> ExprId {
        let parameters: Vec<Type> = self
            .program
            .function(id)
            .parameters
            .iter()
            .map(|p| p.ty.clone())
            .collect();
        let values: Vec<ExprId> = call
            .values
            .iter()
            .zip(&parameters)
            .map(|(v, ty)| self.convert(*v, ty))
            .collect();
        for (value, k) in values.iter().zip(0..) {
            if let Some(indexed) = self.sequence_parameter(id, k) {
                self.note_parameter_indexed(*value, &indexed);
            }
        }
        let ty = with_sizes(&self.result(id), sizes);
        if ty.is_error() {
            return self.error();
        }
        self.add_at(call.span, Kind::Call(id, values), ty)
    }

    /// For a parameter that is a sequence indexed by elements, these.
    fn sequence_parameter(&self, id: FunctionId, k: usize) -> Option<crate::types::Element> {
        match &self.program.function(id).parameters.get(k)?.ty {
            Type::Sequence { index, .. } => *index,
            _ => None,
        }
    }

    fn note_parameter_indexed(&mut self, value: ExprId, element: &crate::types::Element) {
        if let Kind::Input(input) = self.program.arena.kind(value).clone() {
            let list = &mut self.program.inputs[input.0 as usize].indexed_by;
            if !list.contains(element) {
                list.push(*element);
            }
        }
    }

    fn no_candidate(
        &mut self,
        call: &Call<'_, 'a>,
        types: &[Type],
        candidates: &[(ModuleId, usize, Signature)],
    ) -> ExprId {
        let name = &call.name.text;
        let Some((_, _, first)) = candidates.first() else {
            return self.error();
        };
        if candidates
            .iter()
            .any(|(_, _, s)| s.parameters.iter().any(Type::is_error))
        {
            return self.error();
        }
        if candidates.len() > 1 {
            let given: Vec<_> = types.iter().map(with_article).collect();
            let mut diagnostic = Diagnostic::error(
                call.span,
                format!("no definition of `{name}` takes ({})", given.join(", ")),
            );
            let owner = candidates
                .iter()
                .find_map(|(_, _, s)| self.owner_mismatch(s, types));
            if let Some((k, there, here)) = owner {
                diagnostic = diagnostic.label(
                    call.arguments[k].span,
                    format!("this is of `{here}`; `{name}` here is of `{there}`"),
                );
            }
            let shown: Vec<_> = candidates
                .iter()
                .map(|(_, _, s)| format!("`{}`", s.shown))
                .collect();
            return self.report(diagnostic.help(format!("there are {}", shown.join(", "))));
        }
        if first.parameters.len() != types.len() {
            let message = format!(
                "`{name}` takes {} but is given {}",
                count(first.parameters.len(), "argument"),
                types.len()
            );
            return self.report(
                Diagnostic::error(call.span, message)
                    .label(first.span, "defined here")
                    .help(format!("its parameters are `{}`", first.shown)),
            );
        }
        if let Some((k, there, here)) = self.owner_mismatch(first, types) {
            let message =
                format!("`{name}` takes elements of `{there}` but is given those of `{here}`");
            return self.report(
                Diagnostic::error(call.arguments[k].span, message)
                    .here(format!("this is {} of `{here}`", with_article(&types[k])))
                    .help("elements of one mesh have no meaning in another"),
            );
        }
        let k = (0..types.len())
            .find(|&k| {
                fit(
                    &first.parameters[k],
                    &types[k],
                    &|_| true,
                    &mut Sizes::default(),
                )
                .is_none()
            })
            .unwrap_or(0);
        let (expected, given) = (with_article(&first.parameters[k]), with_article(&types[k]));
        self.report(
            Diagnostic::error(
                call.arguments[k].span,
                format!("`{name}` takes {expected} but is given {given}"),
            )
            .here(format!("this is {given}"))
            .label(first.span, "defined here")
            .help(format!("its parameters are `{}`", first.shown)),
        )
    }

    /// The first argument that would fit but for its mesh: its number, the mesh of the parameter, its own.
    fn owner_mismatch(
        &self,
        signature: &Signature,
        types: &[Type],
    ) -> Option<(usize, String, String)> {
        if signature.parameters.len() != types.len() {
            return None;
        }
        let element = |ty: &Type| match ty {
            Type::Element(element) => Some((*element, false)),
            _ => ty.element_of_set().map(|element| (element, true)),
        };
        signature
            .parameters
            .iter()
            .zip(types)
            .enumerate()
            .find_map(|(k, (parameter, ty))| {
                let ((p, p_set), (t, t_set)) = (element(parameter)?, element(ty)?);
                (p.kind == t.kind && p_set == t_set && p.mesh != t.mesh)
                    .then(|| (k, self.mesh_name(p.mesh), self.mesh_name(t.mesh)))
            })
    }
}

struct Call<'c, 'a> {
    span: Span,
    name: &'a Name,
    arguments: &'c [&'a Expr],
    values: &'c [ExprId],
}

/// Sizes that arguments bring along.
type Sizes = BTreeMap<String, Dimension>;

fn fits(
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

fn fit(
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
            || parameter.is_sparse() != argument.is_sparse()
        {
            return None;
        }
        let promoted = parameter.is_integer() != argument.is_integer();
        let fit = match (a, b) {
            (Shape::Scalar, Shape::Scalar) => Fit::Exact,
            (Shape::Vector(n), Shape::Vector(m)) => fit_size(&n, &m, is_template, sizes)?,
            (Shape::Matrix(n, m), Shape::Matrix(p, q)) => {
                fit_size(&n, &p, is_template, sizes)?.max(fit_size(&m, &q, is_template, sizes)?)
            }
            (Shape::Vector(n), Shape::Matrix(m, one)) if one == Dimension::known(1) => {
                fit_size(&n, &m, is_template, sizes)?.max(Fit::Promoted)
            }
            (Shape::Scalar, Shape::Matrix(n, m))
                if n == Dimension::known(1) && m == Dimension::known(1) =>
            {
                Fit::Promoted
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
        (Type::CellularSet(a), Type::CellularSet(b)) if a.is_none() || b.is_none() => {
            Some(Fit::Exact)
        }
        _ => None,
    }
}

/// A size that an argument has where the parameter has this one.
fn fit_size(
    parameter: &Dimension,
    argument: &Dimension,
    is_template: &dyn Fn(&str) -> bool,
    sizes: &mut Sizes,
) -> Option<Fit> {
    if let Some(crate::types::Atom::Symbol(name)) = parameter.as_atom()
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
    let parameter = substituted(parameter, sizes);
    (!parameter.differs(argument)).then_some(Fit::Exact)
}

fn substituted(dimension: &Dimension, sizes: &Sizes) -> Dimension {
    dimension.substitute(&|atom| match atom {
        crate::types::Atom::Symbol(name) | crate::types::Atom::Length(name) => {
            sizes.get(name).cloned()
        }
        _ => None,
    })
}

/// A type with the sizes that the arguments of a call bring along.
fn with_sizes(ty: &Type, sizes: &Sizes) -> Type {
    let mut ty = ty.clone();
    match &mut ty {
        Type::Vector { length, .. } => *length = substituted(length, sizes),
        Type::Matrix { rows, columns, .. } => {
            *rows = substituted(rows, sizes);
            *columns = substituted(columns, sizes);
        }
        Type::Sequence { item, length, .. } => {
            **item = with_sizes(item, sizes);
            *length = substituted(length, sizes);
        }
        Type::Set(item) => **item = with_sizes(item, sizes),
        Type::Tuple(items) => items
            .iter_mut()
            .for_each(|item| *item = with_sizes(item, sizes)),
        _ => {}
    }
    ty
}
