//! Reading Gmsh files.

use std::collections::HashMap;

use super::views::View;
use super::{HEXAHEDRON, LINE, POINT, PRISM, PYRAMID, QUADRILATERAL, TETRAHEDRON, TRIANGLE};
use crate::io::FIRST_ORDER;
use crate::io::error::Malformed;
use crate::io::mesh_file::MeshFile;
use crate::io::stream::{Encoding, Scalar, Stream};
use crate::io::text::shorten;

const DAMAGED: &str = "the file is truncated or damaged";
const SAVE_AS: &str = "save it as version 2.2 or 4.1";

/// Tags and what they stand for; most files count from 1, without a table.
pub(super) struct Tags<T> {
    counted: Vec<T>,
    others: HashMap<i64, T>,
}

impl<T: Copy> Tags<T> {
    fn new() -> Self {
        Tags {
            counted: Vec::new(),
            others: HashMap::new(),
        }
    }

    /// `false` if the tag stands for something already.
    fn push(&mut self, tag: i64, value: T) -> bool {
        if self.get(tag).is_some() {
            return false;
        }
        match tag == self.counted.len() as i64 + 1 && self.others.is_empty() {
            true => self.counted.push(value),
            false => drop(self.others.insert(tag, value)),
        }
        true
    }

    pub(super) fn get(&self, tag: i64) -> Option<T> {
        let counted = usize::try_from(tag.wrapping_sub(1)).ok();
        counted
            .and_then(|index| self.counted.get(index))
            .or_else(|| self.others.get(&tag))
            .copied()
    }
}

/// The list of the mesh file that an element went to.
#[derive(Clone, Copy)]
pub(super) enum List {
    Edges,
    Polygons,
    Tetrahedra,
    Hexahedra,
    Polyhedra,
}

/// Where an element went: the list and its number there.
pub(super) type Target = (List, u32);

pub(super) struct Reader<'a> {
    pub(super) stream: Stream<'a>,
    encoding: Encoding,
    /// The type of sizes and tags in version 4.1, and of tags in 2.2.
    size: Scalar,
    is_version_4: bool,
    pub(super) file: MeshFile,
    pub(super) nodes: Tags<u32>,
    pub(super) elements: Tags<Target>,
    pub(super) views: Vec<View>,
}

pub(crate) fn read(bytes: &[u8]) -> Result<MeshFile, Malformed> {
    let mut stream = Stream::new(bytes, None);
    let first = stream.word("`$MeshFormat`")?;
    if first != "$MeshFormat" {
        let problem = format!("the file begins with `{}`", shorten(&first));
        return Err(stream.error(problem, "a Gmsh file begins with `$MeshFormat`"));
    }
    let version = stream.word("the version")?;
    let is_version_4 = match &*version {
        "2.2" | "2.1" | "2" => false,
        "4.1" => true,
        _ => {
            let problem = format!(
                "version `{}` of Gmsh files cannot be read",
                shorten(&version)
            );
            return Err(stream.error(problem, SAVE_AS));
        }
    };
    let encoding = match stream.integer("the kind of file")? {
        0 => Encoding::Text,
        1 => Encoding::LittleEndian,
        kind => {
            let problem = format!("the kind of file is {kind}");
            return Err(stream.error(problem, "0 is text, 1 is binary"));
        }
    };
    let size = stream.integer("the size of numbers")?;
    let mut reader = Reader {
        stream,
        encoding,
        size: match (is_version_4, size) {
            (false, _) | (true, 4) => Scalar::I32,
            _ => Scalar::U64,
        },
        is_version_4,
        file: MeshFile::default(),
        nodes: Tags::new(),
        elements: Tags::new(),
        views: Vec::new(),
    };
    if encoding != Encoding::Text {
        reader.byte_order()?;
    }
    reader.end("$EndMeshFormat")?;
    while let Some(section) = reader.stream.next() {
        match &*section {
            "$Nodes" => reader.nodes()?,
            "$Elements" => reader.elements()?,
            "$NodeData" => reader.view(true)?,
            "$ElementData" => reader.view(false)?,
            _ => {
                let Some(name) = section.strip_prefix('$') else {
                    let problem =
                        format!("`{}` stands where a section must begin", shorten(&section));
                    return Err(reader.stream.error(
                        problem,
                        "sections begin with `$`: check the number of entries before",
                    ));
                };
                reader.stream.skip_to(&format!("$End{name}"))?;
                continue;
            }
        }
        reader.end(&section.replacen('$', "$End", 1))?;
    }
    reader.finish()
}

impl Reader<'_> {
    /// A binary file says its byte order by the number 1.
    fn byte_order(&mut self) -> Result<(), Malformed> {
        self.stream.is_binary = true;
        self.stream.rest_of_line();
        self.stream.encoding = Encoding::LittleEndian;
        let one = self.stream.whole("the number 1", Scalar::I32)?;
        self.encoding = match one {
            1 => Encoding::LittleEndian,
            _ if one == i64::from(1_i32.swap_bytes()) => Encoding::BigEndian,
            _ => {
                let problem = format!("{one} stands where the number 1 tells the byte order");
                return Err(self.stream.error(problem, DAMAGED));
            }
        };
        Ok(())
    }

    /// From here on numbers are binary, if they are in this file.
    pub(super) fn begin_binary(&mut self) {
        if self.encoding != Encoding::Text {
            self.stream.rest_of_line();
        }
        self.stream.encoding = self.encoding;
    }

    fn end(&mut self, section: &str) -> Result<(), Malformed> {
        self.stream.encoding = Encoding::Text;
        let word = self.stream.word(&format!("`{section}`"))?;
        if word != section {
            let problem = format!("`{}` stands where `{section}` must", shorten(&word));
            return Err(self.stream.error(problem, "check the number of entries"));
        }
        Ok(())
    }

    fn size(&mut self, what: &str) -> Result<i64, Malformed> {
        self.stream.whole(what, self.size)
    }

    pub(super) fn int(&mut self, what: &str) -> Result<i64, Malformed> {
        self.stream.whole(what, Scalar::I32)
    }

    fn nodes(&mut self) -> Result<(), Malformed> {
        if !self.is_version_4 {
            let count = self.stream.integer("the number of nodes")?;
            self.begin_binary();
            for _ in 0..self.stream.check_count("nodes", count, 4, 28)? {
                let tag = self.int("the tag of a node")?;
                self.node(tag)?;
            }
            return Ok(());
        }
        self.begin_binary();
        let [n_blocks, n_nodes, _, _] = self.sizes()?;
        self.stream.check_count("nodes", n_nodes, 4, 32)?;
        let n_blocks = self
            .stream
            .check_count("blocks of nodes", n_blocks, 4, 20)?;
        for _ in 0..n_blocks {
            let dimension = self.int("the dimension of an entity")?;
            self.int("the tag of an entity")?;
            let is_parametric = self.int("whether nodes have parameters")? != 0;
            let count = self.size("the number of nodes")?;
            let count = self.stream.check_count("nodes", count, 4, 32)?;
            let tags: Vec<i64> = (0..count)
                .map(|_| self.size("the tag of a node"))
                .collect::<Result<_, _>>()?;
            for tag in tags {
                self.node(tag)?;
                let n_parameters = if is_parametric {
                    dimension.clamp(0, 3)
                } else {
                    0
                };
                for _ in 0..n_parameters {
                    self.stream.value("a parameter", Scalar::F64)?;
                }
            }
        }
        let n_read = self.file.positions.len() as i64;
        if n_read != n_nodes {
            let problem = format!("there are to be {n_nodes} nodes, but the blocks have {n_read}");
            return Err(self.stream.error(problem, DAMAGED));
        }
        Ok(())
    }

    /// The four sizes that begin a section of version 4.1.
    fn sizes(&mut self) -> Result<[i64; 4], Malformed> {
        let mut sizes = [0; 4];
        for (size, what) in sizes.iter_mut().zip([
            "the number of blocks",
            "the number of all",
            "the least tag",
            "the greatest tag",
        ]) {
            *size = self.size(what)?;
        }
        Ok(sizes)
    }

    fn node(&mut self, tag: i64) -> Result<(), Malformed> {
        let index = self.file.positions.len() as u32;
        let position = self.stream.position(Scalar::F64)?;
        if !self.nodes.push(tag, index) {
            let problem = format!("there are two nodes {tag}");
            return Err(self.stream.error(problem, "each node has a tag of its own"));
        }
        self.file.positions.push(position);
        Ok(())
    }

    fn elements(&mut self) -> Result<(), Malformed> {
        if self.is_version_4 {
            self.begin_binary();
            let [n_blocks, n_elements, _, _] = self.sizes()?;
            self.stream.check_count("elements", n_elements, 2, 16)?;
            let n_blocks = self
                .stream
                .check_count("blocks of elements", n_blocks, 4, 20)?;
            let mut n_read = 0;
            for _ in 0..n_blocks {
                self.int("the dimension of an entity")?;
                self.int("the tag of an entity")?;
                let kind = self.int("the type of elements")?;
                let count = self.size("the number of elements")?;
                n_read += count;
                for _ in 0..self.stream.check_count("elements", count, 2, 16)? {
                    let tag = self.size("the tag of an element")?;
                    self.element(kind, tag)?;
                }
            }
            if n_read != n_elements {
                let problem =
                    format!("there are to be {n_elements} elements, but the blocks have {n_read}");
                return Err(self.stream.error(problem, DAMAGED));
            }
            return Ok(());
        }
        let count = self.stream.integer("the number of elements")?;
        self.begin_binary();
        let count = self.stream.check_count("elements", count, 4, 8)?;
        if self.encoding == Encoding::Text {
            for _ in 0..count {
                let tag = self.int("the tag of an element")?;
                let kind = self.int("the type of an element")?;
                self.tags()?;
                self.element(kind, tag)?;
            }
            return Ok(());
        }
        let mut n_left = count;
        while n_left > 0 {
            let kind = self.int("the type of elements")?;
            let count = self.int("the number of elements")?;
            let n_tags = self.int("the number of tags")?;
            let block = usize::try_from(count)
                .ok()
                .filter(|count| (1..=n_left).contains(count));
            let (Some(block), 0..=64) = (block, n_tags) else {
                let problem = format!(
                    "a block is to have {count} elements with {n_tags} tags each, and {n_left} elements are left"
                );
                return Err(self.stream.error(problem, DAMAGED));
            };
            n_left -= block;
            for _ in 0..block {
                let tag = self.int("the tag of an element")?;
                for _ in 0..n_tags {
                    self.int("a tag")?;
                }
                self.element(kind, tag)?;
            }
        }
        Ok(())
    }

    /// The tags that belong to groups.
    fn tags(&mut self) -> Result<(), Malformed> {
        let count = self.int("the number of tags")?;
        for _ in 0..self.stream.check_count("tags", count, 1, 4)? {
            self.int("a tag")?;
        }
        Ok(())
    }

    fn corners<const N: usize>(&mut self) -> Result<[u32; N], Malformed> {
        let mut corners = [0; N];
        for corner in &mut corners {
            let tag = self.size("a node")?;
            *corner = self.nodes.get(tag).ok_or_else(|| {
                let problem = format!("an element names node {tag}, which is not there");
                self.stream.error(
                    problem,
                    "nodes are named by their tags, and stand before the elements",
                )
            })?;
        }
        Ok(corners)
    }

    fn element(&mut self, kind: i64, tag: i64) -> Result<(), Malformed> {
        let (list, length) = match kind {
            POINT => {
                self.corners::<1>()?;
                return Ok(());
            }
            LINE => {
                let corners = self.corners()?;
                self.file.edges.push(corners);
                (List::Edges, self.file.edges.len())
            }
            TRIANGLE => {
                let corners = self.corners::<3>()?;
                self.file.polygons.push(&corners);
                (List::Polygons, self.file.polygons.len())
            }
            QUADRILATERAL => {
                let corners = self.corners::<4>()?;
                self.file.polygons.push(&corners);
                (List::Polygons, self.file.polygons.len())
            }
            TETRAHEDRON => {
                let corners = self.corners()?;
                self.file.tetrahedra.push(corners);
                (List::Tetrahedra, self.file.tetrahedra.len())
            }
            HEXAHEDRON => {
                let corners = self.corners()?;
                self.file.hexahedra.push(corners);
                (List::Hexahedra, self.file.hexahedra.len())
            }
            PRISM => {
                let corners = self.corners()?;
                self.file.polyhedra.push_prism(corners);
                (List::Polyhedra, self.file.polyhedra.len())
            }
            PYRAMID => {
                let corners = self.corners()?;
                self.file.polyhedra.push_pyramid(corners);
                (List::Polyhedra, self.file.polyhedra.len())
            }
            _ => {
                let problem = format!(
                    "elements of type {kind} are neither edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms \
                     nor pyramids of first order"
                );
                return Err(self.stream.error(problem, FIRST_ORDER));
            }
        };
        let target = (list, (length - 1) as u32);
        if !self.elements.push(tag, target) {
            let problem = format!("there are two elements {tag}");
            return Err(self
                .stream
                .error(problem, "each element has a tag of its own"));
        }
        Ok(())
    }
}
