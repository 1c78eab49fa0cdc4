//! An order of vertices in which those of an edge are near each other.

use crate::complex::CellComplex;

/// Fewer vertices than this are in the cache in any order.
const LEAST_VERTICES: usize = 2048;

/// All vertices in another order than that of their numbers.
#[derive(Clone, Debug)]
pub(crate) struct VertexOrder {
    /// The vertices in this order.
    pub(crate) vertices: Vec<u32>,
    /// The place of each vertex in it.
    pub(crate) rank: Vec<u32>,
}

impl VertexOrder {
    /// The order of a breadth-first walk along edges; `None` where the vertices are numbered in a local order already.
    pub(crate) fn of(complex: &CellComplex) -> Option<Self> {
        let n = complex.n(0);
        if is_local(complex) {
            return None;
        }
        let mut rank = vec![u32::MAX; n];
        let mut vertices: Vec<u32> = Vec::with_capacity(n);
        for start in 0..n as u32 {
            if rank[start as usize] != u32::MAX {
                continue;
            }
            let mut head = vertices.len();
            rank[start as usize] = head as u32;
            vertices.push(start);
            while head < vertices.len() {
                let vertex = vertices[head];
                head += 1;
                for &edge in complex.coboundary_elements(1, vertex as usize) {
                    let [a, b] = complex.edge_vertices(edge as usize);
                    let other = a ^ b ^ vertex;
                    if rank[other as usize] == u32::MAX {
                        rank[other as usize] = vertices.len() as u32;
                        vertices.push(other);
                    }
                }
            }
        }
        Some(Self { vertices, rank })
    }
}

/// Whether the ends of edges are near each other: in a local numbering they are a row of the mesh apart, about √n, in a
/// random one about n/3.
fn is_local(complex: &CellComplex) -> bool {
    let (n, n_edges) = (complex.n(0), complex.n(1));
    if n < LEAST_VERTICES || n_edges == 0 {
        return true;
    }
    let sample = (0..n_edges).step_by(1 + n_edges / 4096);
    let count = sample.len() as u64;
    let spread: u64 = sample
        .map(|edge| complex.edge_vertices(edge))
        .map(|[a, b]| u64::from(a.abs_diff(b)))
        .sum();
    spread / count < n as u64 / 16
}

#[cfg(test)]
mod tests {
    use crate::FaceMesh;

    /// A strip of triangles whose vertices are `number` of their places along it.
    fn strip(n: u32, number: impl Fn(u32) -> u32) -> FaceMesh {
        let triangles: Vec<[u32; 3]> = (0..n - 2)
            .map(|k| match k % 2 {
                0 => [number(k), number(k + 1), number(k + 2)],
                _ => [number(k + 1), number(k), number(k + 2)],
            })
            .collect();
        FaceMesh::from_triangles(n as usize, &triangles).unwrap()
    }

    #[test]
    fn a_local_numbering_stays() {
        assert!(strip(5000, |k| k).complex().vertex_order().is_none());
    }

    #[test]
    fn other_vertices_are_brought_near_each_other() {
        // 5001 and 2003 have no common divisor
        let mesh = strip(5001, |k| k * 2003 % 5001);
        let order = mesh.complex().vertex_order().unwrap();
        assert!((0..5001).all(|v| order.vertices[order.rank[v as usize] as usize] == v));
        for edge in 0..mesh.complex().n(1) {
            let [a, b] = mesh.complex().edge_vertices(edge);
            let [a, b] = [a, b].map(|v| order.rank[v as usize]);
            assert!(a.abs_diff(b) < 10);
        }
    }
}
