#include "haptic_station/station/rigs/journaled_scene.h"

#include <fstream>
#include <string>

#include "haptic_station/loop/tick.h"
#include "support/program/version.h"

namespace telepalp::station {
namespace {

constexpr int kRows = 3;
constexpr int kColumns = 4;

}  // namespace

std::string processor_model() {
  std::ifstream facts("/proc/cpuinfo");
  for (std::string line; std::getline(facts, line);)
    if (const std::size_t colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  return {};
}

msg::JournalHeader journal_header(const scenes::Scene& scene, const std::filesystem::path& file,
                                  const surface::SurfaceSettings& surface) {
  msg::JournalHeader header;
  header.set_program("telepalp-station");
  header.set_version(program::version());
  header.set_commit(program::commit());
  header.set_machine(processor_model());
  header.set_scene_file(std::filesystem::absolute(file).string());
  header.set_scene(scene.text);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      header.add_haptic_from_camera(scene.haptic_from_camera.iso(row, column));
  header.set_center_on_surface(scene.center_on_surface);
  header.set_surface_setting(surface.name);
  header.set_tick_period_ns(std::chrono::nanoseconds(loop::kTickPeriod).count());
  return header;
}

Result<JournaledScene> journaled_scene(const msg::JournalHeader& header) {
  if (header.haptic_from_camera_size() != kRows * kColumns)
    return Error{.what = "the journal's header holds no haptic_from_camera",
                 .where = header.scene_file(),
                 .fix = "record the journal again"};
  if (header.scene().empty())
    return Error{.what = "the journal's header holds no scene",
                 .where = header.scene_file(),
                 .fix = "record the journal again: an earlier telepalp-station wrote it"};
  Result<scenes::Scene> scene = scenes::parse_scene(header.scene(), header.scene_file());
  if (!scene) return scene.error();
  const Result<surface::SurfaceSettings> surface = surface::surface_settings(header.surface_setting());
  if (!surface) return surface.error();
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      scene->haptic_from_camera.iso(row, column) = header.haptic_from_camera(kColumns * row + column);
  scene->center_on_surface = header.center_on_surface();
  return JournaledScene{std::move(*scene), *surface};
}

}  // namespace telepalp::station
