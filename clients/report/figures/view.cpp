#include "clients/report/figures/view.h"

#include <cmath>

#include "clients/ar/messages/from_messages.h"

namespace telepalp::report {
namespace {

const msg::StationState* state_at(const Session& session, std::int64_t at_ns) {
  const msg::StationState* best = nullptr;
  const auto distance = [&](const msg::StationState& state) {
    return std::abs(static_cast<std::int64_t>(state.stamp_ns()) - at_ns);
  };
  for (const msg::StationState& state : session.states)
    if (ar::is_drawable(state) && (best == nullptr || distance(state) < distance(*best))) best = &state;
  return best;
}

}  // namespace

std::int64_t deepest_moment_ns(const Session& session) {
  const msg::StationState* deepest = nullptr;
  for (const msg::StationState& state : session.states)
    if (ar::is_drawable(state) && (deepest == nullptr || !(state.indentation_m() < deepest->indentation_m())))
      deepest = &state;
  if (deepest != nullptr) return static_cast<std::int64_t>(deepest->stamp_ns());
  return session.first_ns.value_or(0) + (session.last_ns.value_or(0) - session.first_ns.value_or(0)) / 2;
}

ColorImage draw_view(const Session& session, const RgbdFrame& frame, std::int64_t at_ns) {
  const msg::StationState* state = state_at(session, at_ns);
  if (state == nullptr)
    return ar::draw({.frame = frame, .touch = std::nullopt, .figures = {{"no hand position in this session", ""}}});
  return ar::draw(
      {.frame = frame, .touch = ar::touch_of(*state), .figures = ar::panel_of(*state, session.first_ns.value_or(0))});
}

}  // namespace telepalp::report
