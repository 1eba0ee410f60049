#pragma once

#include "render/output/file.hpp"
#include "render/output/maps.hpp"
#include "viewer/background.hpp"
#include "viewer/document.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gabor::viewer {

/// The time and size of a file, which show whether it has changed since it was read or written.
struct FileStamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const FileStamp&) const = default;
};

/// Returns a file's stamp. Missing files have one too.
inline FileStamp file_stamp(const std::filesystem::path& path) {
    std::error_code ignored;
    return {std::filesystem::last_write_time(path, ignored), std::filesystem::file_size(path, ignored)};
}

/// The absolute path, starting with ~ for files in the home folder.
std::string path_from_home(const std::filesystem::path& path);

/// The form of an export: a picture, the frames of an animation, a mip-mapped texture, or maps for other
/// programs. The maps are those of a material or, for noise in the plane, colour, normals and height.
enum class ExportAs { picture, frames, texture, maps };

/// Where an export goes and in what form.
struct ExportTarget {
    std::string path = {};   ///< frames are numbered: NAME.0001.exr; empty for the document's name
    std::string folder = {}; ///< folder for maps; empty for the document's name
    std::optional<ExportAs> chosen =
        {}; ///< if not set, maps for a material and land from above, and a picture for the rest
    ExportAs as = ExportAs::picture;
    bool of_noise = false; ///< whether the maps show noise instead of a material
    bool coloured = false; ///< whether the noise has the colours of a photograph
    bool png = true;       ///< write a PNG beside each EXR, except for a texture
    int frames = 24;
    bool half = false;               ///< store a texture as 16-bit floats
    bool directx = false;            ///< with maps, also write normals whose green points down
    int map_side = render::map_side; ///< sides of maps, in pixels
    bool tileable = true;            ///< whether maps tile
    double metres = 1;               ///< the width of a material's maps; a terrain has an extent

    /// Returns this target with `path`, `folder`, `as`, `of_noise` and `coloured` set for the document.
    ExportTarget of(const Document& document) const;
    /// The path of the EXR, or the folder for maps.
    const std::string& name() const { return as == ExportAs::maps ? folder : path; }
};

/// Whether maps can be exported for this request.
bool can_export_maps(const render::Request& request);

/// The files that an export writes, except maps.
std::vector<render::Files> files_of(const ExportTarget& target);
/// The paths of all files that an export writes, including maps.
std::vector<std::filesystem::path> paths_of(const ExportTarget& target);

/// The request that an export renders.
render::Request exported(const Document& document, const ExportTarget& target);

/// Renders files in the background on its own logical device, with the same pixels as `gabor render`.
class Exporter {
  public:
    /// `selector` is passed to vulkan::Device.
    explicit Exporter(std::string selector) : selector_(std::move(selector)) {}

    /// Starts an export. The EXR has the channels of the document's output, and the PNG looks like the
    /// window. Throws RequestError for a bad request or path. Call it only when no export is running.
    void start(const Document& document, const ExportTarget& target);
    void cancel() { work_.cancel(); }

    bool running() const { return work_.running(); }
    double progress() const { return work_.progress(); } ///< from 0 to 1
    /// A line about the last export; empty during an export and before the first one.
    std::string result() const;
    bool failed() const { return !running() && !work_.error().empty(); }
    /// The files that the last export wrote, by absolute path; empty during an export.
    std::map<std::filesystem::path, FileStamp> written() const {
        return running() ? decltype(written_)() : written_;
    }

  private:
    void write_noise_maps(const vulkan::Device& device, const Document& document, const ExportTarget& target,
                          const std::function<void(std::uint64_t)>& advance) const;
    void run(const Document& document, const ExportTarget& target, const render::Request& request);

    std::string selector_;
    std::string result_;
    std::map<std::filesystem::path, FileStamp> written_;
    BackgroundTask work_; ///< its task writes the two members above
};

} // namespace gabor::viewer
