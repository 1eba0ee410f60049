//! compose OUT.spv SCENE.wgsl MODULE.wgsl...: composes a shader and its imported modules into SPIR-V, as Bevy does.

use naga::{back::spv, valid};
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor};
use std::{env, fs, io::Write};

fn main() {
    let paths: Vec<String> = env::args().skip(1).collect();
    let read = |path: &String| fs::read_to_string(path).expect(path);
    let mut composer = Composer::default();
    for path in &paths[2..] {
        let module = ComposableModuleDescriptor { source: &read(path), file_path: path, ..Default::default() };
        if let Err(error) = composer.add_composable_module(module) {
            panic!("{}", error.emit_to_string(&composer));
        }
    }
    let scene = NagaModuleDescriptor { source: &read(&paths[1]), file_path: &paths[1], ..Default::default() };
    let module = composer.make_naga_module(scene).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&composer)));
    let info = valid::Validator::new(valid::ValidationFlags::all(), valid::Capabilities::empty()).validate(&module).expect("valid");
    let words = spv::write_vec(&module, &info, &spv::Options::default(), None).expect("SPIR-V");
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    fs::File::create(&paths[0]).and_then(|mut file| file.write_all(&bytes)).expect(&paths[0]);
}
