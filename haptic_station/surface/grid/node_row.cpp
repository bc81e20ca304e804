#include "haptic_station/surface/grid/node_row.h"

#include <cmath>

#include "proto/words/vectorised.h"

// Compiled for several instruction sets. This file must not use inline functions of headers that other files compile
// for another instruction set.

namespace telepalp::surface {
namespace {

constexpr float kNarrowAt = 0.75F;  // up to this cosine between ray and normal, only the narrow window counts
constexpr float kWideAt = 0.95F;    // from this cosine on, only the wide window counts

struct In {
  const float* wide_at;
  const float* wide_across;
  const float* wide_down;
  const float* narrow_at;
  const float* narrow_across;
  const float* narrow_down;
  const float* wide;
  const float* frames;
  const float* ray_x;
};

struct Out {
  float* x;
  float* y;
  float* z;
  float* normal_x;
  float* normal_y;
  float* normal_z;
  float* deviation;
  float* facing;
};

/// 1/z = at + across·du + down·dv is N·X = 1 with N = (across·fx, down·fy, at − across·fx·x − down·fy·y).
TELEPALP_VECTORISED
void make(const In& in, std::size_t count, const NodeRowView& view, const Out& out) {
  const float* __restrict wide_at = in.wide_at;
  const float* __restrict wide_across = in.wide_across;
  const float* __restrict wide_down = in.wide_down;
  const float* __restrict narrow_at = in.narrow_at;
  const float* __restrict narrow_across = in.narrow_across;
  const float* __restrict narrow_down = in.narrow_down;
  const float* __restrict is_wide = in.wide;
  const float* __restrict frames = in.frames;
  const float* __restrict ray_x = in.ray_x;
  float* __restrict out_x = out.x;
  float* __restrict out_y = out.y;
  float* __restrict out_z = out.z;
  float* __restrict normal_x = out.normal_x;
  float* __restrict normal_y = out.normal_y;
  float* __restrict normal_z = out.normal_z;
  float* __restrict deviation = out.deviation;
  float* __restrict out_facing = out.facing;
  const float y = view.ray_y;
  for (std::size_t n = 0; n < count; ++n) {
    const float x = ray_x[n];
    const float ray = std::sqrt(x * x + y * y + 1.0F);

    const float wa = wide_across[n] * view.fx;
    const float wd = wide_down[n] * view.fy;
    const float wr = wide_at[n] + view.reference_per_m;
    const float wz = wr - wa * x - wd * y;
    const float wide_facing = wr / (std::sqrt(wa * wa + wd * wd + wz * wz) * ray);
    const float t = (wide_facing - kNarrowAt) / (kWideAt - kNarrowAt);
    const float above = t > 0.0F ? t : 0.0F;
    const float s = above < 1.0F ? above : 1.0F;
    const float share = is_wide[n] * (s * s * (3.0F - 2.0F * s));
    const float rest = 1.0F - share;

    const float per_m = share * wide_at[n] + rest * narrow_at[n] + view.reference_per_m;
    const float a = (share * wide_across[n] + rest * narrow_across[n]) * view.fx;
    const float d = (share * wide_down[n] + rest * narrow_down[n]) * view.fy;
    const float c = per_m - a * x - d * y;
    const float z = 1.0F / per_m;
    const float length = std::sqrt(a * a + d * d + c * c);
    const float facing = per_m / (length * ray);
    out_x[n] = x * z - view.origin_x;
    out_y[n] = y * z - view.origin_y;
    out_z[n] = z - view.origin_z;
    normal_x[n] = -a / length;
    normal_y[n] = -d / length;
    normal_z[n] = -c / length;
    // Axial noise of a structured-light camera [m]. Source: Nguyen, Izadi and Lovell (2012).
    const float axial = 0.0012F + 0.0019F * (z - 0.4F) * (z - 0.4F);
    out_facing[n] = facing;
    deviation[n] = axial * facing * std::sqrt((share * view.wide_gain + rest * view.narrow_gain) / frames[n]);
  }
}

}  // namespace

NodeRow::NodeRow(std::size_t nodes) {
  for (std::vector<float>* column :
       {&wide_at, &wide_across, &wide_down, &narrow_at, &narrow_across, &narrow_down, &wide, &frames, &ray_x, &x, &y,
        &z, &normal_x, &normal_y, &normal_z, &deviation, &facing})
    column->assign(nodes, 0.0F);
}

void make_nodes(NodeRow& row, const NodeRowView& view) {
  make({row.wide_at.data(), row.wide_across.data(), row.wide_down.data(), row.narrow_at.data(),
        row.narrow_across.data(), row.narrow_down.data(), row.wide.data(), row.frames.data(), row.ray_x.data()},
       row.x.size(), view,
       {row.x.data(), row.y.data(), row.z.data(), row.normal_x.data(), row.normal_y.data(), row.normal_z.data(),
        row.deviation.data(), row.facing.data()});
}

}  // namespace telepalp::surface
