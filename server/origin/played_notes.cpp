#include "server/origin/played_notes.h"

#include <algorithm>
#include <utility>

namespace telepalp::origin {
namespace {

constexpr std::size_t kMostShown = 4;
/// A note's time is renewed before the pages take the note away.
constexpr Nanoseconds kRenewedAfter = PlayedNotes::kStands * 3 / 4;

std::uint64_t stamp(SessionTime now) { return static_cast<std::uint64_t>(to_nanoseconds(now)); }

}  // namespace

PlayedNotes::PlayedNotes(std::vector<wire::ToldNote> notes) : notes_(std::move(notes)) {
  std::erase_if(notes_, [](const wire::ToldNote& one) { return one.note.text().empty() && !one.note.has_at_m(); });
}

const msg::MarksState& PlayedNotes::at(double position_s, SessionTime now) {
  const auto after = std::ranges::upper_bound(notes_, position_s, {}, &wire::ToldNote::at_s);
  const auto first = std::ranges::upper_bound(notes_, position_s - to_seconds(kStands), {}, &wire::ToldNote::at_s);
  std::vector<std::size_t> shown;
  for (auto note = first; note < after; ++note) shown.push_back(static_cast<std::size_t>(note - notes_.begin()));
  if (shown.size() > kMostShown) shown.erase(shown.begin(), shown.end() - kMostShown);
  msg::MarksState state;
  state.set_closed(true);
  state.set_count(static_cast<std::uint32_t>(after - notes_.begin()));
  for (const std::size_t place : shown) {
    const auto before = std::ranges::find(shown_, place);
    msg::LiveNote& note = *state.add_newest();
    note = before == shown_.end() ? notes_[place].note : state_.newest(static_cast<int>(before - shown_.begin()));
    const bool expires = note.at_ns() + static_cast<std::uint64_t>(kRenewedAfter.count()) < stamp(now);
    if (before == shown_.end() || expires) note.set_at_ns(stamp(now));
  }
  shown_ = std::move(shown);
  return state_ = std::move(state);
}

}  // namespace telepalp::origin
