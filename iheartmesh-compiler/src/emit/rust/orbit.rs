//! Evaluation of a function for all elements at once: fields and orbits.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::block::{Body, Mode, variable_ident};
use super::item::field_name;
use super::place::{RegionId, Roots};
use super::plan::PlanCode;
use crate::ir::{FunctionId, Kind};
use crate::optimize::{Orbit, Plan, Staged, Whole};
use crate::types::Type;

impl Context<'_> {
    fn orbit_name(&self, id: FunctionId, orbit: &Orbit) -> Ident {
        format_ident!("orbits{}", self.first_with_orbits(id, orbit).0)
    }

    /// The first function whose rows form the same groups.
    fn first_with_orbits(&self, id: FunctionId, orbit: &Orbit) -> FunctionId {
        let groups = |id: FunctionId, orbit: &Orbit| {
            let key = self.program().function(id).parameters[0].ty.clone();
            let table = self.table_name(orbit.space);
            let exchange = (orbit.columns.clone(), orbit.permutation.clone());
            (key, table, exchange, orbit.terms.len())
        };
        let own = groups(id, orbit);
        let mut functions = self.staged.functions.iter();
        let same = functions.find(|(other, staged)| {
            let orbit = staged.whole.as_ref().and_then(|w| w.orbit.as_ref());
            orbit.is_some_and(|orbit| groups(**other, orbit) == own)
        });
        same.map_or(id, |(first, _)| *first)
    }

    /// The table of the orbits of a function.
    pub(super) fn orbit_plan(&self, id: FunctionId, orbit: &Orbit, code: &mut PlanCode) {
        if self.first_with_orbits(id, orbit) != id {
            return;
        }
        let name = self.orbit_name(id, orbit);
        let table = self.table_name(orbit.space);
        let elements = Literal::usize_unsuffixed(orbit.elements.len());
        let members = Literal::usize_unsuffixed(orbit.terms.len());
        let columns = orbit.columns.iter().map(|c| Literal::u32_unsuffixed(*c));
        let permutation = orbit
            .permutation
            .iter()
            .map(|p| Literal::usize_unsuffixed(*p));
        let parameter = &self.program().function(id).parameters[0];
        let keys = match parameter.ty {
            Type::Element(element) => self.keys(element),
            _ => quote!(rt::Keys::in_order()),
        };
        code.fields
            .extend(quote!(pub #name: ::std::option::Option<rt::Orbits<#elements, #members>>,));
        code.names.extend(quote!(#name,));
        code.statements.extend(quote! {
            let #name = rt::Orbits::<#elements, #members>::build(&#table, &[#(#columns),*], [#(#permutation),*], #keys);
        });
    }

    /// The functions that evaluate a function for all elements; `None` where evaluating it for each is all there is.
    pub(super) fn whole(&self, id: FunctionId, staged: &Staged) -> Option<(Ident, TokenStream)> {
        let whole = staged.whole.as_ref()?;
        let function = self.program().function(id);
        let [key] = function.parameters.as_slice() else {
            return None;
        };
        let Type::Element(element) = key.ty else {
            return None;
        };
        let name = format_ident!("whole{}", id.0);
        let each = self.function_name(id);
        let n = self.count(element);
        let result = self.inner_type(&function.ty);
        let fields: Vec<FieldCode> = whole.fields.iter().map(|f| self.field(*f)).collect();
        let (prepare, parameters, arguments): (TokenStream, TokenStream, TokenStream) =
            fields.iter().fold(
                Default::default(),
                |(mut prepare, mut parameters, mut arguments), field| {
                    let FieldCode { name, ty, value } = field;
                    prepare.extend(quote! {
                        let ::std::result::Result::Ok(#name) = #value else {
                            return rt::for_each_element(#n, |v| #each(s, v));
                        };
                        let #name = &#name[..];
                    });
                    parameters.extend(quote!(, #name: &[#ty]));
                    arguments.extend(quote!(, #name));
                    (prepare, parameters, arguments)
                },
            );
        // a field pays off when its values are used more often than there are elements
        let pays = self.fields_pay(&staged.plan, whole);
        let code = match &whole.orbit {
            None => self.whole_fields(
                id,
                staged,
                whole,
                &name,
                (&parameters, &arguments),
                quote!(#prepare),
            ),
            Some(orbit) => {
                let orbits = self.orbit_name(id, orbit);
                let functions = self.orbit_functions(id, staged, orbit, &fields);
                let (grouped, table) = (grouped_name(id), self.table_name(orbit.space));
                quote! {
                    #functions
                    fn #name(s: &State<'_>) -> rt::Whole<#result> {
                        let t = &s.topology;
                        let ::std::option::Option::Some(orbits) = &s.plans.#orbits else {
                            return rt::for_each_element(#n, |v| #each(s, v));
                        };
                        #prepare
                        match orbits.values(&s.plans.#table, &#grouped { s #arguments }) {
                            ::std::option::Option::Some(values) => ::std::result::Result::Ok(values),
                            // for the first element that has no value
                            ::std::option::Option::None => rt::for_each_element(#n, |v| #each(s, v)),
                        }
                    }
                }
            }
        };
        let guard = match fields.is_empty() {
            true => TokenStream::new(),
            false => quote!(if !(#pays) { return rt::for_each_element(#n, |v| #each(s, v)); }),
        };
        let entry = all_name(id);
        Some((
            entry.clone(),
            quote! {
                #code
                pub fn #entry(s: &State<'_>) -> rt::Whole<#result> {
                    let t = &s.topology;
                    #guard
                    #name(s)
                }
            },
        ))
    }

    fn field(&self, id: FunctionId) -> FieldCode {
        let function = self.program().function(id);
        let Type::Element(element) = function.parameters[0].ty else {
            panic!("bug in iheartmesh: a field of something other than an element");
        };
        let (n, each) = (self.count(element), self.function_name(id));
        FieldCode {
            name: field_name(id),
            ty: self.inner_type(&function.ty),
            value: match self
                .staged
                .functions
                .get(&id)
                .and_then(|f| f.whole.as_ref())
            {
                Some(_) => {
                    let all = all_name(id);
                    quote!(#all(s))
                }
                None => quote!(rt::for_each_element(#n, |v| #each(s, v))),
            },
        }
    }

    /// Whether the rows that use fields are more than the elements of these.
    fn fields_pay(&self, plan: &Plan, whole: &Whole) -> TokenStream {
        let rows = plan.spaces.iter().filter(|s| s.rows.is_several()).map(|s| {
            let table = self.table_name(s.variable);
            quote!(s.plans.#table.len())
        });
        let elements =
            whole
                .fields
                .iter()
                .map(|f| match self.program().function(*f).parameters[0].ty {
                    Type::Element(element) => self.count(element),
                    _ => quote!(0usize),
                });
        quote!(0usize #(+ #rows)* > 0usize #(+ #elements)*)
    }

    /// Evaluation for each element over fields.
    fn whole_fields(
        &self,
        id: FunctionId,
        staged: &Staged,
        whole: &Whole,
        name: &Ident,
        (parameters, arguments): (&TokenStream, &TokenStream),
        prepare: TokenStream,
    ) -> TokenStream {
        let function = self.program().function(id);
        let each = format_ident!("each{}", id.0);
        let Type::Element(element) = function.parameters[0].ty else {
            return TokenStream::new();
        };
        let n = self.count(element);
        let key = variable_ident(self, function.parameters[0].variable);
        let result = self.inner_type(&function.ty);
        let prelude = self.prelude(&[whole.body]);
        let row = self.key_row(&staged.plan);
        let body = Body::single(self, Mode::Dynamic, &staged.plan, whole.body);
        quote! {
            fn #each(s: &State<'_>, #key: u32 #parameters) -> rt::Fallible<#result> {
                #prelude #row #body
            }
            fn #name(s: &State<'_>) -> rt::Whole<#result> {
                let t = &s.topology;
                #prepare
                rt::for_each_element(#n, |v| #each(s, v #arguments))
            }
        }
    }

    /// The values of inputs and fields that the terms of a group read.
    fn touched(&self, orbit: &Orbit) -> Vec<TokenStream> {
        let arena = &self.program().arena;
        let element = |e| match arena.kind(e) {
            Kind::Variable(v) => orbit.elements.iter().position(|other| other == v),
            _ => None,
        };
        let is_small = |ty: &Type| match ty.fixed_vector() {
            Some(n) => (2..=4).contains(&n),
            None => matches!(ty, Type::Scalar(_)),
        };
        let mut found = BTreeSet::new();
        for term in &orbit.terms {
            crate::optimize::reachable(arena, *term, &mut |kind| match *kind {
                Kind::Item(sequence, index) => {
                    if let (Kind::Input(id), Some(k)) = (arena.kind(sequence), element(index))
                        && let Type::Sequence { item, .. } = &self.program().input(*id).ty
                        && is_small(item)
                    {
                        found.insert((self.input_field(*id), k));
                    }
                }
                Kind::Field(id, index) => {
                    if let Some(k) = element(index)
                        && is_small(&self.program().function(id).ty)
                    {
                        found.insert((field_name(id), k));
                    }
                }
                _ => {}
            });
        }
        let values = found.into_iter().map(|(values, k)| {
            let k = Literal::usize_unsuffixed(k);
            quote!(#values[elements[#k] as usize])
        });
        values.collect()
    }

    /// The terms of a group, of a single row, and what is done with the sum.
    fn orbit_functions(
        &self,
        id: FunctionId,
        staged: &Staged,
        orbit: &Orbit,
        fields: &[FieldCode],
    ) -> TokenStream {
        let function = self.program().function(id);
        let arena = &self.program().arena;
        let plan = &staged.plan;
        let value = self.inner_type(arena.variable_type(orbit.sum_variable));
        let result = self.inner_type(&function.ty);
        let n_elements = Literal::usize_unsuffixed(orbit.elements.len());
        let n_members = Literal::usize_unsuffixed(orbit.terms.len());
        let n_columns =
            Literal::usize_unsuffixed(plan.space(orbit.space).map_or(0, |s| s.columns.len()));
        // what the terms read besides the elements
        let names: Vec<&Ident> = fields.iter().map(|f| &f.name).collect();
        let types: Vec<&TokenStream> = fields.iter().map(|f| &f.ty).collect();
        let unpack = quote!(let Self { s #(, #names)* } = *self;);

        let mut roots = Roots::default();
        let region = roots.region(None, None);
        orbit.terms.iter().for_each(|t| roots.need(region, *t));
        let mut body = Body::new(self, Mode::Dynamic, plan, &roots);
        body.variables = orbit
            .elements
            .iter()
            .enumerate()
            .map(|(k, v)| {
                let k = Literal::usize_unsuffixed(k);
                (*v, quote!(elements[#k]))
            })
            .collect::<BTreeMap<_, _>>();
        let statements = body.statements(RegionId(region), &orbit.terms);
        let results: Vec<TokenStream> = orbit.terms.iter().map(|t| body.owned(*t)).collect();
        let touched = self.touched(orbit);
        let touch_prelude = self.prelude(&orbit.terms);
        let terms_prelude = &touch_prelude;

        let Kind::Fold { body: term, .. } = arena.kind(orbit.sum) else {
            panic!("bug in iheartmesh: an orbit of no sum");
        };
        let key = variable_ident(self, function.parameters[0].variable);
        let row = super::block::row_name(orbit.space);
        let term_prelude = self.prelude(&[*term]);
        let term_code = Body::single(self, Mode::Dynamic, plan, *term);

        let sum = variable_ident(self, orbit.sum_variable);
        let zero = self.zero_of(arena.variable_type(orbit.sum_variable));
        let rest_prelude = self.prelude(&[orbit.rest]);
        let key_row = self.key_row(plan);
        let rest_code = Body::single(self, Mode::Dynamic, plan, orbit.rest);
        let grouped = grouped_name(id);
        quote! {
            pub struct #grouped<'s, 'a> {
                s: &'s State<'a>,
                #(#names: &'s [#types],)*
            }
            impl rt::Grouped<#n_elements, #n_members, #n_columns> for #grouped<'_, '_> {
                type Term = #value;
                type Value = #result;
                fn zero(&self) -> #value {
                    let s = self.s;
                    let sizes = &s.sizes;
                    #zero
                }
                #[inline(always)]
                fn touch(&self, elements: &[u32; #n_elements]) -> u64 {
                    #unpack #touch_prelude
                    0u64 #(^ rt::touch(&#touched))*
                }
                #[inline(always)]
                fn terms(&self, elements: [u32; #n_elements]) -> rt::Fallible<[#value; #n_members]> {
                    #unpack #terms_prelude #statements
                    ::std::result::Result::Ok([#(#results),*])
                }
                fn term(&self, #key: u32, #row: &[u32; #n_columns]) -> rt::Fallible<#value> {
                    #unpack #term_prelude #term_code
                }
                #[inline(always)]
                fn rest(&self, #key: u32, #sum: #value) -> rt::Fallible<#result> {
                    #unpack #rest_prelude #key_row #rest_code
                }
            }
        }
    }
}

/// The function that evaluates a function for all elements.
fn all_name(id: FunctionId) -> Ident {
    format_ident!("all{}", id.0)
}

/// The type that gives the terms of an orbit.
fn grouped_name(id: FunctionId) -> Ident {
    format_ident!("Grouped{}", id.0)
}

struct FieldCode {
    name: Ident,
    ty: TokenStream,
    value: TokenStream,
}
