// Runs kernels over numpy arrays, on several cores. __init__.py checks and documents their arguments.

#include "kernel.hpp"

#include "gabor_noise_grid.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <system_error>
#include <thread>

#ifdef _MSC_VER
#define NOMINMAX
#include <windows.h>
#endif

namespace nb = nanobind;

namespace {

const std::map<std::string, Kernel>& kernels() {
    static const std::map<std::string, Kernel> all = [] {
        std::map<std::string, Kernel> named;
        for (const auto& some : {noise_kernels(), terrain_kernels(), material_kernels(), ocean_kernels()})
            for (const Kernel& kernel : some)
                named.emplace(kernel.name, kernel);
        return named;
    }();
    return all;
}

// An array of the output's shape, or one whose strides repeat its values, as numpy.broadcast_to returns.
using Array = nb::ndarray<const double, nb::device::cpu>;

// The values of an argument in any range of the output's points.
class Reader {
  public:
    explicit Reader(const Array& array) : data_(array.data()) {
        for (std::size_t k = 0; k < array.ndim(); ++k)
            axes_.push_back({array.shape(k), array.stride(k)});
        constant_ = std::all_of(axes_.begin(), axes_.end(),
                                [](const Axis& axis) { return axis.stride == 0 || axis.size == 1; });
    }

    bool constant() const { return constant_; }

    // Copies the values of `count` points from `begin` on.
    void read(std::size_t begin, std::size_t count, double* copy) const {
        for (std::size_t done = 0; done < count;) {
            std::int64_t offset = 0;
            std::size_t rest = begin + done;
            for (std::size_t k = axes_.size(); k-- > 0; rest /= axes_[k].size)
                offset += std::int64_t(rest % axes_[k].size) * axes_[k].stride;
            const Axis last = axes_.empty() ? Axis{count, 0} : axes_.back();
            const std::size_t run = std::min(count - done, last.size - (begin + done) % last.size);
            for (std::size_t i = 0; i < run; ++i)
                copy[done + i] = data_[offset + std::int64_t(i) * last.stride];
            done += run;
        }
    }

  private:
    struct Axis {
        std::size_t size;
        std::int64_t stride;
    };
    const double* data_;
    std::vector<Axis> axes_;
    bool constant_;
};

// Runs parts 0 to count - 1 of a task on several threads.
template <typename Part>
void run(std::size_t count, std::size_t threads, const Part& part) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i; (i = next++) < count;)
            part(i);
    };
    std::vector<std::thread> others;
    try {
        for (std::size_t t = 1; t < std::min(threads, count); ++t)
            others.emplace_back(work);
    } catch (const std::system_error&) {
        // The system refuses more threads: those that run do the work.
    }
    work();
    for (std::thread& other : others)
        other.join();
}

// Fills `out`, whose first axis is the channels, on at most `threads` cores, with the GIL released.
template <typename T>
void evaluate(const std::string& name, const std::vector<Array>& inputs,
              const nb::ndarray<T, nb::c_contig, nb::device::cpu>& out, std::size_t threads) {
    const Kernel& kernel = kernels().at(name);
    const std::size_t points = out.size() / kernel.channels;
    const std::vector<Reader> readers(inputs.begin(), inputs.end());
    T* const values = out.data();

    nb::gil_scoped_release release;
    const std::size_t blocks = (points + Block::size - 1) / Block::size, together = 16; // blocks of a part
    const auto fill = [&](std::size_t part) {
        std::vector<double> copies(readers.size() * Block::size);
        std::vector<float> results(kernel.channels * Block::size);
        std::vector<Input> in;
        for (std::size_t k = 0; k < readers.size(); ++k) {
            in.push_back({&copies[k * Block::size], readers[k].constant()});
            readers[k].read(0, readers[k].constant() ? Block::size : 0, &copies[k * Block::size]);
        }
        for (std::size_t block = part * together; block < std::min(blocks, (part + 1) * together); ++block) {
            const std::size_t begin = block * Block::size, count = std::min(Block::size, points - begin);
            for (std::size_t k = 0; k < readers.size(); ++k)
                if (double* copy = &copies[k * Block::size]; !readers[k].constant()) {
                    readers[k].read(begin, count, copy);
                    in[k].constant =
                        std::all_of(copy, copy + count, [=](double value) { return value == *copy; });
                }
            kernel.fill({count, in, results.data()});
            for (std::size_t c = 0; c < kernel.channels; ++c)
                std::copy_n(&results[c * Block::size], count, values + c * points + begin);
        }
    };
    const std::size_t least = 1 << 14; // the fewest points worth a thread
    run((blocks + together - 1) / together, std::max<std::size_t>(1, std::min(threads, points / least)),
        fill);
}

// One noise of a sum: its pixels per kernel radius, cycles per kernel radius, orientation and amplitude.
using Wave = std::array<double, 4>;

// Fills a picture with a sum of noises, on at most `threads` cores, with the GIL released. `first` is the
// position of the first pixel, in pixels.
void fill_grid(const nb::ndarray<float, nb::ndim<2>, nb::c_contig, nb::device::cpu>& out,
               std::array<double, 2> first, const std::vector<Wave>& waves,
               const std::vector<std::uint32_t>& seeds, std::array<float, 2> period, double evolution,
               std::size_t threads) {
    const std::size_t height = out.shape(0), width = out.shape(1), rows = std::min<std::size_t>(64, height);
    float* const values = out.data();

    nb::gil_scoped_release release;
    run((height + rows - 1) / rows, std::min(threads, 1 + height * width * waves.size() / (1 << 16)),
        [&](std::size_t band) {
            GaborGrid grid;
            grid.width = width;
            grid.height = std::min(rows, height - band * rows);
            grid.period = {period[0], period[1]};
            grid.evolution = static_cast<float>(evolution - std::floor(evolution));
            float* const sum = values + band * rows * width;
            std::vector<float> noise(waves.size() > 1 ? grid.height * width : 0);
            for (std::size_t i = 0; i < waves.size(); ++i) {
                const auto& [scale, frequency, orientation, amplitude] = waves[i];
                grid.step = 1 / scale;
                grid.x = first[0] / scale;
                grid.y = (first[1] + static_cast<double>(band * rows)) / scale;
                grid.wave = gabor_wave_vector(static_cast<float>(frequency), static_cast<float>(orientation));
                grid.seed = seeds[i];
                gabor_noise_grid(grid, i == 0 ? sum : noise.data());
                const float a = static_cast<float>(amplitude);
                if (i == 0 && a == 1)
                    continue;
                for (std::size_t k = 0; k < grid.height * width; ++k)
                    sum[k] = i == 0 ? a * sum[k] : sum[k] + a * noise[k];
            }
        });
}

namespace Type {
const char* const number = "number";
const char* const integer = "integer";
const char* const angle = "angle";
const char* const colour = "colour";
} // namespace Type

// What the drop-ins say about a member of a struct: angles in degrees here, as on gabor's command line.
struct Row {
    const char* name;
    const char* kind;
    const char* unit;
    std::array<double, 2> range, slider;
    std::array<double, 3> standard;
    const char* about;
};

const Row rows[]{
#include "struct_rows.inc"
};

bool has_avx2() {
#ifndef GABOR_AVX2
    return false; // there is no module for it
#elif defined(_MSC_VER)
    return IsProcessorFeaturePresent(PF_AVX2_INSTRUCTIONS_AVAILABLE);
#else
    return __builtin_cpu_supports("avx2");
#endif
}

#define GABOR_DEFINE(name) NB_MODULE(name, module)

} // namespace

GABOR_DEFINE(GABOR_MODULE) {
    module.attr("HAS_AVX2") = has_avx2();
    module.def("evaluate", &evaluate<float>, nb::arg(), nb::arg(), nb::arg().noconvert(), nb::arg());
    module.def("evaluate", &evaluate<double>, nb::arg(), nb::arg(), nb::arg().noconvert(), nb::arg());
    module.def("fill_grid", &fill_grid, nb::arg().noconvert(), nb::arg(), nb::arg(), nb::arg(), nb::arg(),
               nb::arg(), nb::arg());
    module.def("derived_seed", &gabor_derived_seed);
    nb::dict described;
    for (const auto& [name, kernel] : kernels())
        described[name.c_str()] = nb::make_tuple(kernel.inputs, kernel.channels, kernel.defaults);
    module.attr("KERNELS") = described;
    nb::list members;
    for (const Row& row : rows)
        members.append(nb::make_tuple(row.name, row.kind, row.range, row.about));
    module.attr("ROWS") = members;
}
