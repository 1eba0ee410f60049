// Reads regions of a picture as one picture.

#include "image/exr_mosaic.hpp"

#include "error.hpp"
#include "image/exr_inspection.hpp"
#include "image/exr_threads.hpp"

#include <ImfChannelList.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

namespace gabor::image {

void refuse_join(std::string_view what) {
    throw RequestError(fmt::format("cannot join: {}", what));
}

namespace {

namespace fs = std::filesystem;
using Region = ExrMosaic::Region;

std::unique_ptr<Imf::InputFile> open_file(const fs::path& path, int threads) try {
    return std::make_unique<Imf::InputFile>(path.c_str(), threads);
} catch (const Iex::BaseExc& error) {
    refuse_damaged_exr(path, error.what());
}

std::string described(const Region& region) {
    const Imath::V2i size = region.window.size() + Imath::V2i(1);
    return fmt::format("'{}' ({},{},{},{})", region.path.string(), region.window.min.x, region.window.min.y,
                       size.x, size.y);
}

// ---- Common attributes ----

// Returns a header's attributes as serialized, without the data window.
std::map<std::string, std::string> common_attributes(const Imf::Header& header) {
    std::map<std::string, std::string> values;
    for (auto i = header.begin(); i != header.end(); ++i) {
        if (i.name() == std::string_view("dataWindow"))
            continue;
        Imf::StdOSStream stream;
        i.attribute().writeValueTo(stream, Imf::EXR_VERSION);
        values[i.name()] = stream.str();
    }
    return values;
}

void check_region(const fs::path& path, const Imf::Header& header) {
    if (!header.findTypedAttribute<Imf::StringAttribute>("gabor"))
        refuse_join(fmt::format("'{}' has no 'gabor' attribute; accepted are regions that gabor rendered",
                                path.string()));
    bool floats = !header.hasTileDescription();
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
        floats &= i.channel() == Imf::Channel(Imf::FLOAT);
    if (!floats)
        refuse_join(
            fmt::format("'{}' has tiles or values that are no 32-bit floats; accepted are regions of flat "
                        "pictures",
                        path.string()));
    const Imath::Box2i& picture = header.displayWindow();
    const Imath::Box2i& window = header.dataWindow();
    if (!picture.intersects(window.min) || !picture.intersects(window.max))
        refuse_join(fmt::format("{} is not within its picture", described({path, window, 0})));
}

void check_same(const fs::path& path, const Imf::Header& header, const fs::path& first_path,
                const std::map<std::string, std::string>& first) {
    const auto own = common_attributes(header);
    if (own == first)
        return;
    std::string name;
    for (const auto& attributes : {own, first})
        for (const auto& [candidate, value] : attributes)
            if (name.empty() && (!own.contains(candidate) || !first.contains(candidate) ||
                                 own.at(candidate) != first.at(candidate)))
                name = candidate;
    const auto text = [&](const auto& attributes) {
        const auto found = attributes.find(name);
        return found == attributes.end() ? std::string("nothing") : found->second;
    };
    if (name == "software")
        refuse_join(
            fmt::format("'{}' was rendered by {}, '{}' by {}; accepted are regions from one version and "
                        "driver, whose pixels agree",
                        path.string(), text(own), first_path.string(), text(first)));
    refuse_join(fmt::format("'{}' differs from '{}' in {}; accepted are regions of one picture",
                            path.string(), first_path.string(),
                            name == "gabor"           ? "its parameters"
                            : name == "displayWindow" ? "the size of its picture"
                                                      : "its " + name));
}

// ---- Placement ----

// Sorts regions by their upper left corners. Each must then start at the first pixel, in row order, that the
// earlier ones leave uncovered. `heights` maps the first column of each run of columns to the row down to
// which that run is covered.
void check_cover(const std::vector<Region>& regions, const Imath::Box2i& picture) {
    struct Column {
        int height;
        const Region* region;
    };
    std::map<int, Column> heights{{picture.min.x, {picture.min.y, nullptr}}};
    const auto lowest = [&] {
        return std::ranges::min_element(heights, {}, [](const auto& each) { return each.second.height; });
    };
    const auto split = [&](int x) { // make a run start at x
        if (x <= picture.max.x)
            heights.emplace(x, std::prev(heights.upper_bound(x))->second);
    };
    const auto refuse_gap = [&] {
        refuse_join(fmt::format("no region has the pixel {},{}; accepted are regions that cover the picture",
                                lowest()->first, lowest()->second.height));
    };
    for (const Region& region : regions) {
        const Imath::V2i& corner = region.window.min;
        const auto open = lowest();
        if (std::tuple(corner.y, corner.x) > std::tuple(open->second.height, open->first))
            refuse_gap();
        split(corner.x);
        split(region.window.max.x + 1);
        const auto end = heights.lower_bound(region.window.max.x + 1);
        for (auto column = heights.find(corner.x); column != end; ++column)
            if (column->second.height > corner.y)
                refuse_join(fmt::format("{} and {} overlap; accepted is one region for each pixel",
                                        described(*column->second.region), described(region)));
        heights.erase(std::next(heights.find(corner.x)), end);
        heights[corner.x] = {region.window.max.y + 1, &region};
    }
    if (lowest()->second.height <= picture.max.y)
        refuse_gap();
}

} // namespace

ExrMosaic::ExrMosaic(const fs::path& path) {
    start_exr_threads();
    const int threads = inspect_exr(path);
    std::unique_ptr<Imf::InputFile> file = open_file(path, threads);
    header_ = file->header();
    regions_.push_back({path, header_.dataWindow(), threads});
    open_.push_back({&regions_.front(), std::move(file)});
    opened_ = 1;
}

ExrMosaic::ExrMosaic(std::span<const fs::path> paths) {
    start_exr_threads();
    std::map<std::string, std::string> attributes;
    for (const fs::path& path : paths) {
        const int threads = inspect_exr(path);
        const Imf::Header own = open_file(path, 0)->header();
        check_region(path, own);
        if (regions_.empty()) {
            header_ = own;
            attributes = common_attributes(own);
        } else {
            check_same(path, own, paths.front(), attributes);
        }
        regions_.push_back({path, own.dataWindow(), threads});
    }
    std::ranges::sort(regions_, {}, [](const Region& region) {
        return std::tuple(region.window.min.y, region.window.min.x);
    });
    check_cover(regions_, header_.displayWindow());
    header_.dataWindow() = header_.displayWindow();
}

void ExrMosaic::read(const Imf::FrameBuffer& frame, int first, int last) {
    std::erase_if(open_, [&](const Open& each) { return each.region->window.max.y < first; });
    for (; opened_ < regions_.size() && regions_[opened_].window.min.y <= last; ++opened_)
        open_.push_back({&regions_[opened_], nullptr});
    for (Open& each : open_) {
        const Region& region = *each.region;
        if (!each.file)
            each.file = open_file(region.path, region.threads);
        try {
            each.file->setFrameBuffer(frame);
            each.file->readPixels(std::max(region.window.min.y, first), std::min(region.window.max.y, last));
        } catch (const Iex::BaseExc& error) {
            refuse_damaged_exr(region.path, error.what());
        }
    }
}

} // namespace gabor::image
