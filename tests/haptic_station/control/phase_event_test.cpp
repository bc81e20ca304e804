#include "haptic_station/control/phases/phase_event.h"
#include "where.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>
#include <sstream>

namespace telepalp::control {
namespace {

constexpr Phase kPhases[] = {Phase::InBody,       Phase::BodyToPlane, Phase::OutBody,
                             Phase::PlaneToBody,  Phase::ObjectUpper, Phase::ObjectLateral,
                             Phase::AroundObject, Phase::Released,    Phase::Faulted};
static_assert(std::size(kPhases) == kPhaseCount);

using Pair = std::pair<Phase, Event>;

/// Calls `look` for every phase with every combination of facts.
void for_each_seen(const std::function<void(Phase, const Seen&)>& look) {
  for (const Phase phase : kPhases)
    for (unsigned bits = 0; bits < 1024; ++bits)
      for (const auto touch : {effects::ObjectTouch::None, effects::ObjectTouch::Near, effects::ObjectTouch::Lateral,
                               effects::ObjectTouch::Upper}) {
        const auto bit = [bits](unsigned i) { return ((bits >> i) & 1U) != 0; };
        look(phase, {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6), bit(7), bit(8), bit(9), touch});
      }
}

std::set<Pair> raised() {
  std::set<Pair> pairs;
  for_each_seen([&](Phase phase, const Seen& seen) {
    if (const auto event = event_in(phase, seen)) pairs.emplace(phase, *event);
  });
  return pairs;
}

/// True for an event that only confirms the present phase.
bool says_what_is(const Pair& pair) {
  const Pair kStays[] = {{Phase::InBody, Event::AwayFromObject},
                         {Phase::AroundObject, Event::NearObject},
                         {Phase::ObjectUpper, Event::TouchUpper},
                         {Phase::ObjectLateral, Event::TouchLateral}};
  return std::ranges::find(kStays, pair) != std::end(kStays);
}

/// The table as docs/controller.md prints it.
std::string as_page() {
  const std::set<Pair> pairs = raised();
  std::ostringstream page;
  page << "| event |";
  for (const Phase phase : kPhases) page << " " << name(phase) << " |";
  page << "\n| --- |";
  for (std::size_t i = 0; i < kPhaseCount; ++i) page << " --- |";
  page << "\n";
  for (std::size_t e = 0; e < kEventCount; ++e) {
    const auto event = static_cast<Event>(e);
    page << "| `" << name(event) << "` |";
    for (const Phase phase : kPhases) {
      const Row* row = transition(phase, event);
      const char* to = row != nullptr ? name(row->to) : pairs.contains({phase, event}) ? "stays" : "·";
      page << " " << to << (row != nullptr && row->waits_for_dwell ? " ⏱" : "") << " |";
    }
    page << "\n";
  }
  return page.str();
}

TEST(PhaseEvents, EveryPossibleEventIsInTheTableOrStatesThePresentPhase) {
  for (const Pair& pair : raised()) {
    const bool listed = transition(pair.first, pair.second) != nullptr;
    EXPECT_NE(listed, says_what_is(pair)) << name(pair.first) << " with " << name(pair.second);
  }
}

TEST(PhaseEvents, EveryRowOfTheTableCanHappen) {
  const std::set<Pair> pairs = raised();
  for (const Row& row : transitions())
    EXPECT_TRUE(pairs.contains({row.from, row.on})) << name(row.from) << " with " << name(row.on);
}

TEST(PhaseEvents, FromEveryPhaseSomethingCanHappen) {
  for (const Phase phase : kPhases)
    EXPECT_TRUE(std::ranges::any_of(transitions(), [&](const Row& row) { return row.from == phase; })) << name(phase);
}

TEST(PhaseEvents, SafetyComesBeforeEverythingElse) {
  for_each_seen([](Phase phase, const Seen& seen) {
    if (phase == Phase::Faulted) return;
    const auto event = event_in(phase, seen);
    if (seen.fault_stands || seen.fault_latched) {
      EXPECT_EQ(event, Event::Fault);
    } else if (seen.inputs_stale) {
      EXPECT_EQ(event, phase == Phase::Released ? std::nullopt : std::optional(Event::InputStale));
    }
  });
}

TEST(PhaseEvents, NothingIsRearmedWhileTheCauseLastsOrWithoutARequest) {
  for_each_seen([](Phase phase, const Seen& seen) {
    if (phase == Phase::Faulted && (seen.fault_stands || !seen.rearm)) {
      EXPECT_EQ(event_in(phase, seen), std::nullopt);
    }
  });
}

TEST(PhaseEvents, ThePageAboutTheControllerPrintsTheTable) {
  std::ifstream file(TELEPALP_SOURCE_DIR "/docs/controller.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_NE(page.str().find("<!-- begin phases -->\n" + as_page() + "<!-- end phases -->"), std::string::npos)
      << "if the change is meant, put this between the markers of docs/controller.md:\n"
      << as_page();
}

}  // namespace
}  // namespace telepalp::control
