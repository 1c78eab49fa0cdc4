//! Reading VTK.

use glam::DVec3;

use super::cells::Sources;
use super::{LINE, POLY_LINE, POLY_VERTEX, POLYGON, TRIANGLE_STRIP};
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, COLOR};
use crate::io::error::{Malformed, counted};
use crate::io::mesh_file::MeshFile;
use crate::io::stream::{Encoding, Scalar, Stream};
use crate::io::text::{percent_decoded, shorten};

const DAMAGED: &str = "the file is truncated or damaged";

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
        count: None,
    };
    while let Some(keyword) = reader.stream.next() {
        reader.section(&keyword.to_ascii_uppercase())?;
    }
    reader.make_cells()?;
    Ok(reader.file)
}

/// The cells as they stand in the file, until all is known of them.
#[derive(Default)]
struct Cells {
    /// Where the corners of each cell end.
    ends: Vec<usize>,
    corners: Vec<i64>,
    kinds: Vec<u8>,
}

struct Reader<'a> {
    stream: Stream<'a>,
    encoding: Encoding,
    file: MeshFile,
    cells: Cells,
    sources: Sources,
    is_polygonal: bool,
    /// The kind of element that values belong to, at vertices or not, and how many there are.
    count: Option<(bool, usize)>,
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
                    self.cells.kinds.push(u8::try_from(kind).unwrap_or(u8::MAX));
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
    fn begin(
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

    fn scalar(&mut self) -> Result<Scalar, Malformed> {
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
            for _ in 0..self.begin("corners", second, 1, scalar.size())? {
                let corner = self.stream.whole("a corner", scalar)?;
                self.cells.corners.push(corner);
            }
        } else {
            let length = self.begin("entries", second, 1, 4)?;
            let mut left = length;
            for _ in 0..usize::try_from(first).unwrap_or(0) {
                let n_corners = self.stream.whole("the number of corners", Scalar::I32)?;
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
        // corners may stand before the points: they are compared when all is known, but most files are in order
        let n_points = self.file.positions.len();
        let new = &self.cells.corners[start..];
        if let Some(corner) = new.iter().find(|&&corner| !is_below(corner, n_points)) {
            let problem = format!(
                "a cell names vertex {corner}, but the file has {}",
                counted(n_points, ElementKind::Vertex)
            );
            return Err(self.stream.error(problem, "vertices are numbered from 0"));
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
        let mut start = 0;
        for (&end, kind) in cells.ends.iter().zip(cells.kinds) {
            let corners: Vec<u32> = cells.corners[start..end]
                .iter()
                .map(|&corner| corner as u32)
                .collect();
            let kind = match (self.is_polygonal, kind, corners.len()) {
                (true, POLY_LINE, 2) => LINE,
                _ => kind,
            };
            self.sources
                .push(kind, &corners, &mut self.file)
                .map_err(|problem| {
                    self.stream
                        .error(problem, "remove it, or save it as other cells")
                })?;
            start = end;
        }
        Ok(())
    }

    fn values_of(
        &mut self,
        is_at_vertices: bool,
        n_elements: usize,
        elements: &str,
    ) -> Result<(), Malformed> {
        let count = self.stream.integer("the number of values")?;
        if usize::try_from(count) != Ok(n_elements) {
            let problem =
                format!("there are values of {count} {elements}, but {n_elements} {elements}");
            return Err(self.stream.error(problem, DAMAGED));
        }
        self.count = Some((is_at_vertices, n_elements));
        Ok(())
    }

    /// An array of values, begun with this word.
    fn attribute(&mut self, keyword: &str) -> Result<(), Malformed> {
        let known = "SCALARS COLOR_SCALARS VECTORS NORMALS TENSORS TENSORS6 TEXTURE_COORDINATES GLOBAL_IDS PEDIGREE_IDS LOOKUP_TABLE";
        if !known.split(' ').any(|word| word == keyword) {
            let problem = format!("unknown section `{}`", shorten(keyword));
            return Err(self
                .stream
                .error(problem, "remove it, or check the number of entries before"));
        }
        let name = percent_decoded(&self.stream.word("the name of the values")?);
        if keyword == "LOOKUP_TABLE" {
            // colours with opacity
            let count = self.stream.integer("the number of colours")?;
            let count = self.begin("colours", count, 4, 1)?;
            for _ in 0..4 * count {
                self.stream.value("a part of a colour", Scalar::U8)?;
            }
            return Ok(());
        }
        let Some((_, count)) = self.count else {
            let problem = format!("the values `{}` belong to nothing", shorten(&name));
            return Err(self
                .stream
                .error(problem, "`POINT_DATA` or `CELL_DATA` stands before values"));
        };
        let mut n_components = match keyword {
            "VECTORS" | "NORMALS" => 3,
            "TENSORS" => 9,
            "TENSORS6" => 6,
            "COLOR_SCALARS" | "TEXTURE_COORDINATES" => {
                self.stream.integer("the number of components")?
            }
            _ => 1,
        };
        if keyword == "COLOR_SCALARS" {
            let values = self.numbers(count, n_components, Scalar::U8)?;
            // a colour has three parts, and perhaps an opacity
            let is_color = n_components >= 3;
            let factor = match self.encoding {
                Encoding::Text if is_color => 255.0,
                _ => 1.0,
            };
            let values: Vec<f64> = values.iter().map(|value| value * factor).collect();
            self.keep(&name, &values, n_components as usize, is_color)?;
            return Ok(());
        }
        let scalar = self.scalar()?;
        if keyword == "SCALARS" {
            let rest = self.stream.rest_of_line();
            n_components = match rest.is_empty() {
                true => 1,
                false => rest.parse().unwrap_or(0),
            };
            let word = self.stream.word("`LOOKUP_TABLE`")?;
            if word != "LOOKUP_TABLE" {
                let problem = format!("`{}` stands where `LOOKUP_TABLE` must", shorten(&word));
                return Err(self.stream.error(problem, DAMAGED));
            }
            self.stream.word("the name of the lookup table")?;
        }
        let values = self.numbers(count, n_components, scalar)?;
        let is_color = scalar == Scalar::U8 && matches!(n_components, 3 | 4);
        self.keep(&name, &values, n_components as usize, is_color)?;
        Ok(())
    }
    /// So many numbers for each of `count` elements.
    fn numbers(
        &mut self,
        count: usize,
        n_components: i64,
        scalar: Scalar,
    ) -> Result<Vec<f64>, Malformed> {
        if n_components < 1 {
            let problem = format!("the values have {n_components} components");
            return Err(self.stream.error(problem, DAMAGED));
        }
        let count = n_components.saturating_mul(i64::try_from(count).unwrap_or(i64::MAX));
        let count = self.begin("values", count, 1, scalar.size())?;
        let values = (0..count).map(|_| self.stream.value("a value", scalar));
        let values = values.collect();
        self.stream.encoding = Encoding::Text;
        values
    }

    /// Arrays of any sizes; those that have a value for each element are its values.
    fn field(&mut self) -> Result<(), Malformed> {
        self.stream.word("the name of the field")?;
        let n_arrays = self.stream.integer("the number of arrays")?;
        for _ in 0..n_arrays {
            if self.stream.peek().as_deref() == Some("METADATA") {
                self.stream.next();
                self.metadata();
            }
            let name = percent_decoded(&self.stream.word("the name of an array")?);
            let n_components = self.stream.integer("the number of components")?;
            let n_values = self.stream.integer("the number of values")?;
            let scalar = self.scalar()?;
            let Ok(count) = usize::try_from(n_values) else {
                let problem = format!("the number of values is {n_values}");
                return Err(self.stream.error(problem, "it cannot be negative"));
            };
            let values = match count {
                0 => Vec::new(),
                _ => self.numbers(count, n_components, scalar)?,
            };
            if self.count.is_some_and(|(_, expected)| expected == count) && count > 0 {
                let is_color = scalar == Scalar::U8 && matches!(n_components, 3 | 4);
                self.keep(&name, &values, n_components as usize, is_color)?;
            }
        }
        Ok(())
    }

    /// Reads past what VTK adds to arrays, up to an empty line.
    fn metadata(&mut self) {
        self.stream.rest_of_line();
        while !self.stream.rest_of_line().is_empty() {}
    }

    /// Values, `n` for each element, as attributes.
    fn keep(
        &mut self,
        name: &str,
        values: &[f64],
        n: usize,
        is_color: bool,
    ) -> Result<(), Malformed> {
        if matches!(self.count, Some((false, _))) {
            // a cell of VTK may be many elements
            let n_values = self.sources.n_elements().saturating_mul(n);
            self.stream.take_memory(n_values.saturating_mul(8), name)?;
        }
        let rows = values.chunks_exact(n);
        if is_color {
            // Saturates, and takes NaN to 0.
            let color = |row: &[f64]| [row[0], row[1], row[2]].map(|part| part.round() as u8);
            self.push(COLOR, AttributeValues::Color(rows.map(color).collect()));
        } else if n == 3 {
            let vectors = rows.map(DVec3::from_slice).collect();
            self.push(name, AttributeValues::Vector(vectors));
        } else {
            for component in 0..n {
                let scalars = rows.clone().map(|row| row[component]).collect();
                let name = match n {
                    1 => name.to_owned(),
                    _ => format!("{name}_{component}"),
                };
                self.push(&name, AttributeValues::Scalar(scalars));
            }
        }
        Ok(())
    }

    fn push(&mut self, name: &str, values: AttributeValues) {
        match self.count {
            Some((true, _)) => self.file.attributes.push(ElementKind::Vertex, name, values),
            _ => self.sources.distribute(name, &values, &mut self.file),
        }
    }
}

/// Whether a corner is one of so many vertices.
fn is_below(corner: i64, n_vertices: usize) -> bool {
    usize::try_from(corner).is_ok_and(|corner| corner < n_vertices)
}
