//! Sparse sums of blocks with planned places, see [`super::slots`]: a function that finds the places, and one that adds
//! the values to the entries.
//!
//! Both walk the same loops in the same order, so that the values of the second follow one another as the places of the
//! first.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::block::{Body, Mode};
use super::place::{Part, RegionId, Roots};
use super::slots::{Added, Parts, SlotSum, Step, Term, is_in_rounds};
use crate::ir::{Binary, ExprId, GlobalId, Kind, Range, Unary};
use crate::optimize::{Plan, reachable};

impl Context<'_> {
    /// Statements that compute the definitions which terms ask for. Terms are added by several threads; what one of them
    /// computes first must not be waited for by a task that it takes up meanwhile. Whether one fails is seen at its use.
    fn known_before(&self, e: ExprId) -> TokenStream {
        let mut all = BTreeSet::new();
        reachable(&self.program().arena, e, &mut |kind| {
            if let Kind::Global(id) = kind
                && !self.is_static_global(*id)
            {
                all.insert(*id);
            }
        });
        let names = all.into_iter().map(|id| self.global_name(id));
        quote!(#(let _ = s.#names();)*)
    }

    /// The functions that find the places, and add the values to entries.
    pub(super) fn slot_functions(&self, id: GlobalId) -> TokenStream {
        let (Some(sum), Some(staged)) = (self.slot_sums.get(&id), self.staged.globals.get(&id))
        else {
            return TokenStream::new();
        };
        let name = self.global_name(id);
        let (slots, fill) = (
            format_ident!("slots_{}", name),
            format_ident!("fill_{}", name),
        );
        let places = self.places_of(id, sum, &staged.plan);
        let prelude = self.prelude(&[staged.body]);
        let mut needed: Vec<ExprId> = sum.sizes_and_keys().collect();
        needed.push(staged.body);
        let before_places = self.prelude(&needed);
        let known = self.known_before(staged.body);
        let mut roots = Roots::default();
        let region = roots.region(None, None);
        roots.need(region, staged.body);
        let mut body = Body::new(self, Mode::Dynamic, &staged.plan, &roots);
        body.slots = Some(sum);
        let statements = body.statements(RegionId(region), &[staged.body]);
        let (mut blocks, mut wholes) = (0usize, 0usize);
        let mut terms = TokenStream::new();
        for term in &sum.terms {
            terms.extend(match &term.parts {
                Parts::Blocks(_) => {
                    blocks += 1;
                    body.add_blocks(term, blocks - 1)
                }
                whole => {
                    wholes += 1;
                    body.add_whole(term, whole, wholes - 1)
                }
            });
        }
        let others = match self.program().pass(id) {
            Some(pass) => self.pass_functions(pass),
            None => self.function_into(id),
        };
        let arrays = Literal::usize_unsuffixed(sum.arrays.len());
        let totals = Literal::usize_unsuffixed(sum.totals);
        quote! {
            #others
            pub fn #slots(s: &State<'_>) -> rt::Fallible<::std::sync::Arc<rt::Slots>> { #before_places #places }
            pub fn #fill(s: &State<'_>, slots: &rt::Slots, data: &mut [&mut [f64]; #arrays], totals: &mut [f64; #totals]) -> rt::Fallible<()> {
                #known
                #prelude
                #statements
                #terms
                ::std::result::Result::Ok(())
            }
        }
    }

    /// The body of the function that finds the places.
    fn places_of(&self, id: GlobalId, sum: &SlotSum, plan: &Plan) -> TokenStream {
        let mut roots = Roots::default();
        let outside = roots.region(None, None);
        for size in sum.sizes_and_keys() {
            roots.need(outside, size);
        }
        // done only where there are no slots yet
        let inside = roots.region(Some(outside), None);
        let terms: Vec<(&Term, Vec<Placed<'_>>)> = sum
            .terms
            .iter()
            .map(|term| {
                let placed = match &term.parts {
                    Parts::Blocks(steps) => self.placed(steps, inside, &mut roots),
                    Parts::Definition(_) => Vec::new(),
                    Parts::Steady => {
                        roots.need(inside, term.value);
                        Vec::new()
                    }
                };
                (term, placed)
            })
            .collect();
        let mut body = Body::new(self, Mode::Build, plan, &roots);
        let statements = body.statements(RegionId(outside), &[]);
        let sizes: Vec<TokenStream> = sum.sizes_and_keys().map(|e| body.owned(e)).collect();
        let before = body.statements(RegionId(inside), &[]);
        let layouts = sum.layouts();
        let totals = Literal::usize_unsuffixed(sum.totals);
        body.slots = Some(sum);
        let terms: TokenStream = terms
            .iter()
            .map(|(term, steps)| {
                match term.parts {
                    Parts::Blocks(_) => {}
                    Parts::Definition(id) => {
                        let slots = format_ident!("slots_{}", self.global_name(id));
                        return quote!(places.pattern(&*#slots(s)?););
                    }
                    Parts::Steady => {
                        let value = body.reference(term.value);
                        return quote!(places.matrix(#value););
                    }
                }
                let end = quote!(places.end_round(););
                let rounds = is_in_rounds(self, plan, term.value);
                let (inside, after) = match rounds {
                    true => (end, TokenStream::new()),
                    false => (TokenStream::new(), end),
                };
                let steps = body.places_of(steps, &inside);
                quote!(places.part(); #steps #after)
            })
            .collect();
        let field = format_ident!("slots{}", id.0);
        let site = self.site_because(
            self.program().global(id).value,
            "a matrix with more entries than can be counted".to_owned(),
        );
        quote! {
            #statements
            let all = [#(#sizes),*];
            s.#field.get(all, || {
                #before
                let mut places = rt::Places::new(&[#layouts], #totals);
                #terms
                places.finish(#site)
            })
        }
    }

    /// The regions that steps are in, with what is needed in each.
    fn placed<'a>(&self, steps: &'a [Step], region: usize, roots: &mut Roots) -> Vec<Placed<'a>> {
        let arena = &self.program().arena;
        let mut placed = Vec::new();
        for step in steps {
            placed.push(match step {
                Step::Block { rows, columns, .. } => {
                    for place in rows.iter().chain(columns) {
                        roots.need(region, *place);
                    }
                    Placed::Block(step)
                }
                Step::Branch(steps) => Placed::Branch(self.placed(steps, region, roots)),
                Step::Local { steps, added, .. } => {
                    if let Added::Columns(columns) = added {
                        roots.need(region, *columns);
                    }
                    Placed::Local(step, self.placed(steps, region, roots))
                }
                Step::Columns { rows, columns, .. } => {
                    for place in rows {
                        roots.need(region, *place);
                    }
                    roots.need(region, *columns);
                    Placed::Block(step)
                }
                Step::Loop { fold, steps } => {
                    let Kind::Fold {
                        variable,
                        range,
                        condition,
                        ..
                    } = arena.kind(*fold)
                    else {
                        panic!("bug in iheartmesh: no loop");
                    };
                    match range {
                        Range::Set(set) => roots.need(region, *set),
                        Range::Integers(from, to) => {
                            roots.need(region, *from);
                            roots.need(region, *to);
                        }
                        Range::Rows { .. } => {}
                    }
                    let inside = roots.region(Some(region), Some(*variable));
                    let is_dynamic = self.slot_sums_know(*fold);
                    match condition.filter(|_| !is_dynamic) {
                        None => Placed::Loop {
                            fold: *fold,
                            region: inside,
                            taken: None,
                            steps: self.placed(steps, inside, roots),
                        },
                        Some(condition) => {
                            roots.need(inside, condition);
                            let taken = roots.region(Some(inside), None);
                            Placed::Loop {
                                fold: *fold,
                                region: inside,
                                taken: Some((condition, taken)),
                                steps: self.placed(steps, taken, roots),
                            }
                        }
                    }
                }
                Step::Choice {
                    condition,
                    then,
                    otherwise,
                } => {
                    roots.need(region, *condition);
                    let branches = [then, otherwise].map(|steps| {
                        let inside = roots.region(Some(region), None);
                        (inside, self.placed(steps, inside, roots))
                    });
                    Placed::Choice(*condition, branches)
                }
            });
        }
        placed
    }

    /// Whether the condition of a loop depends on values.
    fn slot_sums_know(&self, fold: ExprId) -> bool {
        let mut sums = self.slot_sums.values();
        sums.any(|sum| sum.branches.contains_key(&fold) || sum.local_branches.contains_key(&fold))
    }
}

/// A step with its regions.
enum Placed<'a> {
    Block(&'a Step),
    Local(&'a Step, Vec<Placed<'a>>),
    Loop {
        fold: ExprId,
        region: usize,
        taken: Option<(ExprId, usize)>,
        steps: Vec<Placed<'a>>,
    },
    Branch(Vec<Placed<'a>>),
    Choice(ExprId, [(usize, Vec<Placed<'a>>); 2]),
}

impl Body<'_> {
    /// Statements that note the places of blocks; `last` ends each round of an outermost loop.
    fn places_of(&mut self, steps: &[Placed<'_>], last: &TokenStream) -> TokenStream {
        let nothing = TokenStream::new();
        let mut code = TokenStream::new();
        for step in steps {
            code.extend(match step {
                Placed::Block(step) => self.places_of_block(step),
                Placed::Local(step, steps) => {
                    let steps = self.places_of(steps, &nothing);
                    self.places_of_local(step, &steps)
                }
                Placed::Branch(steps) => {
                    let steps = self.places_of(steps, &nothing);
                    quote!(places.enter(); #steps places.leave();)
                }
                Placed::Loop {
                    fold,
                    region,
                    taken,
                    steps,
                } => {
                    let Kind::Fold {
                        variable, range, ..
                    } = self.kind(*fold)
                    else {
                        panic!("bug in iheartmesh: no loop");
                    };
                    let head = self.loop_head(*variable, range);
                    let before = self.statements(RegionId(*region), &[]);
                    match taken {
                        None => {
                            let steps = self.places_of(steps, &nothing);
                            quote!(#head { #before #steps #last })
                        }
                        Some((condition, taken)) => {
                            let condition = self.owned(*condition);
                            let statements = self.statements(RegionId(*taken), &[]);
                            let steps = self.places_of(steps, &nothing);
                            quote!(#head { #before if #condition { #statements #steps } #last })
                        }
                    }
                }
                Placed::Choice(condition, branches) => {
                    let condition = self.owned(*condition);
                    let mut branch = |(region, steps): &(usize, Vec<Placed<'_>>)| {
                        let statements = self.statements(RegionId(*region), &[]);
                        let steps = self.places_of(steps, &nothing);
                        quote!({ #statements #steps })
                    };
                    let (then, otherwise) = (branch(&branches[0]), branch(&branches[1]));
                    quote!(if #condition #then else #otherwise)
                }
            });
        }
        code
    }

    fn places_of_block(&mut self, step: &Step) -> TokenStream {
        let (Step::Block { array, rows, .. } | Step::Columns { array, rows, .. }) = step else {
            panic!("bug in iheartmesh: no block");
        };
        let rows = self.places(rows);
        let array = Literal::usize_unsuffixed(*array);
        let several = self.slots.is_some_and(|sum| sum.arrays.len() > 1);
        let array = several.then(|| quote!(places.array(#array);));
        match step {
            Step::Columns {
                columns, height, ..
            } => {
                let columns = self.owned(*columns);
                let height = Literal::usize_unsuffixed(*height);
                quote! {
                    #array
                    for column in 0..rt::size(#columns) {
                        places.block(
                            (|| -> rt::Fallible<_> { ::std::result::Result::Ok(([#(#rows),*], [column])) })(),
                            #height,
                            1,
                        );
                    }
                }
            }
            Step::Block {
                columns,
                height,
                width,
                ..
            } => {
                let columns = self.places(columns);
                let [height, width] = [*height, *width].map(Literal::usize_unsuffixed);
                quote! {
                    #array
                    places.block(
                        (|| -> rt::Fallible<_> { ::std::result::Result::Ok(([#(#rows),*], [#(#columns),*])) })(),
                        #height,
                        #width,
                    );
                }
            }
            _ => TokenStream::new(),
        }
    }

    /// Statements that hand the values of a sum to `terms`.
    pub(super) fn terms(&mut self, e: ExprId) -> TokenStream {
        let Some(sum) = self.slots else {
            panic!("bug in iheartmesh: no planned sum");
        };
        match self.kind(e) {
            Kind::Assemble { blocks, .. } => {
                let (site, array) = (self.context.site(e), self.array_number());
                let blocks = blocks.iter().map(|block| {
                    let value = self.reference(block.value);
                    let pieces = self.context.pieces(block).unwrap_or(0);
                    let pieces = Literal::usize_unsuffixed(pieces);
                    quote!(terms[#array].block(#value, #pieces, #site)?;)
                });
                blocks.collect()
            }
            Kind::Tuple(items) => {
                let (arrays, totals) = items.split_at(sum.arrays.len());
                let mut code = TokenStream::new();
                for (k, item) in arrays.iter().enumerate() {
                    self.array = k;
                    code.extend(self.terms(*item));
                }
                for (k, item) in totals.iter().enumerate() {
                    if !matches!(self.kind(*item), Kind::Real(0)) {
                        let value = self.owned(*item);
                        let k = Literal::usize_unsuffixed(k);
                        code.extend(quote!(totals[#k] += #value;));
                    }
                }
                code
            }
            Kind::Unary(Unary::Negate, a) => {
                let (steps, array) = (self.terms(*a), self.array_number());
                quote!({ let from = terms[#array].position(); #steps terms[#array].scale(from, -1.0); })
            }
            Kind::Unary(op, a) => match sum.units.get(&e) {
                Some(unit) => self.symmetric(e, *op, *a, unit),
                None => self.local(*op, *a, None),
            },
            Kind::Binary(Binary::Product, block, factor) => {
                match (sum.units.get(block), self.kind(*block)) {
                    (Some(unit), _) => self.symmetric_product(e, *block, *factor, unit),
                    (None, Kind::Unary(op, a)) => self.local(*op, *a, Some(*factor)),
                    _ => panic!("bug in iheartmesh: no block"),
                }
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let k = self.owned(*k);
                let (steps, array) = (self.terms(*a), self.array_number());
                quote!({ let (k, from) = (#k, terms[#array].position()); #steps terms[#array].scale(from, k); })
            }
            Kind::Binary(Binary::Divide, a, k) => {
                let k = self.owned(*k);
                let (steps, array) = (self.terms(*a), self.array_number());
                quote!({ let (k, from) = (#k, terms[#array].position()); #steps terms[#array].divide(from, k); })
            }
            Kind::Binary(Binary::Subtract, a, b) => {
                let (a, b, array) = (self.terms(*a), self.terms(*b), self.array_number());
                quote!(#a { let from = terms[#array].position(); #b terms[#array].scale(from, -1.0); })
            }
            Kind::Binary(_, a, b) => {
                let (a, b) = (self.terms(*a), self.terms(*b));
                quote!(#a #b)
            }
            Kind::If(condition, a, b) => {
                let condition = self.owned(*condition);
                let then = self.branch(e, Part::Then, *a);
                let otherwise = self.branch(e, Part::Else, *b);
                match sum.branches.get(&e).filter(|branches| !branches.same) {
                    None => quote!(if #condition { #then } else { #otherwise }),
                    Some(branches) => {
                        let both = [&branches.then, &branches.otherwise];
                        let [before, after] = both.map(|counts| sum.skip(counts));
                        let [a, b] = both.map(|counts| sum.enter(counts));
                        quote!(if #condition { #a #then #after } else { #before #b #otherwise })
                    }
                }
            }
            Kind::Fold { body, .. } => {
                let body = *body;
                let (start, otherwise) = match sum.branches.get(&e) {
                    Some(branches) => {
                        let skip = sum.skip(&branches.then);
                        (sum.enter(&branches.then), quote!(else { #skip }))
                    }
                    None => (TokenStream::new(), TokenStream::new()),
                };
                let step = |this: &mut Self| {
                    let terms = this.terms(body);
                    quote!(#start #terms)
                };
                self.looped_or(e, step, otherwise)
            }
            other => panic!("bug in iheartmesh: no blocks in {other:?}"),
        }
    }

    /// The array to which blocks are added.
    pub(super) fn array_number(&self) -> Literal {
        Literal::usize_unsuffixed(self.array)
    }

    fn branch(&mut self, e: ExprId, part: Part, value: ExprId) -> TokenStream {
        let region = self.placement.part(e, part);
        let statements = self.statements(region, &[]);
        let steps = self.terms(value);
        quote!(#statements #steps)
    }
}
