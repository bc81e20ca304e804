#include "clients/report/summary/provenance.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <sstream>

#include "proto/words/counted.h"

namespace telepalp::report {
namespace {

/// Session time is the server's wall clock; the virtual time of a replay begins near 0.
std::string date_of(std::int64_t at_ns) {
  constexpr std::int64_t kYear2001_ns = 978'307'200'000'000'000;
  if (at_ns < kYear2001_ns) return {};
  const std::time_t seconds = static_cast<std::time_t>(at_ns / 1'000'000'000);
  std::tm parts{};
  std::array<char, 40> text{};
  if (::gmtime_r(&seconds, &parts) == nullptr) return {};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &parts);
  return {text.data(), length};
}

/// The scene that the station says it runs: "the control loop runs scene NAME …". Empty: no such event.
std::string scene_of_station(const Session& session) {
  constexpr std::string_view kBefore = "the control loop runs scene ";
  for (const msg::StationEvent& event : session.events)
    if (event.kind() == msg::EVENT_KIND_SCENE && event.text().starts_with(kBefore))
      return event.text().substr(kBefore.size(), event.text().find(' ', kBefore.size()) - kBefore.size());
  return {};
}

/// What a program states of itself; in a replay, one program stands for server and station.
std::string or_replayed(const Session& session, const std::string& stated) {
  const bool replayed = stated.empty() && session.info.program == "telepalp-replay";
  return replayed ? "simulated by " + software_of(session.info) : stated;
}

}  // namespace

std::string software_of(const wire::SessionInfo& info) {
  std::string text = info.program;
  if (!info.version.empty()) text += " " + info.version;
  if (!info.commit.empty()) text += ", commit " + info.commit;
  return text;
}

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

Provenance provenance_of(const Session& session) {
  const std::string scene = scene_name(session.info.scene);
  return {.date = date_of(session.first_ns.value_or(0)),
          .scene = scene.empty() ? scene_of_station(session) : scene,
          .software = software_of(session.info),
          .recorder = session.info.recorded_by,
          .consent = session.info.consent,
          .server = or_replayed(session, session.server_software),
          .station = or_replayed(session, session.station_stats ? session.station_stats->software() : "")};
}

}  // namespace telepalp::report
