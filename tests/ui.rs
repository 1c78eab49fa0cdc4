//! The macro as rustc shows it: where errors point, that nothing else is reported, and what compiles.
//!
//! `TRYBUILD=overwrite cargo test --test ui` writes the expected texts anew. They hold for the pinned toolchain.

#[test]
fn what_rustc_shows() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/pass/*.rs");
    cases.compile_fail("tests/ui/fail/*.rs");
}
