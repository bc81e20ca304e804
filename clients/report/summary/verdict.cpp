#include "clients/report/summary/verdict.h"

#include <algorithm>
#include <cmath>

#include "clients/report/summary/checks.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::number;
using plot::readable;

std::string timers_part(const Summary& s) {
  const auto part = std::lround(late_by_the_timer_percent(s) * 0.01 * static_cast<double>(s.ticks));
  std::string count = "about " + std::to_string(part);
  if (part == 0) count = "none";
  if (part > 0 && static_cast<std::uint64_t>(part) >= *s.deadlines_missed) count = "all";
  return count + " of them because of the timer of the station's computer, which missed " +
         std::to_string(s.idle_timer->missed) + " of " + std::to_string(s.idle_timer->wakeups) +
         " wake-ups while the station only waited";
}

std::string images_sentence(const Summary& s) {
  if (!s.frames_sent || !s.frames_received) return "";
  return " Of " + counted(*s.frames_sent, "depth image", "depth images") + " sent to the station, " +
         std::to_string(*s.frames_received) + " were received.";
}

/// Empty if the session does not tell.
std::string ways_sentence(const Summary& s) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(s.ways.size(), kMost); ++i)
    text += (i == 0 ? " Images and touch went " : "; from " + number(s.ways[i].from_s, 1) + " s on ") + s.ways[i].words;
  if (s.ways.size() > kMost)
    text += "; " + counted(s.ways.size() - kMost, "more change", "more changes") + " of the way under Events";
  return text.empty() ? text : text + ".";
}

std::string account_of(const Summary& s) {
  std::string text;
  if (s.ticks == 0)
    return "The session lasts " + number(s.seconds, 1) + " s and has no ticks of a station." +
           (s.depth.moved ? " The depth of its images is " + wire::in_words(s.depth) + "." : "");
  if (s.touches == 0 && !(s.contact_s > 0.0)) {
    text = "In " + number(s.seconds, 1) + " s the doctor's hand did not touch the patient.";
  } else {
    text = "In " + number(s.seconds, 1) + " s the doctor touched the patient" +
           (s.touches > 0 ? (s.touches == 1 ? " once" : " " + std::to_string(s.touches) + " times") : "") + ", for " +
           number(s.contact_s, 1) + " s in all, pressed in as deep as " + readable(s.indentation_max_mm) + " mm" +
           (std::isfinite(s.force_in_contact_max_N) ? " and felt up to " + readable(s.force_in_contact_max_N) + " N."
                                                    : ".");
  }
  if (std::isfinite(s.surface_age_ms.p50))
    text += " The surface under the hand was typically " + readable(s.surface_age_ms.p50) + " ms old" +
            (std::isfinite(s.clock_error_ms.p50) ? ", known to within " + readable(s.clock_error_ms.p50) + " ms" : "") +
            ".";
  if (s.deadlines_missed)
    text += " Of " + counted(s.ticks, "tick", "ticks") + " " + counted(*s.deadlines_missed, "was late", "were late") +
            (s.idle_timer && *s.deadlines_missed > 0 ? ", " + timers_part(s) : "") + ".";
  text += images_sentence(s) + ways_sentence(s);
  if (s.realtime && !*s.realtime) text += " The station ran without real-time priority or without locked memory.";
  return text;
}

/// A cause, and what the headline says of it.
struct Finding {
  Rank rank;
  std::string brief;
  Cause cause;
};

Finding of_senders(const Summary& s) {
  std::string text = std::to_string(s.senders.size()) + " programs published as the station:";
  for (const SenderSummary& sender : s.senders)
    text += (&sender == &s.senders.front() ? " " : ", ") + in_words(sender) + " (" +
            counted(sender.ticks, "tick", "ticks") + ", " + counted(sender.states, "message", "messages") +
            " of /station/state)";
  return {Rank::Safety,
          std::to_string(s.senders.size()) + " programs published as the station",
          {text + "; the figures are those of the first program, and the messages of the others may be forged",
           "find out which program is the doctor's; use keys, so that one doctor at a time holds the touch"}};
}

/// The checks that miss their budgets, by rank. Of two checks of the latency, the first says it all.
std::vector<Finding> findings_of(const Summary& s, const std::vector<Check>& checks, const Session* session) {
  std::vector<Finding> findings;
  if (s.senders.size() > 1) findings.push_back(of_senders(s));
  for (const Check& check : checks) {
    if (check.standing() != Standing::Misses) continue;
    const bool again = check.rank == Rank::Latency && !findings.empty() && findings.back().rank == Rank::Latency;
    if (again) continue;
    const std::string when =
        session == nullptr
            ? ""
            : in_words(moments_beyond(*session, check.each.sample, check.each.limit, check.at_most), check.each.sample);
    findings.push_back({check.rank, check.brief, {check.meaning, check.to_do, when}});
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& one, const Finding& other) { return one.rank < other.rank; });
  return findings;
}

std::string headline_of(const std::vector<Finding>& findings, bool judged) {
  if (findings.empty())
    return judged ? "The run was good: every measured figure meets its requirement."
                  : "The run is not judged: the session has no ticks of a station.";
  const bool only_the_computer = findings.front().rank == Rank::Computer;
  if (only_the_computer) return "The run was good, but " + findings.front().brief + ".";
  return "Check this run: " + findings.front().brief + ".";
}

}  // namespace

Standing Check::standing() const noexcept {
  if (!std::isfinite(value)) return Standing::NotMeasured;
  return (at_most ? value <= budget : value >= budget) ? Standing::Holds : Standing::Misses;
}

std::string in_words(const SenderSummary& sender) {
  if (sender.name.empty()) return "sender " + std::to_string(sender.sender);
  return sender.name + " at " + sender.address;
}

Verdict judge(const Summary& summary, const PathLimits& path, const Session* session) {
  Verdict verdict;
  verdict.checks = checks_of(summary, path);
  const bool judged = summary.ticks > 0;
  const std::vector<Finding> findings = findings_of(summary, verdict.checks, session);
  verdict.good = judged && findings.empty();
  verdict.headline = headline_of(findings, judged);
  for (const Finding& finding : findings) verdict.causes.push_back(finding.cause);
  verdict.account = account_of(summary);
  return verdict;
}

}  // namespace telepalp::report
