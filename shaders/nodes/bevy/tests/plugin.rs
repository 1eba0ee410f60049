//! The plugin loads every module, and each import of a module names one that is loaded.

use bevy_app::{App, TaskPoolPlugin};
use bevy_asset::{AssetApp, AssetPlugin, Assets};
use bevy_gabor_noise::GaborNoisePlugin;
use bevy_shader::{Shader, ShaderImport, ShaderLoader};
use std::{collections::BTreeSet, fs, thread, time::Duration};

#[test]
fn loads_every_module() {
    let mut app = App::new();
    app.add_plugins((TaskPoolPlugin::default(), AssetPlugin::default()))
        .init_asset::<Shader>()
        .init_asset_loader::<ShaderLoader>()
        .add_plugins(GaborNoisePlugin);
    let files = fs::read_dir("src").unwrap().filter(|file| file.as_ref().unwrap().path().extension().unwrap() == "wgsl").count();
    let loaded = |app: &App| app.world().resource::<Assets<Shader>>().len();
    for _ in 0..1000 {
        app.update();
        if loaded(&app) == files {
            break;
        }
        thread::sleep(Duration::from_millis(10));
    }
    assert_eq!(loaded(&app), files);
    let shaders = app.world().resource::<Assets<Shader>>();
    let name = |import: &ShaderImport| match import {
        ShaderImport::Custom(name) => name.clone(),
        other => panic!("{other:?}"),
    };
    let names: BTreeSet<_> = shaders.iter().map(|(_, shader)| name(&shader.import_path)).collect();
    assert_eq!(names.len(), files);
    for import in shaders.iter().flat_map(|(_, shader)| &shader.imports) {
        assert!(names.contains(&name(import)), "{import:?}");
    }
}
