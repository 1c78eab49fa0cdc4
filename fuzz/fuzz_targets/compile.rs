//! Any bytes through every stage: Rust or diagnostics.

#![no_main]

use std::hint::black_box;

use iheartmesh_compiler::optimize::Optimizations;
use iheartmesh_compiler::render::render;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::{Library, Request, compile};
use libfuzzer_sys::fuzz_target;
use proc_macro2::{Ident, Span, TokenStream};

const NEIGHBORHOODS: &str = include_str!("../../neighborhoods/src/Neighborhoods.hlang");

fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    let libraries = match text.contains("Neighborhoods") {
        true => vec![Library {
            name: "Neighborhoods".to_owned(),
            source: Source::file("Neighborhoods.hlang", NEIGHBORHOODS),
        }],
        false => Vec::new(),
    };
    for optimizations in [Optimizations::ALL, Optimizations::NONE] {
        let outcome = compile(Request {
            name: Ident::new("Fuzz", Span::call_site()),
            visibility: TokenStream::new(),
            attributes: TokenStream::new(),
            krate: "::iheartmesh".parse().expect("a path"),
            source: Source::file("fuzz.hlang", text.as_ref()),
            libraries: libraries.clone(),
            optimizations,
            together: Vec::new(),
        });
        // either code, or an error that says why there is none
        assert!(outcome.code.is_some() != outcome.diagnostics.has_errors());
        black_box(outcome.code.map(|code| code.to_string()));
        for diagnostic in outcome.diagnostics.sorted().iter().take(3) {
            render(&outcome.sources, diagnostic);
        }
    }
});
