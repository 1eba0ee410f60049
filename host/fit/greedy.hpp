#pragma once

#include "fit/levenberg.hpp"

#include <vector>

namespace gabor::fit {

/// Looks for the wave that takes most of a residual, over all frequencies of the grid and over radii in steps
/// of sqrt 2.
class Search {
  public:
    explicit Search(const TargetSpectra& target);

    /// That wave, with the weights that fit best while others stay as they are.
    Wave best(const Residual& left) const;

  private:
    // Atoms of one radius along an axis, and what a wave at each frequency has for a square.
    struct Scale {
        double radius;
        std::vector<int> rows;    ///< frequencies of y that are tried, in steps of the grid
        std::vector<int> columns; ///< of x
        Eigen::MatrixXf atoms_y;  ///< one row for each
        Eigen::MatrixXf atoms_x;
        Eigen::MatrixXf square;
    };

    int channels_;
    Eigen::ArrayXd weight_;
    std::vector<Scale> scales_;
};

} // namespace gabor::fit
