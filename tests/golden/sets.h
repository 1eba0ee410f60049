// The macros of each set of functions, for C++ and GLSL. GABOR_OF_x chooses set x, whose values are in x.txt.

#if defined GABOR_OF_sparse_one
#define GOLDEN_SPARSE
#elif defined GABOR_OF_sparse_pure
#define GOLDEN_SPARSE
#define GABOR_CELLS_PER_RADIUS 1.5f
#define GABOR_WEIGHT_FLOOR 0.5f
#define GABOR_WINDOW vec3(1.0f, -1.0f, 1.0f)
#elif defined GABOR_OF_sparse_paper
#define GOLDEN_SPARSE
#define GABOR_IMPULSES 2
#define GABOR_WEIGHT_FLOOR 1.0f
#define GABOR_PHASES 2
#define GABOR_WINDOW vec3(1.0f, 0.0f, 0.0f)
#elif defined GABOR_OF_sparse_own // two phases and a window with three terms, which use all of the code
#define GOLDEN_SPARSE
#define GABOR_IMPULSES 3
#define GABOR_CELLS_PER_RADIUS 1.25f
#define GABOR_PHASES 2
#elif defined GABOR_OF_lattice_2
#define GOLDEN_NOISE
#define GABOR_TAPS 2
#elif defined GABOR_OF_lattice_3
#define GOLDEN_NOISE
#elif defined GABOR_OF_lattice_4
#define GOLDEN_NOISE
#define GABOR_TAPS 4
#elif defined GABOR_OF_spectrum
#define GOLDEN_SPECTRUM
#elif defined GABOR_OF_noise_3d
#define GOLDEN_NOISE_3D
#elif defined GABOR_OF_direction
#define GOLDEN_DIRECTION
#elif defined GABOR_OF_erosion
#define GOLDEN_EROSION
#elif defined GABOR_OF_fractal
#define GOLDEN_FRACTAL
#elif defined GABOR_OF_ocean
#define GOLDEN_OCEAN
#elif defined GABOR_OF_materials
#define GOLDEN_MATERIALS
#endif
#define GABOR_LOBES 3
