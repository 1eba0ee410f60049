#pragma once

#include "fit/levenberg.hpp"

#include <vector>

namespace gabor::fit {

/// Finds the wave that reduces a residual most.
class WaveSearch {
  public:
    explicit WaveSearch(const TargetSpectra& target);

    /// Returns the wave that reduces the residual `left` most, with the weights that fit best while other
    /// waves stay unchanged. Tries all frequencies of the first scale with the radii that its windows can
    /// resolve, and the highest peaks of the other scales with larger radii. Radii double from step to step
    /// along each axis.
    Wave best(const TargetSpectra& target, const Eigen::MatrixXd& left) const;

  private:
    // The spectra of all frequencies and radii along an axis: one row for each pair.
    struct Axis {
        std::vector<int> frequency; ///< indices on the grid
        std::vector<double> radius;
        Eigen::MatrixXf spectra;
        Eigen::MatrixXf mirrored; ///< spectra times those of the opposite frequencies
    };
    static Axis axis_of(const SpectrumScale& scale, int which, double largest_radius, int lowest);

    Axis x_;
    Axis y_;
    Eigen::MatrixXf
        square_; ///< squared norm of each product of a spectrum of y_ (row) and one of x_ (column)
};

} // namespace gabor::fit
