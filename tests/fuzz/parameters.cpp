// Reads a request as JSON. It must be refused, or stay the same when it is written and read again.

#include "render/request/parameters.hpp"
#include "error.hpp"

#include <cstdint>
#include <cstdlib>

using namespace gabor;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string text =
            render::to_json(render::from_json({reinterpret_cast<const char*>(data), size}));
        if (render::to_json(render::from_json(text)) != text)
            std::abort();
    } catch (const RequestError&) {
    }
    return 0;
}
