# Writes OUTPUT, a C++ source with the bytes of the file INPUT as the result of a function of that NAME.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include <span>

namespace gabor::viewer {

std::span<const unsigned char> ${NAME}();

std::span<const unsigned char> ${NAME}() {
    static constexpr unsigned char bytes[]{
${bytes}};
    return bytes;
}

} // namespace gabor::viewer
")
