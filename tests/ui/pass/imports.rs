// Modules of the same call, of this crate, of other crates and of the standard, without any warning.
#![deny(warnings)]

pub mod library {
    iheartmesh::iheartmesh! {
        pub struct Doubled = "a ∈ ℝ\nb = 2 a";
        /// Imports its neighbour.
        pub struct Fourfold = "b from Doubled(a)\na ∈ ℝ\nc = 2 b";
    }

    pub mod tests {
        use super::*;

        iheartmesh::iheartmesh! {
            use super::Fourfold as Four;
            pub(crate) struct Relative = "c from Four(a)\na ∈ ℝ\nd = c";
        }

        iheartmesh::iheartmesh! {
            use Doubled;
            pub(crate) struct InScope = "b from Doubled(a)\na ∈ ℝ\nd = b";
        }
    }
}

iheartmesh::iheartmesh! {
    use library::Fourfold;
    use shared_neighborhoods::KRings;
    use shared_neighborhoods::Disks as Surroundings;

    pub struct Everything = r#"
        ElementSets from MeshConnectivity
        Faces from Neighborhoods(M)
        SecondRing from KRings(M)
        Disk from Surroundings(M)
        c from Fourfold(a)
        M : FaceMesh
        V, E, F = ElementSets(M)
        a ∈ ℝ
        n(v) = |Faces(v)| + |SecondRing(v)| + |Disk(v)| where v ∈ V
        d = c
    "#;
}

fn main() {
    assert!(Everything::SOURCE.contains("Surroundings"));
    assert!(library::tests::Relative::SOURCE.contains("Four"));
    assert!(library::tests::InScope::SOURCE.contains("Doubled"));
}
