#include "image/exr_parts.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace gabor::image {

void refuse_damaged_exr(const std::filesystem::path& path, std::string_view how) {
    if (const auto named = how.rfind("\". ");
        named != how.npos) // OpenEXR's message begins with the file's name
        how.remove_prefix(named + 3);
    refuse_picture(path,
                   fmt::format("it is truncated or damaged ({}); expected a complete OpenEXR file", how));
}

namespace {

// Tells whether the first header names a compression that this OpenEXR does not know.
bool has_newer_compression(const std::filesystem::path& path) {
    std::string start(1 << 16, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    using namespace std::string_view_literals;
    constexpr std::string_view attribute = "compression\0compression\0\1\0\0\0"sv; // name, type, size
    const std::size_t at = start.find(attribute);
    return at != start.npos && at + attribute.size() < start.size() &&
           static_cast<unsigned char>(start[at + attribute.size()]) >= EXR_COMPRESSION_LAST_TYPE;
}

constexpr std::int64_t widest = 65536;
constexpr std::uint64_t largest_block = 256u << 20;
constexpr std::uint64_t decoding_memory = 4 * largest_block;

// OpenEXR's C++ classes, which decode in parallel, allocate whatever sizes a file claims. So the file is
// first checked with the C library, which compares those sizes with the size of the file.
class ExrContext {
  public:
    explicit ExrContext(const std::filesystem::path& path) : path_(path) {
        exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
        settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
        // Strict mode reports unfinished files and whatever the C++ classes cannot handle.
        settings.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
        require(exr_start_read(&context_, path.string().c_str(), &settings));
    }
    ~ExrContext() { exr_finish(&context_); }
    ExrContext(const ExrContext&) = delete;
    ExrContext& operator=(const ExrContext&) = delete;

    operator exr_const_context_t() const { return context_; }
    void require(exr_result_t result) const {
        if (result == EXR_ERR_FILE_BAD_HEADER)
            refuse_picture(path_, "it is not an OpenEXR file");
        if (result != EXR_ERR_SUCCESS && has_newer_compression(path_))
            refuse_picture(path_, "it is compressed by a newer OpenEXR; expected any compression up to DWAB");
        if (result != EXR_ERR_SUCCESS)
            refuse_damaged_exr(path_, exr_get_default_error_message(result));
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    const std::filesystem::path& path_;
    exr_context_t context_ = nullptr;
};

// Reading where a chunk lies checks that it is complete.
void check_scanlines(const ExrContext& file, std::int32_t first, std::int32_t last) {
    std::int32_t step = 0;
    file.require(exr_get_scanlines_per_chunk(file, 0, &step));
    exr_chunk_info_t chunk;
    for (std::int64_t y = first; y <= last; y += step)
        file.require(exr_read_scanline_chunk_info(file, 0, static_cast<int>(y), &chunk));
}

void check_tiles(const ExrContext& file, std::int64_t width, std::int64_t height) {
    std::int32_t across = 0;
    std::int32_t down = 0;
    file.require(exr_get_tile_sizes(file, 0, 0, 0, &across, &down));
    exr_chunk_info_t chunk;
    for (int y = 0; std::int64_t{y} * down < height; ++y)
        for (int x = 0; std::int64_t{x} * across < width; ++x)
            file.require(exr_read_tile_chunk_info(file, 0, x, y, 0, 0, &chunk));
}

// Returns the size in bytes of the largest block to decode.
std::uint64_t inspect(const ExrContext& file) {
    exr_storage_t storage;
    file.require(exr_get_storage(file, 0, &storage));
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        refuse_picture(file.path(), "it contains deep data; only flat scanlines and tiles are supported");
    exr_attr_box2i_t window;
    file.require(exr_get_data_window(file, 0, &window));
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width > widest || height > widest)
        refuse_picture(file.path(),
                       fmt::format("its data window has {} x {} pixels; at most {} x {} are supported", width,
                                   height, widest, widest));

    const bool tiled = storage == EXR_STORAGE_TILED;
    std::uint64_t block = 0;
    file.require(exr_get_chunk_unpacked_size(file, 0, &block));
    if (tiled) {
        std::uint32_t across = 0;
        std::uint32_t down = 0;
        file.require(exr_get_tile_descriptor(file, 0, &across, &down, nullptr, nullptr));
        block = std::max(block, static_cast<std::uint64_t>(width) * down * sizeof(float)); // a row of tiles
    }
    if (block > largest_block)
        refuse_picture(file.path(),
                       fmt::format("one block or row of tiles takes {} MiB; at most {} MiB are supported",
                                   block >> 20, largest_block >> 20));

    if (tiled)
        check_tiles(file, width, height);
    else
        check_scanlines(file, window.min.y, window.max.y);
    return block;
}

} // namespace

int inspect_exr(const std::filesystem::path& path) {
    open_file(path); // throws unless the file is regular and readable
    const std::uint64_t block = inspect(ExrContext(path));
    const auto affordable = static_cast<int>(decoding_memory / (2 * std::max<std::uint64_t>(block, 1)));
    return std::min(affordable, Imf::globalThreadCount()); // OpenEXR keeps two blocks per thread
}

} // namespace gabor::image
