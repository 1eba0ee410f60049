// The seminal N that is needed for the same Gaussianity, against N, with both weights.

#include "study/convergence.hpp"
#include "study/figures.hpp"

namespace gabor::study {

Tables figure3(const vulkan::Device& device, const Effort& effort) {
    Table table{"figure3", std::string(convergence_columns), {}};
    for (const Weights weights : {Weights::uniform, Weights::bernoulli})
        for (const Points points : all_points)
            for (const int n : effort.impulses)
                table.rows.push_back(
                    convergence_row(device, {.points = points, .weights = weights, .impulses = n}, effort));
    table.derived = "n_star,n_star_low,n_star_high";
    table.derive = [seminal = effort.impulses](std::vector<Numbers>& rows) {
        SeminalCurve curve;
        for (std::size_t i = 0; i < seminal.size(); ++i) // the first rows are the seminal noise
            curve.add(seminal[i], rows[i][0]);
        for (Numbers& row : rows)
            for (const double cvm : {row[0], row[2], row[1]})
                row.push_back(curve.equivalent(cvm));
    };
    return {table};
}

} // namespace gabor::study
