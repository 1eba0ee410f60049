// The law of the lattice noise on the device.

#include "lattice_sampler.hpp"

#include <catch2/catch.hpp>
