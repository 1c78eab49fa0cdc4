//! From the tokens of a call to the items that stand in its place.
//!
//! **Invariant:** whatever the tokens are, every item that has a name is defined, or is replaced by an error of ours.

use crate::collection::{Collection, Context, STANDARD};
use crate::error::Error;
use crate::exports;
use crate::invocation::{Header, Invocation, Item, Use, parse};
use crate::libraries::{self, Problem};
use crate::module::{Module, Need, Reader, Route, fingerprint};
use crate::report;
use crate::switches::Together;
use iheartmesh_compiler::diagnostic::{Diagnostic, Severity};
use iheartmesh_compiler::render::render;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::{Library, Outcome, Request, compile, imported_modules};
use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote;
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The first step: three paths, then what the user wrote.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut reader = Reader::new(tokens);
    let Some(context) = Context::read(&mut reader) else {
        return broken();
    };
    let user: TokenStream = reader.rest().collect();
    let call = parse(user.clone());
    let of_call = modules(&call);
    let errors: TokenStream = call.errors.iter().map(report::call_error).collect();
    let unread: Vec<&Header> = call.unread.iter().collect();
    let failed = report::failed(&unread, &errors);
    let sources = call.items.iter().zip(&of_call);
    let sources = sources.map(|(item, module)| exports::source_macro(item, module, &of_call));
    let sources: TokenStream = sources.collect();
    let collection = Collection::new(&call, &of_call, &context);
    let rest = step(&context, &collection, &call, &of_call, &user);
    quote!(#failed #sources #rest)
}

/// A further step: the answer to a question, then what was asked to come back with it.
pub fn resume(tokens: TokenStream) -> TokenStream {
    resumed(tokens).unwrap_or_else(broken)
}

fn resumed(tokens: TokenStream) -> Option<TokenStream> {
    let mut reader = Reader::new(tokens);
    let answer = reader.token()?;
    let context = Context::read(&mut reader)?;
    let mut collection = Collection::read(&mut reader)?;
    let user: TokenStream = reader.rest().collect();
    let call = parse(user.clone());
    let of_call = modules(&call);
    collection.accept(answer, &of_call, &exports::crate_identity(), &context)?;
    Some(step(&context, &collection, &call, &of_call, &user))
}

/// Asks for the next module, or compiles with all of them in hand.
fn step(
    context: &Context,
    collection: &Collection,
    call: &Invocation,
    of_call: &[Module],
    user: &TokenStream,
) -> TokenStream {
    match collection.next_path() {
        Some(path) => {
            let state = collection.write(context);
            exports::question(path, context, &quote!(#state #user))
        }
        None => finish(context, collection, call, of_call),
    }
}

fn broken() -> TokenStream {
    let message = "call this macro as `iheartmesh!`, of the crate `iheartmesh`";
    report::error(Span::call_site(), message)
}

/// The items of a call as modules, with what they need.
fn modules(call: &Invocation) -> Vec<Module> {
    let own_crate = exports::crate_identity();
    let plain = |item: &Item| {
        item.header
            .name
            .to_string()
            .trim_start_matches("r#")
            .to_string()
    };
    let id = |item: &Item| {
        let Source {
            file,
            text,
            first_line,
            indents,
            ..
        } = &item.body.source;
        let place = format!("{first_line} {indents:?}");
        fingerprint(&[&own_crate, &plain(item), file, &place, text])
    };
    let route = |name: &str| {
        if let Some(item) = call.items.iter().find(|item| plain(item) == name) {
            Route::Known(id(item))
        } else if let Some(used) = call.uses.iter().find(|used| used.name == name) {
            let path: TokenStream = used.path.iter().cloned().collect();
            match used.path.as_slice() {
                [TokenTree::Ident(first), _, ..] if first != "self" && first != "super" => {
                    Route::Path(path)
                }
                [TokenTree::Punct(_), ..] => Route::Path(path),
                _ => Route::Closed(path.to_string().replace(' ', "")),
            }
        } else if STANDARD.contains(&name) {
            Route::Standard
        } else {
            Route::Unknown
        }
    };
    let module = |item: &Item| Module {
        id: id(item),
        name: plain(item),
        source: item.body.source.clone(),
        needs: imported_modules(&item.body.source)
            .into_iter()
            .map(|name| Need {
                route: route(&name),
                name,
            })
            .collect(),
    };
    call.items.iter().map(module).collect()
}

/// Compiles all items; everything they import is in hand, or is nowhere.
fn finish(
    context: &Context,
    collection: &Collection,
    call: &Invocation,
    of_call: &[Module],
) -> TokenStream {
    let mut circles: Vec<BTreeSet<String>> = Vec::new();
    let mut output = TokenStream::new();
    let mut results = Vec::new();
    for (item, module) in call.items.iter().zip(of_call) {
        results.push(match libraries::of(module, call, of_call, collection) {
            Ok(found) => {
                let library = |found: &libraries::Found| Library {
                    name: found.name.to_string(),
                    source: found.module.source.clone(),
                };
                let list = found.iter().map(library).collect();
                let bundle = exports::bundle(item, module, of_call, collection);
                output.extend(bundle);
                compiled(context, item, list)
            }
            Err(problems) => unresolved(problems, &mut circles, module),
        });
    }
    let failed: Vec<&Source> = results
        .iter()
        .zip(of_call)
        .filter(|(outcome, _)| outcome.code.is_none())
        .map(|(_, module)| &module.source)
        .collect();
    let mut stand_ins = Vec::new();
    let mut errors = TokenStream::new();
    for ((item, module), outcome) in call.items.iter().zip(of_call).zip(&results) {
        let messages = Messages {
            item,
            module,
            outcome,
        };
        output.extend(tracked(item));
        output.extend(messages.remarks());
        match &outcome.code {
            Some(code) => output.extend(code.clone()),
            None => {
                errors.extend(messages.errors(&failed));
                errors.extend(messages.misfits());
                stand_ins.push(&item.header);
            }
        }
    }
    output.extend(report::failed(&stand_ins, &errors));
    if call.errors.is_empty() {
        output.extend(unused(call, of_call));
    }
    output
}

/// A warning for each `use` that no source of the call needs.
fn unused(call: &Invocation, of_call: &[Module]) -> TokenStream {
    let warning = |used: &Use| {
        let name = used.name.to_string();
        let mut needs = of_call.iter().flat_map(|m| &m.needs);
        let message = format!("no source of this call imports `{name}`");
        (!needs.any(|need| need.name == name))
            .then(|| report::remark(used.name.span(), Severity::Warning, &message))
    };
    call.uses.iter().filter_map(warning).collect()
}

/// Whether two sources are one and the same.
fn same(left: &Source, right: &Source) -> bool {
    (&left.file, left.first_line, &left.text) == (&right.file, right.first_line, &right.text)
}

/// Problems with imports as an outcome of the compiler.
fn unresolved(
    problems: Vec<Problem>,
    circles: &mut Vec<BTreeSet<String>>,
    module: &Module,
) -> Outcome {
    let mut outcome = Outcome::default();
    outcome.sources.add(module.source.clone());
    for Problem { diagnostic, circle } in problems {
        if let Some(circle) = circle {
            if circles.contains(&circle) {
                continue;
            }
            circles.push(circle);
        }
        outcome.diagnostics.push(diagnostic);
    }
    outcome
}

/// Runs the compiler; a defect in it becomes an error like any other.
fn compiled(context: &Context, item: &Item, libraries: Vec<Library>) -> Outcome {
    let header = &item.header;
    let run = || {
        compile(Request {
            name: header.name.clone(),
            visibility: header.visibility.clone(),
            attributes: header.attributes.clone(),
            krate: context.krate.clone(),
            source: item.body.source.clone(),
            libraries,
            optimizations: header.switches.optimizations,
            together: header
                .switches
                .together
                .iter()
                .map(Together::plain)
                .collect(),
        })
    };
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
        let mut outcome = Outcome::default();
        let source = outcome.sources.add(item.body.source.clone());
        let place = iheartmesh_compiler::span::Span::new(source, 0, 0);
        let text = text.unwrap_or("the compiler gave up without a message");
        let text = text.trim_start_matches("bug in iheartmesh: ");
        let message = format!("bug in iheartmesh: {text}");
        outcome.diagnostics.push(
            Diagnostic::error(place, message).help("please report it together with this source"),
        );
        outcome
    })
}

/// Makes rustc look at the file of an `include` again when it changes.
fn tracked(item: &Item) -> Option<TokenStream> {
    let written = item.body.included.as_ref()?;
    Some(quote! {
        const _: &[u8] = ::core::include_bytes!(
            ::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #written)
        );
    })
}

/// Everything there is to say about one item.
struct Messages<'a> {
    item: &'a Item,
    module: &'a Module,
    outcome: &'a Outcome,
}

impl Messages<'_> {
    fn place(&self, found: &Diagnostic) -> &Source {
        self.outcome.sources.get(found.span().source)
    }

    fn message(&self, found: &Diagnostic) -> TokenStream {
        let own = same(self.place(found), &self.module.source);
        let rendered = render(&self.outcome.sources, found);
        report::diagnostic(&self.item.body, own, found, &rendered)
    }

    /// Warnings and notes.
    fn remarks(&self) -> TokenStream {
        let list = self.outcome.diagnostics.sorted().into_iter();
        list.filter(|found| found.severity != Severity::Error)
            .map(|found| self.message(found))
            .collect()
    }

    /// What is wrong with `#[together(…)]`, each at its name.
    fn misfits(&self) -> TokenStream {
        let lists = &self.item.header.switches.together;
        let messages = self.outcome.misfits.iter().map(|misfit| {
            let list = lists.get(misfit.list);
            let name = list.and_then(|list| list.names.get(misfit.name?));
            let whole = list.map_or_else(Span::call_site, |list| list.span);
            let span = name.map_or(whole, |name| name.span());
            report::call_error(&Error::new(span, &misfit.message).help(&misfit.help))
        });
        messages.collect()
    }

    /// Errors, without those inside of another module of this call that has failed and reports them itself.
    fn errors(&self, failed: &[&Source]) -> TokenStream {
        let reported = |found: &&Diagnostic| {
            let source = self.place(found);
            !same(source, &self.module.source) && failed.iter().any(|other| same(source, other))
        };
        let list = self.outcome.diagnostics.sorted().into_iter();
        list.filter(|found| found.severity == Severity::Error && !reported(found))
            .map(|found| self.message(found))
            .collect()
    }
}

#[cfg(test)]
mod tests;
