#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "lrcs/scene.h"
#include "lrcs/sweep.h"

namespace lrcs {

// 10 log10(sigma / 1 m^2) [dBsm]; -infinity for 0.
[[nodiscard]] double dbsm(double sigma_m2);

// The content of sweep.csv: comment lines with version, digests, wavelength and conventions, the header, one line a
// row. Numbers are the shortest that read back to the same double.
[[nodiscard]] std::string sweep_csv(const Scene& scene, const std::string& target_digest,
                                    const std::vector<SweepRow>& rows);

// The rows of such a file. error: InputError at file:line:column. Receivers of bistatic rows are known to the rounding
// of their angles.
[[nodiscard]] std::vector<SweepRow> read_sweep_csv(const std::filesystem::path& file);

}  // namespace lrcs
