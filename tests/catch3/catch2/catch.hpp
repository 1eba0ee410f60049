#pragma once

// Catch2 3 with the header and the names of Catch2 2, which Debian 12 has.

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Approx;

namespace Catch::Matchers {
inline auto Contains(const std::string& text) {
    return ContainsSubstring(text);
}
} // namespace Catch::Matchers

namespace Catch {
using Matchers::Contains;
}
