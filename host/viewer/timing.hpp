#pragma once

#include "bench/subjects.hpp"
#include "viewer/noise_pass.hpp"

#include <memory>
#include <optional>

namespace gabor::viewer {

/// What `gabor bench` times for the noise of a pane: the function that draws each of its waves, as one would
/// paste it. None where it times no such noise. The subject may refer to the recipe of `noise`.
std::optional<bench::Subject> subject_of(const NoisePass& noise);

/// Times the noises of panes by the code and on the device that `gabor bench` has, one after the other and
/// again, so that what disturbs the machine disturbs all alike. The least times count: other work can only
/// add.
class Timing {
  public:
    explicit Timing(const vulkan::Device& device);

    /// What is to be timed. Panes whose code stays keep their times.
    void set(const std::vector<NoisePass>& panes);
    /// Whether nothing is left to be timed.
    bool done() const { return rounds_ == most_rounds; }
    /// One round.
    void run();

    /// Nanoseconds per pixel, of all waves; NaN as long as they are unknown.
    double nanoseconds(std::size_t pane) const;
    /// The function that was timed; empty for none.
    std::string function(std::size_t pane) const;

  private:
    static constexpr int most_rounds = 7;

    struct Timed {
        NoisePass noise;
        std::string function;
        double waves = 1;
        int side = 0;
        std::unique_ptr<bench::Filling> filling;
        double seconds = 0; ///< for a pixel of one wave, the least so far; 0 for none
    };

    const vulkan::Device& device_;
    vulkan::Buffer picture_;
    std::vector<Timed> panes_;
    int rounds_ = most_rounds;
};

} // namespace gabor::viewer
