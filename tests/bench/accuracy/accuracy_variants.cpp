#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "haptic_station/surface/paper/paper_surface.h"
#include "tests/bench/accuracy/accuracy_surface.h"

namespace telepalp::bench {
namespace {

using surface::Index;
using surface::Method;
using surface::Support;
using surface::SurfaceSettings;

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%g mm", 1e3 * metres);
  return text;
}

std::string index_of(const SurfaceSettings& settings) {
  if (settings.method == Method::Grid) return "depth lattice";
  if (settings.index == Index::PclKdTree) return "PCL KD-tree";
  return settings.index == Index::Nanoflann ? "nanoflann" : "PCL organised";
}

std::string support_of(const SurfaceSettings& settings) {
  if (settings.method == Method::Grid) {
    char text[64];
    std::snprintf(text, sizeof text, "%g nodes of %d px", settings.support_nodes, settings.node_step_px);
    return text;
  }
  if (settings.method == Method::Paper)
    return "N " + std::to_string(settings.neighbors) + " in R " + millimetres(settings.radius_m) + ", no fade";
  return settings.support == Support::FixedRadius ? "fades at " + millimetres(settings.radius_m)
                                                  : "fades at neighbour " + std::to_string(settings.neighbors);
}

std::string normals_of(const SurfaceSettings& settings, int neighbors) {
  if (settings.method == Method::Grid) return "fit over ±" + std::to_string(settings.fit_radius_px) + " px";
  if (settings.method == Method::Paper) return "PCA of N, at each query";
  return "PCA of " + std::to_string(neighbors > 0 ? neighbors : 16) + ", once a frame";
}

std::string family_of(const SurfaceSettings& settings) {
  if (settings.method == Method::Grid) return "lattice";
  return settings.method == Method::Paper ? "paper" : "cloud";
}

SurfaceVariant variant_of(std::string name, SurfaceSettings settings, bool named, int normal_neighbors = 0) {
  settings.name = name;
  return {.family = family_of(settings),
          .name = std::move(name),
          .index = index_of(settings),
          .support = support_of(settings),
          .normals = normals_of(settings, normal_neighbors),
          .settings = settings,
          .named = named,
          .normal_neighbors = normal_neighbors};
}

/// `base` with one field changed.
template <class Value>
void vary(std::vector<SurfaceVariant>& into, const SurfaceSettings& base, Value SurfaceSettings::*field,
          const std::string& label, std::initializer_list<Value> values) {
  for (const Value value : values) {
    SurfaceSettings settings = base;
    settings.*field = value;
    std::string number = std::to_string(value);
    if (number.find('.') != std::string::npos) number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    into.push_back(variant_of(base.name + ", " + label + " " + number, settings, false));
  }
}

}  // namespace

std::vector<SurfaceVariant> surface_variants() {
  std::vector<SurfaceVariant> all;
  for (const SurfaceSettings& settings : surface::all_surface_settings())
    all.push_back(variant_of(settings.name, settings, true));
  const SurfaceSettings fast = *surface::surface_settings("fast");
  vary(all, fast, &SurfaceSettings::fit_radius_px, "fit", {3, 5, 9, 12});
  vary(all, fast, &SurfaceSettings::support_nodes, "support", {1.5, 2.0, 3.5, 5.0});
  vary(all, fast, &SurfaceSettings::node_step_px, "step", {1, 3, 4});
  const SurfaceSettings paper = *surface::surface_settings("paper-nanoflann");
  vary(all, paper, &SurfaceSettings::neighbors, "N", {5, 20, 40});
  vary(all, paper, &SurfaceSettings::radius_m, "R", {0.02, 0.005});
  const SurfaceSettings cloud = *surface::surface_settings("cloud");
  vary(all, cloud, &SurfaceSettings::radius_m, "support", {0.006, 0.020});
  const SurfaceSettings kth = *surface::surface_settings("cloud-kth");
  vary(all, kth, &SurfaceSettings::neighbors, "k", {20, 80, 160});
  SurfaceSettings by_pcl = cloud;
  by_pcl.index = Index::PclKdTree;
  all.push_back(variant_of("cloud, PCL KD-tree", by_pcl, false));
  for (const int neighbors : {8, 32, 64})
    all.push_back(variant_of("cloud, normals of " + std::to_string(neighbors), cloud, false, neighbors));
  return all;
}

std::shared_ptr<const surface::SurfaceSnapshot> VariantStream::add(const DepthImage& depth, const Intrinsics& camera,
                                                                   double at_s, const surface::Reach& reach) {
  if (variant_.normal_neighbors == 0) return builder_.add(depth, camera, testing::scene_time(at_s), reach);
  const surface::PixelBox box = surface::box_in_reach(camera, reach, 8);
  const surface::DepthField field = surface::to_depth_field(depth);
  const surface::IndexedPoints points = surface::to_points(field, camera);
  std::vector<Eigen::Vector3f> in_reach;
  for (int row = box.top; row < box.bottom; ++row)
    for (int column = box.left; column < box.right; ++column) in_reach.push_back(points.at_m[field.index(column, row)]);
  surface::CloudShape shape;
  shape.support_m = variant_.settings.radius_m;
  auto snapshot = std::make_shared<surface::CloudSnapshot>(
      surface::with_normals(in_reach, variant_.normal_neighbors, Eigen::Vector3f::Zero()), shape,
      variant_.settings.index);
  snapshot->captured = testing::scene_time(at_s);
  return snapshot;
}

std::vector<SurfaceVariant> few_variants() {
  std::vector<SurfaceVariant> few;
  for (SurfaceVariant& variant : surface_variants())
    for (const char* name : {"fast", "single-frame", "smooth", "paper-nanoflann", "cloud", "cloud-kth"})
      if (variant.name == name) few.push_back(std::move(variant));
  return few;
}

}  // namespace telepalp::bench
