// Builds the native module of packages/pypi as a library, for native.py.

#include "module.cpp"

extern "C" {

const char* gabor_attributes() {
    static const std::string text = [] {
        nb::module_ module;
        GABOR_MODULE(module);
        return nb::literal(module.attributes);
    }();
    return text.c_str();
}

// `strides` has those of each input.
void gabor_evaluate(const char* name, std::size_t inputs, const double* const* data, std::size_t dimensions,
                    const std::size_t* shape, const std::int64_t* strides, float* floats, double* doubles,
                    std::size_t size, std::size_t threads) {
    std::vector<Array> arrays;
    for (std::size_t k = 0; k < inputs; ++k, strides += dimensions)
        arrays.push_back({data[k], {shape, shape + dimensions}, {strides, strides + dimensions}});
    if (floats)
        evaluate<float>(name, arrays, {floats, {size}, {1}}, threads);
    else
        evaluate<double>(name, arrays, {doubles, {size}, {1}}, threads);
}

void gabor_fill_grid(float* out, std::size_t height, std::size_t width, const double* first,
                     std::size_t count, const Wave* waves, const std::uint32_t* seeds, const float* period,
                     double evolution, std::size_t threads) {
    fill_grid({out, {height, width}, {}}, {first[0], first[1]}, {waves, waves + count},
              {seeds, seeds + count}, {period[0], period[1]}, evolution, threads);
}

std::uint32_t gabor_seed_derived(std::uint32_t seed, int index) {
    return gabor_derived_seed(seed, index);
}
}
