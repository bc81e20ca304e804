#include "clients/report/compare/settings.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "clients/report/summary/provenance.h"
#include "clients/report/summary/scene_difference.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

// Names in report.json of the settings that a recorded session states in its messages.
constexpr const char* kSurface = "surface_setting";
constexpr const char* kDepth = "depth_coding";
constexpr const char* kCamera = "depth_camera";

/// The network of a replay, without its seed, which is a setting of its own.
std::string network_of(const Run& run) {
  if (!run.replay) return {};
  const std::string& text = run.replay->network;
  return text.substr(0, text.find("; seed "));
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

std::string in_replay(const Run& run, const char* name) {
  if (!run.replay) return {};
  const auto found = run.replay->settings.find(name);
  return found == run.replay->settings.end() ? std::string() : found->second;
}

/// The setting that the surfaces name; a replay's surfaces name none, its report does.
std::string surface_words(const Run& run) {
  const Session& session = run.session;
  const std::string named = session.surfaces.empty() ? std::string() : session.surfaces.back().setting();
  return named.empty() ? in_replay(run, kSurface) : named;
}

std::string depth_words(const Run& run) {
  const wire::DepthFidelity& depth = run.summary.depth;
  if (depth.mode.empty() && !depth.moved) return in_replay(run, kDepth);
  return wire::in_words(depth);
}

std::string camera_of(const Run& run) {
  const std::string named = camera_words(run.session);
  return named.empty() ? in_replay(run, kCamera) : named;
}

/// The other settings of replays. A run without them (not a replay, or of an older version) states nothing.
void add_replay_settings(std::vector<Setting>& all, const Run& a, const Run& b) {
  std::set<std::string> names;
  for (const Run* run : {&a, &b})
    if (run->replay)
      for (const auto& [name, value] : run->replay->settings) names.insert(name);
  for (const char* shown : {kSurface, kDepth, kCamera}) names.erase(shown);
  for (const std::string& name : names) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    all.push_back({words, in_replay(a, name.c_str()), in_replay(b, name.c_str())});
  }
}

}  // namespace

std::vector<Setting> settings_of(const Run& a, const Run& b) {
  const bool both = !a.info.scene.empty() && !b.info.scene.empty();
  const std::string said = both ? scene_difference(a.info.scene, b.info.scene) : "";
  std::vector<Setting> all{
      {"network", network_of(a), network_of(b)},
      {"software", software_of(a.info), software_of(b.info)},
      {"server's software", provenance_of(a.session).server, provenance_of(b.session).server},
      {"station's software", provenance_of(a.session).station, provenance_of(b.session).station},
      {"source of the images", source_of(a.session), source_of(b.session)},
      {"recorded from (server or file)", a.session.origin, b.session.origin},
      {"scene", scene_name(a.info.scene), scene_name(b.info.scene) + (said.empty() ? "" : "; " + said)},
      {"haptic effects", effects_words(a.session), effects_words(b.session)},
      {"hand in the replay", replay_text(a, &ReplayFacts::hand), replay_text(b, &ReplayFacts::hand)},
      {"random seed of the replay", replay_text(a, &ReplayFacts::seed), replay_text(b, &ReplayFacts::seed)},
      {"depth coding", depth_words(a), depth_words(b)},
      {"surface setting", surface_words(a), surface_words(b)},
      {"depth camera", camera_of(a), camera_of(b)},
      {"station's computer", timer_words(a.session), timer_words(b.session)},
      {"person or account that recorded", a.info.recorded_by, b.info.recorded_by},
  };
  add_replay_settings(all, a, b);
  std::erase_if(all, [](const Setting& setting) { return setting.a.empty() && setting.b.empty(); });
  std::stable_partition(all.begin(), all.end(), [](const Setting& setting) { return setting.differs(); });
  return all;
}

}  // namespace telepalp::report
