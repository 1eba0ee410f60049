#include "fit/preset.hpp"

#include "noise/lobe.hpp"

#include <cmath>

namespace gabor::fit {

render::Request request_of(const Exemplar& exemplar, const FittedNoise& fitted) {
    render::Request request;
    request.width = exemplar.width;
    request.height = exemplar.height;
    request.scale = unit_of(fitted.waves);
    request.lobes.clear();
    for (const Wave& wave : fitted.waves) {
        noise::Lobe lobe;
        lobe.frequency = wave.frequency.norm() * request.scale;
        lobe.orientation = noise::degrees(std::atan2(wave.frequency.y(), wave.frequency.x()));
        lobe.radius = wave.radius.x() / request.scale;
        lobe.stretch = wave.radius.y() / wave.radius.x();
        lobe.power = (exemplar.components * wave.weight).squaredNorm() / exemplar.components.squaredNorm();
        request.lobes.push_back(lobe);
    }
    request.colour = fitted.colour;
    return request;
}

} // namespace gabor::fit
