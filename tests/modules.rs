//! Modules that import modules of other crates, from a crate that is neither theirs nor the macro's.

use iheartmesh::{FaceMesh, Set, Vertex, iheartmesh};
use shared_neighborhoods::{Disks, KRings};

iheartmesh! {
    use shared_neighborhoods::rings::KRings as Rings;

    /// How many vertices are at two edges.
    struct Reach = r#"
        ElementSets from MeshConnectivity
        SecondRing from Rings(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        n(v) = |SecondRing(v)| where v ∈ V
    "#;
}

/// One module for each kind of place that the other tests of imports do not reach.
mod same_name {
    use iheartmesh::iheartmesh;

    iheartmesh! {
        // the same module through two paths is one module
        use shared_neighborhoods::KRings;
        use shared_neighborhoods::Disks;

        pub struct Reach = r#"
            ElementSets from MeshConnectivity
            FirstRing from KRings(M)
            Disk from Disks(M)
            M : FaceMesh
            V, E, F = ElementSets(M)
            n(v) = |Disk(v)| - |FirstRing(v)| where v ∈ V
        "#;
    }
}

#[test]
fn modules_of_the_same_name_live_beside_each_other() {
    assert_ne!(Reach::SOURCE, same_name::Reach::SOURCE);
}

#[test]
fn the_standard_modules_can_be_used_from_rust() {
    assert!(iheartmesh::neighborhoods::Neighborhoods::SOURCE.contains("VertexOneRing"));
}

/// Vertices, and the faces around each in order.
type Polygons = (usize, Vec<Vec<u32>>);

/// A torus of quadrilaterals.
fn torus(rows: u32, columns: u32) -> Polygons {
    let at = |i: u32, j: u32| (i % rows) * columns + j % columns;
    let face = |k: u32| {
        let (i, j) = (k / columns, k % columns);
        vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    };
    let n = rows * columns;
    (n as usize, (0..n).map(face).collect())
}

/// Closed and open meshes, one with a hexagon, one with a vertex that nothing touches and edges of three faces.
fn meshes() -> Vec<Polygons> {
    let fan = (1..=6).map(|k| vec![0, k, k % 6 + 1]).collect();
    let book = vec![vec![0, 1, 2], vec![0, 1, 3], vec![1, 0, 4]];
    let hexagon = vec![vec![0, 1, 2, 3, 4, 5], vec![1, 0, 6], vec![3, 2, 7]];
    vec![
        torus(7, 5),
        torus(3, 3),
        (7, fan),
        (6, book),
        (8, hexagon),
        (2, Vec::new()),
    ]
}

/// For each vertex the number of edges to each other one, by walking the sides of the faces.
fn distances((n, faces): &Polygons) -> Vec<Vec<Option<usize>>> {
    let mut near = vec![Vec::new(); *n];
    for face in faces {
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            near[a as usize].push(b as usize);
            near[b as usize].push(a as usize);
        }
    }
    let from = |start: usize| {
        let mut distance = vec![None; *n];
        distance[start] = Some(0);
        let mut open = std::collections::VecDeque::from([start]);
        while let Some(v) = open.pop_front() {
            for &w in &near[v] {
                if distance[w].is_none() {
                    distance[w] = distance[v].map(|d| d + 1);
                    open.push_back(w);
                }
            }
        }
        distance
    };
    (0..*n).map(from).collect()
}

/// The vertices at these distances from a vertex.
fn at(distances: &[Option<usize>], wanted: &[usize]) -> Set<Vertex> {
    let is_wanted = |v: &usize| distances[*v].is_some_and(|d| wanted.contains(&d));
    let found = (0..distances.len()).filter(is_wanted);
    found.map(|v| Vertex::new(v as u32)).collect()
}

#[test]
fn imported_functions_give_what_brute_force_gives() -> Result<(), Box<dyn std::error::Error>> {
    for polygons in meshes() {
        let (n, faces) = &polygons;
        let mesh = FaceMesh::from_polygons(*n, faces)?;
        let distances = distances(&polygons);
        // the modules as their own crate compiled them, and what this one made of them
        let rings = KRings::new(&mesh)?;
        let disks = Disks::new(&mesh)?;
        let reach = Reach::new(&mesh)?;
        let same_name = same_name::Reach::new(&mesh)?;
        for v in mesh.vertices() {
            let from = &distances[v.index()];
            assert_eq!(rings.FirstRing(v), at(from, &[1]));
            assert_eq!(rings.SecondRing(v), at(from, &[2]));
            assert_eq!(disks.Disk(v), at(from, &[0, 1]));
            assert_eq!(reach.n(v), at(from, &[2]).len() as i64);
            assert_eq!(same_name.n(v), 1);
        }
        assert_eq!(reach.n_all().len(), *n);
    }
    Ok(())
}
