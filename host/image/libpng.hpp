#pragma once

#include <png.h>

#include <csetjmp>
#include <string>

namespace gabor::image {

constexpr png_uint_32 widest_png = 65536;

/// Receives libpng's messages; pass its address as libpng's error pointer.
struct PngErrors {
    std::string message;

    static void on_error(png_structp png, png_const_charp text) {
        static_cast<PngErrors*>(png_get_error_ptr(png))->message = text;
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
};

/// Runs `calls` and returns whether libpng reported no error. libpng reports errors by a longjmp to here, so
/// `calls` must not own objects with destructors.
template <class Calls>
[[nodiscard]] bool succeeds(png_structp png, Calls calls) {
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    calls();
    return true;
}

} // namespace gabor::image
