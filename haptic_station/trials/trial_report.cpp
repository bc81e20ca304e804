#include "haptic_station/trials/trial_report.h"

#include <cstdio>

#include "haptic_station/trials/cylinder_paths.h"
#include "proto/words/phase_names.h"
#include "support/plot/chart.h"
#include "support/plot/number.h"
#include "support/plot/palette.h"
#include "support/program/files/whole_file.h"

namespace telepalp::trials {
namespace {

using control::Phase;

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Quotes without escaping, because the texts are constants of telepalp.
std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// As in the report of a session (clients/report).
std::string_view color_of(Phase phase) {
  switch (phase) {
    case Phase::InBody:
      return plot::kOrange;
    case Phase::BodyToPlane:
      return plot::kGreen;
    case Phase::OutBody:
      return plot::kSky;
    case Phase::PlaneToBody:
      return plot::kYellow;
    case Phase::ObjectLateral:
      return plot::kBlue;
    case Phase::AroundObject:
      return plot::kVermilion;
    case Phase::ObjectUpper:
      return plot::kPurple;
    case Phase::Released:
      return plot::kGrey;
    case Phase::Faulted:
      return plot::kBlack;
  }
  return plot::kBlack;
}

plot::Band band_of(Phase phase, double from_s, double to_s) {
  return {.from = from_s,
          .to = to_s,
          .color = std::string(color_of(phase)),
          .name = std::string(phase_name(static_cast<int>(phase)).words),
          .mark = std::to_string(control::plotted_number(phase))};
}

std::vector<plot::Band> bands_of(const TrialResult& result) {
  std::vector<plot::Band> out;
  double from_s = 0.0;
  Phase phase = Phase::Released;
  for (const Transition& change : result.transitions) {
    out.push_back(band_of(phase, from_s, change.time_s));
    from_s = change.time_s;
    phase = change.to;
  }
  if (!result.samples.empty()) out.push_back(band_of(phase, from_s, result.samples.back().time_s));
  return out;
}

template <class Of>
std::vector<double> each(const TrialResult& result, Of&& of) {
  std::vector<double> out;
  for (const TrialSample& sample : result.samples) out.push_back(of(sample));
  return out;
}

template <class Of>
plot::Series over_time(const TrialResult& result, const char* name, std::string_view color, Of&& of) {
  return {.name = name,
          .x = each(result, [](const TrialSample& s) { return s.time_s; }),
          .y = each(result, of),
          .color = std::string(color)};
}

plot::Chart chart_over_time(const TrialResult& result, const char* title, const char* unit,
                            std::vector<plot::Series> series) {
  return {.title = title,
          .x = {.label = "time [s]"},
          .y = {.label = unit},
          .series = std::move(series),
          .bands = bands_of(result)};
}

plot::Chart force_against_indentation(const TrialResult& result) {
  plot::Series inside{
      .name = "in contact", .x = {}, .y = {}, .color = std::string(plot::kVermilion), .style = plot::Style::Path};
  for (const TrialSample& s : result.samples)
    if (control::is_inside(s.phase)) {
      inside.x.push_back(s.indentation_m * 1e3);
      inside.y.push_back(s.force.N.norm());
    }
  return {
      .title = "force against indentation", .x = {.label = "|d| [mm]"}, .y = {.label = "|F| [N]"}, .series = {inside}};
}

std::vector<plot::Chart> charts_of(const TrialResult& result) {
  std::vector<plot::Chart> charts;
  charts.push_back(chart_over_time(
      result, "height", "y [mm]",
      {over_time(result, "hand", plot::kGrey, [](const TrialSample& s) { return s.hand.m.y() * 1e3; }),
       over_time(result, "end-effector", plot::kBlue, [](const TrialSample& s) { return s.device.m.y() * 1e3; }),
       over_time(result, "displayed hand", plot::kGreen, [](const TrialSample& s) { return s.shown.m.y() * 1e3; })}));
  charts.push_back(chart_over_time(
      result, "along x", "x [mm]",
      {over_time(result, "hand", plot::kGrey, [](const TrialSample& s) { return s.hand.m.x() * 1e3; }),
       over_time(result, "end-effector", plot::kBlue, [](const TrialSample& s) { return s.device.m.x() * 1e3; })}));
  charts.push_back(chart_over_time(
      result, "force", "|F| [N]",
      {over_time(result, "force", plot::kVermilion, [](const TrialSample& s) { return s.force.N.norm(); })}));
  if (const plot::Chart paths = cylinder_paths(result); !paths.series.empty()) charts.push_back(paths);
  charts.push_back(force_against_indentation(result));
  return charts;
}

std::string json_of(const TrialResult& result) {
  const TrialFigures& f = result.figures;
  std::string out = "  {\"trial\":" + quoted(title(result.trial)) + ",\"surface\":" + quoted(result.surface) +
                    ",\"force_step_N\":" + number(f.worst_force_step_N) +
                    ",\"jump_mm\":" + number(f.worst_jump_m * 1e3) +
                    ",\"speed_jump_mm_per_s\":" + number(f.worst_speed_jump_m_per_s * 1e3) +
                    ",\"force_N\":{\"max\":" + number(f.most_force_N) + "},\"contact_s\":" + number(f.contact_s) +
                    ",\"least_passivity_mJ\":" + number(f.least_passivity_J * 1e3) + ",\"entries\":{";
  bool first = true;
  for (std::size_t i = 0; i < f.entries.size(); ++i) {
    if (f.entries[i] == 0) continue;
    out += (first ? "" : ",") + quoted(name(static_cast<Phase>(i + 1))) + ":" + std::to_string(f.entries[i]);
    first = false;
  }
  out += "},\"transitions\":[";
  for (const Transition& change : result.transitions)
    out += (out.back() == '[' ? "" : ",") + std::string("{\"time_s\":") + number(change.time_s) +
           ",\"from\":" + quoted(name(change.from)) + ",\"to\":" + quoted(name(change.to)) +
           ",\"on\":" + quoted(name(change.on)) + "}";
  return out + "]}";
}

}  // namespace

std::string to_json(std::span<const TrialResult> results) {
  std::string out = "{\"trials\":[\n";
  for (const TrialResult& result : results) out += (&result == results.data() ? "" : ",\n") + json_of(result);
  return out + "\n]}\n";
}

std::string to_html(std::span<const TrialResult> results) {
  std::string out =
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>telepalp: the four trials</title>\n"
      "<style>body{font-family:sans-serif;max-width:940px;margin:2em auto}"
      "td,th{text-align:right;padding:2px 10px}</style>\n<h1>The four trials</h1>\n<p>A simulated hand "
      "performs the trials on a simulated device. The haptic loop is the one that drives a real device; its time is "
      "computed, not real. Surface plane: a level skin that is known exactly, so that errors come from the controller "
      "alone. Surface camera: a belly, built from "
      "the depth images of a Kinect-like camera with noise and steps of depth. There is no network. Positions are in "
      "the haptic base's frame: y points up, and the origin is the middle of the skin. |d| is the indentation, |F| "
      "the force. The colours and numbers in the charts name the controller's phase; numbers below 4 are those of "
      "paper S1 (docs/sources.md). The phases 4 and 5 have no force.</p>\n";
  for (const TrialResult& result : results) {
    const TrialFigures& f = result.figures;
    out += "<h2>" + std::string(title(result.trial)) + ", surface: " + result.surface + "</h2>\n<p>largest force " +
           plot::readable(f.most_force_N) + " N, largest change of force " + plot::readable(f.worst_force_step_N) +
           " N in a tick, largest jump of the end-effector at a phase change " + plot::readable(f.worst_jump_m * 1e3) +
           " mm, " + plot::readable(f.contact_s) + " s in contact, " + plot::readable(f.unfelt_s) +
           " s inside the true skin without force</p>\n";
    out += plot::to_svg(charts_of(result));
  }
  return out + "</html>\n";
}

Result<void> write_report(std::span<const TrialResult> results, const std::filesystem::path& folder) {
  constexpr auto kReaders = program::Readers::Anyone;  // the report has no data of a patient
  if (const Result<void> made = program::make_folder(folder, kReaders); !made) return made;
  if (const Result<void> json = program::write_whole_file(folder / "report.json", to_json(results), kReaders); !json)
    return json;
  return program::write_whole_file(folder / "report.html", to_html(results), kReaders);
}

}  // namespace telepalp::trials
