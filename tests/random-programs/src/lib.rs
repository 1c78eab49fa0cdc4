//! Random well-typed programs. `generate` makes them from seeds; `build.rs` compiles some to Rust, and the tests compare
//! what that computes with what the interpreter says.
