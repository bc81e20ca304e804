#pragma once

#include <string>

#include "proto/words/result.h"
#include "server/capture/synthetic/shape/settings.h"

namespace telepalp::server {

/// What `synthetic:…` asks for.
struct SyntheticSpec {
  std::string model = "torso";  ///< the shipped torso, or the path of a PLY file
  SyntheticSettings settings;
};

/// Reads MODEL[,key=value…], both parts optional. An unknown key is answered with all there are; a value out of bounds
/// with its bounds.
[[nodiscard]] Result<SyntheticSpec> parse_synthetic_spec(const std::string& text);

}  // namespace telepalp::server
