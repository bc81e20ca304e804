#include "clients/report/summary/checks.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::readable;

constexpr double kLeastBalance_mJ = -5.0;  // of the storms that telepalp-replay makes (docs/replay.md)
constexpr double kMostExcess_mJ = 250.0;
constexpr double kPeriod_us = 500.0;  // of a tick

double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : kUnknown; }

std::vector<Check> safety_checks(const Summary& s) {
  const double faulted = s.ticks > 0 ? static_cast<double>(s.dwells.back().entries) : kUnknown;
  return {{"largest force",
           s.force_max_N,
           10.0,
           "N",
           true,
           Rank::Safety,
           "the force exceeded the device's peak force",
           "the station commanded " + readable(s.force_max_N) + " N; the device's peak force is 10 N",
           "do not use this scene on a patient; look at its limits { peak_N }",
           {Measurement::Force, 10.0}},
          {"numbers that are not finite",
           s.ticks > 0 ? static_cast<double>(s.non_finite) : kUnknown,
           0.0,
           "",
           true,
           Rank::Safety,
           "a force or a position was not a number",
           "a position, force, indentation or distance was not a finite number",
           "send this session to the developers: it is a defect of telepalp, or of the device's driver",
           {Measurement::NotFinite, 0.0}},
          {"faults",
           faulted,
           0.0,
           "",
           true,
           Rank::Safety,
           "the station faulted",
           "the station faulted, and the device gave no force until it was re-armed",
           "read the fault below, under Events",
           {Measurement::Fault, 0.0}},
          {"lowest energy balance of the display",
           s.display_least_mJ,
           kLeastBalance_mJ,
           "mJ",
           false,
           Rank::Safety,
           "the display created energy",
           "the display gave the hand " + readable(-s.display_least_mJ) + " mJ more than the hand had put in",
           "look in the section Energy whether surface or scene changed at this time",
           {Measurement::Balance, kLeastBalance_mJ}},
          {"largest excess work on the hand in one contact",
           s.hand_excess_most_mJ,
           kMostExcess_mJ,
           "mJ",
           true,
           Rank::Safety,
           "the skin gave the hand too much work",
           "in one contact the device did " + readable(s.hand_excess_most_mJ) +
               " mJ more work on the hand than the measured skin would have done",
           "keep the patient still, or use a path with less delay: an old surface or a moving patient causes this",
           {Measurement::ExcessWork, kMostExcess_mJ}}};
}

/// The check that the touched depth is as the camera measured it.
Check depth_check(const Summary& s) {
  const wire::DepthFidelity& depth = s.depth;
  const bool is_known = s.ticks > 0 && (depth.moved || !depth.mode.empty());
  const bool stated = !depth.moved || depth.within;
  const double off_mm = depth.within ? wire::at_1_m_mm(*depth.within) : stated ? 0.0 : 1.0;
  return {stated ? "error bound of the depth coding, 1 m from the camera (0: lossless)"
                 : "depth is near-lossless, bound not stated (1: yes, 0: no)",
          is_known ? off_mm : kUnknown,
          0.0,
          stated ? "mm" : "",
          true,
          Rank::Depth,
          "near-lossless depth was touched",
          "the station made its surface from near-lossless depth (" + wire::in_words(depth) + ")",
          "touch lossless depth only: start telepalp-server with --depth-mode fast, intra or temporal"};
}

/// A part of a depth image's way from the camera to the hand.
struct Stage {
  std::string_view brief;  ///< for the headline: "the network"
  std::string_view name;
  Quantiles Summary::*time;
  std::string_view to_do;
};

constexpr Stage kStages[] = {
    {"the camera's computer", "the camera's computer", &Summary::capture_to_encoded_ms,
     "close other programs on the server's computer, or choose a smaller camera image or --depth-mode fast"},
    {"the network", "the network", &Summary::encoded_to_received_ms,
     "use a path with less delay or more rate, or move slowly and wait for the skin; telepalp-link shows the path"},
    {"the station", "the station's computer (waiting and decoding)", &Summary::received_to_decoded_ms,
     "close other programs on the station's computer, or choose a faster surface setting"},
    {"the station", "the station's computer (building the surface)", &Summary::decoded_to_touchable_ms,
     "choose a faster surface setting (docs/accuracy.md), or a computer with more cores"},
};

/// The stage that took the most of the time, in the quantile `part`.
const Stage& largest_stage(const Summary& s, double Quantiles::*part) {
  return *std::max_element(std::begin(kStages), std::end(kStages), [&](const Stage& one, const Stage& other) {
    const double first = (s.*one.time).*part, second = (s.*other.time).*part;
    return (std::isfinite(first) ? first : 0.0) < (std::isfinite(second) ? second : 0.0);
  });
}

Check latency_check(const Summary& s, double Quantiles::*part, const char* quantile, const char* which,
                    double limit_ms) {
  const double value_ms = s.capture_to_touchable_ms.*part;
  const Stage& stage = largest_stage(s, part);
  const PathLimits& like = path_like(s.encoded_to_received_ms.p50);
  const bool network = stage.time == &Summary::encoded_to_received_ms;
  const bool typical = part == &Quantiles::p50;
  std::string meaning = std::string(which) + " became touchable " + readable(value_ms) + " ms " +
                        (typical ? "" : "or more ") + "after its capture; " + std::string(stage.name) + " took " +
                        readable((s.*stage.time).*part) + " ms " +
                        (typical ? "for a typical one" : "or more for one in a hundred");
  if (network)
    meaning += ". The path resembles the profile “" + std::string(like.name) + "”, on which telepalp allows " +
               readable(typical ? like.latency_p50_ms : like.latency_p99_ms) + " ms";
  return {std::string("depth image: from the camera to the hand, ") + quantile,
          value_ms,
          limit_ms,
          "ms",
          true,
          Rank::Latency,
          std::string(stage.brief) + (typical ? " made the touch " : " made some images ") + readable(value_ms) +
              " ms late",
          meaning,
          std::string(stage.to_do),
          {Measurement::Latency, limit_ms}};
}

std::vector<Check> image_checks(const Summary& s, const PathLimits& path) {
  const PathLimits& like = path_like(s.encoded_to_received_ms.p50);
  const std::string of_sent = s.frames_sent && s.frames_received
                                  ? std::to_string(*s.frames_received) + " of " + std::to_string(*s.frames_sent) + " "
                                  : "";
  const std::string still =
      s.frames_on_the_way > 0 ? " (about " + std::to_string(s.frames_on_the_way) + " were still on the way)" : "";
  const double dropped = percent(known(s.frames_dropped), known(s.frames_sent) + known(s.frames_dropped));
  return {
      {"share of the sent depth images that reached the station", 100.0 * s.received_share(),
       std::min(path.received_pct, like.received_pct), "%", false, Rank::Images, "depth images were lost on the way",
       "the station received only " + of_sent + "depth images that the server sent" + still,
       "use a path that loses fewer packets, give it more rate, or choose a smaller camera image"},
      {"share of the depth images that the server did not send, because a newer one came", dropped, 5.0, "%", true,
       Rank::Images, "the path was too slow for the images",
       "the server replaced " + readable(dropped) +
           " % of the depth images by newer ones before they were sent: network or station were too slow",
       "give the path more rate, or choose a smaller camera image"},
      {"depth images that the camera took, per second", s.camera_depth_per_s, 25.0, "/s", false, Rank::Images,
       "the camera was slow",
       "only " + readable(s.camera_depth_per_s) +
           " depth images a second are in the file: the camera was slow, or the recording has gaps",
       "compare with the received images; record at the server's own machine"}};
}

double missed_percent(const Summary& s) { return percent(known(s.deadlines_missed), static_cast<double>(s.ticks)); }

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
  constexpr Each late_ticks{Measurement::TickEnd, kPeriod_us};
  const std::string brief = "the force came late",
                    late = "the force came late: " + readable(known(s.deadlines_missed)) + " of " +
                           readable(static_cast<double>(s.ticks)) +
                           " deadlines were missed, more than one in a thousand";
  if (!s.idle_timer)
    return {{"late ticks, share of all ticks", missed_percent(s), kBudget, "%", true, Rank::Loop, brief, late,
             what_to_do(s), late_ticks}};
  const double timer = late_by_the_timer_percent(s);
  const std::string watched = std::to_string(s.idle_timer->missed) + " of " + std::to_string(s.idle_timer->wakeups);
  return {{"late ticks not caused by the timer of the station's computer, share of all ticks",
           missed_percent(s) - timer, kBudget, "%", true, Rank::Loop, brief,
           late + ", not counting the wake-ups that the timer of the station's computer misses even without work (" +
               watched + ")",
           what_to_do(s), late_ticks},
          {"late ticks caused by the timer of the station's computer, share of all ticks", timer, kBudget, "%", true,
           Rank::Computer, "the station's computer was late",
           "the timer of the station's computer misses wake-ups even without work: " + watched +
               " while the station only waited",
           what_to_do(s), late_ticks}};
}

std::vector<Check> loop_checks(const Summary& s) {
  std::vector<Check> checks{
      {"control rate", s.ticks_per_s, 1990.0, "Hz", false, Rank::Loop, "the control loop was too slow",
       "the station made only " + readable(s.ticks_per_s) + " ticks a second", what_to_do(s)},
      {"tick time, p99.9",
       s.tick_us.p999,
       kPeriod_us,
       "µs",
       true,
       Rank::Loop,
       "ticks took too long",
       "more than one tick in a thousand took longer than its period of 500 µs",
       "see Computing time of the effects, or choose another surface setting",
       {Measurement::TickTime, kPeriod_us}}};
  for (Check& check : deadline_checks(s)) checks.insert(checks.end() - 1, std::move(check));
  return checks;
}

std::vector<Check> other_checks(const Summary& s, const PathLimits& path) {
  const PathLimits& like = path_like(s.encoded_to_received_ms.p50);
  const double missing = percent(known(s.ticks_missing), static_cast<double>(s.ticks) + known(s.ticks_missing));
  return {
      {"error bound of the station's clock, p99",
       s.clock_error_ms.p99,
       std::max(path.clock_error_ms, like.clock_error_ms),
       "ms",
       true,
       Rank::Clock,
       "the station's clock was uncertain",
       "ages and latencies are known only to " + readable(s.clock_error_ms.p99) + " ms",
       "find what delays the packets in one direction only; the bound is half of a round trip",
       {Measurement::ClockError, std::max(path.clock_error_ms, like.clock_error_ms)}},
      {"ticks that are not in the recording", missing, 0.1, "%", true, Rank::Recording, "the recording has gaps",
       readable(missing) + " % of the ticks are not in the recording, so that it may lack a force; the hand was not "
                           "affected",
       "record at the server's own machine, or keep the ticks at the station"}};
}

}  // namespace

double late_by_the_timer_percent(const Summary& s) {
  return s.idle_timer ? std::min(100.0 * s.idle_timer->missed_share(), missed_percent(s)) : 0.0;
}

std::vector<Check> checks_of(const Summary& s, const PathLimits& path) {
  std::vector<Check> all = safety_checks(s);
  const auto add = [&](std::vector<Check> more) {
    for (Check& check : more) all.push_back(std::move(check));
  };
  add(loop_checks(s));
  add({latency_check(s, &Quantiles::p50, "p50", "a typical depth image", path.latency_p50_ms),
       latency_check(s, &Quantiles::p99, "p99", "one depth image in a hundred", path.latency_p99_ms)});
  add(image_checks(s, path));
  add({depth_check(s)});
  add(other_checks(s, path));
  return all;
}

}  // namespace telepalp::report
