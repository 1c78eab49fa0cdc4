//! Any bytes: a tree and diagnostics, in steps proportional to the length, with spans inside of the text.

#![no_main]

use iheartmesh_compiler::render::render;
use iheartmesh_compiler::source::{Source, Sources};
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::{NoImports, count_steps, dump, imports, parse};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    let source = Source::file("fuzz.hlang", text.as_ref());
    let steps = count_steps(&source);
    assert!(
        steps <= 120 * (text.len() + 20),
        "{steps} steps for {} bytes",
        text.len()
    );
    let (module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    imports(&source, SourceId(0));
    dump(&module);
    let mut sources = Sources::default();
    sources.add(source);
    for diagnostic in diagnostics.sorted() {
        let span = diagnostic.span();
        let place = span.start as usize..span.end as usize;
        assert!(text.get(place).is_some(), "{}", diagnostic.message);
        assert!(diagnostic.help.is_some(), "{}", diagnostic.message);
    }
    for diagnostic in diagnostics.sorted().iter().take(3) {
        render(&sources, diagnostic);
    }
});
