// Prints the noise, quadrature and gradient of grids, as floats, to compare processors bit for bit.

#include "gabor_noise_grid.hpp"

#include <cstdio>

int main() {
    for (int i = 0; i < 24; ++i) {
        GaborGrid grid;
        grid.width = 1 + static_cast<std::size_t>(i * 37 % 197);
        grid.height = 1 + static_cast<std::size_t>(i * 25 % 141);
        grid.x = (i % 4 == 3 ? 1e6 : 0) + 1.37 * i - 20;
        grid.y = 0.71 * i - 7;
        grid.step = i % 3 == 0 ? 1 / 3.0 : i % 3 == 1 ? 1 / 16.0 : 0.71;
        grid.wave = gabor_wave_vector(1.0f + 0.5f * static_cast<float>(i), 0.3f * static_cast<float>(i));
        grid.seed = static_cast<std::uint32_t>(i);
        grid.evolution = i % 5 == 4 ? 0.3f : 0.0f;
        std::vector<float> noise(grid.width * grid.height), second(noise.size()), third(noise.size());
        const auto print = [](const std::vector<float>& values) {
            std::fwrite(values.data(), sizeof(float), values.size(), stdout);
        };
        gabor_noise_grid_quadrature(grid, noise.data(), second.data());
        print(noise);
        print(second);
        gabor_noise_grid_gradient(grid, noise.data(), second.data(), third.data());
        print(second);
        print(third);
    }
}
