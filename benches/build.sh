#!/bin/sh
# How long a crate that depends on iheartmesh takes to build, and how long the macro takes in the default profile.
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

cd "$root"
echo "The compiler in the default profile on the Gaussian curvature, from the start of its process to formatted Rust:"
cargo build --quiet -p iheartmesh-compiler --features cli --bin hlangc
time cargo hlangc --emit rust tests/programs/gaussian_curvature.hlang > /dev/null

for features in "" --no-default-features; do
    count=$(cargo tree --edges normal,build --prefix none $features |
        sed 's/ (.*//' | sort -u | grep -cv '^iheartmesh')
    echo "Crates from the registry with ${features:-default features}: $count"
done
