#include "haptic_station/trials/trial_report.h"

#include <cstdio>

#include "haptic_station/trials/cylinder_paths.h"
#include "haptic_station/trials/figure.h"
#include "support/program/files/whole_file.h"

namespace telepalp::trials {
namespace {

using control::Phase;

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// A number with three digits, for the reader.
std::string readable(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}  // without escaping: the texts are telepalp's own names

const char* color_of(Phase phase) {
  switch (phase) {
    case Phase::InBody:
      return "#fde0dd";
    case Phase::BodyToPlane:
      return "#fff7cc";
    case Phase::OutBody:
      return "#e5f5e0";
    case Phase::PlaneToBody:
      return "#deebf7";
    case Phase::ObjectLateral:
      return "#e7d4f0";
    case Phase::AroundObject:
      return "#f3e6f5";
    case Phase::ObjectUpper:
      return "#d5c0e6";
    case Phase::Released:
    case Phase::Faulted:
      return "#eeeeee";
  }
  return "#ffffff";
}

std::vector<Stretch> stretches_of(const TrialResult& result) {
  std::vector<Stretch> out;
  double from_s = 0.0;
  Phase phase = Phase::Released;
  for (const Transition& change : result.transitions) {
    out.push_back({from_s, change.time_s, color_of(phase)});
    from_s = change.time_s;
    phase = change.to;
  }
  if (!result.samples.empty()) out.push_back({from_s, result.samples.back().time_s, color_of(phase)});
  return out;
}

template <class Of>
std::vector<double> each(const TrialResult& result, Of&& of) {
  std::vector<double> out;
  for (const TrialSample& sample : result.samples) out.push_back(of(sample));
  return out;
}

std::vector<Figure> figures_of(const TrialResult& result) {
  const std::vector<double> time = each(result, [](const TrialSample& s) { return s.time_s; });
  std::vector<Figure> figures;
  figures.push_back(
      {"height",
       "time [s]",
       "y [mm]",
       {{"hand", "#888888", time, each(result, [](const TrialSample& s) { return s.hand.m.y() * 1e3; })},
        {"end-effector", "#1f77b4", time, each(result, [](const TrialSample& s) { return s.device.m.y() * 1e3; })},
        {"shown hand", "#2ca02c", time, each(result, [](const TrialSample& s) { return s.shown.m.y() * 1e3; })}},
       stretches_of(result)});
  figures.push_back(
      {"along x",
       "time [s]",
       "x [mm]",
       {{"hand", "#888888", time, each(result, [](const TrialSample& s) { return s.hand.m.x() * 1e3; })},
        {"end-effector", "#1f77b4", time, each(result, [](const TrialSample& s) { return s.device.m.x() * 1e3; })}},
       stretches_of(result)});
  figures.push_back({"force",
                     "time [s]",
                     "|F| [N]",
                     {{"force", "#d62728", time, each(result, [](const TrialSample& s) { return s.force.N.norm(); })}},
                     stretches_of(result)});
  Curve curve{"in body", "#d62728", {}, {}};
  for (const TrialSample& s : result.samples)
    if (control::is_inside(s.phase)) {
      curve.x.push_back(s.indentation_m * 1e3);
      curve.y.push_back(s.force.N.norm());
    }
  if (const Figure paths = cylinder_paths(result); !paths.curves.empty()) figures.push_back(paths);
  figures.push_back({"force against indentation", "|d| [mm]", "|F| [N]", {curve}, {}});
  return figures;
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
      "<style>body{font-family:sans-serif;max-width:940px;margin:2em auto}span{padding:2px 6px;margin-right:6px}"
      "td,th{text-align:right;padding:2px 10px}</style>\n<h1>The four trials</h1>\n<p>Run in virtual time by a "
      "simulated hand on a simulated device, through the live haptic loop. Plane: a level skin that is known exactly, "
      "so that the controller alone is seen. Camera: a belly under a Kinect-like camera, with noise and disparity "
      "steps, through the surface builder. There is no network.</p>\n<p>";
  for (std::size_t i = 0; i < control::kPhaseCount; ++i) {
    const auto phase = static_cast<Phase>(i + 1);
    out += "<span style=\"background:" + std::string(color_of(phase)) + "\">" + name(phase) +
           " (s<sub>f</sub> = " + std::to_string(control::plotted_number(phase)) + ")</span> ";
  }
  out += "</p>\n";
  for (const TrialResult& result : results) {
    const TrialFigures& f = result.figures;
    out += "<h2>" + std::string(title(result.trial)) + ", on the " + result.surface + "</h2>\n<p>largest force " +
           readable(f.most_force_N) + " N, largest step " + readable(f.worst_force_step_N) +
           " N a tick, end-effector jump at transitions " + readable(f.worst_jump_m * 1e3) + " mm, " +
           readable(f.contact_s) + " s in contact, " + readable(f.unfelt_s) + " s in the true skin unfelt</p>\n";
    for (const Figure& figure : figures_of(result)) out += to_svg(figure);
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
