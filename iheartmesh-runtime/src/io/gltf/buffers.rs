//! The numbers in the buffers of a glTF file.

use std::borrow::Cow;

use ::gltf::json::accessor::{ComponentType, Type};
use ::gltf::json::buffer::View;
use ::gltf::json::validation::Checked;
use ::gltf::json::{Index, Root};

use crate::io::error::{Malformed, Place};

/// The entry `index` of a list of the file.
pub(super) fn entry<'a, T>(
    list: &'a [T],
    name: &'static str,
    index: usize,
    by: Place,
) -> Result<&'a T, Malformed> {
    list.get(index).ok_or_else(|| Malformed {
        place: by,
        problem: format!("there is no {name}[{index}]: there are {}", list.len()),
        help: "entries are numbered from 0",
    })
}

/// The contents of all buffers.
pub(super) type Buffers<'a> = Vec<Cow<'a, [u8]>>;

/// The contents of a file: its JSON, its buffers, and the memory that may still be taken.
pub(super) struct Contents<'a> {
    pub(super) root: &'a Root,
    pub(super) buffers: Buffers<'a>,
    pub(super) allowance: usize,
}

/// What an accessor holds.
pub(super) struct Numbers {
    pub(super) n_components: usize,
    pub(super) component: ComponentType,
    is_normalized: bool,
    /// Row by row.
    pub(super) values: Vec<f64>,
}

impl Numbers {
    /// The values as the fractions that whole numbers stand for, if they do.
    pub(super) fn fractions(mut self) -> Numbers {
        let greatest = match self.component {
            ComponentType::I8 => 127.0,
            ComponentType::U8 => 255.0,
            ComponentType::I16 => 32767.0,
            ComponentType::U16 => 65535.0,
            ComponentType::U32 | ComponentType::F32 => return self,
        };
        if self.is_normalized {
            for value in &mut self.values {
                *value = (*value / greatest).max(-1.0);
            }
        }
        self
    }
}

impl Contents<'_> {
    /// Takes memory that the file accounts for: entries may share the same bytes.
    pub(super) fn take(&mut self, n_bytes: usize, place: Place) -> Result<(), Malformed> {
        match self.allowance.checked_sub(n_bytes) {
            Some(allowance) => {
                self.allowance = allowance;
                Ok(())
            }
            None => Err(Malformed {
                place,
                problem: "the scene takes far more memory than the file".to_owned(),
                help: "the same data is placed too often, or a sparse accessor is far longer than its data",
            }),
        }
    }

    /// The numbers of `accessors[index]`, which `by` refers to.
    pub(super) fn numbers(&mut self, index: usize, by: Place) -> Result<Numbers, Malformed> {
        let root = self.root;
        let accessor = entry(&root.accessors, "accessors", index, by)?;
        let place = Place::Entry("accessors", index);
        let error = |problem: &str, help| Malformed {
            place,
            problem: problem.to_owned(),
            help,
        };
        let (Checked::Valid(component), Checked::Valid(kind)) =
            (accessor.component_type, accessor.type_)
        else {
            return Err(error(
                "the type of the accessor is unknown",
                "types are SCALAR, VEC2, VEC3, …, components 5120 to 5126",
            ));
        };
        let component = component.0;
        let n_components = kind.multiplicity();
        if matches!(kind, Type::Mat2 | Type::Mat3 | Type::Mat4) {
            return Err(error(
                "the accessor holds matrices",
                "vertices have scalars and vectors",
            ));
        }
        let count = to_usize(accessor.count.0);
        let n_values = count.saturating_mul(n_components);
        let start = accessor.byte_offset.map_or(0, |offset| offset.0);
        let place_in = |view: Index<View>, start, count, component| Rows {
            view: view.value(),
            start: to_usize(start),
            count,
            component,
            n_components,
            place,
        };
        let mut values = match (accessor.buffer_view, &accessor.sparse) {
            (Some(view), _) => self.rows(&place_in(view, start, count, component))?,
            (None, Some(_)) => {
                self.take(n_values.saturating_mul(8), place)?;
                vec![0.0; n_values]
            }
            (None, None) => {
                return Err(error(
                    "the accessor has no `bufferView`",
                    "save the file without compressed data",
                ));
            }
        };
        if let Some(sparse) = &accessor.sparse {
            let Checked::Valid(index_component) = sparse.indices.component_type else {
                return Err(error(
                    "the type of the indices of the sparse accessor is unknown",
                    "components of indices are 5121, 5123 or 5125",
                ));
            };
            let n_sparse = to_usize(sparse.count.0);
            let start = sparse.indices.byte_offset.0;
            let view = sparse.indices.buffer_view;
            let indices = self.rows(&Rows {
                n_components: 1,
                ..place_in(view, start, n_sparse, index_component.0)
            })?;
            let start = sparse.values.byte_offset.0;
            let view = sparse.values.buffer_view;
            let others = self.rows(&place_in(view, start, n_sparse, component))?;
            let mut least = 0;
            for (row, other) in indices.iter().zip(others.chunks_exact(n_components)) {
                // 32 bits are exact
                let row = *row as usize;
                if row < least || row >= count {
                    let problem = format!(
                        "a value of the sparse accessor is to stand at {row} of {count} after {least} at least"
                    );
                    return Err(error(
                        &problem,
                        "the indices increase and are less than `count`",
                    ));
                }
                values[row * n_components..][..n_components].copy_from_slice(other);
                least = row + 1;
            }
        }
        Ok(Numbers {
            n_components,
            component,
            is_normalized: accessor.normalized,
            values,
        })
    }

    /// The numbers of rows, one after the other; all are inside of the view.
    fn rows(&mut self, rows: &Rows) -> Result<Vec<f64>, Malformed> {
        let &Rows {
            count,
            component,
            n_components,
            place,
            ..
        } = rows;
        let size = component.size() * n_components;
        let root = self.root;
        let view = entry(&root.buffer_views, "bufferViews", rows.view, place)?;
        let view_place = Place::Entry("bufferViews", rows.view);
        let buffer = view.buffer.value();
        let data = entry(&self.buffers, "buffers", buffer, view_place)?;
        let stride = view.byte_stride.map_or(size, |stride| stride.0);
        if stride < size {
            return Err(Malformed {
                place: view_place,
                problem: format!(
                    "`byteStride` is {stride}, less than the {size} bytes of an entry"
                ),
                help: "the file is damaged",
            });
        }
        let view_start = to_usize(view.byte_offset.map_or(0, |offset| offset.0));
        let view_end = view_start.checked_add(to_usize(view.byte_length.0));
        let Some(view_end) = view_end.filter(|end| *end <= data.len()) else {
            return Err(Malformed {
                place: view_place,
                problem: format!(
                    "{} bytes from byte {view_start} are to be in a buffer of {}",
                    view.byte_length.0,
                    data.len()
                ),
                help: "the file is truncated or damaged",
            });
        };
        let start = rows.start.saturating_add(view_start);
        let end = match count {
            0 => Some(start),
            _ => stride
                .checked_mul(count - 1)
                .and_then(|length| length.checked_add(size)?.checked_add(start)),
        };
        if end.is_none_or(|end| end > view_end) {
            return Err(Malformed {
                place,
                problem: format!(
                    "{count} entries of {size} bytes are to be in a view of {} bytes",
                    view.byte_length.0
                ),
                help: "the file is truncated or damaged",
            });
        }
        self.take(count.saturating_mul(8 * n_components), place)?;
        let data: &[u8] = &self.buffers[buffer];
        let mut values = Vec::with_capacity(count * n_components);
        for row in 0..count {
            let row = &data[start + row * stride..][..size];
            let parts = row.chunks_exact(component.size());
            values.extend(parts.map(|part| number(part, component)));
        }
        Ok(values)
    }
}

/// Where rows of numbers stand.
struct Rows {
    view: usize,
    /// From the start of the view.
    start: usize,
    count: usize,
    component: ComponentType,
    n_components: usize,
    /// What refers to them.
    place: Place,
}

fn number(part: &[u8], component: ComponentType) -> f64 {
    match component {
        ComponentType::I8 => f64::from(part[0] as i8),
        ComponentType::U8 => f64::from(part[0]),
        ComponentType::I16 => f64::from(i16::from_le_bytes([part[0], part[1]])),
        ComponentType::U16 => f64::from(u16::from_le_bytes([part[0], part[1]])),
        ComponentType::U32 => f64::from(u32::from_le_bytes([part[0], part[1], part[2], part[3]])),
        ComponentType::F32 => f64::from(f32::from_le_bytes([part[0], part[1], part[2], part[3]])),
    }
}

fn to_usize(n: u64) -> usize {
    usize::try_from(n).unwrap_or(usize::MAX)
}
