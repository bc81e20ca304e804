// A station's journal against the core: live threads, then the same inputs again.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/journal/journal_replay.h"
#include "haptic_station/core/journal/journal_words.h"
#include "haptic_station/station/parts/core_threads.h"
#include "haptic_station/station/rigs/journaled_scene.h"
#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/station/rigs/scene_rig.h"
#include "haptic_station/station/threads/journal_thread.h"
#include "server/capture/synthetic/source/patient_model.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "tests/haptic_station/core/steady_now.h"
#include "tests/haptic_station/core/stream.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::core {
namespace {

using namespace std::chrono_literals;

scenes::Scene scene_named(const std::string& name) {
  return scenes::read_scene(TELEPALP_SOURCE_DIR "/haptic_station/scenes/" + name + ".scene.textproto").value();
}

/// Length of each live run [s]: long enough for a contact. TELEPALP_JOURNAL_SECONDS=60 runs the full check.
double live_seconds() {
  const char* asked = std::getenv("TELEPALP_JOURNAL_SECONDS");
  return asked == nullptr ? 4.0 : std::atof(asked);
}

/// Runs the station's own threads on a breathing patient and keeps a journal, which is returned as bytes.
std::string live_journal(const std::string& scene_name, const std::string& setting, double seconds) {
  const scenes::Scene scene = scene_named(scene_name);
  const surface::SurfaceSettings surface = *surface::surface_settings(setting);
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "run.journal";
  auto journal = station::JournalThread::open(file, station::journal_header(scene, "a.scene.textproto", surface));
  EXPECT_TRUE(journal.ok());
  station::CoreThreads threads(scene, surface::runs_in_tick(surface), station::rig_of(scene, std::nullopt),
                               journal->get());
  threads.start_surface(
      surface, [&](const DepthImage& depth, const Intrinsics& camera) { return station::placed(scene, depth, camera); },
      {.now = steady_now,
       .on_report = [](const msg::SurfaceReport&) {},
       .on_bad_frame = [](const Error& error) { ADD_FAILURE() << to_string(error); },
       .request_key_frame = [](const wire::Message&) {}});
  EXPECT_TRUE(threads.start_haptic(station::Realtime::Prefer, 0ns, steady_now).ok());
  const capture::SyntheticPatient patient(capture::open_patient("torso,motion=irregular,width=160")->patient);
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 12});
  const auto begun = std::chrono::steady_clock::now();
  loop::TickSample sample;
  for (int i = 0; i < static_cast<int>(30.0 * seconds); ++i) {
    std::this_thread::sleep_until(begun + i * kFrame);
    const SessionTime captured = steady_now();
    msg::DepthImage message;
    const DepthImage depth = patient.depth_of(patient.pose(session_time(0) + i * kFrame), captured);
    message.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
    message.set_sequence(static_cast<std::uint64_t>(i));
    message.set_width(static_cast<std::uint32_t>(depth.width));
    message.set_height(static_cast<std::uint32_t>(depth.height));
    codec::EncodedDepth encoded = encoder.encode(depth);
    message.set_data(std::move(encoded.bytes));
    threads.surface().offer({.depth = wire::make_message(wire::kCameraDepth, captured, message, encoded.key_frame),
                             .camera = patient.settings().camera,
                             .received = captured});
    while (threads.ticks().try_pop(sample)) {
    }
  }
  threads.end();
  EXPECT_TRUE((*journal)->close().ok());
  EXPECT_EQ((*journal)->end().ticks_lost() + (*journal)->end().runs_lost(), 0U);
  std::stringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

struct Replayed {
  JournalVerdict verdict;
  bool whole = false;
  double largest_N = 0.0;
};

Replayed replay(const std::string& bytes) {
  std::istringstream in(bytes);
  Result<JournalReader> reader = JournalReader::open(in, "the test's journal");
  EXPECT_TRUE(reader.ok());
  const auto journaled = station::journaled_scene(reader->header());
  EXPECT_TRUE(journaled.ok());
  const scenes::Scene& scene = journaled->scene;
  loop::HapticLoop loop({}, {scene.control, bank_of(scene.effects)});
  SurfaceStage surfaces(
      journaled->surface,
      [&scene](const DepthImage& depth, const Intrinsics& camera) { return station::placed(scene, depth, camera); },
      bank_of(scene.effects));
  CollisionStage collision;
  Replayed replayed;
  JournalReplay run(loop, surfaces, surface::runs_in_tick(journaled->surface) ? nullptr : &collision,
                    [&](const msg::JournalTick&, const Eigen::Vector3d& force_N) {
                      replayed.largest_N = std::max(replayed.largest_N, force_N.norm());
                    });
  replayed.verdict = run.run(*reader);
  replayed.whole = reader->end().has_value();
  return replayed;
}

class LiveJournal : public testing::TestWithParam<const char*> {};

TEST_P(LiveJournal, TheCoreComputesEachForcePhaseAndProxyAgainToTheLastBit) {
  const double seconds = live_seconds();
  const Replayed replayed = replay(live_journal("palpation", GetParam(), seconds));
  const JournalVerdict& verdict = replayed.verdict;
  EXPECT_FALSE(verdict.stopped) << *verdict.stopped;
  EXPECT_TRUE(replayed.whole);
  EXPECT_GT(verdict.ticks, static_cast<std::uint64_t>(500.0 * seconds));
  EXPECT_GT(verdict.surface_runs, 3U);
  EXPECT_EQ(verdict.forces_differ, 0U);
  EXPECT_EQ(verdict.phases_differ, 0U);
  EXPECT_EQ(verdict.proxies_differ, 0U);
  EXPECT_GT(replayed.largest_N, 0.05) << "nothing was touched";
  std::printf("%s: %llu ticks, %llu surface runs, %llu collision runs, largest force %.2f N, 0 differ\n", GetParam(),
              static_cast<unsigned long long>(verdict.ticks), static_cast<unsigned long long>(verdict.surface_runs),
              static_cast<unsigned long long>(verdict.collision_runs), replayed.largest_N);
}

INSTANTIATE_TEST_SUITE_P(Settings, LiveJournal, testing::Values("fast", "cloud", "paper"));

/// One short live run, for the tests that damage its journal.
const std::string& short_journal() {
  static const std::string kBytes = live_journal("skin", "fast", 3.0);
  return kBytes;
}

/// The journal again with each block as `change` returns it; nullopt leaves the block out.
std::string changed(const std::string& bytes,
                    const std::function<std::optional<msg::JournalBlock>(msg::JournalBlock)>& change) {
  std::istringstream in(bytes);
  Result<JournalReader> reader = JournalReader::open(in, "");
  std::ostringstream out;
  JournalWriter writer(out, reader->header());
  while (auto block = reader->next())
    if (const auto kept = change(std::move(*block))) writer.add(*kept);
  return out.str();
}

/// A level patient, on whom a towel of 80 x 80 pixels and 60 mm lies from the tenth image on.
DepthImage under_a_towel(int number) {
  DepthImage depth = level_patient(0);
  for (int v = 20; number >= 10 && v < 100; ++v)
    for (int u = 40; u < 120; ++u) depth.samples[static_cast<std::size_t>(v * kWidth + u)] = 840;
  return depth;
}

/// What the surface thread reports of `images` images, with the device 10 mm above the towel. The doctor accepts the
/// towel before image 20. Each run goes into `journal`.
std::vector<bool> live_reports(station::JournalThread& journal, int images) {
  LatestValue<loop::TouchableSurface> surfaces;
  LatestValue<Point<HapticBase>> device;
  device.put({{0.0, 0.0, 0.83}});
  std::atomic<int> reported{0};
  std::vector<bool> over_place(static_cast<std::size_t>(images));
  station::SurfaceWorker worker(
      *surface::surface_settings("fast"),
      [](const DepthImage&, const Intrinsics&) { return Transform<HapticBase, DepthCamera>{}; },
      {.now = steady_now,
       .on_report =
           [&](const msg::SurfaceReport& report) {
             over_place[static_cast<std::size_t>(reported)] = report.object_over_place();
             ++reported;
           },
       .on_bad_frame = [](const Error& error) { ADD_FAILURE() << to_string(error); },
       .request_key_frame = [](const wire::Message&) {}},
      surfaces, device, effects::EffectBank());
  worker.write_to(journal);
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Intra, .key_every = 1});
  for (int i = 0; i < images; ++i) {
    if (i == 20) worker.accept_object();
    const SessionTime captured = kFirstImage + i * kFrame;
    msg::DepthImage message;
    message.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
    message.set_sequence(static_cast<std::uint64_t>(i));
    message.set_width(kWidth);
    message.set_height(kHeight);
    codec::EncodedDepth encoded = encoder.encode(under_a_towel(i));
    message.set_data(std::move(encoded.bytes));
    worker.offer({.depth = wire::make_message(wire::kCameraDepth, captured, message, encoded.key_frame),
                  .camera = kCamera,
                  .received = captured});
    for (int tries = 0; tries < 10'000 && reported <= i; ++tries) std::this_thread::sleep_for(1ms);
  }
  return over_place;
}

/// The same reports from the journal's runs; `keeps_acceptance`: false takes the doctor's word out of them.
std::vector<bool> replayed_reports(const std::filesystem::path& file, bool keeps_acceptance) {
  std::ifstream in(file, std::ios::binary);
  Result<JournalReader> reader = JournalReader::open(in, "the test's journal");
  EXPECT_TRUE(reader.ok());
  SurfaceStage stage = fast_stage();
  std::vector<bool> over_place;
  while (auto block = reader->next()) {
    if (!block->has_surface_run()) continue;
    if (!keeps_acceptance) block->mutable_surface_run()->clear_accept_object();
    const StepTimes times = times_of(block->surface_run());
    const auto result = stage.run(job_of(block->surface_run()), [&](StageStep step) { return times.of(step); });
    over_place.push_back(result.report.object_over_place());
  }
  return over_place;
}

TEST(Journal, AnObjectThatTheDoctorAcceptsIsSkinOnTheSurfaceThreadAndInTheReplay) {
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "run.journal";
  auto journal = station::JournalThread::open(
      file, station::journal_header(scene_named("skin"), "a.scene.textproto", *surface::surface_settings("fast")));
  ASSERT_TRUE(journal.ok());
  const std::vector<bool> live = live_reports(**journal, 30);
  ASSERT_TRUE((*journal)->close().ok());
  EXPECT_TRUE(live[19]) << "the towel lies over the place";
  EXPECT_FALSE(live[21]) << "it is skin";
  EXPECT_FALSE(live[29]) << "and stays skin";
  EXPECT_EQ(replayed_reports(file, true), live);
  EXPECT_NE(replayed_reports(file, false), live) << "without the doctor's word, it stays an object";
}

TEST(Journal, ADevicePositionThatDiffersByAPicometreIsSeen) {
  bool done = false;
  const Replayed replayed = replay(changed(short_journal(), [&](msg::JournalBlock block) {
    if (!block.has_ticks()) return std::optional(block);
    for (msg::JournalTick& tick : *block.mutable_ticks()->mutable_ticks())
      if (tick.tick() == 3000 && !std::exchange(done, true)) tick.set_device(1, tick.device(1) + 1e-12);
    return std::optional(block);
  }));
  EXPECT_TRUE(done);
  EXPECT_GT(replayed.verdict.proxies_differ, 0U);
  EXPECT_GE(replayed.verdict.first_difference.value_or(0), 3000U);
}

TEST(Journal, AJournalThatWasCutOffIsReplayedUpToItsLastWholeBlock) {
  const std::string& whole = short_journal();
  const Replayed all = replay(whole);
  const Replayed cut = replay(whole.substr(0, whole.size() * 2 / 3));
  EXPECT_TRUE(all.whole);
  EXPECT_FALSE(cut.whole);
  EXPECT_TRUE(cut.verdict.equal()) << cut.verdict.stopped.value_or("");
  EXPECT_GT(cut.verdict.ticks, 500U);
  EXPECT_LT(cut.verdict.ticks, all.verdict.ticks);
}

TEST(Journal, ADamagedBlockEndsTheReplayInFrontOfIt) {
  std::string damaged = short_journal();
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  const Replayed replayed = replay(damaged);
  EXPECT_FALSE(replayed.whole);
  EXPECT_EQ(replayed.verdict.forces_differ, 0U);
  EXPECT_GT(replayed.verdict.ticks, 100U);
}

TEST(Journal, ASurfaceThatIsMissingIsNamedWithItsTick) {
  int runs = 0;
  const Replayed replayed = replay(changed(short_journal(), [&](msg::JournalBlock block) {
    return block.has_surface_run() && ++runs == 3 ? std::nullopt : std::optional(block);
  }));
  ASSERT_TRUE(replayed.verdict.stopped);
  EXPECT_NE(replayed.verdict.stopped->find(", which the journal does not hold"), std::string::npos)
      << *replayed.verdict.stopped;
  EXPECT_EQ(replayed.verdict.forces_differ, 0U);
}

TEST(Journal, ATickThatIsMissingEndsTheReplayInFrontOfIt) {
  const Replayed replayed = replay(changed(short_journal(), [](msg::JournalBlock block) {
    if (!block.has_ticks()) return std::optional(block);
    auto& ticks = *block.mutable_ticks()->mutable_ticks();
    for (int i = 0; i < ticks.size(); ++i)
      if (ticks[i].tick() == 3000) {
        ticks.DeleteSubrange(i, 1);
        break;
      }
    return std::optional(block);
  }));
  ASSERT_TRUE(replayed.verdict.stopped);
  EXPECT_EQ(*replayed.verdict.stopped, "tick 3000 is missing: the next one in the journal is tick 3001");
  EXPECT_EQ(replayed.verdict.ticks, 3000U);
  EXPECT_EQ(replayed.verdict.forces_differ, 0U);
}

TEST(Journal, AFileThatIsNoJournalIsRefused) {
  for (const std::string& bytes :
       {std::string(), std::string("telepalp-journal 2\n"), std::string(1000, 'x'), short_journal().substr(0, 40)}) {
    std::istringstream in(bytes);
    const Result<JournalReader> reader = JournalReader::open(in, "a.journal");
    ASSERT_FALSE(reader.ok());
    EXPECT_EQ(reader.error().where, "a.journal");
    EXPECT_FALSE(reader.error().fix.empty());
  }
}

TEST(Journal, TicksThatTheDiskIsTooSlowForAreCounted) {
  const support::TemporaryFolder folder;
  auto journal = station::JournalThread::open(folder.path() / "a", {});
  ASSERT_TRUE(journal.ok());
  for (std::uint64_t i = 0; i < 200'000; ++i)
    (*journal)->add(JournalTick{.tick = i});  // faster than any thread takes them
  ASSERT_TRUE((*journal)->close().ok());
  EXPECT_GT((*journal)->end().ticks_lost(), 0U);
  EXPECT_EQ((*journal)->end().ticks() + (*journal)->end().ticks_lost(), 200'000U);
}

TEST(Journal, AFolderThatDoesNotExistIsAnErrorWithAFix) {
  const auto journal = station::JournalThread::open("/no/such/folder/a.journal", {});
  ASSERT_FALSE(journal.ok());
  EXPECT_NE(journal.error().what.find("No such file"), std::string::npos) << journal.error().what;
}

}  // namespace
}  // namespace telepalp::core
