# Writes OUTPUT, a C++ source that defines the function of viewer/embedded.hpp for FILES.
foreach(file ${FILES})
    cmake_path(GET file FILENAME name)
    string(MAKE_C_IDENTIFIER embedded_${name} array)
    file(READ ${file} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
    string(APPEND arrays "constexpr unsigned char ${array}[]{\n${bytes}};\n")
    string(APPEND branches "    if (name == \"${name}\")\n        return ${array};\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"viewer/embedded.hpp\"

namespace gabor::viewer {

namespace {

${arrays}
} // namespace

std::span<const unsigned char> embedded(std::string_view name) {
${branches}    return {};
}

} // namespace gabor::viewer
")
