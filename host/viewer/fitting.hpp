#pragma once

#include "render/request/request.hpp"
#include "viewer/background.hpp"
#include "viewer/window.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gabor::fit {
struct Exemplar;
}

namespace gabor::viewer {

/// A photograph as the window shows it: averaged over squares if it is larger than a screen.
struct Photograph {
    std::string path;
    Extent grid;               ///< size of what is shown
    int square = 1;            ///< side of the averaged squares, in pixels
    std::vector<float> pixels; ///< red, green and blue, from 0 to 1
};

/// A noise fitted to a photograph.
struct FittedPreset {
    render::Request request;
    std::string glsl;               ///< the noise as a GLSL function
    std::vector<std::string> lines; ///< notes for the user
};

/// Fits noises to photographs in the background.
class Fitter {
  public:
    static constexpr int most_lobes = 16;

    /// Starts with another photograph. A fit to the previous one ends without a result.
    void open(const std::string& path);
    /// Forgets the photograph.
    void close();
    /// Sets the largest number of lobes. Starts a new fit if it changes.
    void set_lobes(int lobes) { wanted_.lobes = lobes; }
    int lobes() const { return wanted_.lobes; }
    /// The photograph's file; empty if there is none.
    const std::string& path() const { return wanted_.path; }

    /// Starts fits and collects their results. Call it in each frame.
    void poll();
    bool running() const { return busy_; }
    double progress() const { return work_.progress(); } ///< from 0 to 1
    /// The last photograph that was read.
    const std::shared_ptr<const Photograph>& photograph() const { return photograph_; }
    /// The noise fitted since the last call, if any.
    std::optional<FittedPreset> take() { return std::exchange(fitted_, std::nullopt); }
    /// Why fitting has failed since the last call; empty if it has not.
    std::string take_error() { return std::exchange(error_, {}); }

  private:
    struct Wanted {
        std::string path;
        int lobes = most_lobes;
        bool operator==(const Wanted&) const = default;
    };

    void work(const Wanted& wanted);

    Wanted wanted_;
    Wanted begun_;      ///< the fit that the thread started last
    bool busy_ = false; ///< true until `poll` has collected the result
    std::shared_ptr<const Photograph> photograph_;
    std::optional<FittedPreset> fitted_;
    std::string error_;
    std::shared_ptr<const Photograph> read_; ///< the thread owns this and the following members while it runs
    std::shared_ptr<const fit::Exemplar> exemplar_;
    std::optional<FittedPreset> result_;
    BackgroundTask work_;
};

} // namespace gabor::viewer
