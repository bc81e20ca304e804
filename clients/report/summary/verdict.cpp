#include "clients/report/summary/verdict.h"

#include <algorithm>
#include <cmath>

#include "clients/ar/messages/phases.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::number;
using plot::readable;

double known(const std::optional<std::uint64_t>& count) { return count ? static_cast<double>(*count) : kUnknown; }

double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : kUnknown; }

/// The check that the touched depth is as the camera measured it.
Check depth_check(const Summary& s) {
  const wire::DepthFidelity& depth = s.depth;
  const bool known = s.ticks > 0 && (depth.moved || !depth.mode.empty());
  const std::string meaning =
      "the station made its surface from near-lossless depth (" + wire::in_words(depth) +
      "); only lossless depth is for touching: start telepalp-server with --depth-mode fast, intra or temporal";
  if (depth.moved && !depth.within)
    return {"depth is near-lossless, bound not stated (1: yes, 0: no)", known ? 1.0 : kUnknown, 0.0, "", true, meaning};
  const double off_mm = depth.within ? wire::at_1_m_mm(*depth.within) : 0.0;
  return {"error bound of the depth coding, 1 m from the camera (0: lossless)",
          known ? off_mm : kUnknown,
          0.0,
          "mm",
          true,
          meaning};
}

double missed_percent(const Summary& s) { return percent(known(s.deadlines_missed), static_cast<double>(s.ticks)); }

/// The share of late ticks that the computer's timer explains, at most the share of all late ticks.
double of_the_timer_percent(const Summary& s) {
  return s.idle_timer ? std::min(100.0 * s.idle_timer->missed_share(), missed_percent(s)) : 0.0;
}

std::string what_to_do(const Summary& s) {
  const std::string rights = s.realtime && !*s.realtime
                                 ? "give the station real-time priority and locked memory (ulimit -r and -l, or "
                                   "LimitRTPRIO and LimitMEMLOCK of its service), "
                                 : "";
  return rights + "close other programs, or use a computer that is not shared";
}

/// If the idle timer was measured, two checks: the late ticks of telepalp and those of the computer's timer.
std::vector<Check> deadline_checks(const Summary& s) {
  constexpr double kBudget = 0.1;
  const std::string late = "the force came late in more than one of a thousand ticks";
  if (!s.idle_timer) return {{"late ticks, share of all ticks", missed_percent(s), kBudget, "%", true, late}};
  const double timer = of_the_timer_percent(s);
  const std::string watched = std::to_string(s.idle_timer->missed) + " of " + std::to_string(s.idle_timer->wakeups);
  return {{"late ticks not caused by the timer of the station's computer, share of all ticks",
           missed_percent(s) - timer, kBudget, "%", true,
           late + ", not counting the wake-ups that the timer of the station's computer misses even without work (" +
               watched + ")"},
          {"late ticks caused by the timer of the station's computer, share of all ticks", timer, kBudget, "%", true,
           "the timer of the station's computer misses wake-ups even without work: " + watched +
               " while the station only waited; " + what_to_do(s),
           true}};
}

/// Budgets: the force limit and the rates are S1's (§II.A, §II.D). A frame must be touchable before the next one comes
/// (33 ms at 30 Hz), and 99 of 100 frames within 100 ms, in which breathing moves the skin by less than 1 mm. On a
/// computer without real-time priority, one late tick in a thousand cannot be felt.
std::vector<Check> checks_of(const Summary& s) {
  const double faulted = s.ticks > 0 ? static_cast<double>(s.dwells.back().entries) : kUnknown;
  std::vector<Check> checks{
      {"largest force", s.force_max_N, 10.0, "N", true,
       "the station commanded more than 10 N, the device's peak force"},
      {"numbers that are not finite", s.ticks > 0 ? static_cast<double>(s.non_finite) : kUnknown, 0.0, "", true,
       "a position, force, indentation or distance was not a finite number"},
      {"faults", faulted, 0.0, "", true, "the station faulted, and the device gave no force"},
      {"control rate", s.ticks_per_s, 1990.0, "Hz", false,
       "fewer than 1990 ticks a second are in the file: the control loop was too slow, or the recording has gaps"},
      {"tick time, p99.9", s.tick_us.p999, 500.0, "µs", true,
       "more than one tick in a thousand took longer than its period of 500 µs"},
      {"depth frame: camera to hand, p50", s.capture_to_touchable_ms.p50, 33.3, "ms", true,
       "a typical frame was older than 33.3 ms, the time between frames at 30 Hz, when it became touchable"},
      {"depth frame: camera to hand, p99", s.capture_to_touchable_ms.p99, 100.0, "ms", true,
       "more than one frame in a hundred was older than 100 ms when it became touchable"},
      {"depth frames", s.camera_depth_per_s, 25.0, "/s", false,
       "fewer than 25 depth frames a second are in the file: the camera was too slow, or the recording has gaps"},
      {"depth frames that the server dropped, of all for the station",
       percent(known(s.frames_dropped), known(s.frames_sent) + known(s.frames_dropped)), 5.0, "%", true,
       "the network or the station was too slow, so that frames were lost"},
      depth_check(s),
  };
  const std::vector<Check> deadlines = deadline_checks(s);
  checks.insert(checks.begin() + 4, deadlines.begin(), deadlines.end());  // beside the control rate
  return checks;
}

std::string timers_part(const Summary& s) {
  const auto part = std::lround(of_the_timer_percent(s) * 0.01 * static_cast<double>(s.ticks));
  return (part == 0 ? "none" : "about " + std::to_string(part)) +
         " of them because of the timer of the station's computer, which missed " +
         std::to_string(s.idle_timer->missed) + " of " + std::to_string(s.idle_timer->wakeups) +
         " wake-ups while the station only waited";
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
    text +=
        " The surface under the hand was typically " + readable(s.surface_age_ms.p50) + " ms old" +
        (std::isfinite(s.clock_error_ms.p50) ? ", with an error of at most " + readable(s.clock_error_ms.p50) + " ms"
                                             : "") +
        ".";
  if (s.deadlines_missed)
    text += " Of " + counted(s.ticks, "tick", "ticks") + " " + counted(*s.deadlines_missed, "was late", "were late") +
            (s.idle_timer && *s.deadlines_missed > 0 ? ", " + timers_part(s) : "") + ".";
  if (s.realtime && !*s.realtime) text += " The station ran without real-time priority or without locked memory.";
  return text;
}

std::string senders_warning(const Summary& s) {
  if (s.senders.size() < 2) return "";
  std::string text = std::to_string(s.senders.size()) + " programs published as the station:";
  for (const SenderSummary& sender : s.senders)
    text += (&sender == &s.senders.front() ? " " : ", ") + in_words(sender) + " (" +
            counted(sender.ticks, "tick", "ticks") + ", " + counted(sender.states, "message", "messages") +
            " of /station/state)";
  return text + "; the figures are those of the first program, and the messages of the others may be forged. ";
}

std::string headline_of(const std::vector<Check>& checks, bool judged) {
  std::string missed;
  int misses = 0;
  bool only_the_computer = true;
  for (const Check& check : checks)
    if (check.standing() == Standing::Misses) {
      missed += (misses++ > 0 ? "; " : "") + check.meaning;
      only_the_computer = only_the_computer && check.of_the_computer;
    }
  if (misses > 0 && only_the_computer) return "The run was good, but the station's computer was late: " + missed + ".";
  if (misses > 0) return "Check this run: " + missed + ".";
  return judged ? "The run was good: every measured figure meets its requirement."
                : "The run is not judged: the session has no ticks of a station.";
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

Verdict judge(const Summary& summary) {
  Verdict verdict;
  verdict.checks = checks_of(summary);
  const bool judged = summary.ticks > 0;
  verdict.good = judged;
  for (const Check& check : verdict.checks) verdict.good = verdict.good && check.standing() != Standing::Misses;
  verdict.good = verdict.good && summary.senders.size() < 2;
  verdict.headline = senders_warning(summary) + headline_of(verdict.checks, judged);
  verdict.account = account_of(summary);
  return verdict;
}

}  // namespace telepalp::report
