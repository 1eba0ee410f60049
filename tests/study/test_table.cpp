// Tests spectra and tables, without a device.

#include "../image/scratch_folder.hpp"
#include "error.hpp"
#include "study/figures.hpp"
#include "study/table.hpp"
#include "study/variant.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace gabor;
using namespace gabor::study;

TEST_CASE("the Pareto front of hand-made rows is found", "[frontier]") {
    const auto row = [](double visits, double cvm_high, double sidelobe, double interdecile = 0.01) {
        return Numbers{visits, 0, 0, 0, 1, interdecile, 0.02, 1, sidelobe, 0, 0, 0, cvm_high};
    };
    std::vector<Numbers> rows{
        row(9, 0.5, -28),       row(9, 0.5, -28), // as good as the first; neither dominates the other
        row(18, 0.5, -28),                        // more visits for nothing
        row(18, 0.1, -28),                        // more visits for more Gaussianity
        row(16, 0.6, -30),                        // more visits for lower sidelobes
        row(9, 0.01, -40, 0.2), // better than all, but not stationary, so it dominates nothing and is not
                                // on the front
    };
    mark_pareto(rows);
    std::vector<double> front;
    for (const Numbers& numbers : rows)
        front.push_back(numbers.back());
    CHECK(front == std::vector<double>{1, 1, 0, 1, 1, 0});
}

TEST_CASE("windows with known spectra have the expected spectral purity", "[purity]") {
    // (1 - x^2)^2 has the spectrum j_2(a) / a^2, whose largest sidelobe is at a = 6.988.
    const double a = 6.9879;
    const double side = std::sph_bessel(2, a) / (a * a) * 15;
    CHECK(spectral_purity({"", Shape::separable, {1, 0, 0}}).sidelobe ==
          Approx(20 * std::log10(std::abs(side))).margin(0.01));
    // (1 - r^2)^2 has J_3(a) / a^3, whose largest sidelobe is at a = 7.588.
    const double b = 7.5883;
    CHECK(spectral_purity({"", Shape::radial, {1, 0, 0}}).sidelobe ==
          Approx(20 * std::log10(std::abs(std::cyl_bessel_j(3.0, b)) / (b * b * b) * 48)).margin(0.01));
    for (const Shape shape : {Shape::separable, Shape::radial, Shape::gaussian}) {
        const double outside = spectral_purity({"", shape, {1, 0, 0}}).outside;
        CHECK(outside > 1e-4);
        CHECK(outside < 4e-3);
    }
}

TEST_CASE("the seminal curve is inverted correctly", "[convergence]") {
    SeminalCurve curve;
    curve.add(4, 39.3);
    curve.add(10, 5.83);
    curve.add(30, 0.5);
    CHECK(curve.equivalent(5.83) == Approx(10));
    CHECK(curve.equivalent(20) > 4);
    CHECK(curve.equivalent(20) < 10);
    CHECK(curve.equivalent(0.125) == Approx(60).epsilon(0.05)); // 2.7 / N by theory
    CHECK(std::isinf(curve.equivalent(-0.01)));
}

namespace {

// A table of three rows that counts how often a row is measured.
Table counted(int& measured) {
    const auto measure = [&measured](std::uint32_t seed) -> Numbers {
        ++measured;
        return {seed / 3.0, std::sqrt(2.0)};
    };
    const auto derive = [](std::vector<Numbers>& rows) {
        for (Numbers& row : rows)
            row.push_back(row[0] - rows[0][0]);
    };
    return {"numbers", "name,a,b", {{"x", 1, measure}, {"y", 1, measure}, {"z", 1, measure}}, "c", derive};
}

void write(const Table& table, const std::filesystem::path& folder) {
    MeasuredRows measured;
    write_table(table, folder, "conditions", measured, [](double) {});
}

} // namespace

TEST_CASE("a table counts as finished only under the conditions of its measurement", "[table]") {
    int measured = 0;
    const Table table = counted(measured);
    const ScratchFolder folder;
    CHECK_FALSE(is_finished(table, folder.path(), "conditions"));
    write(table, folder.path());
    CHECK(measured == 3);
    CHECK(is_finished(table, folder.path(), "conditions"));
    CHECK_FALSE(is_finished(table, folder.path(), "other conditions"));
    std::filesystem::remove(folder / "numbers.csv");
    CHECK_FALSE(is_finished(table, folder.path(), "conditions"));
}

TEST_CASE("an interrupted table leaves no file, and the next run writes the same bytes", "[table]") {
    int measured = 0;
    const Table table = counted(measured);
    const ScratchFolder whole;
    write(table, whole.path());
    const ScratchFolder broken;
    MeasuredRows rows;
    CHECK_THROWS_AS(write_table(table, broken.path(), "conditions", rows, [](double) { throw 7; }), int);
    CHECK(broken.count() == 0);
    write(table, broken.path());
    CHECK(read_file(broken / "numbers.csv") == read_file(whole / "numbers.csv"));
}

TEST_CASE("tables with the same columns measure each row only once", "[table]") {
    int measured = 0;
    const Table table = counted(measured);
    Table other = table;
    other.name = "other";
    const ScratchFolder folder;
    MeasuredRows rows;
    for (const Table& each : {table, other})
        write_table(each, folder.path(), "conditions", rows, [](double) {});
    CHECK(measured == 3);
    CHECK(read_file(folder / "other.csv") == read_file(folder / "numbers.csv"));
    other.columns = "name,a,c";
    write_table(other, folder.path(), "conditions", rows, [](double) {});
    CHECK(measured == 6);
}

TEST_CASE("a folder that cannot be written to is refused before anything is measured", "[table]") {
    int measured = 0;
    const ScratchFolder folder;
    CHECK_THROWS_AS(write(counted(measured), folder / "nowhere"), RequestError);
    CHECK(measured == 0);
}
