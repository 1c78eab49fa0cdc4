//! The blocks of single elements whose eigenvalues are replaced, in sums with planned places: put together in a small matrix
//! of fixed size, and multiplied where a product with such a sum is computed.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::block::Body;
use super::place::Part;
use super::slots::Unit;
use crate::ir::{Binary, Block, ExprId, Kind, Unary};

impl Body<'_> {
    /// The block of one element with its eigenvalues replaced.
    pub(super) fn symmetric(
        &mut self,
        e: ExprId,
        op: Unary,
        a: ExprId,
        unit: &Unit,
    ) -> TokenStream {
        let (block, places, part) = self.unit(op, a, unit);
        let (site, array) = (self.context.site(e), self.array_number());
        quote!(terms[#array].symmetric(#block, [#(#places),*], #part, #site)?;)
    }

    /// The product of such a block and the rows of a vector or dense matrix at its places.
    pub(super) fn symmetric_product(
        &mut self,
        e: ExprId,
        block: ExprId,
        factor: ExprId,
        unit: &Unit,
    ) -> TokenStream {
        let Kind::Unary(op, a) = *self.kind(block) else {
            panic!("bug in iheartmesh: no block");
        };
        let (block, places, part) = self.unit(op, a, unit);
        let factor = self.reference(factor);
        let (site, array) = (self.context.site(e), self.array_number());
        quote!(terms[#array].symmetric_product(#block, [#(#places),*], #part, #factor, #site)?;)
    }

    /// A block, its places, and what replaces its eigenvalues.
    fn unit(
        &mut self,
        op: Unary,
        a: ExprId,
        unit: &Unit,
    ) -> (TokenStream, Vec<TokenStream>, TokenStream) {
        let block = self.local_block(unit, a);
        let places = self.places(&unit.places);
        let part = match op {
            Unary::PositivePart => quote!(rt::Part::Positive),
            _ => quote!(rt::Part::Absolute),
        };
        (block, places, part)
    }

    fn local_block(&mut self, unit: &Unit, e: ExprId) -> TokenStream {
        let [parts, height, rows, less] = [
            unit.places.len(),
            unit.height,
            unit.places.len() * unit.height,
            (unit.places.len() - 1) * unit.height,
        ]
        .map(Literal::usize_unsuffixed);
        let steps = self.local_terms(unit, e);
        quote!({ let mut block = rt::LocalBlock::<#parts, #height, #rows, #less>::new(); #steps block })
    }

    /// Statements that add to `block`.
    fn local_terms(&mut self, unit: &Unit, e: ExprId) -> TokenStream {
        match self.kind(e) {
            Kind::Assemble { blocks, .. } => {
                let blocks = blocks.iter().map(|block| self.add_local(unit, block));
                blocks.collect()
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let k = self.owned(*k);
                let inner = self.local_block(unit, *a);
                quote!({ let (k, mut inner) = (#k, #inner); inner.scale(k); block.merge(&inner); })
            }
            Kind::Binary(_, a, b) => {
                let (a, b) = (self.local_terms(unit, *a), self.local_terms(unit, *b));
                quote!(#a #b)
            }
            Kind::If(condition, a, b) => {
                let condition = self.owned(*condition);
                let branches = [(Part::Then, *a), (Part::Else, *b)].map(|(part, value)| {
                    let region = self.placement.part(e, part);
                    let statements = self.statements(region, &[]);
                    let steps = self.local_terms(unit, value);
                    quote!({ #statements #steps })
                });
                let [then, otherwise] = branches;
                quote!(if #condition #then else #otherwise)
            }
            other => panic!("bug in iheartmesh: no blocks in {other:?}"),
        }
    }

    fn add_local(&mut self, unit: &Unit, block: &Block) -> TokenStream {
        let value = self.reference(block.value);
        let known = match block.core {
            None => quote!(block.without_core();),
            Some(core) => {
                let n = self.context.fixed_shape(core).map(|(n, _)| n);
                let n = Literal::usize_unsuffixed(n.unwrap_or(0));
                let core = self.reference(core);
                quote!(block.with_core::<#n>(#core);)
            }
        };
        let at = |places: &[ExprId]| -> Vec<Literal> {
            let numbers = places.iter().filter_map(|place| {
                let mut known = unit.places.iter();
                known.position(|p| p == place)
            });
            numbers.map(Literal::usize_unsuffixed).collect()
        };
        let (rows, columns) = (at(&block.rows), at(&block.columns));
        quote!(block.add([#(#rows),*], [#(#columns),*], #value); #known)
    }
}
