//! Why a mesh file could not be read or written.

use std::error::Error;
use std::fmt::{self, Display};
use std::path::{Path, PathBuf};

use crate::element::ElementKind;

/// Where in a file something is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In a line of a text file, counted from 1.
    Line(usize),
    /// At a byte of a binary file, counted from 0.
    Byte(usize),
    /// In an entry, counted from 0, of one of the lists that a file in JSON has, such as `accessors`.
    Entry(&'static str, usize),
}

impl Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Line(line) => write!(formatter, "{line}"),
            Place::Byte(byte) => write!(formatter, "byte {byte}"),
            Place::Entry(list, index) => write!(formatter, "{list}[{index}]"),
        }
    }
}

/// Why a mesh file could not be read or written.
///
/// Printed as `file:line: what; help`, or `file:byte 1234: what; help` in a binary file, or `file:accessors[5]: what; help` in
/// a glTF file.
#[derive(Debug)]
#[non_exhaustive]
pub enum IoError {
    /// The operating system could not read or write the file.
    File {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: std::io::Error,
    },
    /// The file name has no extension of a format that is known.
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// The format is known, but not compiled in.
    MissingFeature {
        /// The file.
        path: PathBuf,
        /// The feature that reads and writes the format.
        feature: &'static str,
    },
    /// The contents are not what the format demands.
    Malformed {
        /// The file.
        path: PathBuf,
        /// Where it is wrong.
        place: Place,
        /// What is wrong.
        problem: String,
        /// What to do.
        help: &'static str,
    },
    /// The values to be written do not fit the mesh, or not the format.
    CannotWrite {
        /// The file.
        path: PathBuf,
        /// What does not fit.
        problem: String,
        /// What to do.
        help: &'static str,
    },
}

impl Display for IoError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            IoError::File { path, source } => write!(formatter, "{}: {source}", path.display()),
            IoError::UnknownFormat { path } => {
                write!(
                    formatter,
                    "{}: unknown file format; name it .obj, .off, .ply, .stl, .mesh, .msh, .vtk, .gltf or .glb",
                    path.display()
                )
            }
            IoError::MissingFeature { path, feature } => {
                write!(
                    formatter,
                    "{}: this format needs the feature `{feature}` of iheartmesh; add it in Cargo.toml",
                    path.display()
                )
            }
            IoError::Malformed {
                path,
                place,
                problem,
                help,
            } => {
                write!(formatter, "{}:{place}: {problem}; {help}", path.display())
            }
            IoError::CannotWrite {
                path,
                problem,
                help,
            } => {
                write!(formatter, "{}: {problem}; {help}", path.display())
            }
        }
    }
}

impl Error for IoError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            IoError::File { source, .. } => Some(source),
            _ => None,
        }
    }
}

/// [`IoError::Malformed`] before the file's name is known.
#[derive(Debug)]
pub(super) struct Malformed {
    pub(super) place: Place,
    pub(super) problem: String,
    pub(super) help: &'static str,
}

impl Malformed {
    pub(super) fn in_file(self, path: &Path) -> IoError {
        let Malformed {
            place,
            problem,
            help,
        } = self;
        IoError::Malformed {
            path: path.to_owned(),
            place,
            problem,
            help,
        }
    }
}

/// [`IoError::CannotWrite`] before the file's name is known.
#[derive(Debug)]
pub(super) struct CannotWrite {
    pub(super) problem: String,
    pub(super) help: &'static str,
}

impl CannotWrite {
    pub(super) fn about(self, path: &Path) -> IoError {
        IoError::CannotWrite {
            path: path.to_owned(),
            problem: self.problem,
            help: self.help,
        }
    }
}

/// "3 vertices", "1 face".
pub(super) fn counted(n: usize, kind: ElementKind) -> String {
    match (n, kind) {
        (1, _) => format!("1 {kind}"),
        (_, ElementKind::Vertex) => format!("{n} vertices"),
        _ => format!("{n} {kind}s"),
    }
}
