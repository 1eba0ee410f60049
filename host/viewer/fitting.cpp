#include "viewer/fitting.hpp"

#include "fit/fit.hpp"
#include "fit/glsl.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>

namespace gabor::viewer {

namespace {

constexpr int largest_shown = 2048; // pixels

static_assert(Fitter::most_lobes == fit::most_lobes);

Photograph read_photograph(const std::string& path, const fit::Advance& advance) {
    const std::unique_ptr<image::PictureReader> reader = image::open_picture(path);
    const int width = reader->format().width, height = reader->format().height,
              channels = reader->format().channels;
    const int square = (std::max(width, height) + largest_shown - 1) / largest_shown;
    Photograph photograph{.path = path,
                          .grid = {std::max(width / square, 1), std::max(height / square, 1)},
                          .square = square,
                          .pixels = {}};
    const auto columns = static_cast<std::size_t>(photograph.grid.width);
    photograph.pixels.assign(3 * columns * static_cast<std::size_t>(photograph.grid.height), 0);
    std::vector<float> row(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels));
    for (int y = 0; y < height; ++y) {
        reader->read_row(row);
        advance(static_cast<double>(y) / height);
        if (y / square >= photograph.grid.height)
            continue;
        float* const to = &photograph.pixels[3 * columns * static_cast<std::size_t>(y / square)];
        for (std::size_t x = 0; x < columns * static_cast<std::size_t>(square); ++x)
            for (std::size_t c = 0; c < 3; ++c)
                to[x / static_cast<std::size_t>(square) * 3 + c] +=
                    row[x * static_cast<std::size_t>(channels) + (channels == 3 ? c : 0)] /
                    static_cast<float>(square * square);
    }
    return photograph;
}

// Makes a GLSL name from the file's name. It contains no double underscore, which GLSL reserves, and does not
// end with an underscore, so that more words can be appended.
std::string glsl_name(const std::string& path) {
    std::string name = "texture";
    bool apart = true;
    for (const char c : std::filesystem::path(path).stem().string()) {
        const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (letter)
            name += apart ? std::string{'_', c} : std::string{c};
        apart = !letter;
    }
    return name;
}

std::vector<std::string> lines_of(const fit::Exemplar& exemplar, const fit::FittedNoise& fitted) {
    std::vector<std::string> lines{
        fmt::format("{} lobes; spectrum within {:.3f}, autocorrelation within {:.3f}", fitted.waves.size(),
                    fitted.error.l1, fitted.error.autocorrelation)};
    std::ranges::copy(fit::warnings(exemplar, fitted), std::back_inserter(lines));
    return lines;
}

} // namespace

void Fitter::open(const std::string& path) {
    wanted_ = {path, most_lobes};
    if (begun_ == wanted_)
        begun_ = {}; // read it again
}

void Fitter::close() {
    wanted_ = {};
    photograph_.reset();
}

void Fitter::poll() {
    if (work_.running()) {
        if (wanted_ != begun_)
            work_.cancel();
        return;
    }
    if (std::exchange(busy_, false) && wanted_.path == begun_.path) {
        photograph_ = read_;
        fitted_ = std::exchange(result_, std::nullopt);
        error_ = work_.error();
        if (work_.was_cancelled())
            begun_ = {}; // start again if the same number of lobes is chosen later
        else if (!error_.empty() && !exemplar_)
            close();
    }
    if (wanted_ == begun_ || wanted_.path.empty())
        return;
    if (wanted_.path != begun_.path) {
        read_.reset();
        exemplar_.reset();
    }
    begun_ = wanted_;
    result_.reset();
    busy_ = true;
    work_.start([this, wanted = wanted_] { work(wanted); });
}

void Fitter::work(const Wanted& wanted) {
    const auto part = [this](double from, double to) {
        return [this, from, to](double share) { work_.advance(from + (to - from) * share); };
    };
    if (!exemplar_) {
        Photograph photograph = read_photograph(wanted.path, part(0, 0.1));
        auto exemplar = std::make_shared<fit::Exemplar>(fit::read_exemplar(wanted.path, part(0.1, 0.4)));
        read_ = std::make_shared<Photograph>(std::move(photograph));
        exemplar_ = std::move(exemplar);
    }
    const fit::FittedNoise fitted = fit::fit(*exemplar_, wanted.lobes, part(0.4, 1));
    result_ = FittedPreset{fit::request_of(*exemplar_, fitted),
                           fit::glsl_of(glsl_name(wanted.path), wanted.path, *exemplar_, fitted),
                           lines_of(*exemplar_, fitted)};
}

} // namespace gabor::viewer
