#pragma once

#include <openexr.h>

#include <filesystem>

namespace gabor::image {

/// A file that OpenEXR's C library has open. It knows the file's size and holds every claim in it against
/// that.
class ExrContext {
  public:
    /// The path must outlive it. Throws RequestError where the file cannot be read, as `require` does.
    explicit ExrContext(const std::filesystem::path& path);
    ~ExrContext() { exr_finish(&context_); }
    ExrContext(const ExrContext&) = delete;
    ExrContext& operator=(const ExrContext&) = delete;

    /// For the library's functions, whose results `require` takes.
    operator exr_const_context_t() const { return context_; }
    void require(exr_result_t result) const;

    const std::filesystem::path& path() const { return path_; }

  private:
    const std::filesystem::path& path_;
    exr_context_t context_ = nullptr;
};

} // namespace gabor::image
