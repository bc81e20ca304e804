#include "haptic_station/surface/build/patch_registration.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/build/normal_sums.h"
#include "haptic_station/surface/build/patch_terms.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMiddle_m = 0.02;  // radius around the mark in which the skin must be measured
constexpr int kLooks = 2;           // how often the residuals are computed again from the image
constexpr int kReweighted = 2;      // reweighted fits to each set of residuals
constexpr double kFirstScale_m = 0.01;
constexpr double kLeastNoise_m = 0.0005;
constexpr double kCorrelatedNodes = 9.0;  // errors of neighbouring nodes are correlated: this many nodes count as one
constexpr int kHalf_px = 2;
constexpr int kLeast_px = 18;

double tukey(double residual_m, double scale_m) {
  const double u = residual_m / (4.7 * scale_m);
  return u * u >= 1.0 ? 0.0 : (1.0 - u * u) * (1.0 - u * u);
}

double sigma_of(const Eigen::Matrix2d& information, double noise_m) {
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(information).eigenvalues()[0];
  return noise_m * std::sqrt(kCorrelatedNodes / std::max(least, 1e-9));
}

/// Mean depth of a window with holes, extrapolated to `pixel`.
double depth_beside_holes(const DepthField& depth, int column, int row, const Vector2d& pixel, const Vector2d& per_px) {
  double sum = 0.0;
  Vector2d at = Vector2d::Zero();
  int count = 0;
  for (int v = row - kHalf_px; v <= row + kHalf_px; ++v)
    for (int u = column - kHalf_px; u <= column + kHalf_px; ++u) {
      const float z = depth.z_m[depth.index(u, v)];
      if (z <= 0.0F) continue;
      sum += static_cast<double>(z);
      at += Vector2d(u, v);
      ++count;
    }
  return count < kLeast_px ? 0.0 : sum / count + per_px.dot(pixel - at / count);
}

/// Mean depth of the window around `pixel`, extrapolated to `pixel` with the slope `per_px`. 0: not measured.
double depth_at(const DepthField& depth, const Vector2d& pixel, const Vector2d& per_px) {
  const int column = static_cast<int>(std::lround(pixel.x()));
  const int row = static_cast<int>(std::lround(pixel.y()));
  if (column < kHalf_px || row < kHalf_px || column + kHalf_px >= depth.width || row + kHalf_px >= depth.height)
    return 0.0;
  constexpr int kSide_px = 2 * kHalf_px + 1;
  double sum = 0.0;
  bool whole = true;
  for (int v = row - kHalf_px; v <= row + kHalf_px; ++v) {
    const float* z = &depth.z_m[depth.index(column - kHalf_px, v)];
    for (int u = 0; u < kSide_px; ++u) {
      whole &= z[u] > 0.0F;
      sum += static_cast<double>(z[u]);
    }
  }
  if (!whole) return depth_beside_holes(depth, column, row, pixel, per_px);
  return sum / (kSide_px * kSide_px) + per_px.dot(pixel - Vector2d(column, row));
}

/// The residuals for the motion `found`.
void look_at(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera, const PatchCoefficients& found,
             PatchResiduals& residuals) {
  residuals.m.clear();
  residuals.terms.clear();
  residuals.in_middle.clear();
  residuals.middle_nodes = 0;
  for (const SkinPatch::Node& node : patch.nodes) {
    const PatchCoefficients terms = terms_of(node);
    const bool in_middle = node.from.norm() * patch.radius_m < kMiddle_m;
    residuals.middle_nodes += in_middle ? 1 : 0;
    const Vector3d expected = node.at + Vector3d(found[0], found[1], terms.tail<6>().dot(found.tail<6>()));
    const double m_per_px = expected.z() / camera.fx;
    const double z_m = depth_at(depth, pixel_of(camera, expected), node.slope * m_per_px);
    if (z_m <= 0.0) continue;
    residuals.m.push_back(z_m - expected.z());
    residuals.terms.insert(residuals.terms.end(), terms.begin(), terms.end());
    residuals.in_middle.push_back(in_middle ? 1 : 0);
  }
}

/// What the residuals are once the expectation has changed by `change` [m].
std::vector<double> remaining(const PatchResiduals& residuals, const PatchCoefficients& change) {
  std::vector<double> m(residuals.m.size());
  for (std::size_t i = 0; i < m.size(); ++i)
    m[i] = residuals.m[i] - Eigen::Map<const PatchCoefficients>(&residuals.terms[8 * i]).dot(change);
  return m;
}

/// 1-sigma of the residuals `m`.
double scale_of(std::vector<double> m) {
  for (double& one : m) one = std::abs(one);
  return std::max(kLeastNoise_m, m.empty() ? 0.0 : 1.4826 * median_of(m));
}

/// The weighted normal equations once the expectation has changed by `change`, with weights for `scale_m`.
PatchFit fitted(const PatchResiduals& residuals, const PatchCoefficients& change, double scale_m) {
  PatchFit fit;
  std::vector<double> m = remaining(residuals, change);
  std::vector<double> weights(m.size());
  std::vector<double> values(m.size());
  for (std::size_t i = 0; i < m.size(); ++i) {
    weights[i] = tukey(m[i], scale_m);
    values[i] = weights[i] * m[i];
    if (residuals.in_middle[i] == 0) continue;
    fit.middle_weight += weights[i];
    fit.middle_m += values[i];
  }
  add_normal_equations(residuals.terms.data(), weights.data(), values.data(), m.size(), fit.normal.data(),
                       fit.by.data());
  fit.middle_m /= std::max(1.0, fit.middle_weight);
  fit.scale_m = scale_of(std::move(m));
  return fit;
}

PatchCoefficients coefficients_of(const PatchPose& pose) {
  PatchCoefficients coefficients = PatchCoefficients::Zero();
  coefficients.head<2>() = pose.slide_m;
  coefficients[2] = pose.deeper_m;
  return coefficients;
}

/// One step towards the least squares of `fit`.
void step(const PatchFit& fit, bool slides, PatchCoefficients& found) {
  if (slides)
    found += fit.normal.ldlt().solve(fit.by);
  else  // the slide is given: only the change of depth is fitted
    found.tail<6>() += fit.normal.bottomRightCorner<6, 6>().ldlt().solve(fit.by.tail<6>());
}

}  // namespace

PatchSearch::PatchSearch(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera,
                         const PatchPose& start)
    : patch_(patch), depth_(depth), camera_(camera), start_(start) {
  look_at(patch, depth, camera, coefficients_of(start), residuals_);
  fit_ = fitted(residuals_, PatchCoefficients::Zero(), kFirstScale_m);
}

PatchPose PatchSearch::found(bool slides) const {
  PatchPose pose = start_;
  pose.seen = false;
  PatchCoefficients found = coefficients_of(start_);
  PatchCoefficients seen_from = found;
  PatchResiduals closer;
  const PatchResiduals* residuals = &residuals_;
  PatchFit fit = fit_;
  for (int look = 0; look < kLooks; ++look) {
    if (look > 0) {
      fit.scale_m = scale_of(remaining(*residuals, found - seen_from));
      look_at(patch_, depth_, camera_, found, closer);
      residuals = &closer;
      seen_from = found;
    }
    for (int i = 0; i < kReweighted; ++i) {
      if (look + i > 0) fit = fitted(*residuals, found - seen_from, fit.scale_m);
      if (2.0 * fit.middle_weight < residuals->middle_nodes || residuals->middle_nodes == 0) return pose;
      step(fit, slides, found);
    }
  }
  fit = fitted(*residuals, found - seen_from, fit.scale_m);
  pose.seen = true;
  pose.slide_m = found.head<2>();
  pose.deeper_m = found[2] + fit.middle_m;
  pose.sigma_depth_m = fit.scale_m * std::sqrt(kCorrelatedNodes / std::max(1.0, fit.middle_weight));
  pose.sigma_slide_m = sigma_of(slide_information(fit.normal), fit.scale_m);
  return pose;
}

}  // namespace telepalp::surface
