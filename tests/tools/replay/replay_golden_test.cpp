// Golden digests: small replays give the bytes that they gave when golden/digests.txt was written, on each machine.
//
// A change that is meant to alter forces, telemetry, link or codec alters the digests. Look at what changed with
// `telepalp-replay diff`, then renew them:
//
//   TELEPALP_WRITE_GOLDEN=1 ctest --test-dir build/release -R replay_golden_test
//
// ctest sets GLIBC_TUNABLES, so that the C library rounds sin, exp and others alike on processors with and without FMA.

#include <gtest/gtest.h>
#include <zstd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "support/program/files/shipped.h"
#include "tools/replay/figures/metrics.h"
#include "tools/replay/run/session_run.h"
#include "where.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

constexpr const char* kGolden = TELEPALP_SOURCE_DIR "/tests/tools/replay/golden/digests.txt";

struct SmallReplay {
  const char* name;
  const char* source;
  const char* scene;
  codec::DepthMode mode;
  Scenario scenario;
  double seconds = 3.0;
};

/// Every fault and both kinds of coding. Colour is left out, so that no digest depends on the JPEG library.
std::vector<SmallReplay> small_replays() {
  Scenario lossy;
  lossy.down = lossy.up = {
      .delay = 80ms, .jitter = 15ms, .loss = 0.05, .burst_packets = 4.0, .reorder = 0.02, .rate_B_per_s = 2.5e6};
  lossy.deadline = 180ms;
  Scenario faulty;
  faulty.down = faulty.up = {.delay = 20ms};
  faulty.faults = {.outages = {{2300ms, 300ms}},
                   .restarts = {{500ms, 300ms}},
                   .tracker_lost = {{1s, 200ms}},
                   .glitches = {{{2700ms, 4ms}, 0.02}},
                   .clock_steps = {{{1500ms, 300ms}, -60ms}}};
  faulty.seed = 7;
  return {
      {"lossy", "synthetic:torso,motion=irregular,width=320", "palpation", codec::DepthMode::Fast, lossy},
      {"faulty", "synthetic:torso,motion=cough,seed=3,width=320", "skin_sliding", codec::DepthMode::Fast, faulty},
      {"predicted", "synthetic:torso,motion=speech,width=320", "friction", codec::DepthMode::Temporal, lossy},
      {"needle", "synthetic:torso,motion=irregular,width=320", "amniocentesis", codec::DepthMode::Fast, lossy, 4.5}};
}

/// FNV-1a.
class Digest {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  }
  [[nodiscard]] std::string hex() const {
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value_));
    return text.data();
  }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// The digest of all that the station publishes and of all figures; then the largest force, for a reader.
std::string digest_of(const SmallReplay& small, int threads) {
  const Result<scenes::Scene> scene = scenes::read_scene(
      *program::shipped_file(std::string("haptic_station/scenes/") + small.scene + ".scene.textproto"));
  Result<Tape> tape = Tape::open(small.source, {.depth = {.mode = small.mode, .key_every = 12}, .color = false});
  EXPECT_TRUE(tape.ok());
  Digest digest;
  const auto add = [&](const wire::Message& message) {
    digest.add(std::string(message.topic.name) + std::to_string(to_nanoseconds(message.published)));
    digest.add(*message.payload);
  };
  const Result<RunResults> results = run_session(
      *tape, {.scene = *scene, .surface = {}, .recorded = nullptr, .seconds = small.seconds, .threads = threads},
      {{.scenario = unimpaired(small.scenario)}, {.scenario = small.scenario, .publish = add}});
  EXPECT_TRUE(results.ok()) << (results ? "" : to_string(results.error()));
  const Figures& figures = results->runs.back().figures;
  for (const Metric& metric : metrics()) {
    const double value = figures.*metric.value;
    digest.add({reinterpret_cast<const char*>(&value), sizeof value});
  }
  std::array<char, 64> force{};
  std::snprintf(force.data(), force.size(), " %.4f N", figures.force_max_N);
  return digest.hex() + force.data();
}

/// What the digests depend on beside telepalp: zstd's packets, the order of Eigen's sums, the compiler, and how the C
/// library rounds.
std::string libraries_line() {
  Digest rounding;
  for (int i = 1; i <= 4096; ++i) {
    const double x = 0.0037 * i;
    for (const double value : {std::sin(x), std::cos(x), std::tan(x), std::exp(-x), std::expm1(-x), std::log(x),
                               std::pow(x, 0.3), std::atan2(x, 1.7), std::asin(x / 16.0), std::hypot(x, 0.7)})
      rounding.add({reinterpret_cast<const char*>(&value), sizeof value});
  }
  std::ostringstream line;
  line << "# zstd " << ZSTD_versionString() << ", Eigen " << EIGEN_WORLD_VERSION << "." << EIGEN_MAJOR_VERSION << "."
       << EIGEN_MINOR_VERSION << ", compiler " << __VERSION__ << ", C library rounds as " << rounding.hex();
  return line.str();
}

TEST(ReplayGolden, SmallReplaysGiveTheGoldenBytesOnAnyNumberOfThreads) {
  std::ostringstream written;
  written << "# replay digest largest-force\n" << libraries_line() << "\n";
  std::map<std::string, std::string> now;
  for (const SmallReplay& small : small_replays()) {
    now[small.name] = digest_of(small, 1);
    EXPECT_EQ(digest_of(small, 3), now[small.name]) << small.name << ": threads change the bytes";
    EXPECT_EQ(now[small.name].find(" 0.0000 N"), std::string::npos) << small.name << ": nothing is touched";
    written << small.name << " " << now[small.name] << "\n";
  }
  if (std::getenv("TELEPALP_WRITE_GOLDEN") != nullptr) {
    std::ofstream file(kGolden);
    ASSERT_TRUE(file << written.str()) << kGolden << " cannot be written";
  }
  std::stringstream golden;
  golden << std::ifstream(kGolden).rdbuf();
  if (golden.str().find(libraries_line() + "\n") == std::string::npos)
    GTEST_SKIP() << "the digests were written with other libraries, or not by ctest. Here: " << libraries_line();
  EXPECT_EQ(golden.str(), written.str()) << "if the change is meant, renew them as this file's first lines say";
}

}  // namespace
}  // namespace telepalp::replay
