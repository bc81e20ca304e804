#pragma once

#include "where.h"

namespace telepalp::bench {

inline constexpr const char* kRoom = TELEPALP_SOURCE_DIR "/deploy/demo_data/oni/3dj_test.oni";

}  // namespace telepalp::bench
