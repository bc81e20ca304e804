#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace telepalp::replay {

// Subjects of the messages between sweeps and workers (proto/WIRE.md, "Sweeps by workers"). BUILD is the digest of
// version and commit, so that a worker gets only cells of its own build. SWEEP and CELL are identities (settings.h).
//   telepalp-sweep.cell.BUILD.SWEEP.CELL      the order of a cell, for one worker
//   telepalp-sweep.answer.SWEEP.CELL          the report of the cell, or the reason of a refusal
//   telepalp-sweep.source.SHA256.SIZE.NUMBER  a chunk of SIZE bytes of a recording
//   telepalp-sweep.here.worker, .here.sweep   the presence of a worker, or of a sweep that waits for workers

inline constexpr const char* kOrders = "TELEPALP_ORDERS";  ///< stream of the orders, a work queue
inline constexpr const char* kSweeps = "TELEPALP_SWEEPS";  ///< stream of the answers and sources
inline constexpr const char* kOrderSubjects = "telepalp-sweep.cell.>";
inline constexpr const char* kAnswerSubjects = "telepalp-sweep.answer.>";
inline constexpr const char* kSourceSubjects = "telepalp-sweep.source.>";
inline constexpr const char* kWorkerIsHere = "telepalp-sweep.here.worker";
inline constexpr const char* kSweepIsHere = "telepalp-sweep.here.sweep";

/// The token BUILD for this_build().
[[nodiscard]] std::string build_token(const std::string& build);
/// `cell`: "*" for all.
[[nodiscard]] std::string order_subject(const std::string& build, const std::string& sweep, const std::string& cell);
/// Matches the orders of all sweeps of this build.
[[nodiscard]] std::string orders_of_build(const std::string& build);
/// `cell`: "*" for all.
[[nodiscard]] std::string answer_subject(const std::string& sweep, const std::string& cell);

/// The identities of a cell, as a subject states them.
struct CellPlace {
  std::string sweep;
  std::string cell;
};
/// The last two tokens of an order's or answer's subject; nullopt if they are not identities.
[[nodiscard]] std::optional<CellPlace> place_of(std::string_view subject);

}  // namespace telepalp::replay
