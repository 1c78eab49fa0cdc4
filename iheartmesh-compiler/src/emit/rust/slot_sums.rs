//! The terms of a sum with planned places, with what they are scaled by.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::block::Body;
use super::slots::{Parts, Scale, Term, is_in_rounds};
use crate::ir::Kind;

impl Body<'_> {
    /// Statements that add a sum of blocks to `data`: that of a number among those.
    pub(super) fn add_blocks(&mut self, term: &Term, number: usize) -> TokenStream {
        let number = Literal::usize_unsuffixed(number);
        let (mut before, mut after) = (TokenStream::new(), TokenStream::new());
        // from the inside to the outside
        for (k, scale) in term.scales.iter().enumerate().rev() {
            let name = format_ident!("k{}", k);
            match *scale {
                Scale::Negated => after.extend(quote!(terms.scale(0, -1.0);)),
                Scale::Times(factor) => {
                    let factor = self.owned(factor);
                    before.extend(quote!(let #name = #factor;));
                    after.extend(quote!(terms.scale(0, #name);));
                }
                Scale::Over(divisor) => {
                    let divisor = self.owned(divisor);
                    before.extend(quote!(let #name = #divisor;));
                    after.extend(quote!(terms.divide(0, #name);));
                }
            }
        }
        if is_in_rounds(self.context, self.plan, term.value)
            && let Kind::Fold { variable, .. } = self.kind(term.value)
        {
            self.rounds = Some(*variable);
        }
        let steps = self.terms(term.value);
        self.rounds = None;
        let add = quote! {
            slots.add(#number, data, |range, terms| {
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
            Parts::Steady => quote!(slots.add_kept(#number, data, #factor);),
            _ => {
                let value = self.reference(term.value);
                quote!(slots.add_entries(#number, data, #factor, (#value).data());)
            }
        }
    }
}
