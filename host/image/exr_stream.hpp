#pragma once

#include "image/output_file.hpp"

#include <ImfCompression.h>
#include <ImfIO.h>

#include <exception>
#include <string_view>

namespace gabor::image {

/// Compression level for zip and zips: on noise twice as fast as the default, and no larger.
inline constexpr int exr_zip_level = 1;

/// Returns the method of that name. Throws RequestError, listing the names, if there is none.
Imf::Compression exr_compression(std::string_view name);
/// Returns the name of a lossless method; empty for a lossy one.
std::string_view exr_compression_name(Imf::Compression method);

/// Lets OpenEXR write into an OutputFile. Remembers a failure, because the destructor of Imf::OutputFile,
/// which writes the table of offsets, swallows exceptions.
class ExrStream final : public Imf::OStream {
  public:
    explicit ExrStream(OutputFile& file) : OStream(file.path().c_str()), file_(file) {}

    void write(const char* bytes, int count) override {
        attempt([&] { file_.write(std::as_bytes(std::span(bytes, static_cast<std::size_t>(count)))); });
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override {
        attempt([&] { file_.seek(position); });
    }

    void rethrow_failure() const {
        if (failure_)
            std::rethrow_exception(failure_);
    }

  private:
    template <class Action>
    void attempt(Action action) {
        try {
            action();
        } catch (...) {
            failure_ = std::current_exception();
            throw;
        }
    }

    OutputFile& file_;
    std::exception_ptr failure_;
};

} // namespace gabor::image
