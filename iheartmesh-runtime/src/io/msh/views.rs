//! Values in Gmsh files.

use glam::DVec3;

use super::read::{List, Reader, Target};
use crate::element::ElementKind;
use crate::io::attributes::AttributeValues;
use crate::io::error::Malformed;
use crate::io::mesh_file::MeshFile;
use crate::io::stream::Scalar;
use crate::io::text::shorten;

/// Values on nodes or elements by tag, until all elements are known.
pub(super) struct View {
    is_at_nodes: bool,
    name: String,
    n_components: usize,
    tags: Vec<i64>,
    values: Vec<f64>,
}

impl Reader<'_> {
    pub(super) fn view(&mut self, is_at_nodes: bool) -> Result<(), Malformed> {
        let n_names = self.stream.integer("the number of names")?;
        self.stream.rest_of_line();
        let mut name = String::new();
        for index in 0..self.stream.check_count("names", n_names, 1, 1)? {
            let line = self.stream.rest_of_line();
            if index == 0 {
                name = line.trim_matches('"').to_owned();
            }
        }
        let n_reals = self.stream.integer("the number of real tags")?;
        for _ in 0..self.stream.check_count("real tags", n_reals, 1, 1)? {
            self.stream.number("a real tag")?;
        }
        let n_integers = self.stream.integer("the number of integer tags")?;
        let mut integers = [0, 1, 0];
        for index in 0..self.stream.check_count("integer tags", n_integers, 1, 1)? {
            let tag = self.stream.integer("an integer tag")?;
            if let Some(place) = integers.get_mut(index) {
                *place = tag;
            }
        }
        let [_, n_components, count] = integers;
        if !(1..=9).contains(&n_components) {
            let problem = format!(
                "the values of `{}` have {n_components} components",
                shorten(&name)
            );
            return Err(self.stream.error(problem, "1, 3 or 9 are known"));
        }
        self.begin_binary();
        let n_components = n_components as usize;
        let count =
            self.stream
                .check_count("values", count, 1 + n_components, 4 + 8 * n_components)?;
        let mut view = View {
            is_at_nodes,
            name,
            n_components,
            tags: Vec::with_capacity(count),
            values: Vec::with_capacity(count * n_components),
        };
        for _ in 0..count {
            let tag = self.int("a tag")?;
            let is_known = match is_at_nodes {
                true => self.nodes.get(tag).is_some(),
                false => self.elements.get(tag).is_some(),
            };
            if !is_known {
                let element = if is_at_nodes { "node" } else { "element" };
                let problem = format!("a value belongs to {element} {tag}, which is not there");
                return Err(self
                    .stream
                    .error(problem, "values stand after the elements"));
            }
            view.tags.push(tag);
            for _ in 0..n_components {
                view.values.push(self.stream.value("a value", Scalar::F64)?);
            }
        }
        self.views.push(view);
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<MeshFile, Malformed> {
        let n_tetrahedra = self.file.tetrahedra.len() as u32;
        let n_first = n_tetrahedra + self.file.hexahedra.len() as u32;
        let element = |(list, index): Target| match list {
            List::Edges => (ElementKind::Edge, index),
            List::Polygons => (ElementKind::Face, index),
            List::Tetrahedra => (ElementKind::Cell, index),
            List::Hexahedra => (ElementKind::Cell, n_tetrahedra + index),
            List::Polyhedra => (ElementKind::Cell, n_first + index),
        };
        for view in std::mem::take(&mut self.views) {
            let target = |&tag: &i64| match view.is_at_nodes {
                true => self.nodes.get(tag).map(|node| (ElementKind::Vertex, node)),
                false => self.elements.get(tag).map(element),
            };
            for (kind, n_elements) in [
                (ElementKind::Vertex, self.file.positions.len()),
                (ElementKind::Edge, self.file.edges.len()),
                (ElementKind::Face, self.file.polygons.len()),
                (ElementKind::Cell, self.file.n_cells()),
            ] {
                let n = view.n_components;
                let mut values = Vec::new();
                for (row, tag) in view.values.chunks_exact(n).zip(&view.tags) {
                    if let Some((_, index)) = target(tag).filter(|(other, _)| *other == kind) {
                        values.resize(n_elements * n, f64::NAN);
                        values[index as usize * n..][..n].copy_from_slice(row);
                    }
                }
                if values.is_empty() {
                    continue;
                }
                self.stream.take_memory(values.len() * 8, &view.name)?;
                let rows = values.chunks_exact(n);
                let attributes = &mut self.file.attributes;
                if n == 3 {
                    let vectors = AttributeValues::Vector(rows.map(DVec3::from_slice).collect());
                    attributes.push(kind, &view.name, vectors);
                    continue;
                }
                for component in 0..n {
                    let scalars = rows.clone().map(|row| row[component]).collect();
                    let name = match n {
                        1 => view.name.clone(),
                        _ => format!("{}_{component}", view.name),
                    };
                    attributes.push(kind, &name, AttributeValues::Scalar(scalars));
                }
            }
        }
        Ok(self.file)
    }
}
