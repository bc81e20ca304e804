#include "haptic_station/tissue/fit/insertion_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "haptic_station/tissue/fit/rising_pieces.h"
#include "haptic_station/tissue/layered_tissue.h"

namespace telepalp::tissue {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Error refused(const std::string& what) {
  return {.what = what, .where = "insertion curve", .fix = "give the part of the record in which the needle goes in"};
}

/// Mean force in cells of `cell_m` behind the contact; cell i reaches from i to i + 1 cells.
Result<std::vector<double>> cells_of(const InsertionCurve& curve, const InsertionFitSettings& settings) {
  constexpr double kLeast_m = 0.03;
  const std::size_t count = curve.depth_m.size();
  if (count < 40 || curve.force_N.size() != count) return refused("the curve has fewer than 40 samples");
  std::size_t contact = count;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(curve.depth_m[i]) || !std::isfinite(curve.force_N[i]))
      return refused("sample " + std::to_string(i) + " is not a number");
    if (i > 0 && curve.depth_m[i] < curve.depth_m[i - 1])
      return refused("the depth falls at sample " + std::to_string(i));
    if (contact == count && curve.force_N[i] > settings.contact_N) contact = i;
  }
  if (contact == count || curve.depth_m.back() - curve.depth_m[contact] < kLeast_m)
    return refused("less than 30 mm lie behind the contact");
  std::vector<double> sum;
  std::vector<int> samples;
  for (std::size_t i = contact; i < count; ++i) {
    const auto cell = static_cast<std::size_t>((curve.depth_m[i] - curve.depth_m[contact]) / settings.cell_m);
    if (cell > 10'000) return refused("the curve is longer than 10 000 cells");
    sum.resize(std::max(sum.size(), cell + 1), 0.0);
    samples.resize(sum.size(), 0);
    sum[cell] += curve.force_N[i];
    ++samples[cell];
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (samples[i] > 0) sum[i] /= samples[i];
    if (samples[i] == 0) sum[i] = sum[i - 1];  // cell 0 has the contact's sample
  }
  return sum;
}

/// Non-negative least squares by cyclic coordinate descent, which converges for any columns.
VectorXd non_negative(const MatrixXd& columns, const VectorXd& wanted) {
  constexpr int kRounds = 3000;
  VectorXd x = VectorXd::Zero(columns.cols());
  VectorXd left = wanted;
  for (int round = 0; round < kRounds; ++round)
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
      const double length = columns.col(k).squaredNorm();
      if (length <= 0.0) continue;
      const double to = std::max(0.0, x[k] + columns.col(k).dot(left) / length);
      left -= (to - x[k]) * columns.col(k);
      x[k] = to;
    }
  return x;
}

double middle_m(std::size_t cell, double cell_m) { return (static_cast<double>(cell) + 0.5) * cell_m; }

/// The surface's coefficients a_1 and a_2, fitted to the cells above the puncture, and the fit's sum of squares.
struct SurfaceFit {
  VectorXd a = VectorXd::Zero(2);
  double squares = 0.0;
};
SurfaceFit surface_of(std::span<const double> cells, std::size_t puncture, double cell_m) {
  const auto rows = static_cast<Eigen::Index>(puncture);
  MatrixXd columns(rows, 2);
  VectorXd wanted(rows);
  for (std::size_t i = 0; i < puncture; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double d = middle_m(i, cell_m);
    columns(row, 0) = d / 0.01;
    columns(row, 1) = d * d / 1e-4;
    wanted[row] = cells[i];
  }
  SurfaceFit fit;
  const VectorXd x = non_negative(columns, wanted);
  fit.a << x[0] / 0.01, x[1] / 1e-4;
  fit.squares = (columns * x - wanted).squaredNorm();
  return fit;
}

/// The cutting force of each layer, then the friction per metre of each layer, fitted to the cells behind the puncture.
/// `begins`: the first cell of each layer. For the first layer, this is the cell of the puncture; its friction counts
/// from the contact on.
VectorXd bulks_of(std::span<const double> cells, const std::vector<std::size_t>& begins, double cell_m) {
  const std::size_t from = begins.front();
  const auto layers = static_cast<Eigen::Index>(begins.size());
  MatrixXd columns = MatrixXd::Zero(static_cast<Eigen::Index>(cells.size() - from), 2 * layers);
  VectorXd wanted(columns.rows());
  for (std::size_t i = from; i < cells.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i - from);
    wanted[row] = cells[i];
    for (Eigen::Index k = 0; k < layers; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const std::size_t begin = k == 0 ? 0 : begins[at];
      const std::size_t end = k + 1 < layers ? begins[at + 1] : cells.size();
      if (i >= begin && i < end) columns(row, k) = 1.0;
      const double inside =
          std::min(static_cast<double>(end), static_cast<double>(i) + 0.5) - static_cast<double>(begin);
      columns(row, layers + k) = std::max(0.0, inside) * cell_m / 0.05;
    }
  }
  VectorXd x = non_negative(columns, wanted);
  x.tail(layers) /= 0.05;
  return x;
}

TissueSettings tissue_with(const SurfaceFit& surface, const VectorXd& bulks, const std::vector<std::size_t>& begins,
                           std::size_t count, double cell_m) {
  constexpr double kLeast_N = 0.02;
  TissueSettings tissue;
  tissue.net_edge_m = 0.0075;  // a straight insertion needs no fine net
  const std::size_t layers = begins.size();
  const double deep_m = static_cast<double>(begins.front()) * cell_m;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::size_t begin = k == 0 ? 0 : begins[k];
    const std::size_t end = k + 1 < layers ? begins[k + 1] : count;
    LayerSettings layer{.name = "layer " + std::to_string(k + 1), .surface = {}, .bulk = {}, .relaxation = {}};
    layer.top_m = static_cast<double>(begin) * cell_m;
    layer.thickness_m = static_cast<double>(end) * cell_m - layer.top_m;
    layer.bulk = BulkSettings{.slips_at_N = 0.0,
                              .slips_at_N_per_m = bulks[static_cast<Eigen::Index>(layers + k)],
                              .cuts_at_N = bulks[static_cast<Eigen::Index>(k)]};
    tissue.layers.push_back(layer);
  }
  SurfaceSettings top{.stiffness_N_per_m = std::max(1.0, surface.a[0]), .stiffening_N_per_m2 = surface.a[1]};
  top.punctures_at_N = std::max(kLeast_N, (top.stiffness_N_per_m + top.stiffening_N_per_m2 * deep_m) * deep_m);
  top.friction_N = 0.0;
  tissue.layers.front().surface = top;
  return tissue;
}

/// Mean of the curves' cells, as far as all of them reach. A curve's weight is 1 / its peak^2, because relative_error()
/// divides by the peak: the mean minimises the sum of the squares of these errors.
Result<std::vector<double>> mean_cells(std::span<const InsertionCurve> curves, const InsertionFitSettings& settings) {
  if (curves.empty()) return refused("there is no curve");
  std::vector<double> mean;
  double weights = 0.0;
  for (const InsertionCurve& curve : curves) {
    const Result<std::vector<double>> cells = cells_of(curve, settings);
    if (!cells) return cells.error();
    const double peak_N = *std::max_element(cells->begin(), cells->end());
    const double weight = 1.0 / (peak_N * peak_N);
    if (mean.empty()) mean.assign(cells->size(), 0.0);
    mean.resize(std::min(mean.size(), cells->size()));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += weight * (*cells)[i];
    weights += weight;
  }
  for (double& cell : mean) cell /= weights;
  return mean;
}

/// The first cell behind the puncture. Several short lines fit a part of the surface's curve nearly as well as the
/// surface itself does, so the deepest of all places that fit about as well as the best one is taken.
std::size_t puncture_of(std::span<const double> cells, const RisingPieces& pieces, std::size_t first, std::size_t last,
                        double cell_m) {
  constexpr double kAsGood_N2 = 1e-4;  // per cell: (10 mN)^2; 10 mN is twice the noise of measured curves
  std::vector<double> squares;
  for (std::size_t i = first; i < last; ++i)
    squares.push_back(surface_of(cells, i, cell_m).squares + pieces.squares_from(i));
  const double most =
      *std::min_element(squares.begin(), squares.end()) + kAsGood_N2 * static_cast<double>(cells.size());
  std::size_t best = squares.size();
  while (best-- > 0)
    if (squares[best] <= most) break;
  return first + best;
}

}  // namespace

Result<InsertionFit> fit_insertion(std::span<const InsertionCurve> curves, const InsertionFitSettings& settings) {
  const Result<std::vector<double>> cells = mean_cells(curves, settings);
  if (!cells) return cells.error();
  constexpr std::size_t kLeastCells = 3;
  const RisingPieces pieces(*cells, settings.cell_m, std::clamp(settings.layers, 1, TissueSettings::kMostLayers),
                            kLeastCells);
  const auto last =
      std::min(cells->size() - 2 * kLeastCells, static_cast<std::size_t>(settings.deepest_surface_m / settings.cell_m));
  const std::size_t puncture = puncture_of(*cells, pieces, kLeastCells, last, settings.cell_m);
  const std::vector<std::size_t> begins = pieces.begins_from(puncture);
  const VectorXd bulks = bulks_of(*cells, begins, settings.cell_m);
  return InsertionFit{.tissue = tissue_with(surface_of(*cells, puncture, settings.cell_m), bulks, begins, cells->size(),
                                            settings.cell_m),
                      .punctured_at_m = static_cast<double>(puncture) * settings.cell_m,
                      .left_m = static_cast<double>(cells->size()) * settings.cell_m};
}

Result<double> relative_error(const InsertionFit& fit, const InsertionCurve& curve,
                              const InsertionFitSettings& settings) {
  const Result<std::vector<double>> cells = cells_of(curve, settings);
  if (!cells) return cells.error();
  const auto model = make_tissue(fit.tissue);
  if (!model) return model.error();
  constexpr double kTick_s = 0.0005;
  LayeredTissue tissue(*model);
  NeedleMotion needle;
  tissue.begin(needle);
  const std::size_t count = std::min(cells->size(), static_cast<std::size_t>(fit.left_m / settings.cell_m + 0.5));
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double to_m = static_cast<double>(i + 1) * settings.cell_m;
    double sum_N = 0.0;
    int ticks = 0;
    while (-needle.tip_m.y() < to_m - 1e-9) {
      needle.tip_m.y() -= settings.speed_m_per_s * kTick_s;
      sum_N += tissue.step(needle, kTick_s).force_N.y();
      ++ticks;
    }
    const double off_N = sum_N / std::max(1, ticks) - (*cells)[i];
    squares += off_N * off_N;
  }
  return std::sqrt(squares / static_cast<double>(count)) / *std::max_element(cells->begin(), cells->end());
}

}  // namespace telepalp::tissue
