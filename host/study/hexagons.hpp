#pragma once

#include <array>

namespace gabor::study {

/// The lattice (i / n, i step / n) mod 1: n points in each unit cell, the same in all cells. Its Voronoi
/// cells are equal hexagons that tile the plane, as close to regular ones as a lattice that repeats in each
/// cell can have.
struct Hexagons {
    int step = 0;
    std::array<double, 2> a{}; ///< a reduced basis, a.b >= 0
    std::array<double, 2> b{};
    double overhang = 0; ///< how far hexagons reach over the border of the unit cell, at most 1/2
};

/// The lattice for n points per cell whose nearest points are the furthest apart.
Hexagons hexagons(int n);

} // namespace gabor::study
