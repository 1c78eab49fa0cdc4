//! Named values on the elements of a mesh.

use glam::DVec3;

use crate::element::ElementKind;

/// The values of one attribute, one for each element of its kind in ascending order.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AttributeValues {
    /// Real numbers.
    Scalar(Vec<f64>),
    /// Vectors of ℝ³.
    Vector(Vec<DVec3>),
    /// Red, green and blue, each from 0 to 255.
    Color(Vec<[u8; 3]>),
}

impl AttributeValues {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            AttributeValues::Scalar(values) => values.len(),
            AttributeValues::Vector(values) => values.len(),
            AttributeValues::Color(values) => values.len(),
        }
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Named values on all elements of a kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    pub(super) element: ElementKind,
    pub(super) name: String,
    pub(super) values: AttributeValues,
}

impl Attribute {
    /// The kind of element that carries the values.
    pub fn element(&self) -> ElementKind {
        self.element
    }

    /// The name, as it stands in the file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The values.
    pub fn values(&self) -> &AttributeValues {
        &self.values
    }
}

/// The name of [`Attributes::vertex_colors`] and [`Attributes::face_colors`].
pub(super) const COLOR: &str = "color";
/// The name under which vertex or face normals are written so that other programs know them.
pub(super) const NORMAL: &str = "normal";

/// The values that a mesh file carries besides positions and polygons, in the order of the file.
///
/// Each has one value for each element of its kind, in ascending order: of cells the tetrahedra, then the hexahedra, then
/// the polyhedra of a [`MeshFile`](super::MeshFile). Numbers are those of the file, in its units. An element
/// to which a file gives no value has NaN.
///
/// Made by a chain of calls. Lengths and names are checked when the file is written.
///
/// ```
/// use iheartmesh_runtime::io::Attributes;
///
/// let attributes = Attributes::new()
///     .vertex_scalar("curvature", [0.0, 1.0, 2.0])
///     .face_scalar("area", [0.5])
///     .vertex_colors([[255, 0, 0], [0, 255, 0], [0, 0, 255]]);
/// assert_eq!(attributes.iter().count(), 3);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attributes {
    list: Vec<Attribute>,
}

impl Attributes {
    /// No attributes.
    pub fn new() -> Self {
        Attributes::default()
    }

    /// Adds a real number for each vertex.
    #[must_use]
    pub fn vertex_scalar(self, name: &str, values: impl Into<Vec<f64>>) -> Self {
        self.with(
            ElementKind::Vertex,
            name,
            AttributeValues::Scalar(values.into()),
        )
    }

    /// Adds a real number for each face.
    #[must_use]
    pub fn face_scalar(self, name: &str, values: impl Into<Vec<f64>>) -> Self {
        self.with(
            ElementKind::Face,
            name,
            AttributeValues::Scalar(values.into()),
        )
    }

    /// Adds a vector for each vertex. A vector named `normal` is written as what other programs take for normals.
    #[must_use]
    pub fn vertex_vector(self, name: &str, values: impl Into<Vec<DVec3>>) -> Self {
        self.with(
            ElementKind::Vertex,
            name,
            AttributeValues::Vector(values.into()),
        )
    }

    /// Adds a vector for each face. A vector named `normal` is written as what other programs take for normals.
    #[must_use]
    pub fn face_vector(self, name: &str, values: impl Into<Vec<DVec3>>) -> Self {
        self.with(
            ElementKind::Face,
            name,
            AttributeValues::Vector(values.into()),
        )
    }

    /// Adds a colour for each vertex: red, green and blue, each from 0 to 255. Its name is `color`.
    #[must_use]
    pub fn vertex_colors(self, values: impl Into<Vec<[u8; 3]>>) -> Self {
        self.with(
            ElementKind::Vertex,
            COLOR,
            AttributeValues::Color(values.into()),
        )
    }

    /// Adds a colour for each face: red, green and blue, each from 0 to 255. Its name is `color`.
    #[must_use]
    pub fn face_colors(self, values: impl Into<Vec<[u8; 3]>>) -> Self {
        self.with(
            ElementKind::Face,
            COLOR,
            AttributeValues::Color(values.into()),
        )
    }

    /// Adds a real number for each cell: for the tetrahedra, then the hexahedra, then the polyhedra.
    #[must_use]
    pub fn cell_scalar(self, name: &str, values: impl Into<Vec<f64>>) -> Self {
        self.with(
            ElementKind::Cell,
            name,
            AttributeValues::Scalar(values.into()),
        )
    }

    /// Adds a vector for each cell: for the tetrahedra, then the hexahedra, then the polyhedra.
    #[must_use]
    pub fn cell_vector(self, name: &str, values: impl Into<Vec<DVec3>>) -> Self {
        self.with(
            ElementKind::Cell,
            name,
            AttributeValues::Vector(values.into()),
        )
    }

    /// Adds a real number for each edge that stands in the file as such, not for those of faces.
    #[must_use]
    pub fn edge_scalar(self, name: &str, values: impl Into<Vec<f64>>) -> Self {
        self.with(
            ElementKind::Edge,
            name,
            AttributeValues::Scalar(values.into()),
        )
    }

    fn with(mut self, element: ElementKind, name: &str, values: AttributeValues) -> Self {
        self.push(element, name, values);
        self
    }

    pub(super) fn push(&mut self, element: ElementKind, name: &str, values: AttributeValues) {
        self.list.push(Attribute {
            element,
            name: name.to_owned(),
            values,
        });
    }

    /// Leaves the values of these vertices only. Lists that are too short lose those that they lack.
    pub(super) fn keep_vertices(&mut self, kept: &[usize]) {
        fn chosen<T: Copy>(values: &mut Vec<T>, kept: &[usize]) {
            *values = kept
                .iter()
                .filter_map(|&k| values.get(k).copied())
                .collect();
        }
        let is_of_vertices = |attribute: &&mut Attribute| attribute.element == ElementKind::Vertex;
        for attribute in self.list.iter_mut().filter(is_of_vertices) {
            match &mut attribute.values {
                AttributeValues::Scalar(values) => chosen(values, kept),
                AttributeValues::Vector(values) => chosen(values, kept),
                AttributeValues::Color(values) => chosen(values, kept),
            }
        }
    }

    /// All attributes in order.
    pub fn iter(&self) -> std::slice::Iter<'_, Attribute> {
        self.list.iter()
    }

    /// The values of the attribute with this name on this kind of element: the first one if there are several, `None` if
    /// there is none.
    pub fn get(&self, element: ElementKind, name: &str) -> Option<&AttributeValues> {
        let is_wanted =
            |attribute: &&Attribute| attribute.element == element && attribute.name == name;
        self.list
            .iter()
            .find(is_wanted)
            .map(|attribute| &attribute.values)
    }

    /// The real numbers with this name on this kind of element, or `None` if there are none or they are no numbers.
    pub fn scalar(&self, element: ElementKind, name: &str) -> Option<&[f64]> {
        match self.get(element, name) {
            Some(AttributeValues::Scalar(values)) => Some(values),
            _ => None,
        }
    }

    /// The vectors with this name on this kind of element, or `None` if there are none or they are no vectors. Normals have the
    /// name `normal`.
    pub fn vector(&self, element: ElementKind, name: &str) -> Option<&[DVec3]> {
        match self.get(element, name) {
            Some(AttributeValues::Vector(values)) => Some(values),
            _ => None,
        }
    }

    /// The colours on this kind of element: red, green and blue, each from 0 to 255; or `None`.
    pub fn colors(&self, element: ElementKind) -> Option<&[[u8; 3]]> {
        match self.get(element, COLOR) {
            Some(AttributeValues::Color(values)) => Some(values),
            _ => None,
        }
    }
}

impl<'a> IntoIterator for &'a Attributes {
    type Item = &'a Attribute;
    type IntoIter = std::slice::Iter<'a, Attribute>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
