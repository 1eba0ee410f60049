// The sea on the CPU for sea.js, as WebAssembly; README.md names the packages. In one line:
//     clang++ --target=wasm32-wasi -std=c++17 -O3 -flto -fno-exceptions -mexec-model=reactor
//         -I ../../../shaders/translations sea.cpp -Wl,--export=sea,--export=height,--strip-all -o sea.wasm
#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"

static GaborOcean ocean;

extern "C" const GaborOcean* sea(float wind) {
    ocean = gabor_ocean(wind);
    return &ocean;
}

extern "C" float height(float x, float y, float seconds, unsigned seed) {
    return gabor_water_height(gabor_vec2(x, y), seconds, ocean, seed);
}
