#![doc = include_str!("../README.md")]

use bevy_app::{App, Plugin};
use bevy_shader::load_shader_library;

/// Lets shaders import the modules `gabor_noise::*`. Add it after Bevy's own plugins.
pub struct GaborNoisePlugin;

impl Plugin for GaborNoisePlugin {
    fn build(&self, app: &mut App) {
        load_shader_library!(app, "noise.wgsl");
        load_shader_library!(app, "direction.wgsl");
        load_shader_library!(app, "spectrum.wgsl");
        load_shader_library!(app, "filter.wgsl");
        load_shader_library!(app, "fractal.wgsl");
        load_shader_library!(app, "noise_3d.wgsl");
        load_shader_library!(app, "filter_3d.wgsl");
        load_shader_library!(app, "materials.wgsl");
        load_shader_library!(app, "compose.wgsl");
        load_shader_library!(app, "erosion.wgsl");
        load_shader_library!(app, "ocean.wgsl");
    }
}
