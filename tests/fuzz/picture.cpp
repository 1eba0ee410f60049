// Reads a picture from a file of arbitrary bytes.

#include "program.hpp"

#include "error.hpp"
#include "image/picture.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const gabor::fuzz::MemoryFile file({data, size});
    try {
        const auto picture = gabor::image::open_picture(file.path());
        const auto& format = picture->format();
        std::vector<float> row(static_cast<std::size_t>(format.width) *
                               static_cast<std::size_t>(format.channels));
        for (int y = 0; y < format.height; ++y)
            picture->read_row(row);
    } catch (const gabor::RequestError&) { // refused
    }
    return 0;
}
