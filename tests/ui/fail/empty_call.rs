iheartmesh::iheartmesh! {}

fn main() {}
