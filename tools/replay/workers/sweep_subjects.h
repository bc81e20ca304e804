#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace telepalp::replay {

// Where sweeps and workers meet in a cluster (proto/WIRE.md, "Sweeps by workers"). BUILD is the digest of version and
// commit, so that a worker is offered only cells of its own build. SWEEP and CELL are identities (settings.h).
//   telepalp-sweep.cell.BUILD.SWEEP.CELL      an order; each is taken by one worker
//   telepalp-sweep.answer.SWEEP.CELL          what a worker made of it
//   telepalp-sweep.source.SHA256.SIZE.NUMBER  chunks, of SIZE bytes each, of a recording
//   telepalp-sweep.here.worker, .here.sweep   who is there

inline constexpr const char* kOrders = "TELEPALP_ORDERS";  ///< stream of the orders, a work queue
inline constexpr const char* kSweeps = "TELEPALP_SWEEPS";  ///< stream of the answers and sources
inline constexpr const char* kOrderSubjects = "telepalp-sweep.cell.>";
inline constexpr const char* kAnswerSubjects = "telepalp-sweep.answer.>";
inline constexpr const char* kSourceSubjects = "telepalp-sweep.source.>";
inline constexpr const char* kWorkerIsHere = "telepalp-sweep.here.worker";
inline constexpr const char* kSweepIsHere = "telepalp-sweep.here.sweep";

/// The token BUILD of a build, as this_build() states it.
[[nodiscard]] std::string build_token(const std::string& build);
/// `cell`: "*" for all.
[[nodiscard]] std::string order_subject(const std::string& build, const std::string& sweep, const std::string& cell);
[[nodiscard]] std::string orders_of_build(const std::string& build);
[[nodiscard]] std::string answer_subject(const std::string& sweep, const std::string& cell);

struct CellPlace {
  std::string sweep;
  std::string cell;
};
/// The last two tokens of an order's or answer's subject; nullopt: they are no identities.
[[nodiscard]] std::optional<CellPlace> place_of(std::string_view subject);

}  // namespace telepalp::replay
