// Regions of a picture become the picture.

#include "error.hpp"
#include "image/exr.hpp"
#include "image/exr_inspection.hpp"
#include "image/exr_stream.hpp"
#include "image/exr_threads.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>
#include <ImfXdr.h>
#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace gabor::image {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t band_bytes = std::size_t{16} << 20;

[[noreturn]] void refuse(std::string_view what) {
    throw RequestError(fmt::format("cannot join: {}", what));
}

struct Region {
    fs::path path;
    Imath::Box2i window;
};

std::string described(const Region& region) {
    const Imath::V2i size = region.window.size() + Imath::V2i(1);
    return fmt::format("'{}' ({},{},{},{})", region.path.string(), region.window.min.x, region.window.min.y,
                       size.x, size.y);
}

std::uint64_t pixels_of(const Imath::Box2i& box) {
    const Imath::V2i size = box.size() + Imath::V2i(1);
    return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

// ---- What the regions have in common ----

Imf::Header header_of(const fs::path& path) try {
    inspect_exr(path);
    return Imf::InputFile(path.c_str(), 0).header();
} catch (const Iex::BaseExc& error) {
    refuse_damaged_exr(path, error.what());
}

// The attributes of a header, as they stand in the file, but for the region.
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
        refuse(fmt::format("'{}' has no 'gabor' attribute; accepted are regions that gabor rendered",
                           path.string()));
    bool floats = !header.hasTileDescription();
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
        floats &= i.channel() == Imf::Channel(Imf::FLOAT);
    if (!floats)
        refuse(fmt::format("'{}' has tiles or values that are no 32-bit floats; accepted are regions of flat "
                           "pictures",
                           path.string()));
    const Imath::Box2i& picture = header.displayWindow();
    const Imath::Box2i& window = header.dataWindow();
    if (!picture.intersects(window.min) || !picture.intersects(window.max))
        refuse(fmt::format("{} is not within its picture", described({path, window})));
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
        refuse(fmt::format("'{}' was rendered by {}, '{}' by {}; accepted are regions from one version and "
                           "driver, whose pixels agree",
                           path.string(), text(own), first_path.string(), text(first)));
    refuse(fmt::format("'{}' differs from '{}' in {}; accepted are regions of one picture", path.string(),
                       first_path.string(),
                       name == "gabor"           ? "its parameters"
                       : name == "displayWindow" ? "the size of its picture"
                                                 : "its " + name));
}

// ---- How they lie ----

// Regions in the order of their upper left corners. Each then has to begin at the first pixel, row by row,
// that those before it leave open: `heights` has, from each of its columns up to the next, the row up to
// which the picture is covered.
void check_cover(const std::vector<Region>& regions, const Imath::Box2i& picture) {
    struct Column {
        int height;
        const Region* region;
    };
    std::map<int, Column> heights{{picture.min.x, {picture.min.y, nullptr}}};
    const auto lowest = [&] {
        return std::ranges::min_element(heights, {}, [](const auto& each) { return each.second.height; });
    };
    const auto split = [&](int x) { // so that a column begins at x
        if (x <= picture.max.x)
            heights.emplace(x, std::prev(heights.upper_bound(x))->second);
    };
    const auto refuse_gap = [&] {
        refuse(fmt::format("no region has the pixel {},{}; accepted are regions that cover the picture",
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
                refuse(fmt::format("{} and {} overlap; accepted is one region for each pixel",
                                   described(*column->second.region), described(region)));
        heights.erase(std::next(heights.find(corner.x)), end);
        heights[corner.x] = {region.window.max.y + 1, &region};
    }
    if (lowest()->second.height <= picture.max.y)
        refuse_gap();
}

// ---- Copying ----

// The compressed blocks of a region.
class Reader {
  public:
    explicit Reader(const fs::path& path) : path_(path) {
        exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
        settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
        require(exr_start_read(&context_, path.c_str(), &settings));
    }
    ~Reader() { exr_finish(&context_); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    int lines_per_block() const {
        std::int32_t lines = 0;
        require(exr_get_scanlines_per_chunk(context_, 0, &lines));
        return lines;
    }

    // The one that begins with row `y`.
    void read_block(int y, std::vector<char>& bytes) const {
        exr_chunk_info_t block;
        require(exr_read_scanline_chunk_info(context_, 0, y, &block));
        bytes.resize(block.packed_size);
        require(exr_read_chunk(context_, 0, &block, bytes.data()));
    }

  private:
    void require(exr_result_t result) const {
        if (result != EXR_ERR_SUCCESS)
            refuse_damaged_exr(path_, exr_get_default_error_message(result));
    }

    const fs::path& path_;
    exr_context_t context_ = nullptr;
};

// What Imf::OutputFile writes, but with blocks as they are: the header, a table of the blocks' offsets, and
// each block after the row that it begins with and its length. (OpenEXR's C library would add an attribute.)
void copy_blocks(const std::vector<Region>& regions, const Imf::Header& header, int lines, ExrStream& stream,
                 const std::function<void(std::uint64_t)>& advance) {
    using Imf::Xdr::write;
    write<Imf::StreamIO>(stream, Imf::MAGIC);
    write<Imf::StreamIO>(stream, Imf::EXR_VERSION);
    header.writeTo(stream);
    const std::uint64_t table = stream.tellp();
    const int rows = header.dataWindow().size().y + 1;
    std::vector<std::uint64_t> offsets(static_cast<std::size_t>((rows + lines - 1) / lines));
    const auto write_table = [&] {
        for (const std::uint64_t offset : offsets)
            write<Imf::StreamIO>(stream, offset);
    };
    write_table();

    std::vector<char> block;
    auto offset = offsets.begin();
    for (const Region& region : regions) {
        const Reader in(region.path);
        const Imath::Box2i& window = region.window;
        for (int y = window.min.y; y <= window.max.y; y += lines) {
            in.read_block(y, block);
            *offset++ = stream.tellp();
            write<Imf::StreamIO>(stream, y);
            write<Imf::StreamIO>(stream, static_cast<int>(block.size()));
            stream.write(block.data(), static_cast<int>(block.size()));
            advance(pixels_of({{window.min.x, y}, {window.max.x, std::min(y + lines - 1, window.max.y)}}));
        }
    }
    stream.seekp(table);
    write_table();
}

// ---- Row by row ----

// A region that is being read.
struct Open {
    const Region* region;
    std::unique_ptr<Imf::InputFile> file;
};

void read_and_write(const std::vector<Region>& regions, const Imf::Header& header, ExrStream& stream,
                    const std::function<void(std::uint64_t)>& advance) {
    const Imath::Box2i& picture = header.dataWindow();
    std::vector<std::string> channels;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
        channels.emplace_back(i.name());

    const auto width = static_cast<std::size_t>(picture.size().x) + 1;
    const std::size_t row_bytes = width * channels.size() * sizeof(float);
    const int most_rows = std::max(1, static_cast<int>(band_bytes / row_bytes));
    std::vector<float> band(static_cast<std::size_t>(most_rows) * width * channels.size());
    std::vector<Open> open;
    auto next = regions.begin();
    Imf::OutputFile out(stream, header);
    for (int y = picture.min.y; y <= picture.max.y; y += most_rows) {
        const int rows = std::min(most_rows, picture.max.y - y + 1);
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < channels.size(); ++c)
            frame.insert(channels[c],
                         Imf::Slice::Make(Imf::FLOAT, band.data() + c * width, {picture.min.x, y},
                                          static_cast<std::int64_t>(width), rows, sizeof(float), row_bytes));
        std::erase_if(open, [&](const Open& each) { return each.region->window.max.y < y; });
        for (; next != regions.end() && next->window.min.y < y + rows; ++next)
            open.push_back({&*next, nullptr});
        for (Open& each : open) {
            const Imath::Box2i& window = each.region->window;
            const fs::path& path = each.region->path;
            try {
                if (!each.file)
                    each.file = std::make_unique<Imf::InputFile>(path.c_str(), inspect_exr(path));
                each.file->setFrameBuffer(frame);
                each.file->readPixels(std::max(window.min.y, y), std::min(window.max.y, y + rows - 1));
            } catch (const Iex::BaseExc& error) {
                refuse_damaged_exr(path, error.what());
            }
        }
        out.setFrameBuffer(frame);
        out.writePixels(rows);
        advance(static_cast<std::uint64_t>(rows) * width);
    }
}

} // namespace

void join_exr(std::span<const fs::path> paths, const fs::path& output,
              const std::function<void(std::uint64_t)>& advance) {
    start_exr_threads();
    std::optional<Imf::Header> header;
    std::map<std::string, std::string> attributes;
    std::vector<Region> regions;
    for (const fs::path& path : paths) {
        Imf::Header own = header_of(path);
        check_region(path, own);
        if (header) {
            check_same(path, own, paths.front(), attributes);
        } else {
            header = own;
            attributes = common_attributes(own);
        }
        std::error_code ignored;
        if (fs::equivalent(path, output, ignored))
            refuse(fmt::format("-o '{}' is one of the regions: it takes another file", output.string()));
        regions.push_back({path, own.dataWindow()});
    }
    std::ranges::sort(regions, {}, [](const Region& region) {
        return std::tuple(region.window.min.y, region.window.min.x);
    });
    const Imath::Box2i picture = header.value().displayWindow();
    check_cover(regions, picture);

    header->dataWindow() = picture;
    header->zipCompressionLevel() = exr_zip_level;
    const int lines = Reader(regions.front().path).lines_per_block();
    const bool blocks_match = std::ranges::all_of(regions, [&](const Region& region) {
        return region.window.min.x == picture.min.x && region.window.max.x == picture.max.x &&
               (region.window.min.y - picture.min.y) % lines == 0;
    });
    OutputFile file(not_a_pipe(output));
    ExrStream stream(file);
    if (blocks_match)
        copy_blocks(regions, *header, lines, stream, advance);
    else
        read_and_write(regions, *header, stream, advance);
    stream.rethrow_failure();
    file.commit();
}

} // namespace gabor::image
