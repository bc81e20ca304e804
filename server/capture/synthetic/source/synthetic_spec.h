#pragma once

#include <string>

#include "proto/words/result.h"
#include "server/capture/synthetic/shape/settings.h"

namespace telepalp::capture {

/// The parsed source `synthetic:…`.
struct SyntheticSpec {
  std::string model = "torso";  ///< "torso": the installed model; else the path of a PLY or OBJ file
  SyntheticSettings settings;
};

/// Parses MODEL[,key=value…]; both parts are optional. Error: an unknown key, reported with the list of keys, or a
/// value out of range, reported with the range.
[[nodiscard]] Result<SyntheticSpec> parse_synthetic_spec(const std::string& text);

}  // namespace telepalp::capture
