#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace telepalp {

/// `count` and the words that agree with it: counted(1, "message", "messages") is "1 message".
[[nodiscard]] inline std::string counted(std::uint64_t count, std::string_view one, std::string_view more) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : more);
}

}  // namespace telepalp
