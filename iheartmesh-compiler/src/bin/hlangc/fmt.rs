//! `hlangc fmt`: files in the canonical spelling and layout.

use std::ffi::OsString;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use iheartmesh_compiler::format;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::syntax::print::Spelling;

const USAGE: &str = "\
usage: hlangc fmt [--ascii] [--check] [--library FOLDER]... FILE.hlang...

Writes each file again, in its place, with the signs of mathematics instead of their ASCII spellings, blanks and
indentation in one way. Meaning, comments and the author's lines stay. `-` reads standard input and writes to standard
output. A file with mistakes is left as it is.

  --ascii            ASCII spellings instead of signs, wherever there is one
  --check            writes nothing; names the files that would change and fails if there is one
  --library FOLDER   looks for imported modules in FOLDER as well";

struct Arguments {
    spelling: Spelling,
    check: bool,
    folders: Vec<PathBuf>,
    files: Vec<PathBuf>,
}

/// Formats what the words after `fmt` ask for.
pub fn main(words: impl Iterator<Item = OsString>) -> ExitCode {
    let arguments = match super::or_usage(arguments(words), USAGE) {
        Ok(arguments) => arguments,
        Err(end) => return end,
    };
    let mut success = true;
    for file in &arguments.files {
        match one(file, &arguments) {
            Ok(fine) => success &= fine,
            Err(message) => {
                eprintln!("{}", message.trim_end());
                success = false;
            }
        }
    }
    if success {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn arguments(words: impl Iterator<Item = OsString>) -> Result<Option<Arguments>, String> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_args(words);
    let mut arguments = Arguments {
        spelling: Spelling::Unicode,
        check: false,
        folders: Vec::new(),
        files: Vec::new(),
    };
    while let Some(argument) = parser.next().map_err(|e| e.to_string())? {
        match argument {
            Long("help") | Short('h') => return Ok(None),
            Long("ascii") => arguments.spelling = Spelling::Ascii,
            Long("check") => arguments.check = true,
            Long("library") => {
                let folder = parser.value().map_err(|e| e.to_string())?;
                arguments.folders.push(folder.into());
            }
            Value(file) => arguments.files.push(file.into()),
            other => return Err(other.unexpected().to_string()),
        }
    }
    match arguments.files.is_empty() {
        true => Err("no file is given; `-` is standard input".to_owned()),
        false => Ok(Some(arguments)),
    }
}

/// Formats one file, and says whether all is well with it.
fn one(file: &Path, arguments: &Arguments) -> Result<bool, String> {
    let standard = file == Path::new("-");
    let source = match standard {
        true => standard_input()?,
        false => super::read(file)?,
    };
    let before = source.text.clone();
    let libraries = super::libraries(&source, &arguments.folders, file.parent())?;
    let after = format(source, &libraries, arguments.spelling)
        .map_err(|(diagnostics, sources)| super::messages(&sources, &diagnostics, &[]))?;
    let name = if standard {
        "<stdin>".into()
    } else {
        file.display().to_string()
    };
    if arguments.check {
        if before != after {
            // a reader that has seen enough may have closed the pipe
            let _ = writeln!(std::io::stdout(), "{name}");
        }
        return Ok(before == after);
    }
    if standard {
        let _ = std::io::stdout().write_all(after.as_bytes());
    } else if before != after {
        std::fs::write(file, after).map_err(|e| format!("error: cannot write {name}: {e}"))?;
    }
    Ok(true)
}

fn standard_input() -> Result<Source, String> {
    let mut text = String::new();
    match std::io::stdin().read_to_string(&mut text) {
        Ok(_) => Ok(Source::file("<stdin>", text)),
        Err(error) => Err(format!("error: cannot read standard input: {error}")),
    }
}
