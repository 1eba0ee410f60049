// What needs no device: spectra, and tables that go on where they were.

#include "../image/scratch_folder.hpp"
#include "error.hpp"
#include "study/figures.hpp"
#include "study/table.hpp"
#include "study/variant.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace gabor;
using namespace gabor::study;

TEST_CASE("the Pareto front of hand-made rows", "[frontier]") {
    const auto row = [](double visits, double cvm_high, double sidelobe, double interdecile = 0.01) {
        return Numbers{visits, 0, 0, 0, 1, interdecile, 0.02, 1, sidelobe, 0, 0, 0, cvm_high};
    };
    std::vector<Numbers> rows{
        row(9, 0.5, -28),       row(9, 0.5, -28), // as good as the first: neither dominates the other
        row(18, 0.5, -28),                        // more visits for nothing
        row(18, 0.1, -28),                        // more visits for more Gaussianity
        row(16, 0.6, -30),                        // for lower sidelobes
        row(9, 0.01, -40, 0.2), // better than all, but not stationary: dominates nothing, and is not on the
                                // front
    };
    mark_pareto(rows);
    std::vector<double> front;
    for (const Numbers& numbers : rows)
        front.push_back(numbers.back());
    CHECK(front == std::vector<double>{1, 1, 0, 1, 1, 0});
}

TEST_CASE("spectral purity of known windows", "[purity]") {
    // (1 - x^2)^2 has the spectrum j_2(a) / a^2, whose largest sidelobe is at a = 6.988.
    const double a = 6.9879;
    const double side = std::sph_bessel(2, a) / (a * a) * 15;
    CHECK(spectral_purity({"", Shape::separable, {1, 0, 0}}).sidelobe ==
          Approx(20 * std::log10(std::abs(side))).margin(0.01));
    // (1 - r^2)^2 has J_3(a) / a^3, with its largest at a = 7.588.
    const double b = 7.5883;
    CHECK(spectral_purity({"", Shape::radial, {1, 0, 0}}).sidelobe ==
          Approx(20 * std::log10(std::abs(std::cyl_bessel_j(3.0, b)) / (b * b * b) * 48)).margin(0.01));
    for (const Shape shape : {Shape::separable, Shape::radial, Shape::gaussian}) {
        const double outside = spectral_purity({"", shape, {1, 0, 0}}).outside;
        CHECK(outside > 1e-4);
        CHECK(outside < 4e-3);
    }
}

TEST_CASE("the seminal curve, inverted", "[convergence]") {
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

TEST_CASE("an interrupted table goes on where it was, and ends with the same bits", "[table]") {
    int measured = 0;
    const auto measure = [&](std::uint32_t seed) -> Numbers {
        ++measured;
        return {seed / 3.0, std::sqrt(2.0)};
    };
    const auto derive = [](std::vector<Numbers>& rows) {
        for (Numbers& row : rows)
            row.push_back(row[0] - rows[0][0]);
    };
    const Table table{
        "numbers", "name,a,b", {{"x", 1, measure}, {"y", 1, measure}, {"z", 1, measure}}, "c", derive};
    const ScratchFolder whole;
    const ScratchFolder broken;
    {
        Journal journal(whole.path(), "study");
        write_table(table, whole.path(), journal, [](double) {});
        journal.remove();
    }
    CHECK(whole.count() == 1);
    REQUIRE(measured == 3);

    Journal begun(broken.path(), "study");
    CHECK_THROWS_AS(write_table(table, broken.path(), begun, [](double) { throw 7; }), int);
    REQUIRE(measured == 4);
    std::ofstream(broken / "study.part", std::ios::app) << "a line without its e";
    Journal journal(broken.path(), "study");
    write_table(table, broken.path(), journal, [](double) {});
    CHECK(measured == 6);
    CHECK(read_file(broken / "numbers.csv") == read_file(whole / "numbers.csv"));

    // Another study in the same folder begins anew.
    Journal other(broken.path(), "another study");
    CHECK_FALSE(other.find(table, table.rows[0]).has_value());
    CHECK_THROWS_AS(Journal(broken / "nowhere", "study"), RequestError);
}

TEST_CASE("a row's pieces, measured by several parts, become the row that one run measures", "[table]") {
    std::vector<int> measured;
    // What is rounded differs with the order in which it is added.
    const Measurement in_four(
        4,
        [&](std::uint32_t seed, std::span<const int> pieces) {
            std::vector<Numbers> results;
            for (const int piece : pieces) {
                measured.push_back(piece);
                results.push_back({std::ldexp(1.0 / (seed % 1000 + 1), -20 * piece), std::sqrt(piece)});
            }
            return results;
        },
        [](std::span<const Numbers> pieces) {
            Numbers total{0, 0};
            for (const Numbers& piece : pieces)
                for (std::size_t i = 0; i < total.size(); ++i)
                    total[i] += piece.at(i);
            return total;
        });
    const auto whole_row = [](std::uint32_t seed) -> Numbers { return {seed / 3.0, 1}; };
    const std::vector<Table> tables{
        {"numbers", "name,a,b", {{"large", 100, in_four}, {"small", 10, in_four}, {"one", 40, whole_row}}}};
    const ScratchFolder one_run;
    Journal whole(one_run.path(), "study");
    write_table(tables[0], one_run.path(), whole, [](double) {});
    REQUIRE(measured.size() == 8);

    // With more parts more rows are cut: those that take more than half of a part's share.
    for (const auto& [count, busy] : {std::pair(1, 1), {2, 2}, {3, 3}, {16, 8}}) {
        const ScratchFolder parts;
        std::map<std::string, Numbers> rows;
        measured.clear();
        double cost = 0;
        int with_pieces = 0;
        for (int index = 1; index <= count; ++index) {
            Journal journal(parts.path(), "study");
            cost += cost_of_part(tables, {index, count}, journal);
            double advanced = 0;
            const std::size_t before = measured.size();
            measure_part(tables, {index, count}, journal, [&](double by) { advanced += by; });
            with_pieces += measured.size() > before;
            CHECK(cost_of_part(tables, {index, count}, journal) == 0);
            measure_part(tables, {index, count}, journal, [](double) { FAIL("measured twice"); });
            CHECK(missing_row(tables, journal).empty() == (count == 1));
            journal.complete();
            rows.merge(read_record(parts / "study.rows").value().rows);
        }
        INFO(count << " parts");
        CHECK(cost == Approx(150));
        CHECK(measured.size() == 8);
        CHECK(with_pieces == busy);
        Journal merged(std::move(rows));
        CHECK(missing_row(tables, merged).empty());
        write_table(tables[0], parts.path(), merged, [](double) { FAIL("merging measures nothing"); });
        CHECK(read_file(parts / "numbers.csv") == read_file(one_run / "numbers.csv"));
    }
}
