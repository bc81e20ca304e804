#include "clients/report/compare/settings.h"

#include <algorithm>
#include <sstream>

#include "proto/words/counted.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

std::string software(const Run& run) {
  std::string text = run.info.program;
  if (!run.info.version.empty()) text += " " + run.info.version;
  if (!run.info.commit.empty()) text += ", commit " + run.info.commit;
  return text;
}

/// The line `name: "…"` of a scene file, or its number of lines.
std::string scene_name(const std::string& scene) {
  if (scene.empty()) return {};
  std::istringstream lines(scene);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("name:")) {
      const std::size_t from = line.find('"'), to = line.rfind('"');
      if (from != std::string::npos && to > from) return line.substr(from + 1, to - from - 1);
    }
  return "unnamed scene of " +
         counted(static_cast<std::uint64_t>(std::count(scene.begin(), scene.end(), '\n')), "line", "lines");
}

std::string scene_words(const Run& run, const Run& other) {
  const std::string apart = first_line_apart(run.info.scene, other.info.scene);
  return scene_name(run.info.scene) + (apart.empty() || other.info.scene.empty() ? "" : "; first difference: " + apart);
}

std::string camera_words(const Session& session) {
  const auto found = session.calibrations.find("camera_depth");
  if (found == session.calibrations.end() || found->second.k_size() != 9) return {};
  const foxglove::CameraCalibration& camera = found->second;
  return std::to_string(camera.width()) + "x" + std::to_string(camera.height()) + " pixels, focal lengths in x and y " +
         plot::number(camera.k(0)) + " and " + plot::number(camera.k(4)) + " px, principal point at " +
         plot::number(camera.k(2)) + ", " + plot::number(camera.k(5)) + " px";
}

std::string timer_words(const Session& session) {
  if (!session.station_stats) return {};
  return session.station_stats->realtime() ? "real-time priority and locked memory"
                                           : "no real-time priority or no locked memory";
}

std::string effects_words(const Session& session) {
  std::string text;
  if (session.station_stats)
    for (const msg::EffectCost& cost : session.station_stats->bill()) text += (text.empty() ? "" : ", ") + cost.name();
  return text;
}

std::string replay_text(const Run& run, std::string ReplayFacts::*member) {
  return run.replay ? *run.replay.*member : std::string();
}

std::string setting_of_surface(const Session& session) {
  return session.surfaces.empty() ? std::string() : session.surfaces.back().setting();
}

std::string depth_words(const Run& run) {
  const wire::DepthFidelity& depth = run.summary.depth;
  return depth.mode.empty() && !depth.moved ? std::string() : wire::in_words(depth);
}

}  // namespace

std::string first_line_apart(const std::string& text, const std::string& other) {
  std::istringstream own(text), others(other);
  std::string line, beside;
  for (int number = 1;; ++number) {
    const bool more = static_cast<bool>(std::getline(own, line));
    const bool more_beside = static_cast<bool>(std::getline(others, beside));
    if (!more && !more_beside) return {};
    if (!more) return "the scene file ends before line " + std::to_string(number);
    if (!more_beside || line != beside) return "line " + std::to_string(number) + ": " + line;
  }
}

std::vector<Setting> settings_of(const Run& a, const Run& b) {
  std::vector<Setting> all{
      {"network", replay_text(a, &ReplayFacts::network), replay_text(b, &ReplayFacts::network)},
      {"software", software(a), software(b)},
      {"source of the images", source_of(a.session), source_of(b.session)},
      {"recorded from (server or file)", a.session.origin, b.session.origin},
      {"scene", scene_words(a, b), scene_words(b, a)},
      {"haptic effects", effects_words(a.session), effects_words(b.session)},
      {"hand in the replay", replay_text(a, &ReplayFacts::hand), replay_text(b, &ReplayFacts::hand)},
      {"random seed of the replay", replay_text(a, &ReplayFacts::seed), replay_text(b, &ReplayFacts::seed)},
      {"depth coding", depth_words(a), depth_words(b)},
      {"surface setting", setting_of_surface(a.session), setting_of_surface(b.session)},
      {"depth camera", camera_words(a.session), camera_words(b.session)},
      {"station's computer", timer_words(a.session), timer_words(b.session)},
      {"person or account that recorded", a.info.recorded_by, b.info.recorded_by},
  };
  std::erase_if(all, [](const Setting& setting) { return setting.a.empty() && setting.b.empty(); });
  std::stable_partition(all.begin(), all.end(), [](const Setting& setting) { return setting.differs(); });
  return all;
}

}  // namespace telepalp::report
