//! Calls: which function is meant, whether its arguments fit.

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
use crate::types::{Number, Type};

/// How well an argument fits a parameter: the lesser the better.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    Exact,
    Promoted,
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
            if let Some(fit) = fits(signature, &types) {
                match best.first() {
                    Some((f, ..)) if *f < fit => {}
                    Some((f, ..)) if *f == fit => best.push((fit, *module, *item)),
                    _ => best = vec![(fit, *module, *item)],
                }
            }
        }
        match best.as_slice() {
            [(_, module, item)] => {
                let id = self.function(*module, *item);
                self.call_function(call, id)
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

    fn call_function(&mut self, call: &Call<'_, 'a>, id: FunctionId) -> ExprId {
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
        let ty = self.result(id);
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
            .find(|&k| fit(&first.parameters[k], &types[k]).is_none())
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

fn fits(signature: &Signature, types: &[Type]) -> Option<Fit> {
    if signature.parameters.len() != types.len() {
        return None;
    }
    signature
        .parameters
        .iter()
        .zip(types)
        .map(|(p, t)| fit(p, t))
        .try_fold(Fit::Exact, |worst, f| f.map(|f| worst.max(f)))
}

fn fit(parameter: &Type, argument: &Type) -> Option<Fit> {
    if parameter == argument {
        return Some(Fit::Exact);
    }
    match (parameter, argument) {
        (Type::Scalar(Number::Real), Type::Scalar(Number::Integer)) => Some(Fit::Promoted),
        // the letters of two sequences, or their index sets, do not make them different arguments
        (Type::Sequence { item: a, .. }, Type::Sequence { item: b, .. }) => fit(a, b),
        (Type::CellularSet(a), Type::CellularSet(b)) if a.is_none() || b.is_none() => {
            Some(Fit::Exact)
        }
        (Type::Vector { .. }, Type::Vector { .. }) | (Type::Matrix { .. }, Type::Matrix { .. }) => {
            None
        }
        _ => None,
    }
}
