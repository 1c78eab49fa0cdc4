//! What is read without mistakes, printed and read again, is the same tree, in both spellings.

#![no_main]

use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::ast::Module;
use iheartmesh_compiler::syntax::print::{self, Spelling};
use iheartmesh_compiler::syntax::{NoImports, parse, strip_spans};
use libfuzzer_sys::fuzz_target;

fn read(text: &str) -> Option<Module> {
    let source = Source::file("fuzz.hlang", text);
    let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    strip_spans(&mut module);
    (!diagnostics.has_errors()).then_some(module)
}

fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    let Some(module) = read(&text) else {
        return;
    };
    for spelling in [Spelling::Unicode, Spelling::Ascii] {
        let printed = print::module(&module, spelling);
        let again = read(&printed);
        assert!(again.as_ref() == Some(&module), "{text}\n---\n{printed}");
        let twice = print::module(&module, spelling);
        assert_eq!(printed, twice);
    }
});
