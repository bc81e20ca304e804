#include "tools/replay/workers/sweep_board.h"

#include <utility>

namespace telepalp::replay {

std::string_view name(CellPhase phase) noexcept {
  constexpr std::array<std::string_view, kCellPhases> kNames{"Missing", "Ordered", "Finished", "Refused"};
  return kNames[static_cast<std::size_t>(phase)];
}

std::string_view name(CellEvent event) noexcept {
  constexpr std::array<std::string_view, kCellEvents> kNames{"Order", "Report", "Refusal", "Vanished"};
  return kNames[static_cast<std::size_t>(event)];
}

SweepBoard::SweepBoard(std::vector<std::string> cells) {
  for (std::string& cell : cells)
    if (phases_.emplace(cell, CellPhase::Missing).second) order_.push_back(std::move(cell));
  counts_[static_cast<std::size_t>(CellPhase::Missing)] = phases_.size();
}

bool SweepBoard::on(const std::string& cell, CellEvent event) {
  const auto found = phases_.find(cell);
  if (found == phases_.end()) return false;
  const CellPhase before = found->second;
  found->second = next(before, event);
  if (found->second == before) return false;
  --counts_[static_cast<std::size_t>(before)];
  ++counts_[static_cast<std::size_t>(found->second)];
  return true;
}

std::optional<CellPhase> SweepBoard::phase(const std::string& cell) const {
  const auto found = phases_.find(cell);
  return found == phases_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> SweepBoard::in(CellPhase phase) const {
  std::vector<std::string> cells;
  for (const std::string& cell : order_)
    if (phases_.at(cell) == phase) cells.push_back(cell);
  return cells;
}

}  // namespace telepalp::replay
