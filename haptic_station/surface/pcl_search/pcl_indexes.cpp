#include <pcl/common/point_tests.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/organized.h>

#include <cmath>
#include <limits>

#include "haptic_station/surface/cloud/kdtree_index.h"
#include "haptic_station/surface/pcl_search/pcl_indexes.h"

namespace telepalp::surface {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr to_pcl(const IndexedPoints& points) {
  auto cloud = std::make_shared<Cloud>();
  cloud->reserve(points.at_m.size());
  bool dense = true;
  for (const Eigen::Vector3f& at : points.at_m) {
    cloud->push_back({at.x(), at.y(), at.z()});
    dense = dense && at.allFinite();
  }
  if (points.width > 0) {
    cloud->width = static_cast<std::uint32_t>(points.width);
    cloud->height = static_cast<std::uint32_t>(points.at_m.size()) / cloud->width;
  }
  cloud->is_dense = dense;
  return cloud;
}

/// PCL's radius search allocates memory for its results, so realtime_safe() is false.
template <class Search>
std::size_t search(const Search& tree, const Eigen::Vector3f& query, float radius_m,
                   std::span<Neighbor> found) noexcept {
  if (!query.allFinite() || found.empty()) return 0;
  thread_local pcl::Indices indices;
  thread_local std::vector<float> squared;
  const int count = tree.radiusSearch(pcl::PointXYZ(query.x(), query.y(), query.z()), static_cast<double>(radius_m),
                                      indices, squared, static_cast<unsigned>(found.size()));
  const std::size_t kept = std::min(found.size(), static_cast<std::size_t>(std::max(count, 0)));
  for (std::size_t i = 0; i < kept; ++i) found[i] = {static_cast<std::uint32_t>(indices[i]), squared[i]};
  return kept;
}

/// The search checks all leaves, as in S1 §III.A. PCL has 15 points per leaf where S1 had 10; this changes no result.
class PclKdTreeIndex final : public NeighborIndex {
 public:
  explicit PclKdTreeIndex(const IndexedPoints& points) : tree_(true) {
    const Cloud::Ptr cloud = to_pcl(points);
    for (const pcl::PointXYZ& point : *cloud) empty_ = empty_ && !pcl::isFinite(point);
    if (!empty_) tree_.setInputCloud(cloud);
  }
  std::size_t within(const Eigen::Vector3f& query, float radius_m, std::span<Neighbor> found) const noexcept override {
    return empty_ ? 0 : search(tree_, query, radius_m, found);
  }
  const char* name() const noexcept override { return "PCL KD-tree"; }
  bool realtime_safe() const noexcept override { return false; }

 private:
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
  bool empty_ = true;
};

class PclOrganizedIndex final : public NeighborIndex {
 public:
  explicit PclOrganizedIndex(const IndexedPoints& points) : tree_(true) {
    tree_.setInputCloud(to_pcl(points));
    usable_ = tree_.isValid();
  }
  std::size_t within(const Eigen::Vector3f& query, float radius_m, std::span<Neighbor> found) const noexcept override {
    if (!usable_ || !query.allFinite() || found.empty()) return 0;
    // With a limit on their number, PCL's organised radius search returns the first points that it finds instead of the
    // nearest. So it is called without a limit.
    thread_local pcl::Indices indices;
    thread_local std::vector<float> squared;
    tree_.nearestKSearch(pcl::PointXYZ(query.x(), query.y(), query.z()), static_cast<int>(found.size()), indices,
                         squared);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < indices.size() && kept < found.size(); ++i)
      if (squared[i] < radius_m * radius_m) found[kept++] = {static_cast<std::uint32_t>(indices[i]), squared[i]};
    return kept;
  }
  const char* name() const noexcept override { return "PCL organised search"; }
  bool realtime_safe() const noexcept override { return false; }
  [[nodiscard]] bool usable() const noexcept { return usable_; }

 private:
  pcl::search::OrganizedNeighbor<pcl::PointXYZ> tree_;
  bool usable_ = false;
};

std::shared_ptr<const NeighborIndex> make_pcl_kdtree_index(const IndexedPoints& points) {
  return std::make_shared<const PclKdTreeIndex>(points);
}

std::shared_ptr<const NeighborIndex> make_pcl_organized_index(const IndexedPoints& points) {
  auto index = std::make_shared<const PclOrganizedIndex>(points);
  if (index->usable()) return index;  // else the projection could not be estimated from the points
  return make_pcl_kdtree_index(points);
}

}  // namespace

void use_pcl_indexes() noexcept {
  set_pcl_indexes({.kdtree = make_pcl_kdtree_index, .organized = make_pcl_organized_index});
}

void use_nanoflann_indexes() noexcept { set_pcl_indexes({}); }

}  // namespace telepalp::surface
