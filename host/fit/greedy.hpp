#pragma once

#include "fit/levenberg.hpp"

#include <vector>

namespace gabor::fit {

/// Finds the wave that reduces a residual most.
class Search {
  public:
    explicit Search(const TargetSpectra& target);

    /// That wave, with the weights that fit best while others stay as they are. Tried are all frequencies of
    /// the first scale with radii that its windows can tell, and the highest peaks of the other scales with
    /// larger radii, in steps of a factor of 2 along each axis.
    Wave best(const TargetSpectra& target, const Residual& left) const;

  private:
    // The atoms of all frequencies and radii along an axis: one row for each.
    struct Axis {
        std::vector<int> frequency; ///< on the grid
        std::vector<double> radius;
        Eigen::MatrixXf atoms;
        Eigen::MatrixXf mirrored; ///< times those of the opposite frequency
    };
    static Axis axis_of(const Scale& scale, int which, double largest_radius, int lowest);

    Axis x_;
    Axis y_;
    Eigen::MatrixXf square_; ///< squared norm of each atom: a row for each of y_, a column for each of x_
};

} // namespace gabor::fit
