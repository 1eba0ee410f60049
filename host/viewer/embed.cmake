# Writes OUTPUT, a C++ source with the text of every one of FILES, which are relative to FOLDER.
set(text "#include \"viewer/embedded_shaders.hpp\"\n\nnamespace gabor::viewer {\n\n")
string(APPEND text "std::span<const EmbeddedShader> embedded_shaders() {\n    static constexpr EmbeddedShader all[] = {\n")
foreach(file ${FILES})
    file(READ ${FOLDER}/${file} content)
    string(APPEND text "{\"${file}\", R\"glsl(${content})glsl\"},\n")
endforeach()
string(APPEND text "    };\n    return all;\n}\n\n} // namespace gabor::viewer\n")
file(WRITE ${OUTPUT} "${text}")
