#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace telepalp::replay {

/// Where a cell of a sweep is, as the program that shares the sweep out among workers knows it.
enum class CellPhase {
  Missing,   ///< neither made nor ordered
  Ordered,   ///< in the work queue, or with a worker
  Finished,  ///< its report is here
  Refused    ///< workers have given it up
};
enum class CellEvent {
  Order,    ///< an order of the cell is in the work queue
  Report,   ///< a worker has made it
  Refusal,  ///< a worker has removed its order as bad
  Vanished  ///< the work queue holds no order of it, and no answer came
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
    {CellPhase::Missing, CellEvent::Report, CellPhase::Finished},  // made for an earlier run of the same command
    {CellPhase::Ordered, CellEvent::Report, CellPhase::Finished},
    {CellPhase::Ordered, CellEvent::Refusal, CellPhase::Refused},
    {CellPhase::Ordered, CellEvent::Vanished, CellPhase::Missing},  // for instance, the queue's disk was lost
    {CellPhase::Refused, CellEvent::Report, CellPhase::Finished},   // another worker had it at the same time
};
/// A pair that is not listed changes nothing: a refusal of an earlier run does not keep a missing cell from being
/// ordered again, and a second report is that of the first.
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
  /// `cells`: the identity of each cell. Cells of one identity are one cell.
  explicit SweepBoard(std::vector<std::string> cells);

  /// Returns true if `event` changed the phase of the cell of this identity; false also if there is none.
  bool on(const std::string& cell, CellEvent event);
  [[nodiscard]] std::optional<CellPhase> phase(const std::string& cell) const;
  [[nodiscard]] std::size_t count(CellPhase phase) const noexcept { return counts_[static_cast<std::size_t>(phase)]; }
  [[nodiscard]] std::size_t size() const noexcept { return phases_.size(); }
  /// True when each cell is finished or refused.
  [[nodiscard]] bool is_settled() const noexcept {
    return count(CellPhase::Missing) == 0 && count(CellPhase::Ordered) == 0;
  }
  /// The identities of the cells in `phase`, in the order in which the sweep names them.
  [[nodiscard]] std::vector<std::string> in(CellPhase phase) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, CellPhase> phases_;
  std::array<std::size_t, kCellPhases> counts_{};
};

}  // namespace telepalp::replay
