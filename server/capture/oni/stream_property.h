#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/capture/oni/record_walk.h"

namespace telepalp::capture {

/// Name and value of a property record. `value` is the undecoded bytes.
struct OniProperty {
  std::string_view name;
  std::string_view value;
};

/// Parses a property record; nullopt when a field is missing or truncated. The result points into `record`.
[[nodiscard]] std::optional<OniProperty> property_in(const OniRecord& record);

/// Content of a record that adds a node (a device or a stream).
struct OniNode {
  std::uint32_t type = 0;                              ///< OpenNI's number: 2 depth stream, 3 colour stream
  std::string_view codec;                              ///< four-letter code
  std::optional<std::uint32_t> frames = std::nullopt;  ///< stated number of frames; nullopt: not stated
};

[[nodiscard]] std::optional<OniNode> node_in(const OniRecord& record);

}  // namespace telepalp::capture
