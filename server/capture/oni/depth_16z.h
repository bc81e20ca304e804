#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace telepalp::capture {

/// Decodes `count` samples of OpenNI's depth codec "16z": differences between consecutive samples in four or eight
/// bits, or absolute values. nullopt when `packet` does not contain exactly `count` samples.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> decode_16z(std::span<const std::byte> packet,
                                                                   std::size_t count);

/// Decodes OpenNI's depth codec "16zT": the packet begins with a table of depth values, and its "16z" samples are
/// indices into the table. nullopt as for decode_16z(), and for an index beyond the table.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> decode_16z_table(std::span<const std::byte> packet,
                                                                         std::size_t count);

}  // namespace telepalp::capture
