#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/cloud/cloud_snapshot.h"

namespace telepalp::surface {

/// Finds the side to which the normals of a cloud should point, from the points alone: neighbours on a smooth surface
/// have similar normals, and a closed surface has the winding number 1 inside. Uses at most 20 000 points of the cloud.
/// Source: Hoppe et al. 1992 (propagation along a minimum spanning tree), Barill et al. 2018 (winding number).
class CloudOrientation {
 public:
  /// `cloud`: points with normals that are correct except for their sign. `noise_m`: 1-sigma along the normal. `signs`:
  /// whether the signs come from the file. Signs of the file are kept on a patch that only a sharp edge bounds: across
  /// the edge of a thin fin, the most similar normal is the wrong one.
  enum class Signs { OfTheFile, Guessed };
  CloudOrientation(const std::vector<CloudPoint>& cloud, double noise_m, Signs signs);

  /// Share of input normals that disagree with the propagated sign, where the sign of each connected piece is that of
  /// the majority of its normals. About one half when the input signs are random.
  [[nodiscard]] double against_neighbors() const noexcept { return against_; }
  /// False when 5 % or more of the pairs of neighbours have opposite normals after propagation, as at touching sheets.
  [[nodiscard]] bool is_consistent() const noexcept { return contradictions_ < 0.05; }
  /// True when the cloud encloses a volume: the orientation then points outwards with certainty.
  [[nodiscard]] bool is_closed() const noexcept { return closed_; }

  /// The winding number below the surface plus that above it, averaged over the surface, for propagated normals: 1
  /// for a closed surface with outward normals, -1 with inward ones, 0 for a plane, in between for a dome or a bowl.
  [[nodiscard]] double turns() const noexcept { return turns_; }

  /// Share of the normals of `cloud` that point against the orientation found, which is outwards if is_closed().
  [[nodiscard]] double share_against(const std::vector<CloudPoint>& cloud) const;
  /// Reverses the normals of `cloud` that point against the orientation found.
  void apply(std::vector<CloudPoint>& cloud) const;

 private:
  [[nodiscard]] std::size_t neighbors_of(std::size_t point, std::vector<Neighbor>& found) const;
  [[nodiscard]] bool are_on_one_sheet(const CloudPoint& a, const CloudPoint& b) const;
  [[nodiscard]] std::vector<std::size_t> propagate_from(std::size_t first, std::vector<bool>& seen);
  void propagate();
  void keep_patches_of(const std::vector<CloudPoint>& given);
  [[nodiscard]] int fits_beside(const CloudPoint& here, const CloudPoint& there) const;
  [[nodiscard]] bool is_bounded_by_edges(std::size_t first, const std::vector<CloudPoint>& given,
                                         std::vector<bool>& seen, std::vector<std::size_t>& patch) const;
  void look_for_contradictions();
  void look_for_inside();
  [[nodiscard]] bool points_against(const CloudPoint& point) const;

  std::vector<CloudPoint> points_;  // a subset of the cloud, oriented by propagation
  std::shared_ptr<const NeighborIndex> index_;
  double noise_m_;
  double against_ = 0.0;
  double contradictions_ = 0.0;
  double turns_ = 0.0;
  bool closed_ = false;
};

}  // namespace telepalp::surface
