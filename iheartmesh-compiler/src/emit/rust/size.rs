//! Sizes: where the symbols of a size get their values, and the checks that all inputs agree on them.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Context;
use crate::ir::{ExprId, Input, InputId, Kind, Parameter};
use crate::types::{Atom, Dimension, Type};

/// One direction of an input.
pub(super) struct Axis {
    /// What it is called in messages.
    pub(super) what: &'static str,
    pub(super) dimension: Dimension,
    /// Its size, as `i64`, of the field at hand.
    pub(super) found: TokenStream,
    /// Whether it is of every item of a sequence.
    pub(super) of_items: bool,
    /// For one of every item: that of the first one, as `Option<i64>`.
    first: Option<TokenStream>,
}

impl Context<'_> {
    /// Every symbol of a size with the expression of its value: that of the first input that has it.
    pub(super) fn size_sources(&self) -> Vec<(Ident, TokenStream)> {
        let mut seen = BTreeSet::new();
        let mut sources = Vec::new();
        // a parameter that is the size itself comes first
        for (id, input) in self.values() {
            if matches!(input.ty, Type::Scalar(crate::types::Number::Integer))
                && self.is_size(&input.name)
            {
                let atom = Atom::Symbol(input.name.clone());
                let field = self.input_field(id);
                seen.insert(atom.clone());
                sources.push((self.size_field(&atom, &input.name), quote!(#field)));
            }
        }
        // sequences may be empty, and then their items say nothing
        for of_items in [false, true] {
            for (id, input) in self.values() {
                for axis in self.axes(id, input) {
                    if axis.of_items == of_items
                        && let Some(atom @ (Atom::Symbol(name) | Atom::Length(name))) =
                            axis.dimension.as_atom()
                        && seen.insert(atom.clone())
                    {
                        let found = match of_items {
                            true => self.size_of_items(atom),
                            false => axis.found,
                        };
                        sources.push((self.size_field(atom, name), found));
                    }
                }
            }
        }
        // a symbol that no input gives a value is reported before code is made
        sources
    }

    /// A size that only the items of sequences have: that of the first item there is; where it is needed and there is none,
    /// an error.
    fn size_of_items(&self, atom: &Atom) -> TokenStream {
        let mut all = Vec::new();
        let mut names = Vec::new();
        for (id, input) in self.values() {
            for axis in self.axes(id, input) {
                if axis.dimension.as_atom() == Some(atom) {
                    all.push(axis.first.unwrap_or(axis.found));
                    names.push(input.name.clone());
                }
            }
        }
        names.dedup();
        let found = quote!(::std::option::Option::None #(.or_else(|| #all))*);
        match self.is_computed_with(atom) {
            true => {
                let size = Dimension::atom(atom.clone()).to_string();
                quote!(rt::known_size(#found, #size, &[#(#names),*])?)
            }
            false => quote!(#found.unwrap_or(0)),
        }
    }

    fn is_size(&self, name: &str) -> bool {
        let atom = Atom::Symbol(name.to_owned());
        self.values()
            .any(|(id, input)| self.has_size(id, input, &atom))
            || self.is_computed_with(&atom)
    }

    /// Whether a size is computed from a symbol.
    fn is_computed_with(&self, atom: &Atom) -> bool {
        let arena = &self.program().arena;
        (0..arena.len() as u32).any(|e| {
            let e = ExprId(e);
            match arena.kind(e) {
                Kind::Size(size) => size.atoms().any(|other| other == atom),
                Kind::Fold { .. } | Kind::Tabulate { .. } => {
                    let mut found = false;
                    arena.ty(e).atoms(&mut |other| found |= other == atom);
                    found
                }
                _ => false,
            }
        })
    }

    /// Whether a symbol of a size has a value in `sizes`.
    pub(super) fn is_stored_size(&self, name: &str) -> bool {
        self.is_size(name) && self.size_source(&Atom::Symbol(name.to_owned())).is_some()
    }

    /// Whether a symbol occurs in a size of an input.
    fn has_size(&self, id: InputId, input: &Input, atom: &Atom) -> bool {
        self.axes(id, input).iter().any(|axis| {
            axis.dimension
                .terms()
                .any(|(_, atoms)| atoms.contains(atom))
        })
    }

    /// The sizes that arguments bring along, as `i64`.
    pub(super) fn sizes_of(&self, parameters: &[Parameter]) -> BTreeMap<Atom, TokenStream> {
        let mut sizes = BTreeMap::new();
        // sequences may be empty, and then their items say nothing
        let is_list = |p: &&Parameter| matches!(p.ty, Type::Sequence { .. });
        let others = parameters.iter().filter(|p| !is_list(p));
        for parameter in others.chain(parameters.iter().filter(is_list)) {
            let name = super::block::variable_ident(self, parameter.variable);
            let axes = match &parameter.ty {
                Type::Vector { length, .. } => {
                    vec![(length, quote!(rt::Array::rows(#name) as i64))]
                }
                Type::Matrix { rows, columns, .. } => vec![
                    (rows, quote!(rt::Array::rows(#name) as i64)),
                    (columns, quote!(rt::Array::columns(#name) as i64)),
                ],
                Type::Sequence { item, length, .. } => {
                    let mut axes = vec![(length, quote!(#name.len() as i64))];
                    // all items have the size of the first one
                    let first = |size| quote!(#name.first().map_or(0, |item| #size as i64));
                    match &**item {
                        Type::Vector { length, .. } => {
                            axes.push((length, first(quote!(rt::Array::rows(item)))));
                        }
                        Type::Matrix { rows, columns, .. } => {
                            axes.push((rows, first(quote!(rt::Array::rows(item)))));
                            axes.push((columns, first(quote!(rt::Array::columns(item)))));
                        }
                        _ => {}
                    }
                    axes
                }
                _ => Vec::new(),
            };
            for (dimension, size) in axes {
                if let Some(atom @ (Atom::Symbol(_) | Atom::Length(_))) = dimension.as_atom()
                    && !self.has_source(atom)
                {
                    sizes.entry(atom.clone()).or_insert(quote!((#size)));
                }
            }
        }
        sizes
    }

    /// Whether an input gives a symbol its value.
    pub(super) fn has_source(&self, atom: &Atom) -> bool {
        self.size_source(atom).is_some()
    }

    /// The input that gives a symbol its value.
    pub(super) fn size_source(&self, atom: &Atom) -> Option<InputId> {
        if let Atom::Symbol(name) = atom
            && let Some((id, _)) = self.values().find(|(_, i)| {
                i.name == *name && matches!(i.ty, Type::Scalar(crate::types::Number::Integer))
            })
        {
            return Some(id);
        }
        [false, true].into_iter().find_map(|of_items| {
            self.values()
                .find(|(id, input)| {
                    self.axes(*id, input).iter().any(|axis| {
                        axis.of_items == of_items && axis.dimension.as_atom() == Some(atom)
                    })
                })
                .map(|(id, _)| id)
        })
    }

    /// The directions of an input, for its field at hand.
    pub(super) fn axes(&self, id: InputId, input: &Input) -> Vec<Axis> {
        let field = self.input_field(id);
        let axis = |what, dimension: &Dimension, found, of_items| Axis {
            what,
            dimension: dimension.clone(),
            found,
            of_items,
            first: None,
        };
        let of = |value: TokenStream, ty: &Type, of_items: bool| match ty {
            Type::Vector {
                length,
                space: None,
                ..
            } => {
                vec![axis(
                    "length",
                    length,
                    quote!((rt::Array::rows(#value) as i64)),
                    of_items,
                )]
            }
            Type::Matrix {
                rows,
                columns,
                spaces: None,
                ..
            } => vec![
                axis(
                    "number of rows",
                    rows,
                    quote!((rt::Array::rows(#value) as i64)),
                    of_items,
                ),
                axis(
                    "number of columns",
                    columns,
                    quote!((rt::Array::columns(#value) as i64)),
                    of_items,
                ),
            ],
            _ => Vec::new(),
        };
        match &input.ty {
            Type::Sequence { item, length, .. } => {
                let mut axes = vec![axis(
                    "length",
                    length,
                    quote!((#field.as_ref().len() as i64)),
                    false,
                )];
                let first = of(quote!(item), item, true);
                axes.extend(first.into_iter().map(|a| {
                    let found = &a.found;
                    let first = quote!(#field.as_ref().first().map(|item| #found));
                    Axis {
                        found: quote!(#first.unwrap_or(0)),
                        first: Some(first),
                        ..a
                    }
                }));
                axes
            }
            ty => {
                let value = match super::block::is_copy(ty) {
                    true => quote!(&#field),
                    false => quote!(#field.as_ref()),
                };
                of(value, ty, false)
            }
        }
    }

    /// Whether no other input has the symbols of a size.
    fn is_alone(&self, dimension: &Dimension, id: InputId) -> bool {
        let of = |d: &Dimension| {
            d.terms()
                .flat_map(|(_, atoms)| atoms.to_vec())
                .collect::<BTreeSet<_>>()
        };
        let own = of(dimension);
        self.values()
            .filter(|(other, _)| *other != id)
            .all(|(other, input)| {
                self.axes(other, input)
                    .iter()
                    .all(|axis| of(&axis.dimension).is_disjoint(&own))
            })
    }

    /// The sizes that change with new values of an input: those that only it has.
    pub(super) fn size_updates(&self, id: InputId, input: &Input) -> TokenStream {
        let itself = self.changing_size(id, input).map(|atom| {
            let (size, field) = (self.size_field(&atom, &input.name), self.input_field(id));
            quote!(self.state.sizes.#size = #field;)
        });
        self.changing_axes(id, input)
            .map(|(field, _, found)| quote!(self.state.sizes.#field = #found;))
            .chain(itself)
            .collect()
    }

    /// A parameter that is a size which no other has.
    fn changing_size(&self, id: InputId, input: &Input) -> Option<Atom> {
        let atom = Atom::Symbol(input.name.clone());
        let is_shared = self
            .values()
            .any(|(other, input)| other != id && self.has_size(other, input, &atom));
        (input.ty == Type::INTEGER && !is_shared && self.is_computed_with(&atom)).then_some(atom)
    }

    /// The symbols of sizes that only an input has.
    pub(super) fn own_sizes(&self, id: InputId, input: &Input) -> BTreeSet<Atom> {
        self.changing_axes(id, input)
            .map(|(_, atom, _)| atom)
            .chain(self.changing_size(id, input))
            .collect()
    }

    /// The fields of these sizes, their symbols, and their new values.
    fn changing_axes(
        &self,
        id: InputId,
        input: &Input,
    ) -> impl Iterator<Item = (Ident, Atom, TokenStream)> {
        self.axes(id, input)
            .into_iter()
            .filter(move |axis| self.is_alone(&axis.dimension, id))
            .filter_map(move |axis| match axis.dimension.as_atom() {
                Some(atom @ (Atom::Symbol(name) | Atom::Length(name)))
                    if self.size_source(atom) == Some(id) =>
                {
                    let found = match axis.of_items {
                        true => self.size_of_items(atom),
                        false => axis.found,
                    };
                    Some((self.size_field(atom, name), atom.clone(), found))
                }
                _ => None,
            })
    }

    /// Whether an input is a sequence whose length is only that of other sequences, or the number of elements of a mesh.
    fn is_compared_as_length(&self, input: &Input) -> bool {
        let Type::Sequence { length, .. } = &input.ty else {
            return false;
        };
        let Some(atom @ Atom::Length(_)) = length.as_atom() else {
            return true;
        };
        self.values().all(|(id, other)| {
            let is_sequence = matches!(other.ty, Type::Sequence { .. });
            let axes = self.axes(id, other);
            let inner = axes.iter().skip(usize::from(is_sequence));
            inner
                .flat_map(|axis| axis.dimension.terms())
                .all(|(_, atoms)| !atoms.contains(atom))
        })
    }

    /// Checks that an input has the sizes that it is declared with. `again` after construction, when sizes are fixed.
    pub(super) fn size_checks(&self, id: InputId, input: &Input, again: bool) -> TokenStream {
        let name = &input.name;
        let field = self.input_field(id);
        let mut checks = TokenStream::new();
        // a parameter that is the size itself stays as it is where another one has this size
        let atom = Atom::Symbol(name.clone());
        let holder = self
            .values()
            .find(|(other, input)| *other != id && self.has_size(*other, input, &atom));
        if again
            && input.ty == Type::INTEGER
            && let Some((_, holder)) = holder
        {
            let (size, holder) = (self.size_field(&atom, name), &holder.name);
            checks.extend(
                quote!(rt::check_size(#name, "value", #field, sizes.#size, #name, #holder)?;),
            );
        }
        checks.extend(self.item_size_checks(id, again));
        let axes = self.axes(id, input);
        for (k, axis) in axes.iter().enumerate() {
            if axis.dimension.is_ragged() {
                continue;
            }
            if axis.dimension.value().is_some() || k == 0 && self.is_compared_as_length(input) {
                // the one is in the type, the other is compared with the mesh or with other sequences
                continue;
            }
            let source = axis
                .dimension
                .terms()
                .flat_map(|(_, atoms)| atoms)
                .filter(|atom| !matches!(atom, Atom::Count(_)))
                .find_map(|atom| self.size_source(atom));
            let is_source = source == Some(id) && axis.dimension.as_atom().is_some();
            // a size that stands twice in one type: the first time gives the value
            let first = axes[..k]
                .iter()
                .find(|other| is_source && other.dimension == axis.dimension);
            let is_source = is_source && first.is_none();
            let expected = match first {
                Some(first) => first.found.clone(),
                None => self.size(&axis.dimension),
            };
            if axis.dimension.denominator() != 1 {
                let (above, below) = self.sum_of_terms(&axis.dimension, &|_| None);
                let written = axis.dimension.to_string();
                checks.extend(quote!(rt::check_quotient(#name, #above, #below, #written)?;));
            }
            let (what, written) = (axis.what, axis.dimension.to_string());
            let mesh = axis.dimension.terms().flat_map(|(_, atoms)| atoms);
            let mesh = mesh.filter_map(|atom| match atom {
                Atom::Count(element) => Some(self.program().mesh(element.mesh).name.clone()),
                _ => None,
            });
            let source_name = source
                .map(|s| self.program().input(s).name.clone())
                .or_else(|| mesh.last())
                .unwrap_or_default();
            if !axis.of_items && !(is_source && (!again || self.is_alone(&axis.dimension, id))) {
                let found = &axis.found;
                checks.extend(quote!(rt::check_size(#name, #what, #found, #expected, #written, #source_name)?;));
            }
            if axis.of_items {
                let found = match axis.what {
                    "number of columns" => quote!(rt::Array::columns(item)),
                    _ => quote!(rt::Array::rows(item)),
                };
                checks.extend(quote! {
                    for item in #field.as_ref() {
                        rt::check_size(#name, #what, #found as i64, #expected, #written, #source_name)?;
                    }
                });
            }
        }
        checks
    }
}
