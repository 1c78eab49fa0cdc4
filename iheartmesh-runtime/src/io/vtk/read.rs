//! Reading VTK.

use super::cells::{Cells, Sources};
use super::wedges;
use super::{LINE, POLY_LINE, POLY_VERTEX, POLYGON, TRIANGLE_STRIP};
use crate::io::error::Malformed;
use crate::io::mesh_file::MeshFile;
use crate::io::stream::{Encoding, Scalar, Stream};
use crate::io::text::shorten;

pub(super) const DAMAGED: &str = "the file is truncated or damaged";

pub(crate) fn read(bytes: &[u8]) -> Result<MeshFile, Malformed> {
    let mut stream = Stream::new(bytes, None);
    let first = stream.rest_of_line();
    if !first.starts_with("# vtk DataFile Version") {
        let problem = format!("the first line is `{}`", shorten(&first));
        return Err(stream.error(
            problem,
            "a legacy VTK file begins with `# vtk DataFile Version 3.0`; a file in XML cannot be read",
        ));
    }
    stream.rest_of_line();
    let encoding = stream.word("`ASCII` or `BINARY`")?;
    let encoding = match &*encoding.to_ascii_uppercase() {
        "ASCII" => Encoding::Text,
        "BINARY" => Encoding::BigEndian,
        _ => {
            let problem = format!("`{}` is no encoding", shorten(&encoding));
            return Err(stream.error(problem, "the third line is `ASCII` or `BINARY`"));
        }
    };
    stream.is_binary = encoding != Encoding::Text;
    let mut reader = Reader {
        stream,
        encoding,
        file: MeshFile::default(),
        cells: Cells::default(),
        sources: Sources::default(),
        is_polygonal: false,
        has_points: false,
        count: None,
    };
    while let Some(keyword) = reader.stream.next() {
        reader.section(&keyword.to_ascii_uppercase())?;
    }
    reader.make_cells()?;
    Ok(reader.file)
}

pub(super) struct Reader<'a> {
    pub(super) stream: Stream<'a>,
    pub(super) encoding: Encoding,
    pub(super) file: MeshFile,
    cells: Cells,
    pub(super) sources: Sources,
    is_polygonal: bool,
    has_points: bool,
    /// The kind of element that values belong to, at vertices or not, and how many there are.
    pub(super) count: Option<(bool, usize)>,
}

impl Reader<'_> {
    fn section(&mut self, keyword: &str) -> Result<(), Malformed> {
        match keyword {
            "DATASET" => {
                let kind = self.stream.word("the kind of data set")?;
                self.is_polygonal = match &*kind.to_ascii_uppercase() {
                    "UNSTRUCTURED_GRID" => false,
                    "POLYDATA" => true,
                    _ => {
                        let problem = format!("the data set is `{}`", shorten(&kind));
                        return Err(self.stream.error(
                            problem,
                            "UNSTRUCTURED_GRID and POLYDATA can be read: save it as one of these",
                        ));
                    }
                };
            }
            "POINTS" => {
                if std::mem::replace(&mut self.has_points, true) {
                    let problem = "there are two lists of points";
                    return Err(self.stream.error(problem, "keep one"));
                }
                let count = self.stream.integer("the number of points")?;
                let scalar = self.scalar()?;
                let count = self.begin("points", count, 3, scalar.size())?;
                self.file.positions = Vec::with_capacity(count);
                for _ in 0..count {
                    let position = self.stream.position(scalar)?;
                    self.file.positions.push(position);
                }
            }
            "CELLS" => self.connectivity(None)?,
            "VERTICES" => self.connectivity(Some(POLY_VERTEX))?,
            "LINES" => self.connectivity(Some(POLY_LINE))?,
            "POLYGONS" => self.connectivity(Some(POLYGON))?,
            "TRIANGLE_STRIPS" => self.connectivity(Some(TRIANGLE_STRIP))?,
            "CELL_TYPES" => {
                let count = self.stream.integer("the number of cells")?;
                let count = self.begin("cells", count, 1, 4)?;
                for _ in 0..count {
                    let kind = self.stream.whole("the type of a cell", Scalar::I32)?;
                    let Ok(kind) = u8::try_from(kind) else {
                        let problem = format!("there is no type {kind} of cells");
                        return Err(self.stream.error(problem, DAMAGED));
                    };
                    self.cells.kinds.push(kind);
                }
            }
            "POINT_DATA" => {
                let n_points = self.file.positions.len();
                self.values_of(true, n_points, "points")?;
            }
            "CELL_DATA" => {
                self.make_cells()?;
                self.values_of(false, self.sources.n_cells, "cells")?;
            }
            "METADATA" => self.metadata(),
            "FIELD" => self.field()?,
            _ => self.attribute(keyword)?,
        }
        self.stream.encoding = Encoding::Text;
        Ok(())
    }

    /// The begin of an array whose entries take this many words, or numbers of so many bytes.
    pub(super) fn begin(
        &mut self,
        list: &str,
        count: i64,
        words: usize,
        size: usize,
    ) -> Result<usize, Malformed> {
        if self.encoding != Encoding::Text {
            // the bytes begin after the line
            self.stream.rest_of_line();
        }
        self.stream.encoding = self.encoding;
        self.stream
            .check_count(list, count, words, words.saturating_mul(size))
    }

    pub(super) fn scalar(&mut self) -> Result<Scalar, Malformed> {
        let name = self.stream.word("the type of the numbers")?;
        Ok(match &*name.to_ascii_lowercase() {
            "char" | "vtktypeint8" => Scalar::I8,
            "unsigned_char" | "vtktypeuint8" => Scalar::U8,
            "short" | "vtktypeint16" => Scalar::I16,
            "unsigned_short" | "vtktypeuint16" => Scalar::U16,
            // VTK writes its identifiers with 32 bits
            "int" | "vtktypeint32" | "vtkidtype" => Scalar::I32,
            "unsigned_int" | "vtktypeuint32" => Scalar::U32,
            "long" | "vtktypeint64" => Scalar::I64,
            "unsigned_long" | "vtktypeuint64" => Scalar::U64,
            "float" => Scalar::F32,
            "double" => Scalar::F64,
            _ => {
                let problem = format!("there is no type `{}` of numbers", shorten(&name));
                return Err(self.stream.error(
                    problem,
                    "types are `double`, `float`, `int`, `unsigned_char`, …",
                ));
            }
        })
    }

    /// The corners of cells, which are all of one kind if they are of polygonal data.
    fn connectivity(&mut self, kind: Option<u8>) -> Result<(), Malformed> {
        let first = self.stream.integer("the number of cells")?;
        let second = self.stream.integer("the length of the list of cells")?;
        let n_before = self.cells.ends.len();
        let start = self.cells.corners.len();
        if self.stream.peek().as_deref() == Some("OFFSETS") {
            // version 5: where the corners of each cell begin, and of a last one that is not there
            self.stream.next();
            let scalar = self.scalar()?;
            let count = self.begin("offsets", first, 1, scalar.size())?;
            let mut last = 0;
            for index in 0..count {
                let offset = self.stream.whole("an offset", scalar)?;
                if offset < last || offset > second || (index == 0 && offset != 0) {
                    let problem = format!("offset {index} is {offset} after {last}");
                    return Err(self.stream.error(problem, DAMAGED));
                }
                if index > 0 {
                    self.cells.ends.push(start + offset as usize);
                }
                last = offset;
            }
            if last != second && count > 0 {
                let problem = format!("the last offset is {last}, but there are {second} corners");
                return Err(self.stream.error(problem, DAMAGED));
            }
            self.stream.encoding = Encoding::Text;
            let word = self.stream.word("`CONNECTIVITY`")?;
            if word != "CONNECTIVITY" {
                let problem = format!("`{}` stands where `CONNECTIVITY` must", shorten(&word));
                return Err(self.stream.error(problem, DAMAGED));
            }
            let scalar = self.scalar()?;
            let n_corners = self.begin("corners", second, 1, scalar.size())?;
            // the place of a cell is that of its first corner
            let mut ends = self.cells.ends[n_before..].iter();
            let mut next = start;
            for _ in 0..n_corners {
                let corner = self.stream.whole("a corner", scalar)?;
                while next == self.cells.corners.len() {
                    let Some(&end) = ends.next() else { break };
                    self.cells.places.push(self.stream.place());
                    next = end;
                }
                self.cells.corners.push(corner);
            }
            // cells without corners, at the end
            let n_cells = self.cells.ends.len();
            self.cells.places.resize(n_cells, self.stream.place());
        } else {
            let length = self.begin("entries", second, 1, 4)?;
            let mut left = length;
            for _ in 0..usize::try_from(first).unwrap_or(0) {
                let n_corners = self.stream.whole("the number of corners", Scalar::I32)?;
                self.cells.places.push(self.stream.place());
                let fits = usize::try_from(n_corners)
                    .ok()
                    .and_then(|n| left.checked_sub(n + 1));
                let Some(next) = fits else {
                    let problem = format!(
                        "a cell is to have {n_corners} corners, but {} numbers are left of the {length} of the list",
                        left.saturating_sub(1)
                    );
                    return Err(self.stream.error(problem, DAMAGED));
                };
                left = next;
                for _ in 0..n_corners {
                    let corner = self.stream.whole("a corner", Scalar::I32)?;
                    self.cells.corners.push(corner);
                }
                self.cells.ends.push(self.cells.corners.len());
            }
            if left > 0 || first < 0 {
                let problem = format!("the list of {first} cells has {left} numbers too many");
                return Err(self.stream.error(problem, DAMAGED));
            }
        }
        if let Some(kind) = kind {
            let n_cells = self.cells.ends.len() - n_before;
            self.cells.kinds.extend(std::iter::repeat_n(kind, n_cells));
        }
        Ok(())
    }

    /// Makes elements of the cells that have been read.
    fn make_cells(&mut self) -> Result<(), Malformed> {
        let cells = std::mem::take(&mut self.cells);
        if cells.kinds.len() != cells.ends.len() {
            let problem = format!(
                "there are {} cells, but types of {}",
                cells.ends.len(),
                cells.kinds.len()
            );
            return Err(self.stream.error(problem, DAMAGED));
        }
        let are_reversed = wedges::are_reversed(cells.wedges(), &self.file.positions);
        for (place, kind, numbers) in cells.iter() {
            let kind = match (self.is_polygonal, kind, numbers.len()) {
                (true, POLY_LINE, 2) => LINE,
                _ => kind,
            };
            let pushed = self
                .sources
                .push(kind, numbers, are_reversed, &mut self.file);
            pushed.map_err(|(problem, help)| self.stream.error_at(place, problem, help))?;
        }
        Ok(())
    }
}
