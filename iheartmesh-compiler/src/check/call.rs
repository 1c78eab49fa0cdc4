//! Calls: which function is meant, whether its arguments fit.

use super::Checker;
use super::function::Signature;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, FunctionId, Kind};
use crate::resolve::symbols::{count, given};
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
            // the parser makes calls of functions only
            Found::Value(value) if self.is_error(value) => return value,
            Found::Value(_) | Found::Dimension => {
                return self.unsupported(function.span, "calls of values are");
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
        if call.values.iter().any(|v| self.is_wrong(*v)) {
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
                let message = format!("the call of `{}` is ambiguous", call.name.text);
                let mut diagnostic = Diagnostic::error(call.span, message);
                for (_, module, item) in &best {
                    if let Some(signature) = self.signature(*module, *item) {
                        let text = format!("`{}` fits", signature.shown);
                        diagnostic = diagnostic.label(signature.span, text);
                    }
                }
                self.report(
                    diagnostic.help("rename one of the functions, or import it under another name"),
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
            return self.no_overload(call, types, candidates);
        }
        let parameters = &first.parameters;
        if parameters.len() != types.len() {
            let message = format!(
                "`{name}` takes {} but is given {}",
                count(parameters.len(), "argument"),
                given(types.len())
            );
            return self.report(
                Diagnostic::error(call.span, message)
                    .label(first.span, "defined here")
                    .help(format!("its parameters are `{}`", first.shown)),
            );
        }
        let k = (0..types.len())
            .find(|&k| fit(&parameters[k], &types[k]).is_none())
            .unwrap_or(0);
        let (takes, given) = self.described_both(&parameters[k], &types[k]);
        let help = if is_permutation(parameters, types) {
            format!("the arguments have another order: `{}`", first.shown)
        } else if owner_mismatch(first, types) == Some(k) {
            "elements of one mesh have no meaning in another".to_owned()
        } else {
            format!("its parameters are `{}`", first.shown)
        };
        let message = format!("`{name}` takes {takes} but is given {given}");
        let diagnostic = Diagnostic::error(call.arguments[k].span, message)
            .here(format!("this is {given}"))
            .label(first.span, "defined here")
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[call.arguments[k]]);
        self.report(diagnostic)
    }

    /// None of several definitions takes the arguments.
    fn no_overload(
        &mut self,
        call: &Call<'_, 'a>,
        types: &[Type],
        candidates: &[(ModuleId, usize, Signature)],
    ) -> ExprId {
        let name = &call.name.text;
        let owner = candidates
            .iter()
            .find_map(|(_, _, s)| owner_mismatch(s, types).map(|k| (k, s)));
        let mut described: Vec<String> = types.iter().map(Type::described).collect();
        if let Some((k, signature)) = owner {
            let (takes, given) = self.described_both(&signature.parameters[k], &types[k]);
            let here = format!("this is {given}; `{name}` takes {takes}");
            described[k] = given;
            let message = format!("no definition of `{name}` takes {}", arguments(&described));
            let diagnostic = Diagnostic::error(call.arguments[k].span, message)
                .here(here)
                .help(format!(
                    "import it for the other mesh as well, under another name, as in `{name} as …`"
                ));
            let diagnostic = self.with_origins(diagnostic, &[call.arguments[k]]);
            return self.report(diagnostic);
        }
        let message = format!("no definition of `{name}` takes {}", arguments(&described));
        let mut diagnostic = Diagnostic::error(call.span, message);
        if let [argument] = call.arguments {
            diagnostic = diagnostic.label(argument.span, format!("this is {}", described[0]));
            diagnostic = self.with_origins(diagnostic, &[argument]);
        }
        let shown: Vec<_> = candidates
            .iter()
            .map(|(_, _, s)| format!("`{}`", s.shown))
            .collect();
        self.report(diagnostic.help(format!("it is defined as {}", shown.join(", "))))
    }
}

/// The first argument that would fit but for its mesh.
fn owner_mismatch(signature: &Signature, types: &[Type]) -> Option<usize> {
    if signature.parameters.len() != types.len() {
        return None;
    }
    let element = |ty: &Type| match ty {
        Type::Element(element) => Some((*element, false)),
        _ => ty.element_of_set().map(|element| (element, true)),
    };
    let pairs = signature.parameters.iter().zip(types);
    pairs.enumerate().find_map(|(k, (parameter, ty))| {
        let ((p, p_set), (t, t_set)) = (element(parameter)?, element(ty)?);
        (p.kind == t.kind && p_set == t_set && p.mesh != t.mesh).then_some(k)
    })
}

/// Whether the arguments would fit in another order.
fn is_permutation(parameters: &[Type], types: &[Type]) -> bool {
    let Some((first, rest)) = parameters.split_first() else {
        return types.is_empty();
    };
    types.len() <= 6
        && (0..types.len()).any(|k| {
            let others = [&types[..k], &types[k + 1..]].concat();
            fit(first, &types[k]).is_some() && is_permutation(rest, &others)
        })
}

/// The arguments of a call in a sentence.
fn arguments(described: &[String]) -> String {
    match described {
        [] => "no arguments".to_owned(),
        [one] => one.clone(),
        _ => format!("({})", described.join(", ")),
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
        (Type::Set(_), Type::Set(item)) if **item == Type::Error => Some(Fit::Promoted),
        (Type::CellularSet(a), Type::CellularSet(b)) if a.is_none() || b.is_none() => {
            Some(Fit::Exact)
        }
        (Type::Vector { .. }, Type::Vector { .. }) | (Type::Matrix { .. }, Type::Matrix { .. }) => {
            None
        }
        _ => None,
    }
}
