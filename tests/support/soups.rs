//! Meshes by what is special about them, as lists of faces, and what their neighbourhoods are by slow and obvious
//! definitions.

use iheartmesh::{Cell, CellularSet, Edge, Face, FaceMesh, Set, Vertex};

use super::random::Random;

/// The faces of a mesh, and its edges by the numbering that all meshes have.
pub struct Soup {
    /// What the mesh is.
    pub name: String,
    /// Number of vertices.
    pub n: u32,
    /// The vertices of each face in order.
    pub faces: Vec<Vec<u32>>,
    /// The vertices of each edge, the smaller one first; in ascending order.
    pub edges: Vec<[u32; 2]>,
}

impl Soup {
    /// A mesh by its faces.
    pub fn new(name: &str, n: u32, faces: &[&[u32]]) -> Soup {
        Soup::of_faces(name, n, faces.iter().map(|f| f.to_vec()).collect())
    }

    fn of_faces(name: &str, n: u32, faces: Vec<Vec<u32>>) -> Soup {
        let mut edges: Vec<[u32; 2]> = faces
            .iter()
            .flat_map(|face| sides(face).map(|(a, b)| [a.min(b), a.max(b)]))
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let name = name.to_owned();
        Soup {
            name,
            n,
            faces,
            edges,
        }
    }

    /// The faces of a mesh.
    pub fn of_mesh(name: &str, mesh: &FaceMesh) -> Soup {
        let faces = mesh
            .faces()
            .map(|f| mesh.face_vertices(f).iter().map(Vertex::id).collect())
            .collect();
        Soup::of_faces(name, mesh.n_vertices() as u32, faces)
    }

    /// The mesh of the faces.
    pub fn mesh(&self) -> FaceMesh {
        FaceMesh::from_polygons(self.n as usize, self.faces.iter().map(Vec::as_slice)).unwrap()
    }

    /// Numbers of the faces with a property, ascending.
    fn faces_with(&self, property: impl Fn(&[u32]) -> bool) -> Vec<u32> {
        (0..)
            .zip(&self.faces)
            .filter_map(|(f, face)| property(face).then_some(f))
            .collect()
    }

    /// Numbers of the edges with a property, ascending.
    fn edges_with(&self, property: impl Fn(&[u32; 2]) -> bool) -> Vec<u32> {
        (0..)
            .zip(&self.edges)
            .filter_map(|(e, edge)| property(edge).then_some(e))
            .collect()
    }

    /// Vertices of any of these edges.
    pub fn vertices_of_edges(&self, edges: &[u32]) -> Vec<u32> {
        sorted(edges.iter().flat_map(|e| self.edges[*e as usize]).collect())
    }

    /// Vertices of any of these faces.
    pub fn vertices_of_faces(&self, faces: &[u32]) -> Vec<u32> {
        let of = |f: &u32| self.faces[*f as usize].clone();
        sorted(faces.iter().flat_map(of).collect())
    }

    /// Edges at any of these vertices.
    pub fn edges_of_vertices(&self, vertices: &[u32]) -> Vec<u32> {
        self.edges_with(|edge| edge.iter().any(|v| vertices.contains(v)))
    }

    /// Edges of any of these faces.
    pub fn edges_of_faces(&self, faces: &[u32]) -> Vec<u32> {
        let runs = |[a, b]: [u32; 2], f: &u32| {
            sides(&self.faces[*f as usize]).any(|s| s == (a, b) || s == (b, a))
        };
        self.edges_with(|edge| faces.iter().any(|f| runs(*edge, f)))
    }

    /// Faces at any of these vertices.
    pub fn faces_of_vertices(&self, vertices: &[u32]) -> Vec<u32> {
        self.faces_with(|face| face.iter().any(|v| vertices.contains(v)))
    }

    /// Faces at any of these edges.
    pub fn faces_of_edges(&self, edges: &[u32]) -> Vec<u32> {
        let along = |(a, b): (u32, u32)| {
            edges
                .iter()
                .any(|e| [[a, b], [b, a]].contains(&self.edges[*e as usize]))
        };
        self.faces_with(|face| sides(face).any(along))
    }

    /// Vertices at an edge with one of these, without these.
    pub fn ring(&self, vertices: &[u32]) -> Vec<u32> {
        let ring = self.vertices_of_edges(&self.edges_of_vertices(vertices));
        without(ring, vertices)
    }

    /// The first edge that contains both vertices.
    pub fn edge(&self, i: u32, j: u32) -> Option<u32> {
        first(self.edges_with(|edge| edge.contains(&i) && edge.contains(&j)))
    }

    /// The first face that contains the three vertices.
    pub fn face(&self, corners: [u32; 3]) -> Option<u32> {
        first(self.faces_with(|face| corners.iter().all(|v| face.contains(v))))
    }

    /// The vertices after and before a vertex of a face.
    pub fn around(&self, f: u32, v: u32) -> Option<[u32; 2]> {
        let face = &self.faces[f as usize];
        let place = face.iter().position(|other| *other == v)?;
        let n = face.len();
        Some([face[(place + 1) % n], face[(place + n - 1) % n]])
    }

    /// The smallest vertex of a face with those after and before it.
    pub fn oriented(&self, f: u32) -> [u32; 3] {
        let smallest = *self.faces[f as usize].iter().min().unwrap();
        let [next, previous] = self.around(f, smallest).unwrap();
        [smallest, next, previous]
    }

    /// The first face that runs from the one vertex to the other, and the first that runs back.
    pub fn sides_of(&self, from: u32, to: u32) -> Option<[u32; 2]> {
        let runs = |a, b| first(self.faces_with(|face| sides(face).any(|s| s == (a, b))));
        Some([runs(from, to)?, runs(to, from)?])
    }

    /// The first vertex of each of two faces that is not one of the vertices of an edge.
    pub fn apexes(&self, faces: Option<[u32; 2]>, ends: [u32; 2]) -> Option<[u32; 2]> {
        let [f, g] = faces?;
        let apex = |f| first(without(self.vertices_of_faces(&[f]), &ends));
        Some([apex(f)?, apex(g)?])
    }

    /// The edges of exactly one face.
    pub fn boundary(&self) -> Vec<u32> {
        let is_boundary = |e: &u32| self.faces_of_edges(&[*e]).len() == 1;
        (0..self.edges.len() as u32).filter(is_boundary).collect()
    }
}

/// The directed sides of a polygon.
pub fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()]))
}

fn sorted(mut ids: Vec<u32>) -> Vec<u32> {
    ids.sort_unstable();
    ids.dedup();
    ids
}

fn first(ids: Vec<u32>) -> Option<u32> {
    ids.first().copied()
}

fn without(ids: Vec<u32>, others: &[u32]) -> Vec<u32> {
    ids.into_iter().filter(|v| !others.contains(v)).collect()
}

/// Small meshes, each with something special.
pub fn by_property() -> Vec<Soup> {
    let moebius: Vec<Vec<u32>> = (0..5).map(|i| vec![i, (i + 1) % 5, (i + 2) % 5]).collect();
    vec![
        Soup::new("no faces", 3, &[]),
        Soup::new("one triangle", 3, &[&[2, 0, 1]]),
        Soup::new(
            "tetrahedron",
            4,
            &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
        ),
        Soup::new("square with a boundary", 4, &[&[0, 1, 2], &[0, 2, 3]]),
        Soup::new("not oriented alike", 4, &[&[0, 1, 2], &[2, 0, 3]]),
        Soup::new(
            "quadrilateral and triangle",
            5,
            &[&[3, 2, 1, 0], &[2, 3, 4]],
        ),
        Soup::new(
            "hexagon, two edges shared",
            7,
            &[&[0, 1, 2, 3, 4, 5], &[2, 1, 0, 6]],
        ),
        Soup::new(
            "three triangles on an edge",
            5,
            &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]],
        ),
        Soup::of_faces("strip with one side", 5, moebius),
        Soup::new("isolated vertices", 7, &[&[1, 3, 5]]),
        Soup::new("two components", 6, &[&[5, 4, 3], &[0, 1, 2]]),
        Soup::new("two fans at a vertex", 5, &[&[0, 1, 2], &[0, 3, 4]]),
        Soup::new("the same face twice", 3, &[&[0, 1, 2], &[1, 2, 0]]),
        Soup::new("both sides of a face", 3, &[&[0, 1, 2], &[2, 1, 0]]),
    ]
}

/// Random polygons of 3 to 6 corners on a few vertices.
pub fn random(seed: u64) -> Soup {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let n = 4 + random.below(8);
    let n_faces = 1 + random.below(10);
    let mut faces = Vec::new();
    for _ in 0..n_faces {
        let n_corners = (3 + random.below(4)).min(n) as usize;
        let mut face = Vec::new();
        while face.len() < n_corners {
            let v = random.below(n);
            if !face.contains(&v) {
                face.push(v);
            }
        }
        faces.push(face);
    }
    Soup::of_faces(&format!("random {seed}"), n, faces)
}

/// A result as numbers, to compare it with brute force.
pub trait Ids {
    /// The numbers of the elements, one after the other.
    fn ids(&self) -> Vec<u32>;
}

macro_rules! elements {
    ($($name:ident),*) => {$(
        impl Ids for $name {
            fn ids(&self) -> Vec<u32> {
                vec![self.id()]
            }
        }

        impl Ids for Set<$name> {
            fn ids(&self) -> Vec<u32> {
                self.iter().map(|element| element.id()).collect()
            }
        }
    )*};
}

elements!(Vertex, Edge, Face, Cell);

impl<A: Ids, B: Ids> Ids for (A, B) {
    fn ids(&self) -> Vec<u32> {
        [self.0.ids(), self.1.ids()].concat()
    }
}

impl<A: Ids, B: Ids, C: Ids> Ids for (A, B, C) {
    fn ids(&self) -> Vec<u32> {
        [self.0.ids(), self.1.ids(), self.2.ids()].concat()
    }
}

impl<A: Ids, B: Ids, C: Ids, D: Ids> Ids for (A, B, C, D) {
    fn ids(&self) -> Vec<u32> {
        [self.0.ids(), self.1.ids(), self.2.ids(), self.3.ids()].concat()
    }
}

impl Ids for CellularSet {
    fn ids(&self) -> Vec<u32> {
        // the sizes keep the sets apart
        let parts = [
            self.vertices.ids(),
            self.edges.ids(),
            self.faces.ids(),
            self.cells.ids(),
        ];
        parts
            .into_iter()
            .flat_map(|part| [vec![part.len() as u32], part].concat())
            .collect()
    }
}
