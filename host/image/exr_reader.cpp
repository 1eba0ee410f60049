#include "image/exr.hpp"

#include "error.hpp"
#include "image/exr_threads.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <stdexcept>

namespace gabor::image {

namespace {

constexpr std::int64_t widest = 65536;
constexpr std::uint64_t largest_block = 256u << 20;
constexpr std::uint64_t decoding_memory = 4 * largest_block;

/// Names from a foreign file must not break the line that the message is.
[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view what) {
    std::string message = fmt::format("cannot read {}: {}", path.string(), what);
    std::ranges::replace_if(
        message, [](char c) { return (c >= 0 && c < ' ') || c == 0x7f; }, ' ');
    throw RequestError(message);
}

[[noreturn]] void refuse_damaged(const std::filesystem::path& path, std::string_view how) {
    if (const auto named = how.rfind("\". "); named != how.npos) // OpenEXR has named the file before
        how.remove_prefix(named + 3);
    refuse(path, fmt::format("it is truncated or damaged ({}); accepted is a complete OpenEXR file", how));
}

/// OpenEXR's C library knows the file's size and holds every claim in it against that; the C++ classes, which
/// decode in parallel, believe the file and allocate. So the first looks over what the second will read.
class Inspection {
  public:
    explicit Inspection(const std::filesystem::path& path) : path_(path) {
        exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
        settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
        // Strict, or it would skip what the C++ classes stumble over; and an unfinished file is not made up
        // for.
        settings.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
        require(exr_start_read(&context_, path.c_str(), &settings));
    }
    ~Inspection() { exr_finish(&context_); }
    Inspection(const Inspection&) = delete;
    Inspection& operator=(const Inspection&) = delete;

    /// Returns the bytes of the largest block that has to be decoded at once.
    std::uint64_t run() const {
        exr_storage_t storage;
        require(exr_get_storage(context_, 0, &storage));
        if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
            refuse(path_, "it holds deep data; accepted are flat scanlines and tiles");
        exr_attr_box2i_t window;
        require(exr_get_data_window(context_, 0, &window));
        const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
        const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
        if (width > widest || height > widest)
            refuse(path_, fmt::format("its data window has {} x {} pixels; accepted are at most {} x {}",
                                      width, height, widest, widest));

        std::uint64_t block = 0;
        require(exr_get_chunk_unpacked_size(context_, 0, &block));
        if (storage == EXR_STORAGE_TILED)
            block = std::max(block, row_of_tiles(width));
        if (block > largest_block)
            refuse(path_, fmt::format("one block or row of tiles takes {} MiB; accepted are at most {} MiB",
                                      block >> 20, largest_block >> 20));

        if (storage == EXR_STORAGE_TILED)
            check_tiles(width, height);
        else
            check_scanlines(window.min.y, window.max.y);
        return block;
    }

  private:
    std::uint64_t row_of_tiles(std::int64_t width) const {
        std::uint32_t across = 0;
        std::uint32_t down = 0;
        require(exr_get_tile_descriptor(context_, 0, &across, &down, nullptr, nullptr));
        return static_cast<std::uint64_t>(width) * down * sizeof(float);
    }

    void check_scanlines(std::int32_t first, std::int32_t last) const {
        std::int32_t step = 0;
        require(exr_get_scanlines_per_chunk(context_, 0, &step));
        exr_chunk_info_t block;
        for (std::int64_t y = first; y <= last; y += step)
            require(exr_read_scanline_chunk_info(context_, 0, static_cast<int>(y), &block));
    }

    void check_tiles(std::int64_t width, std::int64_t height) const {
        std::int32_t across = 0;
        std::int32_t down = 0;
        require(exr_get_tile_sizes(context_, 0, 0, 0, &across, &down));
        exr_chunk_info_t tile;
        for (int y = 0; std::int64_t{y} * down < height; ++y)
            for (int x = 0; std::int64_t{x} * across < width; ++x)
                require(exr_read_tile_chunk_info(context_, 0, x, y, 0, 0, &tile));
    }

    void require(exr_result_t result) const {
        if (result == EXR_ERR_FILE_ACCESS)
            refuse(path_, "permission denied");
        if (result == EXR_ERR_FILE_BAD_HEADER)
            refuse(path_, "it is not an OpenEXR file");
        if (result != EXR_ERR_SUCCESS)
            refuse_damaged(path_, exr_get_default_error_message(result));
    }

    const std::filesystem::path& path_;
    exr_context_t context_ = nullptr;
};

/// How many threads may decode the file, if it is safe to open at all.
int inspect(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (error)
        refuse(path, error.message());
    if (!std::filesystem::is_regular_file(status)) // opening a FIFO would wait for ever
        refuse(path, "it is not a regular file");
    const std::uint64_t block = Inspection(path).run();
    const auto affordable = static_cast<int>(decoding_memory / (2 * std::max<std::uint64_t>(block, 1)));
    return std::min(affordable, Imf::globalThreadCount()); // OpenEXR holds two blocks for each
}

std::string list(const Imf::ChannelList& channels) {
    std::string names;
    for (auto i = channels.begin(); i != channels.end(); ++i)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", i.name());
    return names;
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

Window to_window(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

} // namespace

struct ExrReader::State {
    explicit State(const std::filesystem::path& name) : path(name), image(name.c_str(), inspect(name)) {}

    const std::filesystem::path path;
    Imf::InputFile image;
    Window picture;
    Window window;
    std::string channel;
    std::string parameters;
    int rows_read = 0;
    std::vector<float> rows;
};

ExrReader::ExrReader(const std::filesystem::path& path, std::optional<std::string> channel) try {
    start_exr_threads();
    state_ = std::make_unique<State>(path);
    const Imf::Header& header = state_->image.header();
    state_->picture = to_window(header.displayWindow());
    state_->window = to_window(header.dataWindow());
    if (const auto* text = header.findTypedAttribute<Imf::StringAttribute>("gabor"))
        state_->parameters = text->value();

    const Imf::ChannelList& channels = header.channels();
    state_->channel = channel ? *channel : default_channel(channels);
    const Imf::Channel* found = channels.findChannel(state_->channel);
    if (!found && channel)
        refuse(path, fmt::format("there is no channel '{}': it has {}", *channel, list(channels)));
    if (!found)
        refuse(path, fmt::format("no half or float channel among {}", list(channels)));
    if (found->type == Imf::UINT)
        refuse(path,
               fmt::format("channel '{}' holds integers; accepted are half and float", state_->channel));
    if (found->xSampling != 1 || found->ySampling != 1)
        refuse(path, fmt::format("channel '{}' is subsampled; accepted is a value for every pixel",
                                 state_->channel));
} catch (const Iex::BaseExc& error) {
    refuse_damaged(path, error.what());
}

ExrReader::~ExrReader() = default;
ExrReader::ExrReader(ExrReader&&) noexcept = default;

const Window& ExrReader::picture() const {
    return state_->picture;
}
const Window& ExrReader::window() const {
    return state_->window;
}
const std::string& ExrReader::channel() const {
    return state_->channel;
}
bool ExrReader::has_channel(const std::string& name) const {
    return state_->image.header().channels().findChannel(name) != nullptr;
}
const std::string& ExrReader::parameters() const {
    return state_->parameters;
}

std::span<const float> ExrReader::read_rows(int rows) {
    const Window& window = state_->window;
    rows = std::min(rows, window.height - state_->rows_read);
    if (rows <= 0)
        return {};
    const auto width = static_cast<std::size_t>(window.width);
    state_->rows.resize(static_cast<std::size_t>(rows) * width);

    const int y = window.y + state_->rows_read;
    Imf::FrameBuffer band;
    band.insert(state_->channel, Imf::Slice::Make(Imf::FLOAT, state_->rows.data(), {window.x, y},
                                                  window.width, rows, sizeof(float), width * sizeof(float)));
    try {
        state_->image.setFrameBuffer(band);
        state_->image.readPixels(y, y + rows - 1);
    } catch (const Iex::BaseExc& error) {
        refuse_damaged(state_->path, error.what());
    }
    state_->rows_read += rows;
    return state_->rows;
}

} // namespace gabor::image
