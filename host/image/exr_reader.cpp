#include "image/exr.hpp"

#include "image/exr_inspection.hpp"
#include "image/exr_mosaic.hpp"
#include "image/exr_stream.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
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

} // namespace

struct ExrReader::State {
    State(ExrMosaic mosaic, std::filesystem::path first)
        : image(std::move(mosaic)), path(std::move(first)), picture(to_rect(image.header().displayWindow())),
          window(to_rect(image.header().dataWindow())), parameters(text("gabor")),
          software(text("software")) {}

    std::string text(const char* attribute) const {
        const auto* found = image.header().findTypedAttribute<Imf::StringAttribute>(attribute);
        return found ? found->value() : "";
    }
    void add_channel(const std::string& name);

    ExrMosaic image;
    const std::filesystem::path path;
    const Rect picture;
    const Rect window;
    const std::string parameters;
    const std::string software;
    std::vector<std::string> channels;
    int rows_read = 0;
    std::vector<float> rows;
};

void ExrReader::State::add_channel(const std::string& name) {
    const Imf::ChannelList& all = image.header().channels();
    const Imf::Channel* found = all.findChannel(name);
    if (!found)
        refuse_exr(path, fmt::format("there is no channel '{}': it has {}", name, list(all)));
    if (found->type == Imf::UINT)
        refuse_exr(path, fmt::format("channel '{}' holds integers; accepted are half and float", name));
    if (found->xSampling != 1 || found->ySampling != 1)
        refuse_exr(path,
                   fmt::format("channel '{}' is subsampled; accepted is a value for every pixel", name));
    channels.push_back(name);
}

ExrReader::ExrReader(const std::filesystem::path& path, const std::optional<std::string>& channel)
    : ExrReader(std::span(&path, 1), channel) {}

ExrReader::ExrReader(std::span<const std::filesystem::path> paths, const std::optional<std::string>& channel)
    : state_(std::make_unique<State>(paths.size() == 1 ? ExrMosaic(paths.front()) : ExrMosaic(paths),
                                     paths.front())) {
    const Imf::ChannelList& all = state_->image.header().channels();
    const std::string name = channel ? *channel : default_channel(all);
    if (!channel && name.empty())
        refuse_exr(paths.front(), fmt::format("no half or float channel among {}", list(all)));
    state_->add_channel(name);
}

ExrReader::ExrReader(std::span<const std::filesystem::path> paths, const std::vector<std::string>& channels)
    : state_(std::make_unique<State>(ExrMosaic(paths), paths.front())) {
    for (const std::string& channel : channels)
        state_->add_channel(channel);
}

ExrReader::~ExrReader() = default;
ExrReader::ExrReader(ExrReader&&) noexcept = default;

const Rect& ExrReader::picture() const {
    return state_->picture;
}
const Rect& ExrReader::window() const {
    return state_->window;
}
const std::string& ExrReader::channel() const {
    return state_->channels.front();
}
bool ExrReader::has_channel(const std::string& name) const {
    return state_->image.header().channels().findChannel(name) != nullptr;
}
const std::string& ExrReader::parameters() const {
    return state_->parameters;
}
std::string ExrReader::colour_space() const {
    return state_->text("oiio:ColorSpace");
}

const std::string& ExrReader::software() const {
    return state_->software;
}
std::string_view ExrReader::compression() const {
    return exr_compression_name(state_->image.header().compression());
}

std::span<const float> ExrReader::read_rows(int rows) {
    const Rect& window = state_->window;
    rows = std::min(rows, window.height - state_->rows_read);
    if (rows <= 0)
        return {};
    const std::size_t channels = state_->channels.size();
    const std::size_t row_values = static_cast<std::size_t>(window.width) * channels;
    state_->rows.resize(static_cast<std::size_t>(rows) * row_values);

    const int y = window.y + state_->rows_read;
    Imf::FrameBuffer band;
    for (std::size_t c = 0; c < channels; ++c)
        band.insert(state_->channels[c],
                    Imf::Slice::Make(Imf::FLOAT, state_->rows.data() + c, {window.x, y}, window.width, rows,
                                     channels * sizeof(float), row_values * sizeof(float)));
    state_->image.read(band, y, y + rows - 1);
    state_->rows_read += rows;
    return state_->rows;
}

} // namespace gabor::image
