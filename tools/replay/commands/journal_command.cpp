#include "tools/replay/commands/journal_command.h"

#include <array>
#include <cstdio>
#include <istream>
#include <memory>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/journal/journal_replay.h"
#include "haptic_station/core/tick_stage.h"
#include "haptic_station/station/rigs/journaled_scene.h"
#include "haptic_station/station/rigs/placement.h"
#include "proto/wire/mcap/sealed/sealed_stream.h"
#include "support/program/files/whole_file.h"
#include "support/program/version.h"
#include "tools/replay/words/journal_words.h"

namespace telepalp::replay {
namespace {

using core::JournalReader;
using core::JournalVerdict;

/// The forces of both runs as text, exact: equal files are equal doubles.
class ForceFiles {
 public:
  void add(const msg::JournalTick& tick, const Eigen::Vector3d& force_N) {
    live_ += line(tick.tick(), {tick.force(0), tick.force(1), tick.force(2)});
    replayed_ += line(tick.tick(), force_N);
  }
  [[nodiscard]] Result<void> write(const std::filesystem::path& folder) const {
    if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made) return made;
    for (const auto& [name, lines] : {std::pair{"forces-live.csv", &live_}, {"forces-replayed.csv", &replayed_}})
      if (const Result<void> written =
              program::write_whole_file(folder / name, "tick,x_N,y_N,z_N\n" + *lines, program::Readers::Group);
          !written)
        return written;
    return {};
  }

 private:
  static std::string line(std::uint64_t tick, const Eigen::Vector3d& force_N) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "%llu,%.17g,%.17g,%.17g\n", static_cast<unsigned long long>(tick),
                  force_N.x(), force_N.y(), force_N.z());
    return text.data();
  }
  std::string live_;
  std::string replayed_;
};

JournalVerdict verdict_of(JournalReader& reader, const station::JournaledScene& journaled, ForceFiles* files) {
  const scenes::Scene& scene = journaled.scene;
  core::TickStage ticks(scene.control, core::bank_of(scene.effects));
  core::SurfaceStage surfaces(
      journaled.surface,
      [&scene](const DepthImage& depth, const Intrinsics& camera) { return station::placed(scene, depth, camera); },
      core::bank_of(scene.effects));
  core::CollisionStage collision;
  const bool in_tick = surface::runs_in_tick(journaled.surface);
  core::JournalReplay replay(ticks.loop(), surfaces, in_tick ? nullptr : &collision,
                             [files](const msg::JournalTick& tick, const Eigen::Vector3d& force_N) {
                               if (files != nullptr) files->add(tick, force_N);
                             });
  return replay.run(reader);
}

}  // namespace

Result<bool> run_journal(const Request& request) {
  const Result<std::unique_ptr<std::istream>> in = wire::mcap::open_stream(request.journal);
  if (!in) return in.error();
  Result<JournalReader> reader = JournalReader::open(**in, request.journal.string());
  if (!reader) return reader.error();
  const Result<station::JournaledScene> journaled = station::journaled_scene(reader->header());
  if (!journaled) return journaled.error();
  if (core::has_slow_stage(journaled->scene.effects))
    return Error{.what = "the scene has an effect that a slow stage computes, and a journal does not keep its models",
                 .where = request.journal.string(),
                 .fix = "replay the session instead: telepalp-replay --scene SCENE"};
  ForceFiles files;
  const JournalVerdict verdict = verdict_of(*reader, *journaled, request.out.empty() ? nullptr : &files);
  const ReadJournal read{.file = request.journal.string(),
                         .header = reader->header(),
                         .end = reader->end(),
                         .whole_bytes = reader->whole_bytes()};
  std::fputs(
      in_words(read, verdict, {build_of(program::version(), program::commit()), station::processor_model()}).c_str(),
      stdout);
  if (!request.out.empty())
    if (const Result<void> written = files.write(request.out); !written) return written.error();
  return verdict.equal();
}

}  // namespace telepalp::replay
