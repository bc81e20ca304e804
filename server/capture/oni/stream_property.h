#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/capture/oni/record_walk.h"

namespace telepalp::server {

/// The name and value of a property record: `value` holds the bytes as they stand.
struct OniProperty {
  std::string_view name;
  std::string_view value;
};

/// nullopt when the record is shorter than it says. Borrows `record`.
[[nodiscard]] std::optional<OniProperty> property_in(const OniRecord& record);

/// What a record says of a node (a device or a stream) when it appears.
struct OniNode {
  std::uint32_t type = 0;
  std::string_view codec;  ///< four letters
  std::optional<std::uint32_t> frames = std::nullopt;
};

[[nodiscard]] std::optional<OniNode> node_in(const OniRecord& record);

}  // namespace telepalp::server
