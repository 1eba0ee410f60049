#pragma once

// gabor_sparse.glsl translated to C++. Each class has the functions for one choice of the macros as members.

#include "compare.hpp"
#include "reference/reference.hpp"

#include "gabor_sparse.hpp" // for gabor_vec2

namespace gabor::test {

namespace {

#undef GABOR_SPARSE_HPP
struct One {
    const noise::Recipe recipe = noise::find_recipe("one");
#include "gabor_sparse.hpp"
};

#undef GABOR_SPARSE_HPP
#undef GABOR_RADIUS
#undef GABOR_WEIGHT_FLOOR
#undef GABOR_WINDOW
#define GABOR_RADIUS 1.5f
#define GABOR_WEIGHT_FLOOR 0.5f
#define GABOR_WINDOW gabor_vec3(1, -1, 1)
struct Pure {
    const noise::Recipe recipe = noise::find_recipe("pure");
#include "gabor_sparse.hpp"
};

#undef GABOR_SPARSE_HPP
#undef GABOR_IMPULSES
#undef GABOR_RADIUS
#undef GABOR_WEIGHT_FLOOR
#undef GABOR_PHASES
#undef GABOR_WINDOW
#define GABOR_IMPULSES 2
#define GABOR_WEIGHT_FLOOR 1.0f
#define GABOR_PHASES 2
#define GABOR_WINDOW gabor_vec3(1, 0, 0)
struct Paper {
    const noise::Recipe recipe = noise::find_recipe("paper");
#include "gabor_sparse.hpp"
};

#undef GABOR_SPARSE_HPP
#undef GABOR_IMPULSES
#undef GABOR_RADIUS
#undef GABOR_WEIGHT_FLOOR
#undef GABOR_PHASES
#undef GABOR_WINDOW
#define GABOR_IMPULSES 3
#define GABOR_RADIUS 1.06f
#define GABOR_WEIGHT_FLOOR 0.2f
#define GABOR_PHASES 4
#define GABOR_WINDOW gabor_vec3(0.5f, 1.5f, -1)
struct Uneven { // unlike the published recipes in every value
    const noise::Recipe recipe{"uneven", 3, 1.06f, 0.2f, 4, {0.5f, 1.5f, -1}, ""};
#include "gabor_sparse.hpp"
};

} // namespace

} // namespace gabor::test
