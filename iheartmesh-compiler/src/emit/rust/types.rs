//! Types of the language as types of Rust: inside of generated code, and at its public face.
//!
//! Inside, elements are `u32` and sets of elements sorted lists of these; outside they are handles and sets of
//! handles.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use crate::types::{Atom, Dimension, Element, ElementKind, Number, Shape, Type};

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
            Type::Matrix {
                spaces: Some(_), ..
            } => quote!(#krate::sprs::CsMat<f64>),
            Type::Vector { .. } | Type::Matrix { .. } => self.array_type(ty),
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
                quote!(::std::vec::Vec<#item>)
            }
            Type::Function { .. } => {
                let function = self.function_type(ty, &quote!('_));
                quote!(&(#function))
            }
            Type::Mesh(..) | Type::Error => {
                panic!("bug in iheartmesh: no value of type {ty}")
            }
        }
    }

    /// The type of a function of the host, behind a pointer.
    pub(super) fn function_type(&self, ty: &Type, lifetime: &TokenStream) -> TokenStream {
        let Type::Function { parameters, result } = ty else {
            panic!("bug in iheartmesh: {ty} is no function");
        };
        let parameters = parameters.iter().map(|t| self.outer_type(t));
        let result = self.outer_type(result);
        quote! {
            dyn ::std::ops::Fn(#(#parameters),*) -> #result + ::std::marker::Send + ::std::marker::Sync + #lifetime
        }
    }

    /// The Rust type of a vector or matrix: glam up to 4, nalgebra of a fixed size, nalgebra's dynamic ones, sprs.
    fn array_type(&self, ty: &Type) -> TokenStream {
        let krate = self.krate;
        let item = match ty.is_integer() {
            true => quote!(i64),
            false => quote!(f64),
        };
        let fixed = |n: i64| proc_macro2::Literal::i64_unsuffixed(n);
        match ty {
            Type::Matrix { sparse: true, .. } | Type::Vector { sparse: true, .. } => {
                quote!(#krate::sprs::CsMat<f64>)
            }
            Type::Vector { length, .. } => match (length.value(), ty.is_integer()) {
                (Some(2), false) => quote!(#krate::glam::DVec2),
                (Some(3), false) => quote!(#krate::glam::DVec3),
                (Some(4), false) => quote!(#krate::glam::DVec4),
                (Some(n), _) => {
                    let n = fixed(n);
                    quote!(#krate::nalgebra::SVector<#item, #n>)
                }
                (None, _) => quote!(#krate::nalgebra::DVector<#item>),
            },
            Type::Matrix { rows, columns, .. } => {
                match (rows.value(), columns.value(), ty.is_integer()) {
                    (Some(2), Some(2), false) => quote!(#krate::glam::DMat2),
                    (Some(3), Some(3), false) => quote!(#krate::glam::DMat3),
                    (Some(4), Some(4), false) => quote!(#krate::glam::DMat4),
                    (Some(n), Some(m), _) => {
                        let (n, m) = (fixed(n), fixed(m));
                        quote!(#krate::nalgebra::SMatrix<#item, #n, #m>)
                    }
                    _ => quote!(#krate::nalgebra::DMatrix<#item>),
                }
            }
            _ => panic!("bug in iheartmesh: no array of type {ty}"),
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
            Type::Vector { space: Some(_), .. } => quote!(#krate::sprs::CsMat<f64>),
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
            Type::Sequence { item, .. } if super::item::is_functions(ty) => {
                let item = self.parameter_type(item, lifetime);
                quote!(impl ::std::iter::IntoIterator<Item = #item>)
            }
            Type::Sequence { item, .. } => {
                let item = self.outer_type(item);
                quote!(impl ::std::convert::Into<#krate::Values<#lifetime, #item>>)
            }
            Type::Function { parameters, result } => {
                let parameters = parameters.iter().map(|t| self.outer_type(t));
                let result = self.outer_type(result);
                quote!(impl ::std::ops::Fn(#(#parameters),*) -> #result + ::std::marker::Send + ::std::marker::Sync + #lifetime)
            }
            ty if super::item::is_converted(ty) => {
                let value = self.outer_type(ty);
                quote!(impl ::std::convert::Into<#krate::OwnedOrBorrowed<#lifetime, #value>>)
            }
            _ => self.outer_type(ty),
        }
    }

    /// The type in which a function takes a value: what is not copied goes by reference.
    pub(super) fn argument_type(&self, ty: &Type) -> TokenStream {
        match ty {
            _ if super::block::is_copy(ty) => self.inner_type(ty),
            ty if ty.element_of_set().is_some() => quote!(&[u32]),
            Type::Sequence { item, .. } if super::item::is_functions(ty) => {
                let function = self.function_type(item, &quote!('_));
                quote!(&[::std::boxed::Box<#function>])
            }
            Type::Sequence { item, .. } => {
                let item = self.inner_type(item);
                quote!(&[#item])
            }
            _ => {
                let inner = self.inner_type(ty);
                quote!(&#inner)
            }
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
            Type::Sequence { item, .. } if !self.is_same_outside(item) => {
                let converted = self.to_outer(quote!(item), item);
                quote!(#value.into_iter().map(|item| #converted).collect())
            }
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

    pub(super) fn is_same_outside(&self, ty: &Type) -> bool {
        match ty {
            Type::Element(_) | Type::CellularSet(_) => false,
            Type::Tuple(items) => items.iter().all(|t| self.is_same_outside(t)),
            Type::Set(item) | Type::Sequence { item, .. } => self.is_same_outside(item),
            _ => true,
        }
    }

    /// A value that a function of the host gave.
    pub(super) fn given_by_host(&self, call: TokenStream, ty: &Type) -> TokenStream {
        match self.is_same_outside(ty) {
            true => call,
            false => {
                let inner = self.to_inner(quote!(value), ty);
                match ty {
                    Type::Element(_) | Type::Tuple(_) => quote!({ let value = #call; #inner }),
                    _ => quote!({ let value = &#call; #inner }),
                }
            }
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
                    let krate = self.krate;
                    quote!(#value.iter().map(|item| #converted).collect::<#krate::Set<_>>())
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
            Type::Function { .. } => quote!(&#value),
            Type::Sequence { item, .. } if !self.is_same_outside(item) => {
                let converted = self.to_inner(quote!(item), item);
                quote!(#value.iter().map(|item| #converted).collect::<::std::vec::Vec<_>>())
            }
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
        match self.known_zero_of(ty, &BTreeMap::new()) {
            Some(zero) => zero,
            None => panic!("bug in iheartmesh: no zero of {ty}"),
        }
    }

    /// The zero of a type, where its sizes are known from parameters of the program, the mesh, or `sizes` of the function
    /// at hand.
    pub(super) fn known_zero_of(
        &self,
        ty: &Type,
        sizes: &BTreeMap<Atom, TokenStream>,
    ) -> Option<TokenStream> {
        Some(match ty {
            Type::Scalar(Number::Real) => quote!(0.0f64),
            Type::Scalar(Number::Integer) => quote!(0i64),
            _ => {
                let inner = self.inner_type(ty);
                let size = |dimension: &Dimension| {
                    let size = self.known_size(dimension, sizes)?;
                    Some(quote!(rt::size(#size)))
                };
                let (rows, columns) = match ty.shape() {
                    Some(Shape::Vector(n)) if !is_glam(ty) => (size(&n)?, quote!(1usize)),
                    Some(Shape::Matrix(n, m)) if !is_glam(ty) => (size(&n)?, size(&m)?),
                    _ => return Some(quote!(#inner::ZERO)),
                };
                match ty.is_sparse() {
                    true => quote!(rt::sparse_zeros(#rows, #columns)),
                    false => quote!(<#inner as rt::Build>::zeros(#rows, #columns)),
                }
            }
        })
    }

    /// A size as `i64`; needs `s` for symbols and `t` for numbers of elements.
    pub(super) fn size(&self, dimension: &Dimension) -> TokenStream {
        match self.known_size(dimension, &BTreeMap::new()) {
            Some(size) => size,
            None => panic!("bug in iheartmesh: the size {dimension} is not known"),
        }
    }

    /// A size as `i64`, where parameters of the program, the mesh, or `sizes` of the function at hand give it.
    pub(super) fn known_size(
        &self,
        dimension: &Dimension,
        sizes: &BTreeMap<Atom, TokenStream>,
    ) -> Option<TokenStream> {
        if let Some(n) = dimension.value() {
            let n = proc_macro2::Literal::i64_suffixed(n);
            return Some(quote!(#n));
        }
        let mut terms = Vec::new();
        for (k, atoms) in dimension.terms() {
            let k = proc_macro2::Literal::i64_suffixed(k);
            let mut factors = Vec::new();
            for atom in atoms {
                factors.push(match atom {
                    atom if sizes.contains_key(atom) => sizes[atom].clone(),
                    Atom::Count(element) => {
                        let n = self.count(*element);
                        quote!((#n as i64))
                    }
                    Atom::Symbol(name) | Atom::Length(name) if self.has_source(atom) => {
                        let field = self.size_field(atom, name);
                        quote!(sizes.#field)
                    }
                    _ => return None,
                });
            }
            terms.push(quote!(#k #(* #factors)*));
        }
        Some(match dimension.denominator() {
            1 => quote!((0i64 #(+ #terms)*)),
            n => {
                let n = proc_macro2::Literal::i64_suffixed(n);
                quote!(((0i64 #(+ #terms)*) / #n))
            }
        })
    }

    /// The field that holds a size.
    pub(super) fn size_field(&self, atom: &crate::types::Atom, name: &str) -> proc_macro2::Ident {
        let name = super::names::rust_name(name);
        match atom {
            crate::types::Atom::Length(_) => quote::format_ident!("length_{}", name),
            _ => quote::format_ident!("size_{}", name),
        }
    }
}

/// Whether a type is one of glam's.
pub(super) fn is_glam(ty: &Type) -> bool {
    let small = |n: i64| (2..=4).contains(&n);
    match ty {
        _ if ty.is_integer() || ty.is_sparse() => false,
        Type::Vector { length, .. } => length.value().is_some_and(small),
        Type::Matrix { rows, columns, .. } => rows.value().is_some_and(small) && rows == columns,
        _ => false,
    }
}
