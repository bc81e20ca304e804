#include "support/isosurface/cells/cell_check.h"

#include <algorithm>
#include <bitset>
#include <vector>

#include "support/isosurface/cells/planes.h"

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.15;       // sheets this far outside the cell count too, in sides
constexpr double kOpposed = -0.3;     // cosine between normals: sheets may face each other
constexpr double kFacing = -0.9;      // they do, or they meet in an edge sharper than 26 degrees
constexpr double kParallel = -0.995;  // they do, and do not meet near the cell
constexpr double kTouching = 1e-4;    // sheets this near to each other, in sides, enclose nothing: faces that touch
constexpr double kEdge = 0.1;         // sheets that meet in an edge fit it within this share of the side
constexpr double kNear = 1.0;         // an edge or corner may lie this far outside the cell, in sides

/// True if the corners of `signs` that are inside are one group along the cell's edges, and those outside another.
bool in_two_groups(unsigned signs) {
  for (const unsigned wanted : {signs, ~signs & 0xffU}) {
    if (wanted == 0) continue;
    unsigned reached = wanted & (~wanted + 1);
    for (int round = 0; round < 8; ++round)
      for (int c = 0; c < 8; ++c)
        if ((reached >> c & 1U) != 0)
          for (const int bit : {1, 2, 4}) reached |= (1U << (c ^ bit)) & wanted;
    if (reached != wanted) return false;
  }
  return true;
}

bool face_is_ambiguous(unsigned signs) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int low = side << axis;
      const int u = 1 << (axis + 1) % 3;
      const int v = 1 << (axis + 2) % 3;
      const auto sign = [&](int c) { return (signs >> c & 1U) != 0; };
      if (sign(low) == sign(low | u | v) && sign(low | u) == sign(low | v) && sign(low) != sign(low | u)) return true;
    }
  return false;
}

const std::bitset<256>& simple_signs() {
  static const std::bitset<256> table = [] {
    std::bitset<256> made;
    for (unsigned signs = 0; signs < 256; ++signs) made[signs] = in_two_groups(signs) && !face_is_ambiguous(signs);
    return made;
  }();
  return table;
}

/// Ju's test: each middle has the sign of at least one corner of its own edge, face or cell.
bool middles_agree(const CellSamples& samples) {
  for (int index = 0; index < 27; ++index) {
    const std::array at{index % 3, index / 3 % 3, index / 9};
    bool agrees = false;
    for (int c = 0; c < 8 && !agrees; ++c) {
      bool own = true;
      for (int axis = 0; axis < 3; ++axis)
        own = own &&
              (at[static_cast<std::size_t>(axis)] == 1 || at[static_cast<std::size_t>(axis)] == 2 * (c >> axis & 1));
      agrees = own && samples.inside(index_of_corner(c)) == samples.inside(static_cast<std::size_t>(index));
    }
    if (!agrees) return false;
  }
  return true;
}

/// The tangent planes of the surface near the cell, each at the foot point of a sample.
std::vector<Plane> sheets_of(const CellSamples& samples) {
  std::vector<Plane> sheets;
  sheets.reserve(27);
  const double reach_m = (0.5 + kReach) * samples.side_m;
  const Vector3d middle = samples.place(13);
  for (std::size_t i = 0; i < 27; ++i) {
    const double slope = samples.at[i].gradient.norm();
    if (!(slope > 0.3)) continue;
    const Vector3d normal = samples.at[i].gradient / slope;
    const Vector3d foot = samples.place(i) - samples.at[i].m / slope * normal;
    if ((foot - middle).cwiseAbs().maxCoeff() <= reach_m) sheets.push_back({foot, normal});
  }
  return sheets;
}

/// The two sheets whose normals differ most: the cosine between them, and their distance.
struct Opposition {
  double cosine = 1.0;
  double apart_m = 0.0;
};
Opposition opposition_of(const std::vector<Plane>& sheets) {
  Opposition most;
  for (std::size_t i = 0; i < sheets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double cosine = sheets[i].normal.dot(sheets[j].normal);
      if (cosine >= most.cosine) continue;
      const Vector3d across = (sheets[i].normal - sheets[j].normal).normalized();
      most = {cosine, std::abs(across.dot(sheets[i].at - sheets[j].at))};
    }
  return most;
}

}  // namespace

CellCheck check_cell(const CellSamples& samples) {
  CellCheck check;
  unsigned signs = 0;
  for (int c = 0; c < 8; ++c) signs |= samples.inside(index_of_corner(c)) ? 1U << c : 0U;
  check.simple = simple_signs()[signs] && middles_agree(samples);
  const std::vector<Plane> sheets = sheets_of(samples);
  if (sheets.size() < 2) return check;
  const Meeting meeting = meeting_of(sheets);
  check.flat = meeting.worst_m <= kFlat * samples.side_m;
  const Opposition opposed = opposition_of(sheets);
  if (opposed.cosine >= kOpposed) return check;
  const bool none_inside = std::ranges::none_of(samples.at, [](const FieldAt& at) { return at.m < 0.0; });
  const bool all_inside = std::ranges::all_of(samples.at, [](const FieldAt& at) { return at.m < 0.0; });
  if ((none_inside || all_inside) && opposed.apart_m <= kTouching * samples.side_m) return check;
  const double off_m = (meeting.at - samples.place(13)).cwiseAbs().maxCoeff();
  const bool edge = opposed.cosine > kFacing && meeting.rank >= 2 && meeting.worst_m <= kEdge * samples.side_m &&
                    off_m <= (0.5 + kNear) * samples.side_m;
  check.one_sheet = edge;
  if (!edge && opposed.cosine < kParallel) check.apart_m = opposed.apart_m;
  return check;
}

}  // namespace telepalp::isosurface
