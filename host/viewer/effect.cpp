#include "viewer/effect.hpp"

namespace gabor::viewer {

std::string_view without_effect(const Document& document, std::string_view control) {
    const render::Request& request = document.request;
    const Output output = document.output;
    const bool space = render::in_space(request);
    const bool painted = !request.paint.empty();
    if (control == "recipe" && space)
        return "Noise in space has one recipe, the lattice's";
    if (control == "comparison" && space)
        return "Noise in space has one recipe: there is nothing to compare it with";
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
    if (control == "contrast" && (output == Output::phase || output == Output::variance))
        return output == Output::phase ? "A phase goes round all colours once"
                                       : "The share of the variance goes from 0 to 1";
    return {};
}

} // namespace gabor::viewer
