#include "tools/replay/commands/report.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "proto/words/counted.h"
#include "support/plot/svg.h"
#include "support/program/files/whole_file.h"
#include "support/program/json.h"
#include "support/program/version.h"
#include "tools/replay/commands/settings.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

std::string number(double value, const char* form = "%.6g") {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), form, value);
  return text.data();
}

std::string assertions_text(const std::vector<Judgement>& judgements) {
  std::string text;
  for (const Judgement& judgement : judgements)
    text += (judgement.holds ? "holds: " : "FAILS: ") + judgement.text +
            (judgement.holds ? "" : "  (" + judgement.reason + ")") + "\n";
  return text;
}

void add_figures(program::Json& json, std::string_view key, const Figures& figures) {
  json.begin_object(key);
  for (const Metric& metric : metrics()) json.add(metric.name, figures.*metric.value);
  json.begin_object("latency_s");
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    json.begin_object(kLatencyStages[stage]);
    json.add("p50", figures.latency[stage].p50_s);
    json.add("p99", figures.latency[stage].p99_s);
    json.add("max", figures.latency[stage].max_s);
    json.end_object();
  }
  json.end_object();
  json.end_object();
}

void add_images(program::Json& json, const codec::DepthStreamSettings& depth, const ImageFacts& images) {
  const bool is_bounded = depth.mode == codec::DepthMode::Bounded;
  json.begin_object("images");
  json.add("coded_within_mm_at_1_m", is_bounded ? 1e3 * std::max(depth.bound.least_m, depth.bound.per_m) : 0.0);
  json.add("read", images.frames);
  json.add("fx_px", images.camera.fx);
  json.add("fy_px", images.camera.fy);
  json.add("cx_px", images.camera.cx);
  json.add("cy_px", images.camera.cy);
  json.add("mean_depth_m", images.mean_depth_m());
  json.add("depth_digest", images.depth.hex());
  if (!images.damage.empty()) json.add("damage", images.damage);
  json.end_object();
}

std::string windows_in_words(const std::vector<Window>& windows) {
  std::string text;
  for (const Window& window : windows)
    text += (text.empty() ? "from " : " and from ") + number(to_seconds(window.from)) + " s for " +
            number(to_seconds(window.length)) + " s";
  return text;
}

std::string direction_in_words(const impaired::Impairment& path) {
  std::string text = number(to_milliseconds(path.delay)) + " ms delay one way";
  if (path.jitter > Nanoseconds{0}) text += " ± " + number(to_milliseconds(path.jitter)) + " ms";
  if (path.loss > 0.0)
    text += ", " + number(100.0 * path.loss) + " % lost" +
            (path.burst_packets > 1.0 ? " in bursts of " + number(path.burst_packets) + " packets on average" : "");
  if (path.reorder > 0.0) text += ", " + number(100.0 * path.reorder) + " % reordered";
  if (path.rate_B_per_s > 0.0) text += ", " + number(path.rate_B_per_s / 125.0) + " kbit/s at most";
  return text;
}

/// A gap in the source is in both runs, so their difference does not show it.
std::string damage_text(const Request& request, const ImageFacts& images) {
  if (images.damage.empty()) return "";
  const std::string file = session_file_of(request.source);
  return "\nnote: " + request.source + ": " + images.damage + ", so images are missing in both runs. fix: " +
         (file.empty() ? "record it again" : "see telepalp-record verify " + file + ", or record it again") + "\n";
}

}  // namespace

std::string in_words(const Scenario& scenario) {
  std::string text = direction_in_words(scenario.down);
  if (const std::string up = direction_in_words(scenario.up); up != text)
    text += "; from the station to the server: " + up;
  const Faults& faults = scenario.faults;
  if (!faults.outages.empty()) text += ", outage " + windows_in_words(faults.outages);
  if (!faults.restarts.empty()) text += ", server off " + windows_in_words(faults.restarts);
  if (!faults.tracker_lost.empty()) text += ", tracker lost " + windows_in_words(faults.tracker_lost);
  if (!faults.glitches.empty()) text += ", false device position " + counted(faults.glitches.size(), "time", "times");
  if (!faults.clock_steps.empty())
    text += ", false station clock " + counted(faults.clock_steps.size(), "time", "times");
  return text + "; seed " + std::to_string(scenario.seed);
}

std::string report_text(const Request& request, const RunResults& results, const std::vector<Judgement>& judgements) {
  return "source:  " + request.source + "\nscene:   " + request.scene->name + "\nhand:    " +
         (request.recorded.empty() ? "scripted: " + std::string(name(request.scenario.hand)) : "as recorded") +
         "\nnetwork: " + in_words(request.scenario) + "\nlength:  " + number(results.seconds) + " s\n\n" +
         text_table(results.runs.front().figures, results.runs.back().figures) +
         "\ndocs/replay.md defines each metric.\n\n" +
         latency_table(results.runs.front().figures.latency, results.runs.back().figures.latency) +
         damage_text(request, results.images) + (judgements.empty() ? "" : "\n") + assertions_text(judgements);
}

std::string report_json(const Request& request, const Scenario& scenario, const RunOptions& options,
                        const RunResults& results, const std::vector<Judgement>& judgements) {
  program::Json json;
  json.begin_object();
  json.add("program", "telepalp-replay");
  json.add("version", program::version());
  json.add("commit", program::commit());
  json.add("identity", identity_of(request, scenario));
  json.add("source", request.source);
  json.add("scene", request.scene->name);
  json.add("hand", request.recorded.empty() ? name(request.scenario.hand) : "recorded");
  json.add("network", in_words(scenario));
  json.add("seed", scenario.seed);
  json.add("seconds", results.seconds);
  add_settings(json, request, scenario, options, results.images);
  add_images(json, request.tape.depth, results.images);
  add_figures(json, "unimpaired", results.runs.front().figures);
  add_figures(json, "run", results.runs.back().figures);
  json.begin_list("assertions");
  for (const Judgement& judgement : judgements) {
    json.begin_object();
    json.add("text", judgement.text);
    json.add("holds", judgement.holds);
    json.add("reason", judgement.reason);
    json.end_object();
  }
  json.end_list();
  json.end_object();
  return std::move(json).finish();
}

Result<void> write_junit(const Request& request, const std::vector<Judgement>& judgements) {
  if (request.junit.empty()) return {};
  return program::write_whole_file(request.junit, junit_xml(request.source, judgements), program::Readers::Anyone);
}

std::string junit_xml(const std::string& suite, const std::vector<Judgement>& judgements) {
  std::size_t failures = 0;
  std::string cases;
  for (const Judgement& judgement : judgements) {
    cases += "  <testcase classname=\"telepalp-replay\" name=\"" + plot::escaped(judgement.text) + "\"";
    if (!judgement.holds) {
      ++failures;
      cases += ">\n    <failure message=\"" + plot::escaped(judgement.reason) + "\"/>\n  </testcase>\n";
    } else {
      cases += "/>\n";
    }
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"" + plot::escaped(suite) + "\" tests=\"" +
         std::to_string(judgements.size()) + "\" failures=\"" + std::to_string(failures) + "\">\n" + cases +
         "</testsuite>\n";
}

std::string cost_in_words(const RunResults& results, double wall_s) {
  Stopwatch total = results.tape_costs;
  for (const RunResult& run : results.runs) total.add(run.costs);
  double all_ns = 0.0;
  for (std::size_t i = 0; i < kPartCount; ++i) all_ns += static_cast<double>(total.cost_ns(static_cast<Part>(i)));
  std::string text = number(results.seconds, "%.1f") + " s of virtual time in each run took " + number(wall_s, "%.2f") +
                     " s: " + number(results.seconds / wall_s, "%.1f") + " times as fast as real time, for " +
                     std::to_string(results.runs.size()) + " runs side by side; share of the processor time by part:";
  for (std::size_t i = 0; i < kPartCount; ++i)
    text += (i == 0 ? " " : ", ") + std::string(kPartNames[i]) + " " +
            number(100.0 * static_cast<double>(total.cost_ns(static_cast<Part>(i))) / all_ns, "%.0f") + " %";
  return text;
}

}  // namespace telepalp::replay
