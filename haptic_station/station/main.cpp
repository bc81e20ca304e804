#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/effects/presets/tissue_presets.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/commands/calibrate_command.h"
#include "haptic_station/station/commands/hand_over.h"
#include "haptic_station/station/commands/scene_command.h"
#include "haptic_station/station/commands/tissue_command.h"
#include "haptic_station/station/faults/rearm_command.h"
#include "haptic_station/station/rigs/calibrated_scene.h"
#include "haptic_station/station/rigs/journaled_scene.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "haptic_station/station/rigs/scene_parts.h"
#include "haptic_station/station/signals/station_signals.h"
#include "haptic_station/station/station.h"
#include "haptic_station/station/threads/journal_thread.h"
#include "haptic_station/surface/pcl_search/pcl_indexes.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/trials/trials_command.h"
#include "support/program/address.h"
#include "support/program/default_ports.h"
#include "support/program/ending.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/patience.h"

namespace {

using namespace telepalp;

program::Usage usage() {
  return {.program = "telepalp-station",
          .purpose = "turns depth images from the server into a surface, and computes the force on the hand at 2 kHz",
          .positional = "",
          .options = {{"connect", "SERVER", "HOST[:PORT], or SITE@HOST[:PORT]", program::kServerAddress},
                      {"key", "FILE", "your key file, for a server on another machine"},
                      {"accept-touch", "", "take the permission to palpate when you are offered it"},
                      {"scene", "FILE|NAME", "scene file, or one of telepalp's own scenes", "palpation"},
                      {"surface", "NAME|model:FILE", "surface setting or patient model; default: the scene's"},
                      {"depth", "WHAT", "whole, or window: exact only around the hand", "whole"},
                      {"anyway", "", "accept a model that is too coarse or too noisy"},
                      {"calibration", "FILE", "calibration file (telepalp-station calibrate)"},
                      program::patience_option("seconds to wait for the first image; 0: for ever"),
                      {"device", station::kDeviceWords, "the haptic device", "simulated"},
                      {"tracker", station::kTrackerWords,
                       "the hand tracker; held: the hand grips the device; browser: a hand in the viewer", "simulated"},
                      {"check", "", "check the scene, list its effects, and exit"},
                      {"control", "PATH", "socket for rearm and hand-over; none: no socket"},
                      {"state-dir", "DIR", "folder for recordings of faults; default: the user's"},
                      {"journal", "FILE", "keep each input and force exactly (docs/replay.md)"},
                      {"seconds", "S", "run time; 0: until Ctrl-C", "0"},
                      {"realtime", "require|prefer", "require: fail without real-time priority", "prefer"}},
          .example = "telepalp-station --connect 127.0.0.1:7400 --seconds 10",
          .commands = {
              {"trials", "", "run four palpation trials with a simulated hand", trials::trials_command},
              {"calibrate", "", "measure the transforms of camera, tracker and device", station::calibrate_command},
              {"scene", "", "check a scene file, measure its computing time, draw it", station::scene_command},
              {"rearm", "", "end a station's fault, so that it gives force again", station::rearm_command},
              {"hand-over", "", "hand over or accept the permission to palpate", station::hand_over_command},
              {"tissue", "", "fit the skin's stiffness to a compression test", station::tissue_command}}};
}

Result<station::Realtime> realtime_of(const std::string& word) {
  if (word == "require") return station::Realtime::Require;
  if (word == "prefer") return station::Realtime::Prefer;
  return Error{
      .what = "'" + word + "' is neither require nor prefer", .where = "--realtime", .fix = "give one of them"};
}

std::filesystem::path control_of(const program::Arguments& arguments) {
  if (!arguments.has("control")) return station::own_control_path();
  const std::string path = arguments.text("control");
  return path == "none" ? "" : path;
}

Result<station::StationOptions> options_of(const program::Arguments& arguments) {
  const Result<program::Address> server = program::parse_server(arguments.text("connect"), "--connect");
  if (!server) return server.error();
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e6);
  if (!seconds) return seconds.error();
  const Result<program::Patience> patience = program::patience_of(arguments);
  if (!patience) return patience.error();
  const Result<station::Realtime> realtime = realtime_of(arguments.text("realtime"));
  if (!realtime) return realtime.error();
  const std::string depth = arguments.text("depth");
  if (depth != "whole" && depth != "window")
    return Error{.what = "'" + depth + "' is neither whole nor window", .where = "--depth", .fix = "give one of them"};
  return station::StationOptions{.host = server->host,
                                 .port = server->port,
                                 .site = server->site,
                                 .accepts_touch = arguments.has("accept-touch"),
                                 .seconds = *seconds,
                                 .patience = *patience,
                                 .realtime = *realtime,
                                 .control = control_of(arguments),
                                 .control_is_asked_for = arguments.has("control"),
                                 .state_folder = arguments.has("state-dir")
                                                     ? std::filesystem::path(arguments.text("state-dir"))
                                                     : station::default_state_folder(),
                                 .asks_window = depth == "window"};
}

/// Checks the words of --surface, before any file is read.
Result<void> check_surface(const std::string& word) {
  scenes::Scene scene;
  if (const Result<void> asked = station::ask_for_surface(word, scene); !asked) return asked.error();
  if (scene.surface.empty()) return {};
  if (const auto settings = surface::surface_settings(scene.surface); !settings) return settings.error();
  return {};
}

/// Reads the scene, and replaces its transforms by those of this site's calibration file, if one is given.
Result<scenes::Scene> read_calibrated(const std::filesystem::path& scene_file, const program::Arguments& arguments) {
  Result<scenes::Scene> scene = scenes::read_scene(scene_file);
  if (scene)
    if (const auto asked = station::ask_for_surface(arguments.text("surface"), *scene); !asked) return asked.error();
  if (!scene || !arguments.has("calibration")) return scene;
  return station::calibrated(std::move(scene).value(), arguments.text("calibration"));
}

int check(const Result<scenes::Scene>& scene, const std::filesystem::path& scene_file, bool anyway) {
  if (!scene) return program::fail(scene.error());
  station::print_warnings(*scene);
  const Result<station::SceneParts> parts = station::read_parts(*scene, scene_file, anyway);
  if (!parts) return program::fail(parts.error());
  const std::optional<station::StaticPatient>& model = parts->model;
  const std::string touched = model ? std::to_string(model->snapshot->points) + " points of " + scene->model->file +
                                          (model->remarks.empty() ? "" : " (" + model->remarks + ")")
                                    : "setting " + parts->surface.name;
  std::printf("%s; surface: %s\n", station::validity_in_words(*scene).c_str(), touched.c_str());
  if (const effects::SkinSettings* skin = scene->skin(); skin != nullptr)
    if (const effects::TissuePreset* tissue = skin->tissue)
      std::printf(
          "skin: tissue %s, fitted to the compression test of the silicone %s; RMS error %.1f %% of the largest load\n",
          tissue->name.data(), tissue->material.data(), 100.0 * tissue->rms_error_share);
  const double effects_N_per_m = core::bank_of(scene->effects).stiffest_N_per_m(scene->control.limits.peak_N);
  if (const control::VirtualCoupling coupling(scene->control.coupling, effects_N_per_m); coupling.engaged())
    std::printf(
        "the stiffness of all effects together is %.0f N/m; the hand feels at most %.0f N/m, the largest stiffness "
        "that the device displays stably\n",
        effects_N_per_m, coupling.stiffness_N_per_m());
  return program::kDone;
}

/// Reads the scene and the files that it names.
Result<station::LoadedScene> load(const std::filesystem::path& scene_file, const program::Arguments& arguments,
                                  bool anyway) {
  Result<scenes::Scene> scene = read_calibrated(scene_file, arguments);
  if (!scene) return scene.error();
  station::print_warnings(*scene);
  Result<station::SceneParts> parts = station::read_parts(*scene, scene_file, anyway);
  if (!parts) return parts.error();
  return station::LoadedScene{std::move(scene).value(), std::move(parts).value()};
}

/// Opens the journal of the scene with that number, from 1; a null pointer: none is kept.
using OpenJournal = std::function<Result<std::unique_ptr<station::JournalThread>>(int, const station::LoadedScene&)>;

/// A journal and its file, for the station that runs with the `count`-th scene of this program.
Result<std::unique_ptr<station::JournalThread>> open_journal(std::filesystem::path file, int count,
                                                             const station::LoadedScene& loaded,
                                                             const std::filesystem::path& scene_file) {
  if (loaded.parts.model)
    return Error{.what = "a journal cannot be kept, because the scene's patient is a model from a file",
                 .where = "--journal",
                 .fix = "leave out --journal, or give a scene whose patient_surface is streamed"};
  if (core::has_slow_stage(loaded.scene.effects))
    return Error{.what = "a journal cannot be kept, because a slow stage computes an effect of the scene",
                 .where = "--journal",
                 .fix = "leave out --journal, and record the session by telepalp-record"};
  if (count > 1) file.replace_filename(file.stem().string() + "-" + std::to_string(count) + file.extension().string());
  return station::JournalThread::open(file, station::journal_header(loaded.scene, scene_file, loaded.parts.surface));
}

Result<void> close_journal(station::JournalThread* journal) {
  if (journal == nullptr) return {};
  const Result<void> closed = journal->close();
  const msg::JournalEnd& end = journal->end();
  const std::uint64_t lost = end.ticks_lost() + end.runs_lost();
  program::log("telepalp-station",
               "the journal holds " + std::to_string(end.ticks()) + " ticks and " + std::to_string(end.runs()) +
                   " runs of the stages" +
                   (lost == 0 ? "" : "; " + std::to_string(lost) + " more are lost, because the disk is too slow"));
  return closed;
}

/// Runs the station with one scene. Error: the reason why it could not work.
Result<void> run_with(station::LoadedScene loaded, station::StationSignals& signals, station::StationOptions options,
                      const station::RigChoice& rig_choice, station::JournalThread* journal) {
  options.model = std::move(loaded.parts.model);
  options.journal = journal;
  Result<station::ConnectedRig> rig = station::connect_rig(rig_choice, loaded.scene);
  if (!rig) return rig.error();
  boost::asio::io_context io{1};
  signals.keep_end();
  station::Station station(io, signals, options, loaded.scene, loaded.parts.surface, std::move(loaded.parts.trace),
                           std::move(rig).value());
  return station.run();
}

/// Runs the station with its first scene, then with each accepted scene that an operator asks for by SIGHUP.
int run(const station::StationOptions& options, const station::StationSignals::ReadScene& read,
        const station::RigChoice& rig_choice, const OpenJournal& open_journal) {
  station::StationSignals signals(read);
  Result<station::LoadedScene> first = read();
  if (!first) return program::fail(first.error());
  std::optional<station::LoadedScene> scene = std::move(first).value();
  for (int count = 1; scene; ++count) {
    Result<std::unique_ptr<station::JournalThread>> journal = open_journal(count, *scene);
    if (!journal) return program::fail(journal.error());
    const Result<void> done = run_with(std::move(*scene), signals, options, rig_choice, journal->get());
    const Result<void> closed = close_journal(journal->get());
    if (!done) return program::fail(done.error());
    if (!closed) return program::fail(closed.error());
    scene = signals.take_scene();
    if (scene) program::log("telepalp-station", "the station starts again with the new scene " + scene->scene.name);
  }
  return program::kDone;
}

int run_asked(const program::Arguments& arguments) {
  Result<station::StationOptions> options = options_of(arguments);
  if (!options) return program::fail(options.error(), program::kAskedWrongly);
  if (const Result<void> surface = check_surface(arguments.text("surface")); !surface)
    return program::fail(surface.error(), program::kAskedWrongly);
  const Result<station::RigChoice> rig = station::read_rig_choice(arguments.text("device"), arguments.text("tracker"));
  if (!rig) return program::fail(rig.error(), program::kAskedWrongly);
  Result<std::shared_ptr<const keys::KeyFile>> key =
      keys::load_client_key(arguments.text("key"), std::chrono::system_clock::now());
  if (!key) return program::fail(key.error());
  options->key = std::move(key).value();
  const Result<std::filesystem::path> scene = scenes::find_scene(arguments.text("scene"));
  if (!scene) return program::fail(scene.error());
  const bool anyway = arguments.has("anyway");
  // telepalp-replay, which computes a journal again, has no PCL.
  if (arguments.has("journal")) surface::use_nanoflann_indexes();
  if (arguments.has("check")) return check(read_calibrated(*scene, arguments), *scene, anyway);
  return run(
      *options, [&] { return load(*scene, arguments, anyway); }, *rig,
      [&](int count, const station::LoadedScene& loaded) -> Result<std::unique_ptr<station::JournalThread>> {
        if (!arguments.has("journal")) return std::unique_ptr<station::JournalThread>();
        return open_journal(arguments.text("journal"), count, loaded, *scene);
      });
}

}  // namespace

int main(int argc, char** argv) {
  program::say_when_stopped("telepalp-station: stopped: no file was written");
  surface::use_pcl_indexes();
  return program::run_program(usage(), argc, argv, run_asked);
}
