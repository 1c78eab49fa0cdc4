//! Sizes of parameters that must be the same because one index runs over both.

use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use crate::ir::InputId;
use crate::types::display::plural;
use crate::types::{Atom, Dimension};

/// What has one of two sizes.
struct Side {
    /// The parameter, and its place in the order of declaration; nothing for a mesh.
    input: Option<(usize, InputId)>,
    name: String,
    what: String,
    /// The size, as `i64`.
    found: TokenStream,
}

impl Side {
    fn is_of(&self, id: InputId) -> bool {
        self.input.is_some_and(|(_, own)| own == id)
    }
}

impl Context<'_> {
    /// Checks the sizes of an input against those that they must be the same as. `again` after construction; before, against
    /// the inputs that are declared before it.
    pub(super) fn tie_checks(&self, id: InputId, again: bool) -> TokenStream {
        let mut checks = TokenStream::new();
        for tie in &self.program().ties {
            let number = tie
                .sizes
                .iter()
                .find_map(|size| Some((size, size.value()?)));
            if let Some((number, n)) = number {
                for side in tie.sizes.iter().filter(|size| *size != number) {
                    let Some(side) = self.side(side).filter(|s| s.is_of(id)) else {
                        continue;
                    };
                    let (name, what, found) = (&side.name, &side.what, &side.found);
                    let written = number.to_string();
                    checks.extend(quote!(rt::check_size(#name, #what, #found, #n, #written, "")?;));
                }
                continue;
            }
            let [Some(a), Some(b)] = tie.sizes.each_ref().map(|size| self.side(size)) else {
                continue;
            };
            // the later one does not fit to the earlier one
            let (first, second) = match a.input.map(|i| i.0) <= b.input.map(|i| i.0) {
                true => (a, b),
                false => (b, a),
            };
            let (mut first, mut second) = (first, second);
            if again && first.is_of(id) {
                (first, second) = (second, first);
            }
            if !second.is_of(id) {
                continue;
            }
            let (name, what, found) = (&second.name, &second.what, &second.found);
            let (other, its, wanted) = (&first.name, &first.what, &first.found);
            let index = &tie.index;
            checks.extend(quote! {
                rt::check_tied((#name, #what, #found), (#other, #its, #wanted), #index)?;
            });
        }
        checks
    }

    fn side(&self, size: &Dimension) -> Option<Side> {
        if let Some(Atom::Count(element)) = size.as_atom() {
            return Some(Side {
                input: None,
                name: self.program().mesh(element.mesh).name.clone(),
                what: format!("number of {}", plural(element.kind)),
                found: self.size(size),
            });
        }
        for (place, (id, input)) in self.values().enumerate() {
            if let Some(axis) = self
                .axes(id, input)
                .into_iter()
                .find(|axis| axis.dimension == *size && !axis.of_items)
            {
                return Some(Side {
                    input: Some((place, id)),
                    name: input.name.clone(),
                    what: axis.what.to_owned(),
                    found: axis.found,
                });
            }
        }
        None
    }
}
