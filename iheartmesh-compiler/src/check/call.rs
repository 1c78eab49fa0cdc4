//! Calls: which function is meant, whether its arguments fit.

use super::Checker;
use super::function::Signature;
use super::scope::Found;
use super::sizes::{Fit, Sizes, fit_alone, fits, has_sizes_like, with_sizes};
use super::wording::arguments;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, FunctionId, Kind};
use crate::resolve::symbols::{count, given};
use crate::resolve::{Meaning, ModuleId};
use crate::span::Span;
use crate::syntax::ast::{Expr, Name};
use crate::types::Type;

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
                if let Type::Function { parameters, result } = &ty {
                    let arguments: Vec<&'a Expr> = subscripts.iter().chain(arguments).collect();
                    let types = (parameters.as_slice(), &**result);
                    return self.host_call(span, function, value, types, &arguments);
                }
                if let Type::Sequence { item, .. } = &ty
                    && let Type::Function { parameters, result } = &**item
                {
                    let Some((index, rest)) = subscripts.split_first() else {
                        let message = format!(
                            "which of the functions `{}` is called must stand in the text",
                            function.text
                        );
                        return self.report(
                            Diagnostic::error(function.span, message)
                                .here(format!("this is {}", ty.described()))
                                .help(format!(
                                    "write which one as a subscript, as in `{}_i(…)`",
                                    function.text
                                )),
                        );
                    };
                    let Some(called) = self.sequence_item(span, value, index) else {
                        return self.error();
                    };
                    let arguments: Vec<&'a Expr> = rest.iter().chain(arguments).collect();
                    // without arguments it is the function itself
                    if arguments.is_empty() && !parameters.is_empty() {
                        return called;
                    }
                    let types = (parameters.as_slice(), &**result);
                    return self.host_call(span, function, called, types, &arguments);
                }
                // the parser makes calls of functions only
                return match ty.is_error() {
                    true => value,
                    false => self.unsupported(function.span, "calls of values are"),
                };
            }
            Found::Dimension => {
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
            .zip(call.arguments)
            .map(|((v, ty), argument)| {
                let wanted = with_sizes(ty, sizes);
                let value = self.convert(*v, &wanted);
                let value = self.of_sizes(argument.span, value, &wanted);
                self.represented(value, ty)
            })
            .collect();
        let values = self.of_one_length(call, &parameters, values);
        for (value, k) in values.iter().zip(0..) {
            if let Some(indexed) = self.sequence_parameter(id, k) {
                self.note_parameter_indexed(*value, &indexed);
            }
        }
        let own = self.result(id);
        if own.is_error() {
            return self.error();
        }
        let own = self.result_of(id, &values, &own);
        let ty = with_sizes(&own, sizes);
        let is_same = has_sizes_like(&own, &ty);
        let stands = if is_same { &ty } else { &own };
        let value = self.add_at(call.span, Kind::Call(id, values), stands.clone());
        match is_same {
            true => value,
            false => self.with_known_sizes(value, &own, &ty),
        }
    }

    /// The result of a function of arguments of any size, where the sizes of the arguments are known: in the type
    /// with these sizes.
    fn with_known_sizes(&mut self, value: ExprId, own: &Type, ty: &Type) -> ExprId {
        match (own, ty) {
            (Type::Tuple(own), Type::Tuple(items)) => {
                let mut list = Vec::new();
                for (k, (own, ty)) in own.iter().zip(items).enumerate() {
                    list.push(match has_sizes_like(own, ty) {
                        true => self.project(value, k, ty.clone()),
                        false => {
                            let item = self.project(value, k, own.clone());
                            self.with_known_sizes(item, own, ty)
                        }
                    });
                }
                self.add(Kind::Tuple(list), ty.clone())
            }
            _ => self.represented(value, ty),
        }
    }

    /// The type of a result: sizes that are known only at run time are those of this call.
    fn result_of(&mut self, id: FunctionId, values: &[ExprId], ty: &Type) -> Type {
        let key = (id, values.to_vec(), ty.clone());
        if let Some(ty) = self.results_of_calls.get(&key) {
            return ty.clone();
        }
        let ty = self.with_new_sizes(ty, &|_, _| true, true);
        self.results_of_calls.insert(key, ty.clone());
        ty
    }

    /// An argument whose sizes must be those of the parameter: compared at run time where they are not known before.
    fn of_sizes(&mut self, span: Span, value: ExprId, wanted: &Type) -> ExprId {
        let sizes = match wanted {
            Type::Vector {
                length,
                space: None,
                ..
            } => vec![length],
            Type::Matrix {
                rows,
                columns,
                spaces: None,
                ..
            } => vec![rows, columns],
            _ => return value,
        };
        let mut value = value;
        for (axis, wanted) in sizes.into_iter().enumerate() {
            if let Some(size) = self.size(wanted) {
                value = self.sized(span, value, axis as u8, (wanted, size));
            }
        }
        value
    }

    /// Arguments for sequences that are declared with one letter must have one length: compared at run time.
    fn of_one_length(
        &mut self,
        call: &Call<'_, 'a>,
        parameters: &[Type],
        mut values: Vec<ExprId>,
    ) -> Vec<ExprId> {
        let length = |ty: &Type| match ty {
            Type::Sequence { length, .. } => Some(length.clone()),
            _ => None,
        };
        for k in 1..values.len() {
            let Some(letter @ Some(_)) = parameters.get(k).map(length) else {
                continue;
            };
            let Some(first) = (0..k).find(|first| length(&parameters[*first]) == letter) else {
                continue;
            };
            let (a, b) = (values[first], values[k]);
            if length(self.ty(a)) != length(self.ty(b)) {
                let (n, m) = (self.extent(a, 0), self.extent(b, 0));
                let ty = self.ty(b).clone();
                let span = call.arguments[k].span;
                values[k] = self.add_at(span, Kind::Agree(n, m, b), ty);
            }
        }
        values
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
            .find(|&k| fit_alone(&parameters[k], &types[k]).is_none())
            .unwrap_or(0);
        let (takes, given) = self.described_both(&parameters[k], &types[k]);
        let help = if types.len() > 1 && is_permutation(parameters, types) {
            format!("the arguments have another order: `{}`", first.shown)
        } else if owner_mismatch(first, types) == Some(k) {
            "elements of one mesh have no meaning in another".to_owned()
        } else if parameters[k].is_element()
            && let Some(help) = self.counted_help(call.arguments[k])
        {
            help
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
        let takes_element = |k: usize| {
            let mut at = candidates
                .iter()
                .filter_map(|(_, _, s)| s.parameters.get(k));
            at.any(Type::is_element)
        };
        let counted = (call.arguments.iter().enumerate())
            .filter(|(k, _)| takes_element(*k))
            .find_map(|(_, argument)| self.counted_help(argument));
        let defined = || format!("it is defined as {}", shown.join(", "));
        self.report(diagnostic.help(counted.unwrap_or_else(defined)))
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
            fit_alone(first, &types[k]).is_some() && is_permutation(rest, &others)
        })
}

struct Call<'c, 'a> {
    span: Span,
    name: &'a Name,
    arguments: &'c [&'a Expr],
    values: &'c [ExprId],
}
