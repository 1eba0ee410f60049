// Parses GLSL with Rust's glsl and glsl-lang, and prints it again: parsers SHADER FOLDER writes FOLDER/TOOL.frag for each tool.

use glsl::parser::Parse;
use glsl_lang::{ast, parse::DefaultParse, transpiler};
use std::{env, fs, process};

fn by_glsl(text: &str) -> Result<String, String> {
    let tree = glsl::syntax::TranslationUnit::parse(text).map_err(|error| error.to_string())?;
    let mut printed = String::new();
    glsl::transpiler::glsl::show_translation_unit(&mut printed, &tree);
    Ok(printed)
}

fn by_glsl_lang(text: &str) -> Result<String, String> {
    let tree = ast::TranslationUnit::parse(text).map_err(|error| error.to_string())?;
    let mut printed = String::new();
    transpiler::glsl::show_translation_unit(&mut printed, &tree, transpiler::glsl::FormattingState::default())
        .map_err(|error| error.to_string())?;
    Ok(printed)
}

fn main() {
    let given: Vec<String> = env::args().collect();
    let text = fs::read_to_string(&given[1]).expect("a shader");
    let tools: [(&str, fn(&str) -> Result<String, String>); 2] = [("glsl", by_glsl), ("glsl-lang", by_glsl_lang)];
    let mut failed = false;
    for (name, tool) in tools {
        match tool(&text) {
            Ok(printed) => fs::write(format!("{}/{name}.frag", given[2]), printed).expect("a folder"),
            Err(error) => {
                println!("{name}: {}", error.chars().take(300).collect::<String>());
                failed = true;
            }
        }
    }
    process::exit(failed as i32);
}
