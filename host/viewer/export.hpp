#pragma once

#include "render/file.hpp"
#include "viewer/document.hpp"
#include "viewer/file_stamp.hpp"

#include <atomic>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace gabor::viewer {

/// What a document is exported as: one picture, the frames of its animation, or a mip-mapped texture.
enum class ExportAs { picture, frames, texture };

/// Where an export goes, and what it is.
struct ExportTarget {
    std::string path = "noise.exr"; ///< of frames NAME.exr for NAME.0001.exr and on
    ExportAs as = ExportAs::picture;
    bool png = true; ///< beside each EXR; a texture has none
    int frames = 24;
    bool half = false; ///< a texture of 16-bit floats
};

/// The files that it writes.
std::vector<render::Files> files_of(const ExportTarget& target);

/// The request of the document's export.
render::Request exported(const Document& document, ExportAs as);

/// Renders files in the background, on a thread and a logical device of its own, as `gabor render` does.
class Exporter {
  public:
    /// `selector`: as for vulkan::Device.
    explicit Exporter(std::string selector) : selector_(std::move(selector)) {}
    ~Exporter();

    /// The pictures of a document: the channels that its output is made of, and in PNGs what it shows of
    /// them. Throws RequestError where the request or a path will not do. Not while `running`.
    void start(const Document& document, const ExportTarget& target);
    void cancel() { cancelled_ = true; }

    bool running() const { return running_; }
    double progress() const; ///< from 0 to 1
    /// What came of the last one: a line to show, empty at first.
    std::string result() const { return running_ ? std::string() : result_; }
    /// Whether the last one ended with an error.
    bool failed() const { return !running_ && failed_; }
    /// The files of the last one, by their absolute paths; none while it runs.
    std::map<std::filesystem::path, FileStamp> written() const {
        return running_ ? decltype(written_)() : written_;
    }

  private:
    struct Work {
        Document document;
        ExportTarget target;
        render::Request request;
    };
    std::string run(const Work& work); ///< the line to show

    std::string selector_;
    std::thread thread_;
    std::atomic<bool> running_ = false;
    std::atomic<bool> cancelled_ = false;
    std::atomic<std::uint64_t> done_ = 0;
    std::uint64_t total_ = 1;
    std::string result_; ///< this and what follows belong to the thread while it runs
    bool failed_ = false;
    std::map<std::filesystem::path, FileStamp> written_;
};

} // namespace gabor::viewer
