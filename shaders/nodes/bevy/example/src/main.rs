//! Draws stripes.png with wgpu: run `cargo run --release`. naga_oil combines stripes.wgsl with the modules that it imports, as in Bevy.

use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor};
use std::{borrow::Cow, fs::File};
use wgpu::util::DeviceExt;

const WIDTH: u32 = 768;
const HEIGHT: u32 = 384;

fn main() {
    let mut composer = Composer::default();
    for source in [include_str!("../../src/noise.wgsl"), include_str!("../../src/direction.wgsl")] {
        let module = ComposableModuleDescriptor { source, ..Default::default() };
        composer.add_composable_module(module).expect("a module");
    }
    let scene = NagaModuleDescriptor { source: include_str!("stripes.wgsl"), ..Default::default() };
    let module = composer.make_naga_module(scene).expect("stripes.wgsl");

    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("a GPU with a driver");
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default())).expect("a device");
    let shader = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Naga(Cow::Owned(module)),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &shader,
        entry_point: Some("draw"),
        compilation_options: Default::default(),
        cache: None,
    });
    let pixels = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: None,
        contents: &vec![0; (4 * WIDTH * HEIGHT) as usize],
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
    });
    let picture = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: pixels.size(),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[wgpu::BindGroupEntry { binding: 0, resource: pixels.as_entire_binding() }],
    });

    let mut commands = device.create_command_encoder(&Default::default());
    {
        let mut pass = commands.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bindings, &[]);
        pass.dispatch_workgroups(WIDTH / 8, HEIGHT / 8, 1);
    }
    commands.copy_buffer_to_buffer(&pixels, 0, &picture, 0, picture.size());
    queue.submit([commands.finish()]);
    picture.map_async(wgpu::MapMode::Read, .., |result| result.expect("the picture"));
    device.poll(wgpu::PollType::wait_indefinitely()).expect("the picture");

    let mut encoder = png::Encoder::new(File::create("stripes.png").expect("stripes.png"), WIDTH, HEIGHT);
    encoder.set_color(png::ColorType::Rgba);
    let bytes = picture.get_mapped_range(..).expect("the picture");
    encoder.write_header().and_then(|mut writer| writer.write_image_data(&bytes)).expect("stripes.png");
}
