//! Triangles and edges of glTF files.

use ::gltf::json::accessor::ComponentType;
use ::gltf::json::mesh::{Mode, Primitive};
use ::gltf::json::validation::Checked;
use glam::DMat4;

use super::read::{DAMAGED, Reader};
use crate::element::ElementKind;
use crate::io::error::{Malformed, Place, counted};

impl Reader<'_> {
    /// The triangles or edges of a primitive between `count` vertices from `first` on.
    pub(super) fn elements(
        &mut self,
        primitive: &Primitive,
        place: Place,
        (first, count): (usize, usize),
        placed: DMat4,
    ) -> Result<(), Malformed> {
        let Checked::Valid(mode) = primitive.mode else {
            return Err(Malformed {
                place,
                problem: "the mode of a primitive is unknown".to_owned(),
                help: "modes are 0 to 6",
            });
        };
        let corners: Vec<u32> = match primitive.indices {
            None => {
                self.contents.take(count.saturating_mul(4), place)?;
                (first..first + count).map(|vertex| vertex as u32).collect()
            }
            Some(accessor) => {
                let place = Place::Entry("accessors", accessor.value());
                let numbers = self.contents.numbers(accessor.value(), place)?;
                let is_unsigned = matches!(
                    numbers.component,
                    ComponentType::U8 | ComponentType::U16 | ComponentType::U32
                );
                if !is_unsigned || numbers.n_components != 1 {
                    return Err(Malformed {
                        place,
                        problem: "the vertices of elements are not single whole numbers".to_owned(),
                        help: "they are of type SCALAR with components 5121, 5123 or 5125",
                    });
                }
                // 32 bits are exact
                let is_vertex = |index: &f64| (*index as usize) < count;
                if let Some(index) = numbers.values.iter().find(|index| !is_vertex(index)) {
                    let problem = format!(
                        "an element names vertex {index} of {}",
                        counted(count, ElementKind::Vertex)
                    );
                    return Err(Malformed {
                        place,
                        problem,
                        help: "vertices are numbered from 0",
                    });
                }
                let values = numbers.values.iter();
                values
                    .map(|index| (first + *index as usize) as u32)
                    .collect()
            }
        };
        let n_together = match mode {
            Mode::Triangles => 3,
            Mode::Lines => 2,
            _ => 1,
        };
        if !corners.len().is_multiple_of(n_together) {
            let problem = format!("{} vertices are no multiple of {n_together}", corners.len());
            return Err(Malformed {
                place,
                problem,
                help: DAMAGED,
            });
        }
        // strips and fans name each vertex once for up to three triangles
        self.contents
            .take(corners.len().saturating_mul(20), place)?;
        // a reflection turns triangles over
        let is_turned = placed.determinant() < 0.0;
        let polygons = &mut self.file.polygons;
        let mut triangle = |[a, b, c]: [u32; 3]| match is_turned {
            true => polygons.push(&[a, c, b]),
            false => polygons.push(&[a, b, c]),
        };
        match mode {
            Mode::Points => {}
            Mode::Lines => self.file.edges.extend(corners.as_chunks::<2>().0),
            Mode::LineStrip | Mode::LineLoop => {
                let edges = corners.windows(2).map(|edge| [edge[0], edge[1]]);
                self.file.edges.extend(edges);
                if let (Mode::LineLoop, &[start, .., end]) = (mode, &corners[..]) {
                    self.file.edges.push([end, start]);
                }
            }
            Mode::Triangles => corners
                .as_chunks::<3>()
                .0
                .iter()
                .copied()
                .for_each(triangle),
            Mode::TriangleStrip => {
                for (index, window) in corners.windows(3).enumerate() {
                    // every other triangle runs the other way round
                    let (a, b) = if index % 2 == 0 { (0, 1) } else { (1, 0) };
                    triangle([window[a], window[b], window[2]]);
                }
            }
            Mode::TriangleFan => {
                for edge in corners.get(1..).unwrap_or_default().windows(2) {
                    triangle([corners[0], edge[0], edge[1]]);
                }
            }
        }
        Ok(())
    }
}
