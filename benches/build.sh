#!/bin/sh
# How long a crate that depends on iheartmesh takes to build, how long the macro takes in the default profile, and what
# rustc makes of second derivatives with 12 × 12 blocks.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
crate=$(mktemp -d)
trap 'rm -rf "$crate"' EXIT
unset CARGO_TARGET_DIR

mkdir "$crate/src"
cat > "$crate/Cargo.toml" <<EOF
[package]
name = "uses-iheartmesh"
version = "0.1.0"
edition = "2024"

[dependencies]
iheartmesh = { path = "$root" }

[workspace]
EOF
cp "$root/rust-toolchain.toml" "$crate/"
{
    echo 'iheartmesh::iheartmesh! { pub struct GaussianCurvature = r#"'
    cat "$root/tests/programs/gaussian_curvature.hlang"
    echo '"#; }'
    echo 'fn main() { println!("{}", GaussianCurvature::SOURCE.len()); }'
} > "$crate/src/main.rs"

cd "$crate"
echo "Debug build of a crate that depends on iheartmesh, everything downloaded:"
cargo fetch --quiet
time cargo build --quiet
echo "The same after an edit of its source:"
touch src/main.rs
time cargo build --quiet

echo "A crate with the symmetric Dirichlet energy of tetrahedra, e, g, H and psd, after an edit, in debug and in release:"
{
    echo 'iheartmesh::iheartmesh! { pub struct Energy = r#"'
    cat "$root/benches/derivatives/tetrahedra.hlang"
    echo '"#; }'
} > src/lib.rs
echo 'fn main() {}' > src/main.rs
time cargo build --quiet --lib
cargo build --quiet --release --lib
touch src/lib.rs
time cargo build --quiet --release --lib
echo "Its functions with the most instructions in release:"
touch src/lib.rs
cargo rustc --quiet --release --lib -- --emit asm -C codegen-units=1 -C debuginfo=0
awk '/^[A-Za-z_][^ ]*:/ { name = $1 } /^\t[a-z]/ { count[name]++ } END { for (n in count) print count[n], n }' \
    target/release/deps/*.s | sort -rn | head -4 | cut -c1-120

cd "$root"
echo "The compiler in the default profile on the Gaussian curvature, from the start of its process to formatted Rust:"
cargo build --quiet -p iheartmesh-compiler --features cli --bin hlangc
time cargo hlangc --emit rust tests/programs/gaussian_curvature.hlang > /dev/null

for features in "" --no-default-features; do
    count=$(cargo tree --edges normal,build --prefix none $features |
        sed 's/ (.*//' | sort -u | grep -cv '^iheartmesh')
    echo "Crates from the registry with ${features:-default features}: $count"
done
