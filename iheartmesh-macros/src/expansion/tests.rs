//! Errors of whole calls: which file and place they name.

use super::expand;
use proc_macro2::TokenStream;

fn expanded(call: &str) -> String {
    let tokens: TokenStream = format!("[k] [k::macros] [k::standard] {call}")
        .parse()
        .unwrap();
    let text = expand(tokens).to_string();
    // as it stands in the literals of the messages
    text.replace("\\n", "\n")
}

#[test]
fn a_mistake_in_an_included_file_names_that_file() {
    let call = "pub struct Sums = include \"src/expansion/mistake.hlang\";";
    let text = expanded(call);
    let message = "cannot add ℝ³ and ℝ\n --> src/expansion/mistake.hlang:4:8\n";
    assert!(text.contains(message), "{text}");
    assert_eq!(text.matches("compile_error").count(), 1);
    // an edit of the file expands the call again
    assert!(text.contains("include_bytes"), "{text}");
}
