#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

#include "haptic_station/surface/cloud/kdtree_index.h"

namespace telepalp::surface {
namespace {

constexpr std::size_t kLeafPoints = 10;  // S1 §III.A

/// The finite points, in the form that nanoflann needs. `original` maps their indices back.
struct PointsView {
  std::vector<Eigen::Vector3f> at_m;
  std::vector<std::uint32_t> original;

  [[nodiscard]] std::size_t kdtree_get_point_count() const noexcept { return at_m.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t index, std::size_t axis) const noexcept {
    return at_m[index][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const noexcept {
    return false;
  }
};

/// Keeps the nearest points that fit into `found`: once it is full, a nearer point replaces the farthest one of a heap.
/// No allocation.
class NearestThatFit {
 public:
  using DistanceType = float;

  NearestThatFit(std::span<Neighbor> found, float radius_m) noexcept : found_(found), squared_(radius_m * radius_m) {}

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] bool full() const noexcept { return true; }  // nanoflann: may prune by worstDist() at once
  [[nodiscard]] float worstDist() const noexcept { return squared_; }

  bool addPoint(float squared, std::size_t index) noexcept {
    if (squared >= squared_) return true;
    const Neighbor neighbor{static_cast<std::uint32_t>(index), squared};
    if (count_ < found_.size()) {
      found_[count_++] = neighbor;
      if (count_ == found_.size()) std::make_heap(found_.begin(), found_.end(), nearer);
    } else {
      std::pop_heap(found_.begin(), found_.end(), nearer);
      found_.back() = neighbor;
      std::push_heap(found_.begin(), found_.end(), nearer);
    }
    if (count_ == found_.size()) squared_ = found_.front().squared_m2;
    return true;
  }

 private:
  static bool nearer(const Neighbor& a, const Neighbor& b) noexcept { return a.squared_m2 < b.squared_m2; }

  std::span<Neighbor> found_;
  float squared_;
  std::size_t count_ = 0;
};

class NanoflannIndex final : public NeighborIndex {
 public:
  explicit NanoflannIndex(const IndexedPoints& points) : view_(finite(points)), tree_(3, view_, {kLeafPoints}) {}

  std::size_t within(const Eigen::Vector3f& query, float radius_m, std::span<Neighbor> found) const noexcept override {
    if (view_.at_m.empty() || found.empty()) return 0;
    NearestThatFit result(found, radius_m);
    tree_.findNeighbors(result, query.data(), nanoflann::SearchParams());
    for (std::size_t i = 0; i < result.size(); ++i) found[i].index = view_.original[found[i].index];
    return result.size();
  }
  const char* name() const noexcept override { return "nanoflann KD-tree"; }
  bool realtime_safe() const noexcept override { return true; }

 private:
  static PointsView finite(const IndexedPoints& points) {
    PointsView view;
    for (std::size_t i = 0; i < points.at_m.size(); ++i)
      if (points.at_m[i].allFinite()) {
        view.at_m.push_back(points.at_m[i]);
        view.original.push_back(static_cast<std::uint32_t>(i));
      }
    return view;
  }

  PointsView view_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointsView>, PointsView, 3> tree_;
};

PclIndexes pcl_indexes;  // written by main() before any other thread begins

}  // namespace

std::shared_ptr<const NeighborIndex> make_nanoflann_index(const IndexedPoints& points) {
  return std::make_shared<const NanoflannIndex>(points);
}

void set_pcl_indexes(const PclIndexes& indexes) noexcept { pcl_indexes = indexes; }

std::shared_ptr<const NeighborIndex> make_index(Index kind, const IndexedPoints& points) {
  if (kind == Index::Nanoflann || pcl_indexes.kdtree == nullptr) return make_nanoflann_index(points);
  return kind == Index::PclOrganized && points.width > 0 ? pcl_indexes.organized(points) : pcl_indexes.kdtree(points);
}

}  // namespace telepalp::surface
