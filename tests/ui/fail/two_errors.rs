// Every mistake of a program is reported, each once; what uses the struct causes no further error.
mod shapes {
    iheartmesh::iheartmesh! {
        pub struct Areas = r#"
            ElementSets from MeshConnectivity
            OrientedVertices from Neighborhoods(M)
            M : FaceMesh
            V, E, F = ElementSets(M)
            x_i ∈ ℝ³
            m ∈ ℝ
            area(f) = ½ ‖(x_j - x_i) × (x_k - x_i)‖ where f ∈ F, i, j, k = OrientedVertices(f)
            moved(v) = x_v + m where v ∈ V
            around(v) = area(v) where v ∈ V
            total = ∑_(f ∈ F) aera(f)
        "#;
    }
}

use shapes::Areas;

fn total(mesh: &iheartmesh::FaceMesh, x: Vec<[f64; 3]>) -> Result<f64, iheartmesh::Error> {
    let mut areas = Areas::new(mesh, x, 2.0)?;
    areas.set_m(3.0)?;
    let moved = areas.moved_all();
    println!("{} {moved:?}", Areas::SOURCE);
    Ok(*areas.total())
}

fn main() {
    let _ = total;
}
