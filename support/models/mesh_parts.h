#pragma once

#include "proto/words/counted.h"
#include "support/models/point_model.h"

namespace telepalp::models {

/// Error of the PLY and OBJ readers. `name`: the file's name. `what`: the file's defect.
[[nodiscard]] inline Error bad_mesh(const std::string& name, const std::string& what) {
  return {.what = what, .where = name, .fix = "export the model again, as ascii or binary_little_endian PLY, or OBJ"};
}

/// Adds a polygon as a fan of triangles around its first corner.
inline void add_fan(const std::vector<std::uint32_t>& corners, PointModel& model) {
  for (std::size_t k = 2; k < corners.size(); ++k) model.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

/// Returns `model`. Error: a face refers to a missing vertex, or the model has more than kMostModelPoints points.
[[nodiscard]] inline Result<PointModel> checked_mesh(PointModel model, const std::string& name) {
  for (const auto& triangle : model.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= model.points.size())
        return bad_mesh(name, "has " + counted(model.points.size(), "vertex", "vertices") +
                                  ", but a face names vertex " +
                                  (corner == 0xFFFFFFFF ? "numbers that are negative or above 4294967294"
                                                        : std::to_string(corner) + ", counted from 0"));
  if (model.points.size() > kMostModelPoints)
    return Error{.what = "has more than 20 million points", .where = name, .fix = "simplify the model to fewer points"};
  return model;
}

}  // namespace telepalp::models
