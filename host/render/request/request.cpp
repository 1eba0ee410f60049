#include "render/request/request.hpp"

#include "render/request/material.hpp"
#include "render/request/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gabor::render {

std::array<double, 2> light_direction(const Request& request) {
    const double azimuth = noise::radians(std::remainder(request.light_azimuth, 360.0));
    const double along = std::cos(noise::radians(request.light_elevation));
    return {along * std::cos(azimuth), along * std::sin(azimuth)};
}

double least_tile(const Request& request) {
    if (is_surface(request.kind))
        return request.kind == Kind::terrain ? 4 : 0;
    return 2 * std::ranges::max(request.lobes, {}, &noise::Lobe::longest_radius).longest_radius();
}

Request from_above(Request request) {
    if (request.kind == Kind::terrain)
        request.view.projection = Projection::flat;
    return request;
}

double terrain_unit(const Request& request) {
    return request.extent > 0 ? request.extent * request.scale / request.width : 1;
}

double erosion_reach(const Request& request) {
    const auto value = [&](std::string_view name) { return std::get<double>(*parameter(name).get(request)); };
    double reach = 0, depth = value("strength") / value("gully_frequency");
    for (double i = 0; i < value("octaves"); ++i, depth *= value("gain"))
        reach += depth;
    return reach;
}

std::vector<std::string> channels(const Request& request, bool normals) {
    std::vector<std::string> names{"Y"};
    switch (request.kind) {
    case Kind::sea:
        return {passes::ocean_channels.begin(), passes::ocean_channels.end()};
    case Kind::terrain:
        return {terrain_channels.begin(), terrain_channels.end()};
    case Kind::material:
        names.assign(material_channels.begin(), material_channels.end());
        if (request.view.in_space()) {
            names.resize(names.size() - 2);
            names.push_back("A");
        }
        return names;
    case Kind::noise:
        break;
    }
    if (request.colour)
        names = {"R", "G", "B"};
    if (request.quadrature)
        names.push_back("quadrature");
    if (request.gradient)
        names.insert(names.end(), {"gradient.x", "gradient.y"});
    if (request.phasor)
        names.insert(names.end(), {"phase", "intensity"});
    if (normals)
        names.insert(names.end(), {"normal.x", "normal.y", "normal.z", "gradient.z"});
    if (request.view.in_space())
        names.push_back("A");
    else if (request.filter)
        names.push_back("removed");
    return names;
}

} // namespace gabor::render
