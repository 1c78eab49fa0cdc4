//! The command `hlangc fmt`: files in place, standard input, `--check`, and mistakes.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

const ASCII: &str = "r \\in RR\nA=\\pi r^2 // area\n";
const UNICODE: &str = "r ∈ ℝ\nA = π r² // area\n";

/// A folder of its own for each test, with some files.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a writable folder");
    for (file, text) in files {
        std::fs::write(folder.join(file), text).expect("a writable folder");
    }
    folder
}

fn run(folder: &PathBuf, arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_hlangc"))
        .arg("fmt")
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("hlangc runs");
    let mut stdin = child.stdin.take().expect("a pipe");
    stdin.write_all(input.as_bytes()).expect("hlangc reads");
    drop(stdin);
    child.wait_with_output().expect("hlangc ends")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn files_are_written_in_place() {
    let folder = folder("in_place", &[("a.hlang", ASCII), ("b.hlang", UNICODE)]);
    let output = run(&folder, &["a.hlang", "b.hlang"], "");
    assert!(output.status.success() && output.stdout.is_empty());
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).expect("a file");
    assert_eq!(
        (read("a.hlang"), read("b.hlang")),
        (UNICODE.into(), UNICODE.into())
    );
    assert!(run(&folder, &["--ascii", "a.hlang"], "").status.success());
    assert_eq!(read("a.hlang"), "r \\in RR\nA = \\pi r^2 // area\n");
}

#[test]
fn standard_input_goes_to_standard_output() {
    let folder = folder("standard", &[]);
    let output = run(&folder, &["-"], ASCII);
    assert!(output.status.success());
    assert_eq!(text(&output.stdout), UNICODE);
}

#[test]
fn check_names_what_would_change_and_writes_nothing() {
    let folder = folder("check", &[("a.hlang", ASCII), ("b.hlang", UNICODE)]);
    let output = run(&folder, &["--check", "a.hlang", "b.hlang", "-"], ASCII);
    assert!(!output.status.success());
    assert_eq!(text(&output.stdout), "a.hlang\n<stdin>\n");
    assert_eq!(
        std::fs::read_to_string(folder.join("a.hlang")).expect("a file"),
        ASCII
    );
    assert!(run(&folder, &["--check", "b.hlang"], "").status.success());
}

#[test]
fn a_file_with_mistakes_stays_and_the_others_are_written() {
    let folder = folder("mistakes", &[("a.hlang", "A = (r"), ("b.hlang", ASCII)]);
    let output = run(&folder, &["a.hlang", "missing.hlang", "b.hlang"], "");
    assert!(!output.status.success());
    let said = text(&output.stderr);
    assert!(
        said.contains("a.hlang:1:") && said.contains("cannot read missing.hlang"),
        "{said}"
    );
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).expect("a file");
    assert_eq!(
        (read("a.hlang"), read("b.hlang")),
        ("A = (r".into(), UNICODE.into())
    );
}

/// Whether an imported name is a function follows from the module next to the file.
#[test]
fn imported_modules_are_read() {
    let module = "`f_1`(x) = x where x \\in RR\nk = 2\n";
    let program = "* from Other\ny = `f_1`(2)+k(1+1)\n";
    let folder = folder("imports", &[("Other.hlang", module), ("a.hlang", program)]);
    let output = run(&folder, &["a.hlang"], "");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let written = std::fs::read_to_string(folder.join("a.hlang")).expect("a file");
    assert_eq!(written, "* from Other\ny = `f_1`(2) + k(1 + 1)\n");
}
