#include "viewer/effect.hpp"

namespace gabor::viewer {

std::string_view disabled_reason(const Document& document, std::string_view control) {
    const render::Request& request = document.request;
    const Output output = document.output;
    const bool space = render::in_space(request);
    const bool painted = !request.paint.empty();
    if (control == "tiles") {
        const auto* plane = std::get_if<render::Plane>(&request.view);
        return plane && plane->tileable ? "" : "Tiles are of a picture that is tileable";
    }
    if (render::has_material(request)) {
        if (control == "colours" || control == "output")
            return "A material has colours of its own";
        if (control == "contrast" && document.look != Look::height)
            return "Contrast is for a material's height";
        return control == "contrast" || (control != "recipe" && render::applies_to_material(control))
                   ? ""
                   : "A material has no such parameter";
    }
    if (request.colour && document.output == Output::value && (control == "colours" || control == "contrast"))
        return "A photograph's noise has its colours";
    if (control == "recipe" && space)
        return "Noise in space has one recipe, the lattice's";
    if (control == "orientation" && space && request.lobes.size() == 1 &&
        render::is_isotropic(request.lobes.front()))
        return "These waves have all orientations: the orientation spread is 90 degrees";
    if ((control == "frequency" || control == "orientation") && painted)
        return "Frequency and orientation are painted";
    if (control == "lobes" && painted)
        return "What is painted takes the place of a single lobe's frequency and orientation";
    if (control == "paint" && !std::holds_alternative<render::Plane>(request.view))
        return "Paint lies over a picture of the view flat";
    if (control == "paint" && request.lobes.size() > 1)
        return "Paint takes the place of a single lobe, and here are several";
    if (control == "colours" && output == Output::gradient)
        return "A gradient is shown as a normal map, which has its own colours";
    if (control == "contrast" && output == Output::phase)
        return "A phase goes round all colours once";
    if (control == "contrast" && output == Output::variance)
        return "The share of the variance goes from 0 to 1";
    if (control == "contrast" && output == Output::phasor)
        return "A phasor has the same contrast everywhere";
    return {};
}

} // namespace gabor::viewer
