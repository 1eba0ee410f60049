#pragma once

#include "fit/fit.hpp"

#include <filesystem>

namespace gabor::fit {

/// Writes a page, FOLDER/index.html, and its pictures: the exemplar, its random-phase noise and the fit,
/// their spectra, autocorrelations and histograms, and the figures. Throws RequestError where there can be no
/// such folder.
void write_report(const std::filesystem::path& folder, const std::filesystem::path& image,
                  const Exemplar& exemplar, const Texture& texture, const Advance& advance);

} // namespace gabor::fit
