#include "haptic_station/calibration/tissue_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "haptic_station/calibration/number_rows.h"
#include "proto/words/counted.h"
#include "proto/words/numbers/number_row.h"

namespace telepalp::calibration {
namespace {

constexpr std::size_t kMostSamples = 1'000'000;

Eigen::RowVector3d force_basis(double d) { return {d, d * d, d * d * d}; }

double rms(const Eigen::MatrixXd& basis, const Eigen::VectorXd& load, const Eigen::Vector3d& c) {
  return std::sqrt((basis * c - load).squaredNorm() / static_cast<double>(load.size()));
}

/// Least squares over the columns in `chosen` (bit i selects column i); nullopt when a coefficient is negative.
std::optional<Eigen::Vector3d> solve_over(const Eigen::MatrixXd& basis, const Eigen::VectorXd& load, unsigned chosen) {
  std::vector<int> columns;
  for (int i = 0; i < 3; ++i)
    if ((chosen >> i) & 1u) columns.push_back(i);
  const Eigen::VectorXd some = Eigen::MatrixXd(basis(Eigen::all, columns)).colPivHouseholderQr().solve(load);
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < columns.size(); ++i) all[columns[i]] = some[static_cast<Eigen::Index>(i)];
  if (!all.allFinite() || all.minCoeff() < 0.0) return std::nullopt;
  return all;
}

}  // namespace

std::vector<CompressionSample> under_hand(std::span<const CompressionSample> test, const Specimen& specimen,
                                          const TissueUnderHand& tissue) {
  const double length = tissue.thickness_m / specimen.height_m;
  const double diameter = tissue.contact_diameter_m / specimen.diameter_m;
  std::vector<CompressionSample> out;
  for (const CompressionSample& sample : test)
    out.push_back({sample.compression_m * length, sample.load_N * diameter * diameter});
  return out;
}

Result<TissueFit> fit_tissue(std::span<const CompressionSample> samples) {
  if (samples.size() < 4 || samples.size() > kMostSamples)
    return Error{.what = counted(samples.size(), "row has", "rows have") +
                         " a strain of at most --to-strain; the fit needs 4 to 1000000 such rows",
                 .where = "compression test",
                 .fix = samples.size() < 4 ? "give more rows, a larger --to-strain, or the true --height-mm"
                                           : "give fewer rows"};
  const auto rows = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd basis(rows, 3);
  Eigen::VectorXd load(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    basis.row(i) = force_basis(samples[static_cast<std::size_t>(i)].compression_m);
    load[i] = samples[static_cast<std::size_t>(i)].load_N;
  }
  if (!basis.allFinite() || !load.allFinite() || load.maxCoeff() <= 0.0)
    return Error{
        .what = "no load is above zero, or a number is not finite",
        .where = "compression test",
        .fix = "give finite numbers: compression in millimetres, and load in newtons, above zero under compression"};
  std::optional<Eigen::Vector3d> best;
  for (unsigned chosen = 1; chosen < 8; ++chosen)  // with three columns, the best of all subsets is the exact solution
    if (const auto c = solve_over(basis, load, chosen); c && (!best || rms(basis, load, *c) < rms(basis, load, *best)))
      best = c;
  if (!best)
    return Error{.what = "the load falls as the compression grows",
                 .where = "compression test",
                 .fix = "check the signs of compression and load"};
  TissueFit fit;
  fit.law = {.constant_N_per_m = (*best)[0], .slope_N_per_m2 = (*best)[1], .curve_N_per_m3 = (*best)[2]};
  fit.rms_error_N = rms(basis, load, *best);
  fit.rms_error_share = fit.rms_error_N / load.maxCoeff();
  fit.samples = samples.size();
  return fit;
}

Result<std::vector<CompressionSample>> read_compression_test(const std::filesystem::path& file) {
  const Result<std::string> rows = read_rows(file);
  if (!rows) return rows.error();
  std::string_view text = *rows;
  if (text.empty()) return Error{.what = "is empty", .where = file.string(), .fix = "give a file that has rows"};
  (void)take_line(text);  // the header
  std::vector<CompressionSample> samples;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    if (samples.size() == kMostSamples)
      return Error{.what = "has more than 1000000 rows", .where = file.string(), .fix = "give fewer rows"};
    const auto row = number_row<2>(line);
    if (!row)
      return Error{.what = "the row is not two finite numbers",
                   .where = file.string() + ":" + std::to_string(number),
                   .fix = "give rows compression_mm,load_N with a decimal point"};
    samples.push_back({(*row)[0] * 1e-3, (*row)[1]});
  }
  return samples;
}

}  // namespace telepalp::calibration
