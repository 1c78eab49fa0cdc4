//! The grammar of the language reference (its §2), production by production, with the rules of this implementation.
//!
//! Each file of `corpus/grammar` holds probes, each with its tree or its message below it. `UPDATE_EXPECT=1` writes
//! the trees of new lines; what it writes is to be read.

mod syntax_support;

use expect_test::expect_file;
use syntax_support::probes;

#[test]
fn productions() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/grammar");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("the corpus is part of the crate") {
        let path = entry.expect("a readable folder").path();
        let text = std::fs::read_to_string(&path).expect("a readable file");
        let rows: Vec<&str> = text.lines().filter(|line| !line.starts_with(' ')).collect();
        count += rows.len();
        expect_file![&path].assert_eq(&probes(&rows.join("\n")));
    }
    assert!(count > 300, "{count} probes");
}
