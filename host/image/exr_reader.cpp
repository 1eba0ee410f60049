#include "image/exr.hpp"

#include "error.hpp"
#include "image/exr_inspection.hpp"
#include "image/exr_threads.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace gabor::image {

namespace {

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
    explicit State(const std::filesystem::path& name) : path(name), image(name.c_str(), inspect_exr(name)) {}

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
        refuse_exr(path, fmt::format("there is no channel '{}': it has {}", *channel, list(channels)));
    if (!found)
        refuse_exr(path, fmt::format("no half or float channel among {}", list(channels)));
    if (found->type == Imf::UINT)
        refuse_exr(path,
                   fmt::format("channel '{}' holds integers; accepted are half and float", state_->channel));
    if (found->xSampling != 1 || found->ySampling != 1)
        refuse_exr(path, fmt::format("channel '{}' is subsampled; accepted is a value for every pixel",
                                     state_->channel));
} catch (const Iex::BaseExc& error) {
    refuse_damaged_exr(path, error.what());
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
        refuse_damaged_exr(state_->path, error.what());
    }
    state_->rows_read += rows;
    return state_->rows;
}

} // namespace gabor::image
