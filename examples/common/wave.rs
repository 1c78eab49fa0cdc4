//! Distances by waves that run over a surface: which vertex is updated when. How one is updated is the caller's affair.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use iheartmesh::{Face, FaceMesh, Vertex};

/// Distances from the sources, the nearest vertex first (fast marching): each vertex that the wave has reached updates its
/// neighbours across its faces. One that becomes nearer later, as it may across an obtuse triangle, does so again.
///
/// `update(f, v, d)` is the distance of `v` across the face `f`, from the distances `d` so far; unknown ones are `∞`.
pub fn march(
    mesh: &FaceMesh,
    sources: &[Vertex],
    update: impl Fn(Face, Vertex, &[f64]) -> f64,
) -> Vec<f64> {
    let mut faces_of = vec![Vec::new(); mesh.n_vertices()];
    for face in mesh.faces() {
        for vertex in mesh.face_vertices(face).iter() {
            faces_of[vertex.index()].push(face);
        }
    }
    let mut distances = starting_at(mesh, sources);
    let mut wave: BinaryHeap<Reverse<(Nearness, Vertex)>> = BinaryHeap::new();
    wave.extend(sources.iter().map(|v| Reverse((Nearness(0.0), *v))));
    while let Some(Reverse((Nearness(distance), from))) = wave.pop() {
        if distance > distances[from.index()] {
            // it came nearer since, and is there a second time
            continue;
        }
        for &face in &faces_of[from.index()] {
            for vertex in mesh.face_vertices(face).iter().filter(|v| *v != from) {
                let found = update(face, vertex, &distances);
                if found < distances[vertex.index()] {
                    distances[vertex.index()] = found;
                    wave.push(Reverse((Nearness(found), vertex)));
                }
            }
        }
    }
    distances
}

/// Distances from the first of the levels, each of which holds the neighbours of the one before: all vertices of a band
/// of levels are updated at once, the band grows by a level in each round, and leaves a level behind when the distances
/// there change by less than a part of `tolerance`. Returns the number of rounds, too.
///
/// `update(v, d)` is the distance of `v` from the distances `d` so far.
pub fn propagate<'a, Level>(
    mesh: &FaceMesh,
    levels: &'a [Level],
    tolerance: f64,
    update: impl Fn(Vertex, &[f64]) -> f64,
) -> (Vec<f64>, usize)
where
    &'a Level: IntoIterator<Item = &'a Vertex>,
{
    let Some((sources, levels)) = levels.split_first() else {
        return (starting_at(mesh, &[]), 0);
    };
    let sources: Vec<Vertex> = sources.into_iter().copied().collect();
    let mut distances = starting_at(mesh, &sources);
    let (mut first, mut rounds) = (0, 0);
    while first < levels.len() {
        rounds += 1;
        let band = &levels[first..levels.len().min(rounds)];
        let change = |vertex: &Vertex| (*vertex, update(*vertex, &distances));
        let found: Vec<Vec<(Vertex, f64)>> = band
            .iter()
            .map(|level| level.into_iter().map(change).collect())
            .collect();
        let settled = |level: &&Vec<(Vertex, f64)>| {
            let mut changes = level.iter().map(|(v, to)| (distances[v.index()], *to));
            changes.all(|(from, to)| from == to || (from - to).abs() <= tolerance * to)
        };
        first += found.iter().take_while(settled).count();
        for (vertex, distance) in found.into_iter().flatten() {
            distances[vertex.index()] = distance;
        }
    }
    (distances, rounds)
}

fn starting_at(mesh: &FaceMesh, sources: &[Vertex]) -> Vec<f64> {
    let mut distances = vec![f64::INFINITY; mesh.n_vertices()];
    for source in sources {
        distances[source.index()] = 0.0;
    }
    distances
}

/// A distance, by its size.
#[derive(Clone, Copy, PartialEq)]
struct Nearness(f64);

impl Eq for Nearness {}

impl PartialOrd for Nearness {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Nearness {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
