#!/bin/sh
# The Rust crate image clips floats to 0 to 1 when it resizes: heights from -10 to 11 come back as 0s and 1s. blur()
# keeps the range of the same picture, fast_blur() and filter3x3() clip it, and a resize to the same size clips
# nothing.
# Versions: image 0.25.10 (crates.io). Seen with Rust 1.95.
# Surprise: Rgb32F and Luma<f32> are there for EXR and HDR, whose values lie outside 0 to 1; blur() and thumbnail() keep
# them. Operations that clip have the same form as those that do not, and return a plausible picture.
# Who is hit: height maps, displacement and light that are scaled down for mipmaps or previews; slopes from filter3x3
# lose everything that is negative.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
mkdir "$dir/src"
cat >"$dir/Cargo.toml" <<'TOML'
[package]
name = "clips"
version = "0.1.0"
edition = "2021"

[dependencies]
image = { version = "=0.25.10", default-features = false }

[profile.dev]
debug = false
TOML
cat >"$dir/src/main.rs" <<'RUST'
use image::imageops::{self, FilterType};
use image::{DynamicImage, ImageBuffer, Rgb};

fn range(image: &DynamicImage) -> (f32, f32) {
    let values = image.to_rgb32f().into_raw();
    values.iter().fold((f32::MAX, f32::MIN), |(low, high), &v| (low.min(v), high.max(v)))
}

fn main() {
    let ramp = |x: u32, _| Rgb([3.0 * x as f32 - 10.0; 3]);
    let heights = DynamicImage::ImageRgb32F(ImageBuffer::from_fn(8, 8, ramp));
    let sobel = [-1.0, 0.0, 1.0, -2.0, 0.0, 2.0, -1.0, 0.0, 1.0];
    let mut seen = Vec::new();
    for (name, result) in [
        ("source", heights.clone()),
        ("resize to half", heights.resize_exact(4, 4, FilterType::Triangle)),
        ("resize to half, nearest", heights.resize_exact(4, 4, FilterType::Nearest)),
        ("fast_blur", heights.fast_blur(1.0)),
        ("filter3x3 (slope of 24 expected)", heights.filter3x3(&sobel)),
        ("resize to the same size", heights.resize_exact(8, 8, FilterType::Triangle)),
        ("blur", heights.blur(1.0)),
        ("thumbnail", imageops::thumbnail(&heights.to_rgb32f(), 4, 4).into()),
    ] {
        println!("{name}: {:?}", range(&result));
        seen.push(range(&result));
    }
    println!("expected: all near -10 to 11; seen: four of them within 0 to 1");
    let clipped = |&(low, high): &(f32, f32)| low >= 0.0 && high <= 1.0;
    let kept = |&(low, high): &(f32, f32)| low <= -8.0 && high >= 9.0;
    if !seen[1..5].iter().all(clipped) || !seen[5..].iter().all(kept) {
        eprintln!("the behaviour has changed");
        std::process::exit(1);
    }
}
RUST
echo "image 0.25.10"
cargo run --quiet --manifest-path "$dir/Cargo.toml"
