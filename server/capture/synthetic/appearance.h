#pragma once

#include <cstdint>

#include "server/capture/synthetic/shape/rest_shape.h"

namespace telepalp::server {

/// The picture that the colour camera takes of the scene at full exhale: skin with mottling and pores, cloth over the
/// pelvis, a sheet on the table, lit from above the patient's left shoulder. The skin moves along the rays of sight, so
/// this picture holds for the whole breath.
[[nodiscard]] ColorImage paint(const RestShape& rest, std::uint64_t seed);

}  // namespace telepalp::server
