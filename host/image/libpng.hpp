#pragma once

#include <png.h>

#include <csetjmp>
#include <string>

namespace gabor::image {

constexpr png_uint_32 widest_png = 65536;

/// What libpng says of an error: the error pointer of its structures must be one of these.
struct PngErrors {
    std::string message;

    static void on_error(png_structp png, png_const_charp text) {
        static_cast<PngErrors*>(png_get_error_ptr(png))->message = text;
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
};

/// Whether the calls, of libpng, had no error. One is reported by a longjmp to here, so that `calls` must own
/// nothing that has a destructor.
template <class Calls>
[[nodiscard]] bool succeeds(png_structp png, Calls calls) {
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    calls();
    return true;
}

} // namespace gabor::image
