//! Stands in for the compiler's entry points until they are there; see `expansion`.

use iheartmesh_compiler::diagnostic::{Diagnostic, Diagnostics, Severity};
use iheartmesh_compiler::source::{Source, Sources};
use iheartmesh_compiler::span::Span;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

pub struct Library {
    pub name: String,
    pub source: Source,
}

pub struct Request {
    pub name: Ident,
    pub visibility: TokenStream,
    pub attributes: TokenStream,
    pub krate: TokenStream,
    pub source: Source,
    pub libraries: Vec<Library>,
}

#[derive(Default)]
pub struct Outcome {
    pub code: Option<TokenStream>,
    pub skeleton: TokenStream,
    pub diagnostics: Diagnostics,
    pub sources: Sources,
}

pub fn compile(request: Request) -> Outcome {
    let Request {
        name,
        visibility,
        attributes,
        krate,
        source,
        libraries,
    } = request;
    let mut outcome = Outcome::default();
    if source.text.contains("PANIC") {
        panic!("it was asked to");
    }
    let text = source.text.clone();
    let mut all = vec![source];
    all.extend(libraries.iter().map(|l| l.source.clone()));
    for source in all {
        let id = outcome.sources.add(source.clone());
        for (at, word) in source.text.match_indices("_name") {
            let span = Span::new(id, at, at + word.len());
            let error = Diagnostic::error(span, "this is an error")
                .here("here")
                .help("none");
            outcome.diagnostics.push(error);
        }
        for (at, word) in source.text.match_indices("WARNING") {
            let span = Span::new(id, at, at + word.len());
            outcome
                .diagnostics
                .push(Diagnostic::warning(span, "this is a warning"));
        }
    }
    let skeleton = quote!(#attributes #visibility struct #name<'a> { mesh: &'a () });
    outcome.skeleton = skeleton;
    if !outcome.diagnostics.has_errors() {
        let names = libraries.iter().map(|l| &l.name);
        let texts = libraries.iter().map(|l| &l.source.text);
        outcome.code = Some(quote! {
            #attributes
            #visibility struct #name;
            #[allow(dead_code, missing_docs)]
            impl #name {
                pub const SOURCE: &'static str = #text;
                pub fn new<T>(_: T) -> Result<Self, &'static str> { Ok(Self) }
                pub fn b(&self) -> f64 { 0.0 }
                pub const LIBRARIES: &'static [(&'static str, &'static str)] = &[#((#names, #texts)),*];
            }
            const _: () = { #[allow(unused_imports)] use #krate::*; };
        });
    }
    outcome
}

pub fn imported_modules(source: &Source) -> Vec<String> {
    let mut list: Vec<String> = Vec::new();
    for line in source.text.lines() {
        let Some((_, rest)) = line.split_once(" from ") else {
            continue;
        };
        let name: String = rest
            .trim()
            .chars()
            .take_while(|c| c.is_alphanumeric())
            .collect();
        let known = ["MeshConnectivity", "trigonometry", "linearalgebra"].contains(&name.as_str());
        if !known && !list.contains(&name) {
            list.push(name);
        }
    }
    list
}

pub fn render(sources: &Sources, found: &Diagnostic) -> String {
    let severity = match found.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    let mut out = format!("{severity}: {}", found.message);
    for label in &found.labels {
        let source = sources.get(label.span.source);
        let (line, column) = source.line_column(label.span.start);
        let k = source.text[..label.span.start as usize]
            .matches('\n')
            .count();
        let text = source.text.lines().nth(k).unwrap_or("");
        out += &format!(
            "\n --> {}:{line}:{column}\n  |\n{line} | {text}\n  | {}",
            source.file, label.text
        );
    }
    if let Some(help) = &found.help {
        out += &format!("\n  = help: {help}");
    }
    out
}
