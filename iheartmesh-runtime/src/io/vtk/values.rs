//! Reading the values of VTK files.

use glam::DVec3;

use super::read::{DAMAGED, Reader};
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, COLOR};
use crate::io::error::Malformed;
use crate::io::stream::{Encoding, Scalar};
use crate::io::text::{percent_decoded, shorten};

impl Reader<'_> {
    pub(super) fn values_of(
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
    pub(super) fn attribute(&mut self, keyword: &str) -> Result<(), Malformed> {
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
                false => rest.parse().map_err(|_| {
                    let problem = format!(
                        "the number of components `{}` is no whole number",
                        shorten(&rest)
                    );
                    self.stream.error(problem, "write it as 3")
                })?,
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
    pub(super) fn field(&mut self) -> Result<(), Malformed> {
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
    pub(super) fn metadata(&mut self) {
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
