#include "haptic_station/surface/snapshot/surface_settings.h"

namespace telepalp::surface {
namespace {

SurfaceSettings fast() { return {}; }

SurfaceSettings single_frame() {
  SurfaceSettings settings;
  settings.name = "single-frame";
  settings.temporal = settings.predict = settings.breathing = false;
  return settings;
}

SurfaceSettings smooth() {
  SurfaceSettings settings;
  settings.name = "smooth";
  settings.fit_radius_px = 9;
  settings.support_nodes = 3.5;
  return settings;
}

SurfaceSettings paper(std::string name, Index index) {
  SurfaceSettings settings = single_frame();
  settings.name = std::move(name);
  settings.method = Method::Paper;
  settings.index = index;
  return settings;
}

SurfaceSettings cloud(std::string name, Support support, int neighbors, double radius_m) {
  SurfaceSettings settings = single_frame();
  settings.name = std::move(name);
  settings.method = Method::Cloud;
  settings.index = Index::Nanoflann;
  settings.support = support;
  settings.neighbors = neighbors;
  settings.radius_m = radius_m;
  return settings;
}

}  // namespace

std::vector<SurfaceSettings> all_surface_settings() {
  return {fast(),
          single_frame(),
          smooth(),
          paper("paper", Index::PclKdTree),
          paper("paper-nanoflann", Index::Nanoflann),
          paper("paper-organized", Index::PclOrganized),
          cloud("cloud", Support::FixedRadius, 64, 0.012),
          cloud("cloud-kth", Support::KthNeighbor, 40, 0.03)};
}

Result<SurfaceSettings> surface_settings(std::string_view name) {
  std::string known;
  for (const SurfaceSettings& settings : all_surface_settings()) {
    if (settings.name == name) return settings;
    known += (known.empty() ? "" : ", ") + settings.name;
  }
  return Error{
      .what = "'" + std::string(name) + "' is not known", .where = "surface setting", .fix = "give one of " + known};
}

}  // namespace telepalp::surface
