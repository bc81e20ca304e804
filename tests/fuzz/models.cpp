// Model files of users. The first byte selects the format of the rest.

#include <cstdint>
#include <string>

#include "haptic_station/probe/trajectory.h"
#include "proto/words/demand.h"
#include "support/models/point_model.h"

namespace {

using namespace telepalp;

/// Checks that every index of a model is valid.
void check(const Result<models::PointModel>& read) {
  if (!read) {
    demand(!read.error().what.empty() && read.error().where == "fuzz", "an error says what and where");
    return;
  }
  demand(read->normals.empty() || read->normals.size() == read->points.size(), "one normal a point, or none");
  for (const auto& triangle : read->triangles)
    for (const std::uint32_t corner : triangle) demand(corner < read->points.size(), "a face names what is there");
  demand(read->width >= 0 && (read->width == 0 || read->points.size() % static_cast<std::size_t>(read->width) == 0),
         "an organised cloud has whole rows");
  (void)models::unit_error(*read, 1.0);
}

void check(const Result<std::vector<probe::Waypoint>>& read) {
  if (!read) return;
  demand(!read->empty(), "a trajectory has waypoints");
  for (std::size_t i = 1; i < read->size(); ++i) demand((*read)[i].t_s >= (*read)[i - 1].t_s, "time never goes back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::span<const std::byte> rest = std::as_bytes(std::span(data + 1, size - 1));
  switch (data[0] % 4) {
    case 0:
      check(models::parse_pcd(rest, "fuzz"));
      break;
    case 1:
      check(models::parse_ply(rest, "fuzz"));
      break;
    case 2:
      check(models::parse_obj(rest, "fuzz"));
      break;
    default:
      check(probe::parse_trajectory({reinterpret_cast<const char*>(data + 1), size - 1}, "fuzz"));
  }
  return 0;
}
