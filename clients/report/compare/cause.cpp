#include "clients/report/compare/cause.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "clients/ar/messages/phases.h"
#include "clients/report/summary/scene_difference.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::readable;

constexpr double kHandsApart_m = 1e-3;  // more than a tracker's noise
constexpr double kAgesApart_ms = 5.0;   // more than the 10 ms grid of states rounds, on average
constexpr std::int64_t kNear_ns = 20'000'000;
constexpr std::int64_t kBefore_ns = 1'000'000'000;

double force_N(const Session& session, std::size_t tick) {
  const Axes& force = session.ticks.force;
  return std::hypot(double{force[0][tick]}, double{force[1][tick]}, double{force[2][tick]});
}

std::string phase_words(const Session& session, std::size_t tick) {
  return std::string(ar::words_for(session.ticks.phase[tick]).words);
}

bool has_let_go(const Session& session, std::size_t tick) {
  const msg::Phase phase = session.ticks.phase[tick];
  return phase == msg::PHASE_RELEASED || phase == msg::PHASE_FAULTED;
}

/// The newest event other than a change of state in the second before the tick; empty: none.
std::string last_event(const Session& session, std::size_t tick) {
  const std::int64_t now_ns = session.ticks.at_ns[tick];
  std::string text;
  for (const msg::StationEvent& event : session.events) {
    const auto at_ns = static_cast<std::int64_t>(event.stamp_ns());
    if (event.kind() != msg::EVENT_KIND_PHASE && at_ns <= now_ns && at_ns + kBefore_ns >= now_ns) text = event.text();
  }
  return text;
}

std::string letting_go(const Run& run, std::size_t tick, const char* name) {
  const std::string event = last_event(run.session, tick);
  return std::string(name) + " gives the hand no force (state: " + phase_words(run.session, tick) + ")" +
         (event.empty() ? "" : "; its last event: " + event);
}

std::string ages(double a_ms, double b_ms) {
  return "the surface that is touched is " + readable(a_ms) + " ms old in A and " + readable(b_ms) + " ms in B";
}

/// Settings that do not act on the force by themselves: what they change shows in the images or in the contacts.
bool acts_on_the_force(const Setting& setting) {
  constexpr auto kOthers =
      std::to_array<std::string_view>({"source of the images", "software", "server's software", "station's software",
                                       "images", "station's computer", "mean depth m"});
  return std::find(kOthers.begin(), kOthers.end(), setting.name) == kOthers.end();
}

bool differs(const Comparison& comparison, std::string_view name) {
  return std::any_of(comparison.settings.begin(), comparison.settings.end(),
                     [&](const Setting& setting) { return setting.name == name && setting.differs(); });
}

/// Settings that say where and by whom a session was recorded, those that one run does not state, and those that
/// another setting tells better: "network" has the faults in it, and the deadline follows from the network.
bool is_no_cause(const Comparison& comparison, const Setting& setting) {
  if (setting.a.empty() || setting.b.empty()) return true;
  const std::string_view name = setting.name;
  if (name == "recorded from (server or file)" || name == "person or account that recorded") return true;
  const bool path = differs(comparison, "network down") || differs(comparison, "network up");
  const bool fault = differs(comparison, "outage") || differs(comparison, "restart") ||
                     differs(comparison, "tracker lost") || differs(comparison, "glitch") ||
                     differs(comparison, "clock step");
  if (name == "network") return fault && !path;
  return differs(comparison, "network") && (name == "network down" || name == "network up" || name == "deadline ms");
}

/// The settings that differ, in words: those that act on the force by themselves, or the others.
std::vector<std::string> settings_that(const Comparison& comparison, bool act_on_the_force) {
  std::vector<std::string> texts;
  for (const Setting& setting : comparison.settings) {
    if (!setting.differs() || is_no_cause(comparison, setting) || acts_on_the_force(setting) != act_on_the_force)
      continue;
    const std::string how = setting.name != "scene"
                                ? setting.a + " in A, " + setting.b + " in B"
                                : scene_difference(comparison.a.info.scene, comparison.b.info.scene);
    texts.push_back(setting.name + ": " + how);
  }
  return texts;
}

void add_gap(std::vector<std::string>& causes, const char* who, const MissingTicks& missing, std::uint32_t period_ns) {
  constexpr double kLeast_s = 0.05;
  const double missing_s = 1e-9 * static_cast<double>(missing.count) * period_ns;
  if (missing_s < kLeast_s) return;
  causes.push_back(std::string(who) + " lacks the ticks of " + plot::number(missing_s, 3) +
                   " s; the longest gap is from " + plot::number(missing.from_s, 3) + " to " +
                   plot::number(missing.until_s, 3) + " s after the start");
}

void add_missing_images(std::vector<std::string>& causes, const char* who, const char* whose, std::size_t missing,
                        std::size_t all, const ImageComparison& images) {
  constexpr double kLeast_pct = 1.0;
  const double share_pct = all == 0 ? 0.0 : 100.0 * static_cast<double>(missing) / static_cast<double>(all);
  if (share_pct < kLeast_pct) return;
  causes.push_back(std::string(who) + " lacks " + std::to_string(missing) + " of " + whose + "'s " +
                   std::to_string(all) + " depth images" + (images.surfaces ? " that became a surface" : "") + " (" +
                   plot::number(share_pct, 1) + " %)");
}

void add_data(std::vector<std::string>& causes, const Comparison& comparison) {
  const std::uint32_t period_ns = comparison.a.session.ticks.period_ns;
  add_gap(causes, "A", comparison.ticks.missing_in_a, period_ns);
  add_gap(causes, "B", comparison.ticks.missing_in_b, period_ns);
  const ImageComparison& images = comparison.images;
  add_missing_images(causes, "A", "B", images.missing_in_a, images.b, images);
  add_missing_images(causes, "B", "A", images.missing_in_b, images.a, images);
  if (images.sizes_differ) causes.emplace_back("the depth images differ in size");
  constexpr double kLeastScale = 1e-3;
  const double scale = comparison.depth_ratio() - 1.0;
  if (std::abs(scale) > kLeastScale)
    causes.push_back("the depth images of B measure " + readable(100.0 * std::abs(scale)) + " % " +
                     (scale > 0.0 ? "more" : "less") + " than those of A");
  else if (images.depth_apart_mm > 0.0)
    causes.push_back("the depth images of A and B of one instant differ by " + readable(images.depth_apart_mm) +
                     " mm (median)");
}

void add_contacts(std::vector<std::string>& causes, const ContactComparison& contacts) {
  constexpr double kLeastDeeper_mm = 0.5, kLeastRatio = 0.02;
  if (const auto& clipped = contacts.clipped)
    causes.push_back("the force of " + std::string(clipped->in_b ? "B" : "A") + " is clipped at " +
                     readable(clipped->at_N) + " N: " + std::to_string(clipped->ticks) + " ticks stay there, where " +
                     (clipped->in_b ? "A" : "B") + " reaches " + readable(clipped->other_N) + " N");
  if (std::abs(contacts.deeper_mm) > kLeastDeeper_mm)
    causes.push_back("a contact begins " + readable(std::abs(contacts.deeper_mm)) + " mm " +
                     (contacts.deeper_mm > 0.0 ? "deeper" : "less deep") + " in B than in A (median of " +
                     counted(contacts.pairs, "contact", "contacts") + ")");
  const double stiffer = contacts.force_ratio - 1.0;
  if (std::abs(stiffer) > kLeastRatio)
    causes.push_back("at equal indentation, the force of B is " + readable(100.0 * std::abs(stiffer)) + " % " +
                     (stiffer > 0.0 ? "larger" : "smaller") + " than that of A");
}

}  // namespace

double surface_age_ms(const Session& session, std::size_t tick) {
  const std::int64_t at_ns = session.ticks.at_ns[tick];
  const msg::StationState* best = nullptr;
  const auto apart = [&](const msg::StationState& state) {
    return std::abs(static_cast<std::int64_t>(state.stamp_ns()) - at_ns);
  };
  for (const msg::StationState& state : session.states)
    if (best == nullptr || apart(state) < apart(*best)) best = &state;
  if (best == nullptr || apart(*best) > kNear_ns || best->surface_captured_ns() == 0) return kUnknown;
  return 1e-6 * static_cast<double>(static_cast<std::int64_t>(best->stamp_ns() - best->surface_captured_ns()));
}

std::string states_in_words(const Run& a, const Run& b, const Instant& instant) {
  return "A is in the state “" + phase_words(a.session, instant.tick_a) + "” and B in “" +
         phase_words(b.session, instant.tick_b) + "”";
}

std::string forces_in_words(const Run& a, const Run& b, const Instant& instant) {
  return "the force is " + readable(force_N(a.session, instant.tick_a)) + " N in A and " +
         readable(force_N(b.session, instant.tick_b)) + " N in B, and the force vectors differ by " +
         readable(instant.force_apart_N) + " N";
}

std::string cause_in_words(const Run& a, const Run& b, const Instant& instant) {
  if (instant.hands_apart_m > kHandsApart_m)
    return "the hands of A and B are " + readable(1e3 * instant.hands_apart_m) +
           " mm apart: from this instant on they examine different places";
  const bool a_let_go = has_let_go(a.session, instant.tick_a), b_let_go = has_let_go(b.session, instant.tick_b);
  const double age_a = surface_age_ms(a.session, instant.tick_a), age_b = surface_age_ms(b.session, instant.tick_b);
  const bool ages_differ = std::abs(age_a - age_b) > kAgesApart_ms;
  if (a_let_go != b_let_go && std::isfinite(age_a) == std::isfinite(age_b))
    return letting_go(a_let_go ? a : b, a_let_go ? instant.tick_a : instant.tick_b, a_let_go ? "A" : "B") +
           (ages_differ ? "; " + ages(age_a, age_b) : "");
  if (std::isfinite(age_a) != std::isfinite(age_b))
    return std::string(std::isfinite(age_a) ? "B" : "A") +
           " has no surface from a depth image, or recorded no /station/state message within 20 ms of this instant";
  return ages_differ ? ages(age_a, age_b) : "";
}

std::vector<std::string> causes_of(const Comparison& comparison) {
  std::vector<std::string> causes = settings_that(comparison, true);
  add_data(causes, comparison);
  add_contacts(causes, comparison.contacts);
  if (comparison.ticks.first_felt)
    if (std::string there = cause_in_words(comparison.a, comparison.b, *comparison.ticks.first_felt); !there.empty())
      causes.push_back(std::move(there));
  for (std::string& other : settings_that(comparison, false)) causes.push_back(std::move(other));
  if (causes.empty())
    causes.emplace_back(
        "not known: settings, images, hands and ages of the surfaces are the same; compare the programs and the "
        "computers");
  return causes;
}

}  // namespace telepalp::report
