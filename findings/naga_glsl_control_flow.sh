#!/bin/sh
# naga (wgpu's shader translator) changes what GLSL does in two places: the right side of && and || runs always, with
# its side effects; and `continue` in a do-while loop skips the loop's condition.
# Versions: naga 30.0.2 (crates.io). Seen with Rust 1.95.
# Surprise: both parse and validate, and the WGSL looks like the source. A generator that advances its state behind an
# && advances it for every pixel; a loop of three turns makes four, because WGSL's continue goes back to its start.
# Who is hit: random numbers drawn only when needed (x < limit && random(state) < p), and searches or rejection sampling
# in do-while loops, where wgpu, Bevy or a converter takes GLSL.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
mkdir "$dir/src"
cat >"$dir/Cargo.toml" <<'TOML'
[package]
name = "flow"
version = "0.1.0"
edition = "2021"

[dependencies]
naga = { version = "=30.0.2", default-features = false, features = ["glsl-in", "wgsl-out"] }

[profile.dev]
debug = false
TOML
cat >"$dir/src/shader.frag" <<'GLSL'
#version 450
layout(location = 0) in vec4 p;
layout(location = 0) out vec4 o;
float next(inout int state) { state += 1; return float(state); }
void main()
{
    int state = 0, turns = 0;
    bool both = p.x > 0.0 && next(state) > 1.0;
    bool either = p.y > 0.0 || next(state) > 1.0;
    do { turns++; if (turns == 3) continue; } while (turns < 3);
    o = vec4(both || either ? 1.0 : 0.0, float(state), float(turns), 1.0);
}
GLSL
cat >"$dir/src/main.rs" <<'RUST'
use naga::{back::wgsl, front::glsl, valid, ShaderStage};

fn main() {
    let source = include_str!("shader.frag");
    let module = glsl::Frontend::default().parse(&glsl::Options::from(ShaderStage::Fragment), source).unwrap();
    let mut validator = valid::Validator::new(valid::ValidationFlags::all(), valid::Capabilities::all());
    let info = validator.validate(&module).unwrap();
    let text = wgsl::write_string(&module, &info, wgsl::WriterFlags::empty()).unwrap();
    let body = &text[text.find("fn main_1").unwrap()..];
    println!("{}", &body[..body.find("    o = ").unwrap()]);

    // The first `if` of main_1 is the loop's: no condition guards the two calls.
    let always = body[..body.find("if ").unwrap()].matches("next(").count() == 2;
    println!("calls behind && and ||: expected inside an if; seen unconditional: {always}");
    let skips = body.contains("continue;") && !body.contains("continuing");
    println!("condition of do-while: expected in a continuing block; seen skipped by continue: {skips}");
    println!("so the turns of the loop are 4 instead of 3");
    if !always || !skips {
        eprintln!("the behaviour has changed");
        std::process::exit(1);
    }
}
RUST
echo "naga 30.0.2"
cargo run --quiet --manifest-path "$dir/Cargo.toml"
