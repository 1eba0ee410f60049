#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace gabor::fit {

/// Uneven light: in each channel, the least-squares fit of a quadratic polynomial of x and y to the picture.
/// If the light also changes the contrast, deviations are proportional to (light / mean light)^contrast.
struct Trend {
    int width = 0;
    int height = 0;
    Eigen::Matrix<double, 6, Eigen::Dynamic>
        coefficients;    ///< of 1, x, y, x^2, x y, y^2, where x and y go from -1 to 1 over the picture
    double contrast = 0; ///< from 0 (light adds) to 1 (light multiplies)

    /// Subtracts the trend from row y, whose channels are interleaved, and evens out the contrast.
    void subtract(int y, std::span<float> row) const;
    /// Returns the sum of the trend's channels at (u, v), both in [-1, 1], divided by the mean of that sum
    /// over the picture.
    double light(double u, double v) const;
};

/// The result of one pass over a picture.
struct PixelStatistics {
    Trend trend;
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance; ///< covariance of the channels, without the trend and with even contrast
};

/// The sums that these statistics need.
class PixelSums {
  public:
    PixelSums(int width, int height, int channels);

    /// Adds the next row from the top. Pixels whose `seen` is 0 do not count.
    void add_row(std::span<const float> row, std::span<const float> seen);
    /// Returns the statistics; call it after the last row. At least one pixel must have been seen.
    PixelStatistics statistics() const;

  private:
    static constexpr int blocks = 16; ///< along each side of the picture, to measure how its contrast changes
    struct Block {
        double count = 0;
        double sum = 0; ///< sum over pixels of the sum of their channels
        double squares = 0;
    };
    void find_contrast(PixelStatistics& statistics) const;

    int height_;
    int row_ = 0;
    Eigen::Matrix<double, 3, Eigen::Dynamic> powers_;   ///< 1, x, x^2 of each column
    Eigen::MatrixXd values_;                            ///< the current row
    Eigen::Matrix<double, 6, 6> gram_;                  ///< products of the polynomials
    Eigen::Matrix<double, 6, Eigen::Dynamic> products_; ///< products of the polynomials and the channels
    Eigen::MatrixXd squares_;                           ///< products of the channels
    std::vector<Block> blocks_ = std::vector<Block>(blocks * blocks);
};

} // namespace gabor::fit
