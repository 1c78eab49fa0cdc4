//! The names that need no source module: those always at hand, and the three built-in modules.

use super::Export;

/// Functions that are available without an import.
pub const ALWAYS: &[&str] = &[
    "exp",
    "log",
    "ln",
    "sqrt",
    "min",
    "max",
    "tuple",
    "sequence",
    "vertexset",
    "edgeset",
    "faceset",
    "cellset",
    "CellularSet",
    "vertices",
    "edges",
    "faces",
    "cells",
];

/// Words that mean something inside types and attributes only.
pub const TYPE_WORDS: &[&str] = &[
    "scalar",
    "vector",
    "matrix",
    "sparse",
    "index",
    "tets",
    "vertices",
    "edges",
    "faces",
    "cells",
    "EdgeMesh",
    "edgeMesh",
    "Edgemesh",
    "edgemesh",
    "FaceMesh",
    "faceMesh",
    "Facemesh",
    "facemesh",
    "CellMesh",
    "cellMesh",
    "Cellmesh",
    "cellmesh",
    "VertexSet",
    "vertexSet",
    "Vertexset",
    "vertexset",
    "EdgeSet",
    "edgeSet",
    "Edgeset",
    "edgeset",
    "FaceSet",
    "faceSet",
    "Faceset",
    "faceset",
    "CellSet",
    "cellSet",
    "Cellset",
    "cellset",
    "CellularSet",
    "cellularSet",
    "Cellularset",
    "cellularset",
];

const TRIGONOMETRY: &[&str] = &[
    "sin", "cos", "tan", "cot", "sec", "csc", "asin", "arcsin", "acos", "arccos", "atan", "arctan",
    "sinh", "cosh", "tanh", "asinh", "arsinh", "acosh", "arcosh", "atanh", "artanh", "atan2",
];

const LINEAR_ALGEBRA: &[&str] = &[
    "trace",
    "tr",
    "det",
    "rank",
    "inv",
    "diag",
    "vec",
    "vec⁻¹",
    "inversevec",
    "null",
    "orth",
    "svd",
    "psd",
    "psd_abs",
];

const MESH_CONNECTIVITY: &[&str] = &[
    "ElementSets",
    "BoundaryMatrices",
    "UnsignedBoundaryMatrices",
    "IndicatorVector",
    "NonZeros",
    "ValueSet",
];

/// What a built-in module exports; `None` for any other module.
pub fn exports(module: &str) -> Option<Vec<Export>> {
    let (functions, constants): (&[&str], &[&str]) = match module {
        "trigonometry" => (TRIGONOMETRY, &["e"]),
        "linearalgebra" => (LINEAR_ALGEBRA, &[]),
        "MeshConnectivity" => (MESH_CONNECTIVITY, &[]),
        _ => return None,
    };
    let functions = functions.iter().map(|name| (name, true));
    let constants = constants.iter().map(|name| (name, false));
    let export = |(name, function): (&&str, bool)| Export {
        name: name.to_string(),
        function,
    };
    Some(functions.chain(constants).map(export).collect())
}

/// The functions of the standard module `Neighborhoods` of face meshes, to tell where an unknown name may come from. Most
/// are in the modules for other meshes, too.
const NEIGHBORHOODS: &[&str] = &[
    "Vertices",
    "Edges",
    "Faces",
    "VertexOneRing",
    "EdgeIndex",
    "FaceIndex",
    "NextVertexAroundFace",
    "PreviousVertexAroundFace",
    "NeighborVerticesInFace",
    "OrientedVertices",
    "Diamond",
    "OppositeFaces",
    "OrientedOppositeFaces",
    "OppositeVertices",
    "BoundaryEdges",
    "BoundaryVertices",
    "VertexKRing",
    "FaceOneRing",
    "NextEdgeAroundFace",
    "PreviousEdgeAroundFace",
    "OppositeFace",
    "Closure",
    "Star",
    "Link",
    "Boundary",
];

/// What `TetrahedronNeighborhoods` has beyond that.
const CELL_NEIGHBORHOODS: &[&str] = &[
    "Cells",
    "CellOneRing",
    "CellIndex",
    "OppositeCells",
    "NeighborFaceInCell",
    "OppositeCell",
    "OppositeEdge",
    "BoundaryFaces",
];

/// The modules that come with the compiler and with the macro.
pub const MODULES: &[&str] = &[
    "trigonometry",
    "linearalgebra",
    "MeshConnectivity",
    "Neighborhoods",
    "TetrahedronNeighborhoods",
    "PointCloudNeighborhoods",
];

/// The import that makes a name known, for the names of [`MODULES`].
pub fn import_of(name: &str) -> Option<String> {
    if NEIGHBORHOODS.contains(&name) {
        return Some(format!("{name} from Neighborhoods(M)"));
    }
    if CELL_NEIGHBORHOODS.contains(&name) {
        return Some(format!("{name} from TetrahedronNeighborhoods(M)"));
    }
    let has = |module: &&&str| {
        let exports = exports(module).unwrap_or_default();
        exports.iter().any(|export| export.name == name)
    };
    let module = MODULES.iter().find(has)?;
    Some(format!("{name} from {module}"))
}
