#pragma once

#include <string>
#include <vector>

#include "haptic_station/surface/cloud/kdtree_index.h"

namespace telepalp::surface {

/// How far the points of a cloud scatter around the surface that they sample.
struct CloudNoise {
  double spacing_m = 0.0;  ///< mean spacing of the points
  double noise_m = 0.0;    ///< standard deviation of the points along the normal
  double support_m = 0.0;  ///< a point farther than this from the query has no weight; noise_of() chooses it
  bool is_surface = true;  ///< false: the points fill a volume, see noise_of()
  [[nodiscard]] bool follows_noise() const noexcept;  ///< noise makes the support wider than three spacings
};

/// Estimates the noise by quadrics that are fitted to the neighbourhoods of at most 600 sampled points. The radius of
/// the neighbourhoods grows from three spacings until it exceeds five times the median residual, because a smaller
/// neighbourhood of a noisy cloud is a ball and not a disc. If it reaches 30 spacings, the points fill a volume.
///
/// The support is at least three spacings and four times the noise. It is also so wide that the curvature of the
/// averaged noise stays below 10 per metre: a proxy 10 mm above the hand then moves by at most a tenth more than the
/// hand. With Wyvill's soft-object weights and a support r, the curvature is 4.4 × noise × spacing / r³.
[[nodiscard]] CloudNoise noise_of(const IndexedPoints& points, const NeighborIndex& index, double spacing_m);

inline constexpr double kWidestSupport_m = 0.02;  ///< a cloud whose noise needs a wider support is refused

/// Number of neighbours for the estimate of a normal: the points in a disc with the support's radius, 16 to 256.
[[nodiscard]] int neighbors_in_support(const CloudNoise& noise);

/// "22500 points 2.0 mm apart scatter by 2.00 mm around their surface; because of this noise, each place is averaged
/// over a radius of 9.6 mm instead of 6.0 mm".
[[nodiscard]] std::string description_of(const CloudNoise& noise, std::size_t points);

}  // namespace telepalp::surface
