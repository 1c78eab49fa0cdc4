//! What meshes of every kind have, written once.

/// The accessors that meshes of every kind have, with the words in which their documentation differs.
macro_rules! accessors {
    (
        $mesh:ident, $matrices:literal, complex: $($path:ident).+,
        vertices: $vertices:literal,
        elements: [$($n:ident $elements:ident $element:ident $dimension:literal $name:literal),+],
        boundary: $boundary:literal, transpose: $transpose:literal,
        unsigned: $unsigned:literal, which: $which:literal,
        euler: $euler:literal $(,)?
    ) => {
        impl $mesh {
            #[doc = concat!(" The boundary ", $matrices, ", for code that works on meshes of any dimension.")]
            #[inline]
            pub fn complex(&self) -> &CellComplex {
                &self.$($path).+
            }

            #[doc = concat!(" Number of vertices, ", $vertices, ".")]
            #[inline]
            pub fn n_vertices(&self) -> usize {
                self.complex().n(0)
            }

            /// All vertices in ascending order.
            #[inline]
            pub fn vertices(&self) -> Elements<Vertex> {
                Elements::new(0..self.n_vertices() as u32)
            }

            $(
                #[doc = concat!(" Number of ", $name, ".")]
                #[inline]
                pub fn $n(&self) -> usize {
                    self.complex().n($dimension)
                }

                #[doc = concat!(" All ", $name, " in ascending order.")]
                #[inline]
                pub fn $elements(&self) -> Elements<$element> {
                    Elements::new(0..self.$n() as u32)
                }
            )+

            #[doc = concat!(" ", $boundary, " Entries −1 and +1, compressed columns.")]
            ///
            /// Made on the first call and kept, a copy of what the mesh has already: 5 bytes for each entry and 4 for each
            /// column. Column by column it is in [`complex`](Self::complex) without that.
            ///
            /// # Panics
            #[doc = concat!(" Unless ", $which, ".")]
            #[inline]
            pub fn boundary(&self, k: usize) -> &BoundaryMatrix {
                self.complex().boundary(k)
            }

            #[doc = concat!(" ", $transpose)]
            ///
            /// Made on the first call and kept, as [`boundary`](Self::boundary).
            ///
            /// # Panics
            #[doc = concat!(" Unless ", $which, ".")]
            #[inline]
            pub fn boundary_transpose(&self, k: usize) -> &BoundaryMatrix {
                self.complex().boundary_transpose(k)
            }

            #[doc = concat!(" ", $unsigned, ", as [`boundary`](Self::boundary) with entries 1. Made on the first call.")]
            ///
            /// # Panics
            #[doc = concat!(" Unless ", $which, ".")]
            pub fn unsigned_boundary(&self, k: usize) -> &BoundaryMatrix {
                self.complex().unsigned_boundary(k)
            }

            #[doc = concat!(
                " ", $unsigned,
                "ᵀ, as [`boundary_transpose`](Self::boundary_transpose) with entries 1. Made on the first call."
            )]
            ///
            /// # Panics
            #[doc = concat!(" Unless ", $which, ".")]
            pub fn unsigned_boundary_transpose(&self, k: usize) -> &BoundaryMatrix {
                self.complex().unsigned_boundary_transpose(k)
            }

            /// Tail and head of an edge.
            #[inline]
            pub fn edge_vertices(&self, edge: Edge) -> [Vertex; 2] {
                self.complex().edge_vertices(edge.index()).map(Vertex::new)
            }

            /// The edges at a vertex, ascending.
            #[inline]
            pub fn vertex_edges(&self, vertex: Vertex) -> ElementSlice<'_, Edge> {
                ElementSlice::new(self.complex().coboundary_elements(1, vertex.index()))
            }

            /// Number of connected components; an isolated vertex is one.
            pub fn n_components(&self) -> usize {
                self.complex().n_components()
            }

            #[doc = concat!(" ", $euler)]
            pub fn euler_characteristic(&self) -> i64 {
                self.complex().euler_characteristic()
            }
        }

        impl Debug for $mesh {
            #[doc = concat!(" The numbers of elements; the ", $matrices, " would fill pages.")]
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter
                    .debug_struct(stringify!($mesh))
                    .field("n_vertices", &self.n_vertices())
                    $(.field(stringify!($n), &self.$n()))+
                    .finish_non_exhaustive()
            }
        }

        impl AsRef<CellComplex> for $mesh {
            fn as_ref(&self) -> &CellComplex {
                self.complex()
            }
        }
    };
}

/// The accessors that meshes with faces have.
macro_rules! face_accessors {
    ($mesh:ident) => {
        impl $mesh {
            /// The faces at an edge, ascending.
            #[inline]
            pub fn edge_faces(&self, edge: Edge) -> ElementSlice<'_, Face> {
                ElementSlice::new(self.complex().coboundary_elements(2, edge.index()))
            }

            /// The edges of a face, ascending, and for each +1 if the face runs along it and −1 if against it.
            #[inline]
            pub fn face_boundary(&self, face: Face) -> (ElementSlice<'_, Edge>, &[i8]) {
                let (edges, signs) = self.complex().boundary_column(2, face.index());
                (ElementSlice::new(edges), signs)
            }
        }
    };
}

pub(super) use {accessors, face_accessors};
