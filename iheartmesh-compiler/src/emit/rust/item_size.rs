//! Checks of sizes that differ from item to item of a sequence, of sizes that are quotients, and of the sizes of
//! arguments.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Context, names};
use crate::ir::{Function, Input, InputId, Parameter};
use crate::types::{Atom, Dimension, Type};

/// What the messages call a direction.
const VECTOR: &[&str] = &["length"];
const MATRIX: &[&str] = &["number of rows", "number of columns"];

/// The sizes of a vector or matrix, with their names.
fn sizes(ty: &Type) -> Vec<(&'static str, &Dimension)> {
    let (names, list) = match ty {
        Type::Vector {
            length,
            space: None,
            ..
        } => (VECTOR, vec![length]),
        Type::Matrix {
            rows,
            columns,
            spaces: None,
            ..
        } => (MATRIX, vec![rows, columns]),
        _ => return Vec::new(),
    };
    names.iter().copied().zip(list).collect()
}

/// A size of a value at hand, as `i64`.
fn found(axis: usize, value: &TokenStream) -> TokenStream {
    match axis {
        0 => quote!((rt::Array::rows(#value) as i64)),
        _ => quote!((rt::Array::columns(#value) as i64)),
    }
}

/// The symbols of sizes that differ from item to item.
fn ragged_symbols(dimension: &Dimension) -> impl Iterator<Item = &str> {
    dimension.atoms().filter_map(|atom| match atom {
        Atom::Item(of, None) => match &**of {
            Atom::Symbol(name) => Some(name.as_str()),
            _ => None,
        },
        _ => None,
    })
}

fn has_ragged(input: &Input, symbol: &str) -> bool {
    match &input.ty {
        Type::Sequence { item, .. } => sizes(item)
            .iter()
            .any(|(_, size)| ragged_symbols(size).any(|s| s == symbol)),
        _ => false,
    }
}

impl Context<'_> {
    /// Checks the sizes of the items of a sequence that may differ; `again` also those of other sequences that have to
    /// do with it.
    pub(super) fn item_size_checks(&self, id: InputId, again: bool) -> TokenStream {
        let own = self.program().input(id);
        let related = |other: &Input| {
            let symbols = match &other.ty {
                Type::Sequence { item, .. } => sizes(item)
                    .into_iter()
                    .flat_map(|(_, size)| ragged_symbols(size))
                    .collect(),
                _ => Vec::new(),
            };
            symbols
                .iter()
                .any(|symbol| own.name == *symbol || has_ragged(own, symbol))
        };
        self.values()
            .filter(|(other, input)| *other == id || again && related(input))
            .map(|(other, input)| self.item_checks_of(other, input))
            .collect()
    }

    fn item_checks_of(&self, id: InputId, input: &Input) -> TokenStream {
        let Type::Sequence { item, .. } = &input.ty else {
            return TokenStream::new();
        };
        let (name, field) = (&input.name, self.input_field(id));
        let mut checks = TokenStream::new();
        for (axis, (what, size)) in sizes(item).into_iter().enumerate() {
            if !size.is_ragged() {
                continue;
            }
            let alone = match size.as_atom() {
                Some(Atom::Item(of, None)) => match &**of {
                    Atom::Symbol(symbol) => Some(symbol.as_str()),
                    _ => None,
                },
                _ => None,
            };
            if alone.is_some_and(|symbol| self.item_size_source(symbol) == Some((id, Some(axis)))) {
                continue;
            }
            let source = ragged_symbols(size)
                .next()
                .and_then(|symbol| self.item_size_source(symbol))
                .map_or(String::new(), |(id, _)| {
                    self.program().input(id).name.clone()
                });
            let (wanted, n) = self.item_size_terms(size);
            let (found, written) = (found(axis, &quote!(item)), size.to_string());
            checks.extend(quote! {
                for (k, item) in #field.as_ref().iter().enumerate() {
                    rt::check_item_size(#name, k, #what, #found, (#wanted, #n), #written, #source)?;
                }
            });
        }
        checks
    }

    /// The input that gives the sizes of items their values: a sequence of numbers of this name, or the first sequence
    /// whose items have this size, with the direction.
    fn item_size_source(&self, symbol: &str) -> Option<(InputId, Option<usize>)> {
        let declared = self.values().find(|(_, input)| {
            input.name == symbol
                && matches!(&input.ty, Type::Sequence { item, .. } if **item == Type::INTEGER)
        });
        if let Some((id, _)) = declared {
            return Some((id, None));
        }
        self.values().find_map(|(id, input)| {
            let Type::Sequence { item, .. } = &input.ty else {
                return None;
            };
            let is_alone = |size: &Dimension| {
                size.as_atom().is_some() && ragged_symbols(size).any(|s| s == symbol)
            };
            let axis = sizes(item).iter().position(|(_, size)| is_alone(size))?;
            Some((id, Some(axis)))
        })
    }

    /// That size of the item number `k`.
    fn item_size_of(&self, symbol: &str) -> Option<TokenStream> {
        let (id, axis) = self.item_size_source(symbol)?;
        let field = self.input_field(id);
        Some(match axis {
            None => quote!(#field.as_ref().get(k).copied().unwrap_or(0)),
            Some(axis) => {
                let found = found(axis, &quote!(item));
                quote!(#field.as_ref().get(k).map_or(0, |item| #found))
            }
        })
    }

    /// What a size of the item number `k` should be, and what that is divided by.
    fn item_size_terms(&self, size: &Dimension) -> (TokenStream, TokenStream) {
        self.sum_of_terms(size, &|atom| match atom {
            Atom::Item(of, None) => match &**of {
                Atom::Symbol(symbol) => self.item_size_of(symbol),
                _ => None,
            },
            _ => None,
        })
    }

    /// What a size is, and what that is divided by, as `i64`; needs `sizes` and `t`.
    pub(super) fn sum_of_terms(
        &self,
        dimension: &Dimension,
        of: &dyn Fn(&Atom) -> Option<TokenStream>,
    ) -> (TokenStream, TokenStream) {
        let terms = dimension.terms().map(|(k, atoms)| {
            let k = proc_macro2::Literal::i64_suffixed(k);
            let factors = atoms
                .iter()
                .map(|atom| of(atom).unwrap_or_else(|| self.size(&Dimension::atom(atom.clone()))));
            quote!(#k #(* #factors)*)
        });
        let n = proc_macro2::Literal::i64_suffixed(dimension.denominator());
        (quote!((0i64 #(+ #terms)*)), quote!(#n))
    }

    /// Checks the sizes of the arguments of a method, which are at hand under their Rust names: against the module's, and
    /// against those of the arguments before.
    pub(super) fn argument_size_checks(&self, function: &Function) -> TokenStream {
        let mut known = BTreeMap::new();
        let mut checks = TokenStream::new();
        let mut letters: BTreeMap<Dimension, &str> = BTreeMap::new();
        // sequences may be empty, and then their items say nothing
        let is_list = |p: &&Parameter| matches!(p.ty, Type::Sequence { .. } | Type::Set(_));
        let others = function.parameters.iter().filter(|p| !is_list(p));
        let lists = function.parameters.iter().filter(is_list);
        for parameter in others.chain(lists) {
            let name = names::argument(&parameter.name);
            if let Type::Sequence { length, .. } = &parameter.ty
                && matches!(length.as_atom(), Some(Atom::Length(_)))
            {
                let second = parameter.name.as_str();
                let first = *letters.entry(length.clone()).or_insert(second);
                if first != second {
                    let other = names::argument(first);
                    checks.extend(quote! {
                        rt::check_same_length(#first, #other.as_ref().len(), #second, #name.as_ref().len())?;
                    });
                }
            }
            let value = match super::item::is_converted(&parameter.ty) {
                true => quote!(#name.as_ref()),
                false => quote!(&#name),
            };
            let of = parameter.name.as_str();
            match &parameter.ty {
                Type::Sequence { item, .. } => {
                    self.items_check(of, item, &value, &mut known, &mut checks);
                }
                ty => self.argument_check(of, ty, &value, &mut known, &mut checks),
            }
        }
        checks
    }

    fn argument_check(
        &self,
        parameter: &str,
        ty: &Type,
        value: &TokenStream,
        known: &mut BTreeMap<Atom, (proc_macro2::Ident, String)>,
        checks: &mut TokenStream,
    ) {
        if let Type::Tuple(items) = ty {
            for (k, item) in items.iter().enumerate() {
                let k = proc_macro2::Literal::usize_unsuffixed(k);
                let value = quote!(&(#value).#k);
                self.argument_check(parameter, item, &value, known, checks);
            }
            return;
        }
        for (axis, (what, size)) in sizes(ty).into_iter().enumerate() {
            if ty.is_fixed() {
                continue;
            }
            let found = found(axis, value);
            if let Some(atom @ Atom::Symbol(symbol)) = size.as_atom()
                && !known.contains_key(atom)
                && !self.is_stored_size(symbol)
            {
                let name = format_ident!("size{}", known.len());
                checks.extend(quote!(let #name = #found;));
                known.insert(atom.clone(), (name, parameter.to_owned()));
                continue;
            }
            let Some((wanted, n, source)) = self.wanted_size(size, known) else {
                continue;
            };
            let written = size.to_string();
            checks.extend(quote! {
                rt::check_quotient_size(#parameter, #what, #found, (#wanted, #n), #written, #source)?;
            });
        }
    }

    fn items_check(
        &self,
        parameter: &str,
        item: &Type,
        value: &TokenStream,
        known: &mut BTreeMap<Atom, (proc_macro2::Ident, String)>,
        checks: &mut TokenStream,
    ) {
        for (axis, (what, size)) in sizes(item).into_iter().enumerate() {
            if size.value().is_some() {
                continue;
            }
            let found = found(axis, &quote!(item));
            let symbols: Vec<&str> = ragged_symbols(size).collect();
            let sources = symbols.iter().map(|s| self.item_size_source(s));
            if let [Some((source, _))] = sources.collect::<Vec<_>>()[..] {
                let (field, written) = (self.input_field(source), size.to_string());
                let (wanted, n) = self.item_size_terms(size);
                let source = &self.program().input(source).name;
                checks.extend(quote! {{
                    let #field = &s.#field;
                    for (k, item) in #value.iter().enumerate() {
                        rt::check_item_size(#parameter, k, #what, #found, (#wanted, #n), #written, #source)?;
                    }
                }});
            }
            if !symbols.is_empty() {
                continue;
            }
            if let Some(atom @ Atom::Symbol(symbol)) = size.as_atom()
                && !known.contains_key(atom)
                && !self.is_stored_size(symbol)
            {
                let name = format_ident!("size{}", known.len());
                checks.extend(quote!(let #name = #value.first().map_or(0, |item| #found);));
                known.insert(atom.clone(), (name, parameter.to_owned()));
            }
            let Some((wanted, n, source)) = self.wanted_size(size, known) else {
                continue;
            };
            let written = size.to_string();
            checks.extend(quote! {
                for item in #value.iter() {
                    rt::check_quotient_size(#parameter, #what, #found, (#wanted, #n), #written, #source)?;
                }
            });
        }
    }

    /// What a size should be, what that is divided by, and who says so.
    fn wanted_size(
        &self,
        size: &Dimension,
        known: &BTreeMap<Atom, (proc_macro2::Ident, String)>,
    ) -> Option<(TokenStream, TokenStream, String)> {
        let is_known = |atom: &Atom| match atom {
            Atom::Symbol(name) => known.contains_key(atom) || self.is_stored_size(name),
            Atom::Count(_) => true,
            _ => false,
        };
        if !size.atoms().all(is_known) {
            return None;
        }
        let source = size.atoms().find_map(|atom| known.get(atom));
        let source = match source {
            Some((_, parameter)) => parameter.clone(),
            None => size
                .atoms()
                .find_map(|atom| self.size_source(atom))
                .map_or(String::new(), |id| self.program().input(id).name.clone()),
        };
        let (wanted, n) = self.sum_of_terms(size, &|atom| {
            let name = &known.get(atom)?.0;
            Some(quote!(#name))
        });
        Some((wanted, n, source))
    }
}
