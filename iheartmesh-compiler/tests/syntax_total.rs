//! Any text gives a tree and diagnostics, in a bounded number of steps and with bounded nesting.

mod syntax_support;

use iheartmesh_compiler::source::{Source, Sources};
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::print::{self, Spelling};
use iheartmesh_compiler::syntax::{
    MOST_NESTING, NoImports, count_steps, dump, imports, parse, strip_spans,
};
use syntax_support::{PIECES, corpus};

/// Steps that the parser may take for each byte of a text.
const STEPS: usize = 120;

/// Reads, prints and renders a text; a text without mistakes has to be read back.
fn survive(text: &str) {
    let source = Source::file("test.hlang", text);
    let steps = count_steps(&source);
    let most = STEPS * (text.len() + 20);
    assert!(
        steps <= most,
        "{steps} steps for {} bytes:\n{text}",
        text.len()
    );
    let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    imports(&source, SourceId(0));
    dump(&module);
    print::module(&module, Spelling::Unicode);
    print::module(&module, Spelling::Ascii);
    strip_spans(&mut module);
    if !diagnostics.has_errors() {
        for spelling in [Spelling::Unicode, Spelling::Ascii] {
            let printed = print::module(&module, spelling);
            let again = Source::file("test.hlang", printed.as_str());
            let (mut again, _) = parse(&again, SourceId(0), &NoImports);
            strip_spans(&mut again);
            assert!(module == again, "{text}\n{printed}");
        }
    }
    for diagnostic in diagnostics.sorted() {
        assert!(diagnostic.help.is_some(), "{}", diagnostic.message);
        let span = diagnostic.span();
        assert!(span.start <= span.end && span.end as usize <= text.len());
    }
    let mut sources = Sources::default();
    sources.add(source);
    for diagnostic in diagnostics.sorted().iter().take(3) {
        iheartmesh_compiler::render::render(&sources, diagnostic);
    }
}

/// A small generator of numbers, so that every run sees the same texts.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % limit.max(1)
    }
}

#[test]
fn mutated_programs() {
    let mut random = Random(0x5eed);
    for (_, text) in corpus() {
        let letters: Vec<char> = text.chars().collect();
        for _ in 0..40 {
            let mut changed: Vec<char> = match random.below(3) {
                0 => letters[..random.below(letters.len())].to_vec(),
                1 => letters[random.below(letters.len())..].to_vec(),
                _ => letters.clone(),
            };
            for _ in 0..random.below(6) {
                let at = random.below(changed.len() + 1);
                let until = (at + random.below(4)).min(changed.len());
                let piece = PIECES[random.below(PIECES.len())];
                changed.splice(at..until, piece.chars());
            }
            survive(&changed.into_iter().collect::<String>());
        }
    }
}

#[test]
fn token_soup() {
    let mut random = Random(0xfeed);
    for _ in 0..600 {
        let length = random.below(120);
        let text: String = (0..length)
            .map(|_| PIECES[random.below(PIECES.len())])
            .collect();
        survive(&text);
    }
}

#[test]
fn long_repetitions() {
    for piece in PIECES {
        survive(&piece.repeat(400));
        survive(&format!("y = {}", piece.repeat(400)));
    }
    for (first, second) in [
        ("a", ", "),
        ("∑_i ", ""),
        ("∂²", ""),
        ("|a|", " "),
        ("{a if ", ""),
        ("f(", ""),
        ("[a ", ";"),
        ("(a,", "b)"),
        ("{k | ", ""),
        ("<a", ","),
        ("a^", ""),
        ("a_", ""),
        ("x where ", ""),
        ("a ∈ ", ", "),
        ("∑_(i ∈ ", ""),
        ("if (a < ", ""),
        ("((a) < b", ") and "),
        ("a\n", ""),
        ("{ a if b > c\n", ""),
        ("∂a/", "∂b"),
        ("`a`", "_"),
    ] {
        survive(&format!("y = {}", format!("{first}{second}").repeat(1000)));
        survive(&format!("{first}{second}").repeat(1000));
    }
}

/// Four times the text takes about four times the steps, whatever is repeated: nothing is looked at again and again,
/// beyond a bounded look ahead; what is looked at for each piece again would take sixteen times the steps.
#[test]
fn steps_grow_with_the_length() {
    let steps = |text: String| count_steps(&Source::file("test.hlang", text));
    for start in ["h(a) = b where ", "y = { a if b > 0\n"] {
        for first in PIECES {
            for second in ["a", ", ", "; "] {
                let unit = format!("{first}{second}");
                let short = steps(format!("{start}{}", unit.repeat(300)));
                let long = steps(format!("{start}{}", unit.repeat(1200)));
                assert!(long <= 8 * short, "{start:?} {unit:?}: {short} then {long}");
            }
        }
    }
}

/// Runs on three quarters of a mebibyte: less, by a quarter, than the smallest stack that the compiler is run on.
fn on_small_stack(run: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(3 << 18);
    thread
        .spawn(run)
        .expect("a thread")
        .join()
        .expect("no overflow");
}

#[test]
fn deep_nesting_is_an_error_and_no_overflow() {
    for (open, middle, close) in [
        ("(", "a", ")"),
        ("[", "a", "]"),
        ("{", "a", "}"),
        ("f(", "a", ")"),
        ("√", "a", ""),
        ("a^", "b", ""),
        ("a^(", "b", ")"),
        ("∑_i ", "a", ""),
        ("|a + ", "b", "|"),
        ("∂/∂x ", "a", ""),
        ("x_(", "a", ")"),
        ("a + (b + c × (", "a", "))"),
        ("{k for k ∈ ", "S", "}"),
        ("a ∈ ", "b", ""),
        ("⟨a, ", "b", "⟩"),
        ("-(", "a", ")"),
        ("a + ", "b", ""),
        ("a ", "b", ""),
        ("", "a", "ᵀ"),
        ("a ∘ ", "b", ""),
        ("#", "a", ""),
        ("∑_(i for (i < ", "a", ")) b"),
        ("{ a if ", "a", ""),
        ("a^-", "b", ""),
        ("∫_0^1 ", "a", " 𝕕t"),
    ] {
        on_small_stack(move || {
            let text = format!(
                "f ∈ ℝ → ℝ\ny = {}{middle}{}",
                open.repeat(4000),
                close.repeat(4000)
            );
            survive(&text);
            let (_, diagnostics) = parse(&Source::file("t", text), SourceId(0), &NoImports);
            assert!(diagnostics.has_errors(), "{open}");
        });
    }
    for (open, close) in [("{", "}"), ("(", ")"), ("ℝ → ", "")] {
        let text = format!("y ∈ {}ℝ{}", open.repeat(4000), close.repeat(4000));
        on_small_stack(move || survive(&text));
    }
}

#[test]
fn moderate_nesting_is_fine() {
    let depth = MOST_NESTING / 3;
    for (open, close) in [("(1 + ", ")"), ("√", ""), ("[", "]"), ("2 (1 + ", ")")] {
        let text = format!("a ∈ ℝ\ny = {}a{}", open.repeat(depth), close.repeat(depth));
        let (_, diagnostics) = parse(&Source::file("t", text), SourceId(0), &NoImports);
        assert!(diagnostics.is_empty(), "{open} {:?}", diagnostics.sorted());
    }
}
