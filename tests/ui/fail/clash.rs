// Two modules of one name meet in a third.
mod first {
    iheartmesh::iheartmesh! {
        pub struct Rings = "a = 1";
        pub struct First = "a from Rings";
    }
}

mod second {
    iheartmesh::iheartmesh! {
        pub struct Rings = "a = 2";
    }
}

mod inner {
    iheartmesh::iheartmesh! {
        pub struct Deep = "c = 3";
    }
    pub mod further {
        iheartmesh::iheartmesh! {
            use super::Deep;
            pub struct Relative = "c from Deep";
        }
    }
}

iheartmesh::iheartmesh! {
    use first::First;
    use second::Rings;
    use inner::further::Relative;

    struct Both = "a from First\na as b from Rings";
    struct Unreachable = "c from Relative";
}

fn main() {}
