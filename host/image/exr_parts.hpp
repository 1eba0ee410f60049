#pragma once

// Shared by the files that read and write EXR.

#include "image/exr.hpp"
#include "image/output_file.hpp"

#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfThreading.h>

#include <mutex>
#include <thread>

namespace gabor::image {

/// Gives OpenEXR's thread pool, which starts empty, one thread per core.
inline void start_exr_threads() {
    static std::once_flag once;
    std::call_once(once,
                   [] { Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency())); });
}

/// Describes rows of interleaved channels. The first value belongs to the pixel `corner`.
template <typename Value>
Imf::FrameBuffer frame_buffer(Imf::PixelType type, const Value* values,
                              const std::vector<std::string>& channels, const Imath::V2i& corner, int width,
                              int rows) {
    const std::size_t pixel = channels.size() * sizeof(Value);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels.size(); ++c)
        frame.insert(channels[c], Imf::Slice::Make(type, values + c, corner, width, rows, pixel,
                                                   pixel * static_cast<std::size_t>(width)));
    return frame;
}

/// Lets OpenEXR write into an OutputFile. The destructor of Imf::OutputFile, which writes the table of
/// offsets, swallows exceptions, but OutputFile::commit reports them.
class ExrStream final : public Imf::OStream {
  public:
    explicit ExrStream(OutputFile& file) : OStream(file.path().c_str()), file_(file) {}

    void write(const char* bytes, int count) override {
        file_.write({bytes, static_cast<std::size_t>(count)});
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override { file_.seek(position); }

  private:
    OutputFile& file_;
};

/// Converts a header to OpenEXR's form.
Imf::Header exr_header(const ExrHeader& header);

/// Returns the name of a lossless method; empty for a lossy one.
std::string_view exr_compression_name(Imf::Compression method);

/// Throws RequestError for a truncated or damaged file; `how` is OpenEXR's message.
[[noreturn]] void refuse_damaged_exr(const std::filesystem::path& path, std::string_view how);

/// Returns how many threads may decode the file. Throws RequestError if the file is not safe to open.
int inspect_exr(const std::filesystem::path& path);

} // namespace gabor::image
