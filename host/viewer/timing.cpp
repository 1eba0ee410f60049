#include "viewer/timing.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace gabor::viewer {

namespace {

constexpr int least_side = 256; // pixels of the picture to fill
constexpr int most_side = 1024;
constexpr double least_seconds = 3e-3; // in which they are filled, that starting counts little

bench::Function function_of(const render::Request& request) {
    using enum bench::Function;
    const auto* plane = std::get_if<render::Plane>(&request.view);
    return request.filter                       ? filtered
           : request.gradient                   ? gradient
           : request.quadrature                 ? complex_and_phasor
           : plane && plane->tileable           ? tiled
           : render::wrapped_time(request) != 0 ? animated
                                                : noise;
}

bench::SpaceFunction space_function_of(const render::Request& request) {
    using enum bench::SpaceFunction;
    const bool isotropic_lobe = render::is_isotropic(request.lobes.front());
    if (render::along_surface(request))
        return isotropic_lobe ? surface_isotropic : surface;
    return isotropic_lobe ? isotropic : request.filter ? filtered : request.gradient ? gradient : noise;
}

// Seconds on the device's own clock; on a CPU on the host's, for beside a window lavapipe stops its own
// before the work is done.
double seconds_of(const vulkan::Device& device, bench::Filling& filling) {
    const auto before = std::chrono::steady_clock::now();
    const double seconds = filling.run();
    return device.info().kind == "CPU"
               ? std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count()
               : seconds;
}

} // namespace

std::optional<bench::Subject> subject_of(const NoisePass& noise) {
    if (render::has_material(noise.request))
        return {};
    if (render::in_space(noise.request))
        return bench::in_space(space_function_of(noise.request));
    if (!noise.ingredients)
        return bench::drop_in(noise.request.recipe, function_of(noise.request));
    const auto like = [&](study::Ingredients other) {
        other.impulses = noise.ingredients->impulses;
        return *noise.ingredients == other;
    };
    if (like({}))
        return bench::seminal(noise.ingredients->impulses);
    if (like(study::recommended))
        return bench::advice(noise.ingredients->impulses);
    return {};
}

Timing::Timing(const vulkan::Device& device)
    : device_(device), picture_(device, most_side * most_side * sizeof(float),
                                device.unified() ? vulkan::Memory::readback : vulkan::Memory::device) {}

void Timing::set(const std::vector<NoisePass>& panes) {
    panes_.resize(panes.size());
    for (std::size_t i = 0; i < panes.size(); ++i) {
        Timed& timed = panes_[i];
        const std::optional<bench::Subject> subject = subject_of(panes[i]);
        const std::string function = subject ? subject->name : "";
        timed.waves = panes[i].waves;
        // In space the number of directions goes with the frequency.
        const auto frequency = [](const NoisePass& of) { return of.request.lobes.front().frequency; };
        const bool same_cost = !render::in_space(panes[i].request) || timed.noise.request.lobes.empty() ||
                               frequency(timed.noise) == frequency(panes[i]);
        if (timed.function == function && same_cost && timed.noise.request.recipe == panes[i].request.recipe)
            continue;
        timed.noise = panes[i];
        timed.function = function;
        timed.side = 0;
        timed.filling.reset();
        rounds_ = 0;
        for (Timed& each : panes_)
            each.seconds = 0;
    }
}

void Timing::run() {
    for (Timed& timed : panes_) {
        const std::optional<bench::Subject> subject = subject_of(timed.noise);
        if (!subject || !device_.info().timestamps)
            continue;
        const double frequency = render::in_space(timed.noise.request)
                                     ? timed.noise.request.lobes.front().frequency
                                     : bench::base_setting.frequency;
        double seconds = 0;
        if (!timed.filling)
            timed.side = least_side;
        for (;; timed.side *= 2) {
            if (!timed.filling) {
                timed.filling = std::make_unique<bench::Filling>(
                    device_, *subject, bench::Setting{timed.side, bench::base_setting.scale, frequency},
                    picture_);
                timed.filling->run(); // the first one is slow
            }
            seconds = seconds_of(device_, *timed.filling);
            if (seconds >= least_seconds || timed.side >= most_side)
                break;
            timed.filling.reset();
        }
        seconds /= static_cast<double>(timed.side) * timed.side;
        timed.seconds = timed.seconds > 0 ? std::min(timed.seconds, seconds) : seconds;
    }
    ++rounds_;
}

double Timing::nanoseconds(std::size_t pane) const {
    const Timed& timed = panes_.at(pane);
    return timed.seconds > 0 ? 1e9 * timed.seconds * timed.waves : std::numeric_limits<double>::quiet_NaN();
}

std::string Timing::function(std::size_t pane) const {
    return panes_.at(pane).function;
}

} // namespace gabor::viewer
