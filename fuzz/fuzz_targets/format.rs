//! Formatting keeps the tree of any text without mistakes, is done after once, and never refuses.

#![no_main]

use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::ast::Module;
use iheartmesh_compiler::syntax::print::Spelling;
use iheartmesh_compiler::syntax::{NoImports, format, parse, strip_spans};
use libfuzzer_sys::fuzz_target;

fn read(source: &Source) -> Option<Module> {
    let (mut module, diagnostics) = parse(source, SourceId(0), &NoImports);
    strip_spans(&mut module);
    (!diagnostics.has_errors()).then_some(module)
}

fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    let source = Source::file("fuzz.hlang", text.as_ref());
    let module = read(&source);
    for spelling in [Spelling::Unicode, Spelling::Ascii] {
        let formatted = format(&source, SourceId(0), &NoImports, spelling);
        assert_eq!(formatted.is_ok(), module.is_some(), "{text}");
        let Ok(formatted) = formatted else {
            continue;
        };
        let again = Source::file("fuzz.hlang", formatted.as_str());
        assert!(read(&again) == module, "{text}\n---\n{formatted}");
        let twice = format(&again, SourceId(0), &NoImports, spelling);
        assert!(
            twice.is_ok_and(|twice| twice == formatted),
            "{text}\n---\n{formatted}"
        );
    }
});
