#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::replay {

inline constexpr std::size_t kMostAnswer_B = std::size_t{512} << 10U;

/// A worker's answer to an order: a report, or the reason of a refusal.
struct CellAnswer {
  std::string build{};    ///< of the worker
  std::string cell{};     ///< identity of the result
  std::string report{};   ///< cell_report() of sweep_cells.h; empty: refused
  std::string refused{};  ///< why no worker can make the cell; empty: it is made
  std::string worker{};   ///< its name
};

/// The bytes of a SweepAnswer (sweep.proto). A reason is cut at 2 KiB.
[[nodiscard]] std::string encode(const CellAnswer& answer);

/// Error: `bytes` are not an answer, exceed kMostAnswer_B, are of another build or cell, or their SHA-256 is not that
/// of their report.
[[nodiscard]] Result<CellAnswer> parse_answer(std::string_view bytes, const std::string& build,
                                              const std::string& cell);

/// Tells that a worker, or a sweep that waits for workers, is there.
struct Presence {
  std::string name;  ///< of the worker; of a sweep: its identity
  std::string build;
  std::uint64_t finished = 0;  ///< cells
};
/// Each worker, and each sweep, publishes its presence once in this time.
inline constexpr std::chrono::seconds kPresenceEvery{2};
[[nodiscard]] std::string encode(const Presence& presence);
/// Error: `bytes` are not a presence, or a text in them is longer than 256 B.
[[nodiscard]] Result<Presence> parse_presence(std::string_view bytes);

}  // namespace telepalp::replay
