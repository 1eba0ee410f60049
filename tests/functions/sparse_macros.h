// Undefines the macros of gabor_sparse.hpp, to include it again with others.
#undef GABOR_SPARSE_HPP
#undef GABOR_IMPULSES
#undef GABOR_CELLS_PER_RADIUS
#undef GABOR_WEIGHT_FLOOR
#undef GABOR_PHASES
#undef GABOR_WINDOW
