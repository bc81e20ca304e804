#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace telepalp::replay {

/// The phase of a cell of a sweep that workers make, as telepalp-replay knows it.
enum class CellPhase {
  Missing,   ///< neither made nor ordered
  Ordered,   ///< its order is in the work queue, or a worker makes it
  Finished,  ///< telepalp-replay has its report
  Refused    ///< workers have given it up
};
enum class CellEvent {
  Order,    ///< its order is in the work queue
  Report,   ///< its report has come
  Refusal,  ///< a worker has removed its order from the queue
  Vanished  ///< its order has left the work queue, and no answer has come
};
inline constexpr std::size_t kCellPhases = 4;
inline constexpr std::size_t kCellEvents = 4;

struct CellRow {
  CellPhase from;
  CellEvent on;
  CellPhase to;
};
inline constexpr CellRow kCellTransitions[] = {
    {CellPhase::Missing, CellEvent::Order, CellPhase::Ordered},
    {CellPhase::Missing, CellEvent::Report, CellPhase::Finished},  // made for an earlier run of the command
    {CellPhase::Ordered, CellEvent::Report, CellPhase::Finished},
    {CellPhase::Ordered, CellEvent::Refusal, CellPhase::Refused},
    {CellPhase::Ordered, CellEvent::Vanished, CellPhase::Missing},  // for instance, the queue's disk was lost
    {CellPhase::Refused, CellEvent::Report, CellPhase::Finished},   // two workers made it, and only one failed
};
/// A pair that is not listed changes nothing. So a refusal of an earlier run leaves a cell Missing, to be ordered
/// again, and a second report of a cell, which has the same bytes, is ignored.
[[nodiscard]] constexpr CellPhase next(CellPhase phase, CellEvent event) noexcept {
  for (const CellRow& row : kCellTransitions)
    if (row.from == phase && row.on == event) return row.to;
  return phase;
}
[[nodiscard]] std::string_view name(CellPhase phase) noexcept;
[[nodiscard]] std::string_view name(CellEvent event) noexcept;

/// The phases of all cells of one sweep. Pure. Owner: one thread.
class SweepBoard {
 public:
  /// `cells`: identities. An identity that occurs twice is one cell.
  explicit SweepBoard(std::vector<std::string> cells);

  /// Returns true if `event` changed the phase of the cell. False also if the sweep has no cell of this identity.
  bool on(const std::string& cell, CellEvent event);
  /// nullopt: the sweep has no cell of this identity.
  [[nodiscard]] std::optional<CellPhase> phase(const std::string& cell) const;
  [[nodiscard]] std::size_t count(CellPhase phase) const noexcept { return counts_[static_cast<std::size_t>(phase)]; }
  [[nodiscard]] std::size_t size() const noexcept { return phases_.size(); }
  /// True when each cell is finished or refused.
  [[nodiscard]] bool is_settled() const noexcept {
    return count(CellPhase::Missing) == 0 && count(CellPhase::Ordered) == 0;
  }
  /// The identities of the cells in `phase`, in the order of the constructor's `cells`.
  [[nodiscard]] std::vector<std::string> in(CellPhase phase) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, CellPhase> phases_;
  std::array<std::size_t, kCellPhases> counts_{};
};

}  // namespace telepalp::replay
