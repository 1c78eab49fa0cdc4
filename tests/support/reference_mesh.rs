//! One mesh of the reference set with its values.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use iheartmesh::FaceMesh;
use iheartmesh::glam::DVec3;
use iheartmesh::io;

use super::json::Json;

/// How far a value may be from the reference.
#[derive(Clone, Copy, Debug)]
pub enum Tolerance {
    /// The largest difference.
    Absolute(f64),
    /// The largest difference, as a part of the largest reference value of all the columns.
    Relative(f64),
}

/// A surface with what `ref/` says of it.
pub struct ReferenceMesh {
    /// Name of the file without extension.
    pub name: String,
    /// The positions of the vertices.
    pub positions: Vec<DVec3>,
    /// The mesh.
    pub mesh: FaceMesh,
    directory: PathBuf,
    checksums: Json,
}

impl ReferenceMesh {
    /// A mesh file of the set.
    pub fn read(set: &Path, file: &str) -> ReferenceMesh {
        let path = set.join("meshes").join(file);
        let contents = io::read(&path).unwrap();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let directory = set.join("ref").join(&name);
        let checksums = fs::read_to_string(directory.join("summary.json")).map_or_else(
            |_| Json::Object(BTreeMap::new()),
            |text| Json::parse(&text).get("checksums").unwrap().clone(),
        );
        ReferenceMesh {
            name,
            mesh: contents.face_mesh().unwrap(),
            positions: contents.positions,
            directory,
            checksums,
        }
    }

    /// A file of this mesh in `ref/`, as JSON.
    pub fn json(&self, file: &str) -> Option<Json> {
        let text = fs::read_to_string(self.directory.join(file)).ok()?;
        Some(Json::parse(&text))
    }

    /// The number of the edge between two vertices, from the list of edges: lexicographic, smaller vertex first.
    pub fn edge(&self, i: u32, j: u32) -> usize {
        let of = |e| {
            self.mesh
                .edge_vertices(iheartmesh::Edge::new(e))
                .map(|v| v.id())
        };
        let (mut low, mut high) = (0, self.mesh.n_edges() as u32);
        while low < high {
            let middle = low.midpoint(high);
            match of(middle) < [i, j] {
                true => low = middle + 1,
                false => high = middle,
            }
        }
        assert_eq!(of(low), [i, j]);
        low as usize
    }

    /// Compares values for all elements with columns of a table, whose rows may be a selection.
    pub fn check_table(
        &self,
        table: &str,
        columns: &[&str],
        values: &[Vec<f64>],
        tolerance: Tolerance,
    ) {
        let text = fs::read_to_string(self.directory.join(table)).unwrap();
        let mut lines = text.lines();
        let header: Vec<&str> = lines.next().unwrap().split(',').collect();
        let column = |name: &str| {
            header
                .iter()
                .position(|c| *c == name)
                .unwrap_or_else(|| panic!("no column {name} in {table} of {}", self.name))
        };
        let places: Vec<usize> = columns.iter().map(|c| column(c)).collect();
        let rows: Vec<Vec<f64>> = lines
            .map(|line| line.split(',').map(|x| x.parse().unwrap()).collect())
            .collect();
        let element = |row: &[f64]| match header[0] {
            "idx" => row[0] as usize,
            _ => self.edge(row[0] as u32, row[1] as u32),
        };
        let largest = largest(rows.iter().flat_map(|row| places.iter().map(|p| row[*p])));
        let bound = match tolerance {
            Tolerance::Absolute(bound) => bound,
            Tolerance::Relative(part) => part * largest,
        };
        for row in &rows {
            for ((place, name), values) in places.iter().zip(columns).zip(values) {
                let (found, expected) = (values[element(row)], row[*place]);
                assert!(
                    (found - expected).abs() <= bound,
                    "{name} of {} at {}: {found} instead of {expected}, {tolerance:?}",
                    self.name,
                    element(row),
                );
            }
        }
        assert!(!rows.is_empty());
    }

    /// Compares values for all elements with a checksum: sums, extrema, and a sum with different weights.
    pub fn check_sums(&self, name: &str, values: &[Vec<f64>], tolerance: Tolerance) {
        let sums = self
            .checksums
            .get(name)
            .unwrap_or_else(|| panic!("no checksum {name} of {}", self.name));
        let expected = |what: &str| sums.get(what).unwrap().numbers();
        assert_eq!(
            values[0].len() as f64,
            sums.get("n").unwrap().number(),
            "{name}"
        );
        let all = values.iter().flatten().copied();
        let (bound, part) = match tolerance {
            Tolerance::Absolute(bound) => (bound, bound),
            Tolerance::Relative(part) => (part * largest(all), part),
        };
        for (k, values) in values.iter().enumerate() {
            let n = values.len() as f64;
            let l1: f64 = values.iter().map(|x| x.abs()).sum();
            let wsum: f64 = (1u32..)
                .zip(values)
                .map(|(i, x)| (0.7 * f64::from(i)).cos() * x)
                .sum();
            let fold = |start: f64, f: fn(f64, f64) -> f64| values.iter().copied().fold(start, f);
            // a single value may be off by `bound`, a sum by so much for each; the weighted sum is the sharp one
            let sharp = match tolerance {
                Tolerance::Absolute(bound) => bound * n.sqrt(),
                Tolerance::Relative(_) => part * l1.max(bound / part),
            };
            for (what, found, bound) in [
                ("sum", values.iter().sum(), bound * n),
                ("l1", l1, bound * n),
                (
                    "l2",
                    values.iter().map(|x| x * x).sum::<f64>().sqrt(),
                    bound * n.sqrt(),
                ),
                ("min", fold(f64::INFINITY, f64::min), bound),
                ("max", fold(f64::NEG_INFINITY, f64::max), bound),
                ("wsum", wsum, sharp),
            ] {
                let expected = expected(what)[k];
                assert!(
                    (found - expected).abs() <= bound,
                    "{what} of {name} of {}: {found} instead of {expected} ± {bound}",
                    self.name,
                );
            }
        }
    }
}

/// The components of vectors, each as a column.
pub fn components(vectors: &[DVec3]) -> Vec<Vec<f64>> {
    (0..3)
        .map(|k| vectors.iter().map(|v| v[k]).collect())
        .collect()
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, x| largest.max(x.abs()))
}
