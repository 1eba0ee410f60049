#include "render/filler.hpp"

#include "render/bake.hpp"
#include "render/pixels.hpp"
#include "render/solid.hpp"

namespace gabor::render {

std::unique_ptr<Filler> make_filler(const vulkan::Device& device, const Picture& picture,
                                    const image::Window& region) {
    if (Bake::can_fill(picture))
        return std::make_unique<Bake>(device, picture, region);
    if (is_in_space(picture))
        return std::make_unique<Solid>(device, in_space(picture), region);
    return std::make_unique<Pixels>(device, picture, region);
}

} // namespace gabor::render
