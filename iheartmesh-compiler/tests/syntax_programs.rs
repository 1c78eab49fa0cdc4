//! The trees of whole programs: those of the paper and of the language reference.

mod syntax_support;

use expect_test::expect_file;
use syntax_support::{corpus, show};

#[test]
fn programs() {
    for (name, text) in corpus() {
        let path = format!("corpus/syntax_trees/{name}.txt");
        expect_file![path].assert_eq(&show(&text));
    }
}
