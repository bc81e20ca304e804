#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace telepalp::server {

/// The `count` samples in a depth image that OpenNI compressed as "16z": differences from sample to sample in four
/// bits, eight bits or as whole values. nullopt when `packet` holds fewer samples, more, or ends inside one.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> decode_16z(std::span<const std::byte> packet,
                                                                   std::size_t count);

/// The same for "16zT": a table of depth values leads the packet, and the samples are indices into it.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> decode_16z_table(std::span<const std::byte> packet,
                                                                         std::size_t count);

}  // namespace telepalp::server
