//! Types of the language as types of Rust: inside of generated code, and at its public face.
//!
//! Inside, elements are `u32` and sets of elements sorted lists of these; outside they are handles and sets of
//! handles.

use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use crate::types::{Element, ElementKind, Number, Type};

impl Context<'_> {
    /// The handle of a kind of elements.
    pub(super) fn handle(&self, kind: ElementKind) -> TokenStream {
        let krate = self.krate;
        match kind {
            ElementKind::Vertex => quote!(#krate::Vertex),
            ElementKind::Edge => quote!(#krate::Edge),
            ElementKind::Face => quote!(#krate::Face),
            ElementKind::Cell => quote!(#krate::Cell),
        }
    }

    /// The type of a value inside of generated code.
    pub(super) fn inner_type(&self, ty: &Type) -> TokenStream {
        let krate = self.krate;
        match ty {
            Type::Scalar(Number::Real) => quote!(f64),
            Type::Scalar(Number::Integer) => quote!(i64),
            Type::Boolean => quote!(bool),
            Type::Element(_) => quote!(u32),
            Type::Vector { space: Some(_), .. } => quote!(rt::Chain),
            Type::Vector { .. } => self.vector_type(ty),
            Type::Set(item) => match **item {
                Type::Element(_) => quote!(rt::Ids),
                ref item => {
                    let item = self.inner_type(item);
                    quote!(#krate::Set<#item>)
                }
            },
            Type::Tuple(items) => {
                let items = items.iter().map(|t| self.inner_type(t));
                quote!((#(#items,)*))
            }
            Type::CellularSet(_) => quote!((rt::Ids, rt::Ids, rt::Ids, rt::Ids)),
            Type::Sequence { item, .. } => {
                let item = self.inner_type(item);
                quote!(&[#item])
            }
            Type::Matrix { .. } | Type::Function { .. } | Type::Mesh(..) | Type::Error => {
                panic!("bug in iheartmesh: no value of type {ty}")
            }
        }
    }

    fn vector_type(&self, ty: &Type) -> TokenStream {
        let krate = self.krate;
        match ty.fixed_vector() {
            Some(2) => quote!(#krate::glam::DVec2),
            Some(3) => quote!(#krate::glam::DVec3),
            Some(4) => quote!(#krate::glam::DVec4),
            _ => panic!("bug in iheartmesh: no vector of type {ty}"),
        }
    }

    /// The type of a value as the host sees it.
    pub(super) fn outer_type(&self, ty: &Type) -> TokenStream {
        let krate = self.krate;
        match ty {
            Type::Element(element) => self.handle(element.kind),
            Type::Set(item) => {
                let item = self.outer_type(item);
                quote!(#krate::Set<#item>)
            }
            Type::Tuple(items) => {
                let items = items.iter().map(|t| self.outer_type(t));
                quote!((#(#items,)*))
            }
            Type::CellularSet(_) => quote!(#krate::CellularSet),
            Type::Vector { space: Some(_), .. } | Type::Matrix { .. } => {
                quote!(#krate::sprs::CsMat<f64>)
            }
            Type::Sequence { item, .. } => {
                let item = self.outer_type(item);
                quote!(::std::vec::Vec<#item>)
            }
            _ => self.inner_type(ty),
        }
    }

    /// The type of a parameter of a method or of `new`.
    pub(super) fn parameter_type(&self, ty: &Type, lifetime: &TokenStream) -> TokenStream {
        let krate = self.krate;
        match ty {
            Type::Mesh(kind, _) => {
                let mesh = super::names::ident(&kind.to_string());
                quote!(&#lifetime #krate::#mesh)
            }
            Type::Sequence { item, .. } => {
                let item = self.outer_type(item);
                quote!(impl ::std::convert::Into<#krate::Values<#lifetime, #item>>)
            }
            Type::Set(_) | Type::CellularSet(_) => {
                let set = self.outer_type(ty);
                quote!(impl ::std::convert::Into<#krate::OwnedOrBorrowed<#lifetime, #set>>)
            }
            _ => self.outer_type(ty),
        }
    }

    /// A value from inside, given to the host.
    pub(super) fn to_outer(&self, value: TokenStream, ty: &Type) -> TokenStream {
        let krate = self.krate;
        match ty {
            Type::Element(element) => {
                let handle = self.handle(element.kind);
                quote!(#handle::new(#value))
            }
            Type::Set(item) if self.is_same_outside(item) => value,
            Type::Set(item) => match **item {
                Type::Element(_) => quote!(rt::set_of_handles(&#value)),
                ref item => {
                    let converted = self.to_outer(quote!(item), item);
                    let converted = quote!(#value.into_iter().map(|item| #converted));
                    quote!(#converted.collect::<#krate::Set<_>>())
                }
            },
            Type::Tuple(items) => {
                let names: Vec<_> = (0..items.len())
                    .map(|k| super::names::ident(&format!("item_{k}")))
                    .collect();
                let converted = items
                    .iter()
                    .zip(&names)
                    .map(|(ty, name)| self.to_outer(quote!(#name), ty));
                quote!({ let (#(#names,)*) = #value; (#(#converted,)*) })
            }
            Type::CellularSet(_) => quote!(rt::cellular_set(#value)),
            Type::Vector {
                space: Some(element),
                ..
            } => {
                let n = self.count(*element);
                quote!(rt::chain_as_matrix(&#value, #n))
            }
            _ => value,
        }
    }

    fn is_same_outside(&self, ty: &Type) -> bool {
        match ty {
            Type::Element(_) | Type::CellularSet(_) => false,
            Type::Tuple(items) => items.iter().all(|t| self.is_same_outside(t)),
            Type::Set(item) => self.is_same_outside(item),
            _ => true,
        }
    }

    /// A value from the host, as it is inside. `value` has the type of [`Context::outer_type`].
    pub(super) fn to_inner(&self, value: TokenStream, ty: &Type) -> TokenStream {
        match ty {
            Type::Element(_) => quote!(#value.id()),
            Type::Set(item) if self.is_same_outside(item) => quote!(#value.clone()),
            Type::Set(item) => match **item {
                Type::Element(_) => quote!(rt::ids_of_set(#value)),
                ref item => {
                    let converted = self.to_inner(quote!(item), item);
                    quote!(#value.iter().map(|item| #converted).collect())
                }
            },
            Type::Tuple(items) => {
                let converted = items.iter().enumerate().map(|(k, ty)| {
                    let k = proc_macro2::Literal::usize_unsuffixed(k);
                    self.to_inner(quote!(#value.#k), ty)
                });
                quote!((#(#converted,)*))
            }
            Type::CellularSet(_) => quote!(rt::ids_of_cellular_set(#value)),
            _ => value,
        }
    }

    /// Number of the elements of a kind, as `usize`; needs `t`, the topology.
    pub(super) fn count(&self, element: Element) -> TokenStream {
        let mesh = self.mesh_field(element.mesh);
        let dimension = crate::types::element_dimension(element.kind);
        quote!(t.#mesh.complex().n(#dimension))
    }

    /// The zero of a type that has sums.
    pub(super) fn zero_of(&self, ty: &Type) -> TokenStream {
        match ty {
            Type::Scalar(Number::Real) => quote!(0.0f64),
            Type::Scalar(Number::Integer) => quote!(0i64),
            _ => {
                let ty = self.inner_type(ty);
                quote!(#ty::ZERO)
            }
        }
    }
}
