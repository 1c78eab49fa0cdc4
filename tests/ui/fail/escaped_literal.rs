// Escapes make the text and the file advance differently.
iheartmesh::iheartmesh! {
    struct Sums = "a \u{2208} \u{211d}\nb = a + \
                   undefined_name";
}

fn main() {}
