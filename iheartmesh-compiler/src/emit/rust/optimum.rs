//! Optima and integrals: the library gets the function as a closure.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::block::{Body, is_copy, variable_ident};
use super::place::Part;
use crate::ir::{ExprId, Fold, Kind, Restriction, no_optimum};
use crate::types::Type;

impl Body<'_> {
    /// An optimum: a tuple of the value, and where it is taken.
    pub(super) fn optimum(&mut self, e: ExprId) -> TokenStream {
        let Kind::Optimum {
            greatest,
            variables,
            start,
            restrictions,
            objective,
        } = self.kind(e)
        else {
            panic!("bug in iheartmesh: no optimum");
        };
        let (mut setup, mut unpack, mut found) =
            (TokenStream::new(), TokenStream::new(), TokenStream::new());
        for (k, (variable, value)) in variables.iter().zip(start).enumerate() {
            let like = format_ident!("like{}", k);
            let name = variable_ident(self.context, *variable);
            let ty = self.ty(*value);
            let (inner, value) = (self.context.inner_type(ty), self.owned(*value));
            setup.extend(quote! {
                let #like: #inner = #value;
                domain.variable(&#like);
            });
            unpack.extend(quote!(let #name = rt::Coordinates::like(&#like, &mut numbers);));
            // what is not copied has the type in which functions take it
            unpack.extend(match ty {
                ty if is_copy(ty) => TokenStream::new(),
                Type::Sequence { .. } => quote!(let #name = &#name[..];),
                _ => quote!(let #name = &#name;),
            });
            found.extend(quote!(rt::Coordinates::like(&#like, &mut numbers),));
        }
        for restriction in restrictions {
            let (k, bound, method) = match restriction {
                Restriction::Lower(k, bound) => (k, bound, quote!(at_least)),
                Restriction::Upper(k, bound) => (k, bound, quote!(at_most)),
                Restriction::Equal(_) | Restriction::AtMost(_) => continue,
            };
            let (k, bound) = (Literal::usize_suffixed(*k as usize), self.reference(*bound));
            setup.extend(quote!(domain.#method(#k, #bound);));
        }
        let inside = self.placement.part(e, Part::Loop);
        let before = self.statements(inside, &[]);
        let mut puts = TokenStream::new();
        for restriction in restrictions {
            let (value, list) = match restriction {
                Restriction::Equal(value) => (value, quote!(equal)),
                Restriction::AtMost(value) => (value, quote!(at_most)),
                Restriction::Lower(..) | Restriction::Upper(..) => continue,
            };
            let value = self.reference(*value);
            puts.extend(quote!(rt::Coordinates::put(#value, &mut restrictions.#list);));
        }
        let value = self.owned(*objective);
        let reasons = no_optimum(*greatest).map(|reason| self.context.site_because(e, reason));
        let [unbounded, infeasible, unsettled] = reasons;
        quote!({
            let mut domain = rt::Domain::new();
            #setup
            let found = domain.optimum(
                #greatest,
                rt::Reasons {
                    unbounded: #unbounded,
                    infeasible: #infeasible,
                    unsettled: #unsettled,
                },
                |point: &[f64], restrictions: &mut rt::Restrictions| -> rt::Fallible<f64> {
                    let mut numbers = point.iter();
                    #unpack
                    #before
                    #puts
                    ::std::result::Result::Ok(#value)
                },
            )?;
            let mut numbers = found.at.iter();
            (found.value, #found)
        })
    }

    /// An integral.
    pub(super) fn integral(&mut self, e: ExprId) -> TokenStream {
        let Kind::Integral {
            variable,
            from,
            to,
            body,
        } = self.kind(e)
        else {
            panic!("bug in iheartmesh: no integral");
        };
        let name = variable_ident(self.context, *variable);
        let (from, to) = (self.owned(*from), self.owned(*to));
        let inside = self.placement.part(e, Part::Loop);
        let before = self.statements(inside, &[]);
        let value = self.owned(*body);
        let site = self.context.site(e);
        quote!(rt::integral(
            #from,
            #to,
            |#name: f64| -> rt::Fallible<f64> {
                #before
                ::std::result::Result::Ok(#value)
            },
            #site,
        )?)
    }
}

/// Keeps the better one of a value and the best one so far. What is compared is the value, or the number before it.
pub(super) fn keep_best(op: Fold, value: TokenStream) -> TokenStream {
    let better = match op {
        Fold::Min | Fold::ArgMin => quote!(rt::is_less),
        _ => quote!(rt::is_greater),
    };
    let (number, kept) = match op {
        Fold::Min | Fold::Max => (quote!(&value), quote!(best)),
        _ => (quote!(&value.0), quote!(&best.0)),
    };
    quote!({
        let value = #value;
        if best.as_ref().is_none_or(|best| #better(#number, #kept)) {
            best = ::std::option::Option::Some(value);
        }
    })
}
