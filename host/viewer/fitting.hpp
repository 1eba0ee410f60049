#pragma once

#include "render/request.hpp"
#include "viewer/extent.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gabor::fit {
struct Exemplar;
}

namespace gabor::viewer {

/// A photograph as it is shown: averaged over squares where it is larger than a screen.
struct Photograph {
    std::string path;
    Extent extent;             ///< of the file, in pixels
    Extent grid;               ///< of what is shown
    int square = 1;            ///< pixels along each side that one of those stands for
    std::vector<float> pixels; ///< red, green and blue, from 0 to 1
};

/// A noise that was fitted to a photograph.
struct FittedPreset {
    render::Request request;
    std::string glsl;               ///< the function of it
    std::vector<std::string> lines; ///< what is to be said of it
};

/// Fits noises to photographs in the background, on a thread of its own.
class Fitter {
  public:
    static constexpr int most_lobes = 16;

    Fitter() = default;
    ~Fitter();
    Fitter(const Fitter&) = delete;
    Fitter& operator=(const Fitter&) = delete;

    /// Another photograph. What is under way ends without a result.
    void open(const std::string& path);
    /// No photograph.
    void close();
    /// The most lobes that the noise may have: another number fits anew.
    void set_lobes(int lobes) { wanted_.lobes = lobes; }
    int lobes() const { return wanted_.lobes; }
    /// The file's name; empty where there is none.
    const std::string& path() const { return wanted_.path; }

    /// Begins and ends work; for every frame.
    void go_on();
    bool running() const { return thread_.joinable(); }
    double progress() const { return progress_; } ///< from 0 to 1
    /// The photograph, from when it has been read until another one has.
    const std::shared_ptr<const Photograph>& photograph() const { return photograph_; }
    /// What was fitted since the last call.
    std::optional<FittedPreset> take() { return std::exchange(fitted_, {}); }
    /// Why there is nothing to take, since the last call.
    std::optional<std::string> take_error() { return std::exchange(error_, {}); }

  private:
    struct Wanted {
        std::string path;
        int lobes = most_lobes;
        bool operator==(const Wanted&) const = default;
    };

    void work(const Wanted& wanted);

    Wanted wanted_;
    Wanted begun_; ///< what the thread works at, or has worked at
    std::thread thread_;
    std::atomic<bool> done_ = false;
    std::atomic<bool> cancelled_ = false;
    std::atomic<double> progress_ = 0;
    std::shared_ptr<const Photograph> photograph_;
    std::optional<FittedPreset> fitted_;
    std::optional<std::string> error_;
    // These belong to the thread while it runs.
    std::shared_ptr<const Photograph> read_;
    std::shared_ptr<const fit::Exemplar> exemplar_;
    std::optional<FittedPreset> result_;
    std::optional<std::string> failure_;
};

} // namespace gabor::viewer
