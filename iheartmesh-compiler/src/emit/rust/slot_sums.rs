//! The terms of a sum with planned places, with what they are scaled by.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::block::Body;
use super::slots::{Count, Parts, Scale, SlotSum, Term, is_in_rounds};
use crate::ir::{ExprId, GlobalId, Kind};
use crate::types::Type;

impl Body<'_> {
    /// Statements that add a sum of blocks to `data`: that of a number among those.
    pub(super) fn add_blocks(&mut self, term: &Term, number: usize) -> TokenStream {
        let number = Literal::usize_unsuffixed(number);
        let (mut before, mut after) = (TokenStream::new(), TokenStream::new());
        // from the inside to the outside
        for (k, scale) in term.scales.iter().enumerate().rev() {
            let name = format_ident!("k{}", k);
            match *scale {
                Scale::Negated => after.extend(quote!(terms[0].scale(0, -1.0);)),
                Scale::Times(factor) => {
                    let factor = self.owned(factor);
                    before.extend(quote!(let #name = #factor;));
                    after.extend(quote!(terms[0].scale(0, #name);));
                }
                Scale::Over(divisor) => {
                    let divisor = self.owned(divisor);
                    before.extend(quote!(let #name = #divisor;));
                    after.extend(quote!(terms[0].divide(0, #name);));
                }
            }
        }
        let mut kind = quote!(::std::option::Option::None);
        if is_in_rounds(self.context, self.plan, term.value)
            && let Kind::Fold { variable, .. } = self.kind(term.value)
        {
            self.rounds = Some(*variable);
            kind = self.kind_of_rounds(term.value);
        }
        let steps = self.terms(term.value);
        self.rounds = None;
        let add = quote! {
            slots.add(#kind, #number, data, totals, |range, terms, totals| {
                #steps
                #after
                ::std::result::Result::Ok(())
            })?;
        };
        match before.is_empty() {
            true => add,
            false => quote!({ #before #add }),
        }
    }

    /// Statements that add a matrix that is at hand: that of a number among those.
    pub(super) fn add_whole(&mut self, term: &Term, parts: &Parts, number: usize) -> TokenStream {
        let number = Literal::usize_unsuffixed(number);
        let mut factor = quote!(1.0f64);
        for scale in &term.scales {
            factor = match *scale {
                Scale::Negated => quote!(-(#factor)),
                Scale::Times(k) => {
                    let k = self.owned(k);
                    quote!((#factor * #k))
                }
                Scale::Over(k) => {
                    let k = self.owned(k);
                    quote!((#factor / #k))
                }
            };
        }
        match parts {
            Parts::Steady => quote!(slots.add_kept(#number, data[0], #factor);),
            _ => {
                let value = self.reference(term.value);
                quote!(slots.add_entries(#number, data[0], #factor, (#value).data());)
            }
        }
    }
}

impl Context<'_> {
    /// The field that keeps the places of a definition.
    pub(super) fn slots_field(&self, id: GlobalId) -> Option<(Ident, TokenStream)> {
        let sum = self.slot_sums.get(&id)?;
        let n = Literal::usize_unsuffixed(sum.sizes_and_keys().count());
        Some((format_ident!("slots{}", id.0), quote!(rt::Planned<#n>)))
    }

    /// How an array of a sum, by its number, becomes a value of its type; of `slots` and its entries.
    pub(super) fn filled(&self, e: ExprId, array: usize, data: &TokenStream) -> TokenStream {
        let krate = self.krate;
        let array = Literal::usize_unsuffixed(array);
        let pattern = quote!(slots.pattern(#array));
        match self.program().arena.ty(e) {
            ty if ty.is_sparse() => quote!(#pattern.matrix(#data)),
            Type::Vector { .. } => quote!(#krate::nalgebra::DVector::from_vec(#data)),
            _ => {
                let size = quote!(#pattern.rows(), #pattern.columns());
                quote!(#krate::nalgebra::DMatrix::from_vec(#size, #data))
            }
        }
    }
}

impl SlotSum {
    /// Passes over a branch that is not taken.
    pub(super) fn skip(&self, counts: &Option<Vec<Count>>) -> TokenStream {
        let Some(counts) = counts else {
            return self.each(|array| quote!(terms[#array].pass();));
        };
        let counts = counts.iter().enumerate();
        let counts = counts.filter(|(_, count)| count.values > 0);
        let counts = counts.map(|(array, count)| {
            let [array, values, pieces] =
                [array, count.values, count.pieces].map(Literal::usize_unsuffixed);
            quote!(terms[#array].skip(#values, #pieces);)
        });
        counts.collect()
    }

    /// Starts a branch that is taken.
    pub(super) fn enter(&self, counts: &Option<Vec<Count>>) -> TokenStream {
        match counts {
            Some(_) => TokenStream::new(),
            None => self.each(|array| quote!(terms[#array].enter();)),
        }
    }

    fn each(&self, code: impl Fn(Literal) -> TokenStream) -> TokenStream {
        let arrays = 0..self.arrays.len();
        arrays.map(|k| code(Literal::usize_unsuffixed(k))).collect()
    }

    /// The arrays, of which `all` are the sizes.
    pub(super) fn layouts(&self) -> TokenStream {
        let mut used = 0;
        let arrays = self.arrays.iter().map(|array| {
            let sparse = array.sparse;
            let [row, column] = [used, used + 1].map(Literal::usize_unsuffixed);
            used += array.sizes.len();
            let columns = match array.sizes.len() {
                1 => quote!(1),
                _ => quote!(rt::size(all[#column])),
            };
            quote!(rt::Layout { sparse: #sparse, rows: rt::size(all[#row]), columns: #columns },)
        });
        arrays.collect()
    }
}
