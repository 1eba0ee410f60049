#pragma once

#include <Eigen/Core>

#include <span>

namespace gabor::fit {

/// The quadratic polynomial of x and y in each channel that is nearest to a picture, by least squares: light
/// that falls off, no texture.
struct Trend {
    int width = 0;
    int height = 0;
    Eigen::Matrix<double, 6, Eigen::Dynamic>
        coefficients; ///< of 1, x, y, x^2, x y, y^2, in [-1, 1] over the picture

    /// Takes it from row y, whose pixels have their channels side by side.
    void subtract(int y, std::span<float> row) const;
};

/// What one pass over a picture finds.
struct Survey {
    Trend trend;
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance; ///< of the channels, without the trend
};

/// Sums that it is made of.
class PixelSums {
  public:
    PixelSums(int width, int height, int channels);

    /// Rows from the top.
    void add_row(std::span<const float> row);
    /// Call after the last row.
    Survey survey() const;

  private:
    int height_;
    int row_ = 0;
    Eigen::Matrix<double, 3, Eigen::Dynamic> powers_;   ///< 1, x, x^2 of each column
    Eigen::Matrix3d row_gram_;                          ///< of these
    Eigen::MatrixXd values_;                            ///< the row
    Eigen::Matrix<double, 6, 6> gram_;                  ///< of the polynomials
    Eigen::Matrix<double, 6, Eigen::Dynamic> products_; ///< of the polynomials and the channels
    Eigen::MatrixXd squares_;                           ///< of the channels
};

} // namespace gabor::fit
