#pragma once

#include <openexr.h>

#include <filesystem>

namespace gabor::image {

/// A file opened with OpenEXR's C library, which checks sizes in the file against the file's own size.
class ExrContext {
  public:
    /// Keeps a reference to `path`. Throws RequestError if the file cannot be read, like `require`.
    explicit ExrContext(const std::filesystem::path& path);
    ~ExrContext() { exr_finish(&context_); }
    ExrContext(const ExrContext&) = delete;
    ExrContext& operator=(const ExrContext&) = delete;

    /// Converts for calls of the library; pass their results to `require`.
    operator exr_const_context_t() const { return context_; }
    void require(exr_result_t result) const;

    const std::filesystem::path& path() const { return path_; }

  private:
    const std::filesystem::path& path_;
    exr_context_t context_ = nullptr;
};

} // namespace gabor::image
