#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::replay {

inline constexpr std::size_t kMostAnswer_B = std::size_t{512} << 10U;

/// What a worker made of an order.
struct CellAnswer {
  std::string build{};
  std::string cell{};     ///< identity of the result
  std::string report{};   ///< the text of the cell's report.json; empty: refused
  std::string refused{};  ///< why no worker can make the cell; empty: it is made
  std::string worker{};   ///< its name
};

/// With the SHA-256 of the report.
[[nodiscard]] std::string encode(const CellAnswer& answer);

/// Error: not an answer, one above kMostAnswer_B, one of another build or cell, or a report of another digest than the
/// answer states.
[[nodiscard]] Result<CellAnswer> parse_answer(std::string_view bytes, const std::string& build,
                                              const std::string& cell);

/// What a worker, or a sweep that waits for workers, says of itself.
struct Presence {
  std::string name;
  std::string build;
  std::uint64_t finished = 0;  ///< cells
};
[[nodiscard]] std::string encode(const Presence& presence);
/// Error: not a presence, or one with a text above 256 B.
[[nodiscard]] Result<Presence> parse_presence(std::string_view bytes);

}  // namespace telepalp::replay
