//! Arguments of imported modules: whether they are what the module declares.

use super::Checker;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::resolve::{Meaning, ModuleId};
use crate::syntax::ast::{self, Import, ItemKind, TypeKind};
use crate::types::Type;

impl Checker<'_> {
    /// Reports arguments that are obviously of another type than the parameter, where they are handed over: a
    /// mistake of the importing module is not shown inside of the imported one.
    pub(super) fn check_arguments(&mut self) {
        let resolved = self.resolved;
        for (index, module) in resolved.modules.iter().enumerate().skip(1) {
            let parameters: Vec<(usize, &ast::Name, &ast::Type)> = module
                .syntax
                .items
                .iter()
                .filter_map(|item| match &item.kind {
                    ItemKind::Parameters(block) => Some(block),
                    _ => None,
                })
                .flatten()
                .flat_map(|d| d.targets.iter().map(move |t| (t, d)))
                .filter(|(target, _)| !module.declared.contains_key(&target.name.text))
                .enumerate()
                .filter(|(_, (target, _))| target.subscript.is_none())
                .map(|(k, (target, d))| (k, &target.name, &d.ty))
                .collect();
            for (k, parameter, ty) in parameters {
                let symbol = module.symbols.get(&parameter.text);
                let Some(Meaning::Argument(from, name)) = symbol.and_then(|s| s.meanings.first())
                else {
                    continue;
                };
                let Found::Value(value) = self.find_in_module(*from, name) else {
                    continue;
                };
                let given = self.ty(value).clone();
                let Some(takes) = misfit(ty, &given) else {
                    continue;
                };
                self.misfits
                    .insert((ModuleId(index as u32), parameter.text.clone()));
                let place = (*from, name.as_str(), k);
                self.report_misfit(&module.name, place, parameter, &takes, &given);
            }
        }
    }

    fn report_misfit(
        &mut self,
        module: &str,
        (from, name, k): (ModuleId, &str, usize),
        parameter: &ast::Name,
        takes: &str,
        given: &Type,
    ) {
        let importer = self.resolved.module(from);
        let argument = importer
            .syntax
            .items
            .iter()
            .find_map(|item| match &item.kind {
                ItemKind::Import(Import {
                    module: imported,
                    arguments,
                    ..
                }) if imported.text == module => arguments.get(k).filter(|a| a.text == name),
                _ => None,
            });
        let span = argument.map_or(parameter.span, |a| a.span);
        let given = given.described();
        let message = format!("module `{module}` takes {takes} but is given {given}");
        let mut diagnostic = Diagnostic::error(span, message).here(format!("this is {given}"));
        if span != parameter.span {
            diagnostic = diagnostic.label(parameter.span, "declared here");
        }
        self.report(diagnostic.help(format!(
            "hand it {takes} for its parameter `{}`",
            parameter.text
        )));
    }
}

/// What a parameter takes, where the argument cannot be that.
fn misfit(ty: &ast::Type, given: &Type) -> Option<String> {
    if given.is_error() {
        return None;
    }
    match &ty.kind {
        TypeKind::Mesh(kind) => match given {
            Type::Mesh(other, _) if other == kind => None,
            Type::Mesh(_, mesh) => Some(Type::Mesh(*kind, *mesh).described()),
            _ => Some(format!("a {kind}")),
        },
        TypeKind::Scalar(number) => match given {
            Type::Scalar(other) if other == number || *number == ast::Number::Real => None,
            _ => Some(Type::Scalar(*number).to_string()),
        },
        TypeKind::Vector { .. } => {
            (!matches!(given, Type::Vector { .. })).then(|| "a vector".to_owned())
        }
        TypeKind::Matrix { .. } => {
            (!matches!(given, Type::Matrix { .. })).then(|| "a matrix".to_owned())
        }
        TypeKind::Function { .. } => Some("a function".to_owned()),
        TypeKind::Set(_) => (!matches!(given, Type::Set(_))).then(|| "a set".to_owned()),
        _ => None,
    }
}
