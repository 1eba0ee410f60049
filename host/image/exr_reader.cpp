#include "error.hpp"
#include "image/exr_parts.hpp"
#include "image/picture.hpp"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

namespace gabor::image {

namespace fs = std::filesystem;

// A file and the part of the picture in it.
struct ExrRegion {
    fs::path path;
    Imath::Box2i window;
    int threads;                          // threads that may decode the file
    std::unique_ptr<Imf::InputFile> file; // open while the region is being read
};

namespace {

Rect to_rect(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

[[noreturn]] void refuse_join(std::string_view what) {
    throw RequestError(fmt::format("cannot join: {}", what));
}

std::unique_ptr<Imf::InputFile> open_exr(const fs::path& path, int threads) try {
    return std::make_unique<Imf::InputFile>(path.string().c_str(), threads);
} catch (const Iex::BaseExc& error) {
    refuse_damaged_exr(path, error.what());
}

std::string described(const fs::path& path, const Imath::Box2i& window) {
    const Rect r = to_rect(window);
    return fmt::format("'{}' ({},{},{},{})", path.string(), r.x, r.y, r.width, r.height);
}

std::vector<std::string> names_of(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    for (auto i = channels.begin(); i != channels.end(); ++i)
        names.emplace_back(i.name());
    return names;
}

// Describes a file with all of its channels.
ExrHeader description_of(const Imf::Header& header) {
    const auto text = [&](const char* attribute) {
        const auto* found = header.findTypedAttribute<Imf::StringAttribute>(attribute);
        return found ? found->value() : std::string();
    };
    return {.picture = to_rect(header.displayWindow()),
            .window = to_rect(header.dataWindow()),
            .channels = names_of(header.channels()),
            .parameters = text("gabor"),
            .software = text("software"),
            .colour_space = text("oiio:ColorSpace")};
}

void check_region(const fs::path& path, const Imf::Header& header) {
    if (!header.findTypedAttribute<Imf::StringAttribute>("gabor"))
        refuse_join(fmt::format("'{}' has no 'gabor' attribute; expected regions that gabor rendered",
                                path.string()));
    bool floats = !header.hasTileDescription();
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
        floats &= i.channel() == Imf::Channel(Imf::FLOAT);
    if (!floats)
        refuse_join(fmt::format("'{}' has tiles or values other than 32-bit floats; expected regions of flat "
                                "pictures",
                                path.string()));
    const Imath::Box2i& picture = header.displayWindow();
    const Imath::Box2i& window = header.dataWindow();
    if (!picture.intersects(window.min) || !picture.intersects(window.max))
        refuse_join(fmt::format("{} is not within its picture", described(path, window)));
}

void check_same(const fs::path& path, const ExrHeader& own, const fs::path& first_path,
                const ExrHeader& first) {
    const std::string_view difference = own.picture != first.picture         ? "the size of its picture"
                                        : own.channels != first.channels     ? "its channels"
                                        : own.parameters != first.parameters ? "its parameters"
                                                                             : "";
    if (!difference.empty())
        refuse_join(fmt::format("'{}' differs from '{}' in {}; expected regions of one picture",
                                path.string(), first_path.string(), difference));
    if (own.software != first.software)
        refuse_join(fmt::format("'{}' was rendered by {}, '{}' by {}; expected regions from one version and "
                                "driver, whose pixels agree",
                                path.string(), own.software, first_path.string(), first.software));
}

// Checks that each pixel of the picture is in exactly one region.
void check_cover(std::span<const ExrRegion> regions, const Imath::Box2i& picture) {
    // The first pixel of a gap is in the top row or just below a region, and in the left column or just to
    // the right of a region.
    std::set<int> rows{picture.min.y};
    std::set<int> columns{picture.min.x};
    for (std::size_t i = 0; i < regions.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            if (regions[i].window.intersects(regions[j].window))
                refuse_join(fmt::format("{} and {} overlap; each pixel must be in exactly one region",
                                        described(regions[j].path, regions[j].window),
                                        described(regions[i].path, regions[i].window)));
        rows.insert(regions[i].window.max.y + 1);
        columns.insert(regions[i].window.max.x + 1);
    }
    for (const int y : rows)
        for (const int x : columns)
            if (const Imath::V2i pixel(x, y);
                picture.intersects(pixel) && std::ranges::none_of(regions, [&](const ExrRegion& region) {
                    return region.window.intersects(pixel);
                }))
                refuse_join(fmt::format(
                    "no region contains the pixel {},{}; together, the regions must cover the picture", x,
                    y));
}

std::string default_channel(const Imf::ChannelList& channels) {
    for (const char* name : {"Y", "R"})
        if (const Imf::Channel* found = channels.findChannel(name); found && found->type != Imf::UINT)
            return name;
    for (auto i = channels.begin(); i != channels.end(); ++i)
        if (i.channel().type != Imf::UINT)
            return i.name();
    return {};
}

} // namespace

struct ExrReader::State {
    explicit State(const fs::path& path) {
        start_exr_threads();
        const int threads = inspect_exr(path);
        std::unique_ptr<Imf::InputFile> file = open_exr(path, threads);
        header = file->header();
        regions.push_back({path, header.dataWindow(), threads, std::move(file)});
    }
    explicit State(std::span<const fs::path> paths);

    ExrHeader header_of(std::vector<std::string> channels) const;
    void read(const Imf::FrameBuffer& frame, int first, int last);

    std::vector<ExrRegion> regions; // sorted by their upper left corners
    Imf::Header header;             // as if one file held the whole picture
    int rows_read = 0;
    std::vector<float> rows;
};

ExrReader::State::State(std::span<const fs::path> paths) {
    start_exr_threads();
    for (const fs::path& path : paths) {
        const int threads = inspect_exr(path);
        const Imf::Header own = open_exr(path, 0)->header();
        check_region(path, own);
        if (regions.empty())
            header = own;
        else
            check_same(path, description_of(own), paths.front(), description_of(header));
        regions.push_back({path, own.dataWindow(), threads, nullptr});
    }
    std::ranges::sort(regions, {}, [](const ExrRegion& region) {
        return std::tuple(region.window.min.y, region.window.min.x);
    });
    check_cover(regions, header.displayWindow());
    header.dataWindow() = header.displayWindow();
}

// Returns the header, with only the `channels` that are read.
ExrHeader ExrReader::State::header_of(std::vector<std::string> channels) const {
    const fs::path& path = regions.front().path;
    const Imf::ChannelList& all = header.channels();
    for (const std::string& name : channels) {
        const Imf::Channel* found = all.findChannel(name);
        if (!found)
            refuse_picture(path, fmt::format("there is no channel '{}'; the file has {}", name,
                                             fmt::join(names_of(all), ", ")));
        if (found->type == Imf::UINT)
            refuse_picture(
                path, fmt::format("channel '{}' contains integers; only half and float are supported", name));
        if (found->xSampling != 1 || found->ySampling != 1)
            refuse_picture(
                path,
                fmt::format(
                    "channel '{}' is subsampled; only channels with a value for every pixel are supported",
                    name));
    }
    ExrHeader description = description_of(header);
    description.channels = std::move(channels);
    return description;
}

// Reads rows `first` to `last`. Rows must be read in order.
void ExrReader::State::read(const Imf::FrameBuffer& frame, int first, int last) {
    for (ExrRegion& region : regions) {
        if (region.window.max.y < first)
            region.file.reset();
        if (region.window.max.y < first || region.window.min.y > last)
            continue;
        if (!region.file)
            region.file = open_exr(region.path, region.threads);
        try {
            region.file->setFrameBuffer(frame);
            region.file->readPixels(std::max(region.window.min.y, first),
                                    std::min(region.window.max.y, last));
        } catch (const Iex::BaseExc& error) {
            refuse_damaged_exr(region.path, error.what());
        }
    }
}

ExrReader::ExrReader(const fs::path& path, const std::vector<std::string>& channels)
    : state_(std::make_unique<State>(path)) {
    const Imf::ChannelList& all = state_->header.channels();
    const std::string name = default_channel(all);
    if (channels.empty() && name.empty())
        refuse_picture(path,
                       fmt::format("no half or float channel among {}", fmt::join(names_of(all), ", ")));
    header_ = state_->header_of(channels.empty() ? std::vector{name} : channels);
}

ExrReader::ExrReader(std::span<const fs::path> paths, const std::vector<std::string>& channels)
    : state_(std::make_unique<State>(paths)) {
    header_ = state_->header_of(channels.empty() ? names_of(state_->header.channels()) : channels);
}

ExrReader::~ExrReader() = default;
ExrReader::ExrReader(ExrReader&&) noexcept = default;

bool ExrReader::has_channel(const std::string& name) const {
    return state_->header.channels().findChannel(name) != nullptr;
}

std::span<const float> ExrReader::read_rows(int rows) {
    const Rect& window = header_.window;
    const std::vector<std::string>& channels = header_.channels;
    rows = std::min(rows, window.height - state_->rows_read);
    if (rows <= 0)
        return {};
    const int y = window.y + state_->rows_read;
    state_->rows.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(window.width) *
                        channels.size());
    state_->read(frame_buffer(Imf::FLOAT, state_->rows.data(), channels, {window.x, y}, window.width, rows),
                 y, y + rows - 1);
    state_->rows_read += rows;
    return state_->rows;
}

} // namespace gabor::image
