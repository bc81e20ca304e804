// A gate between two runs: telepalp-report A B --assert.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "clients/report/compare/cause.h"
#include "clients/report/compare/gate.h"
#include "clients/report/summary/scene_difference.h"
#include "codec/depth.h"
#include "foxglove/CameraCalibration.pb.h"
#include "proto/wire/mcap/writer.h"
#include "tests/clients/report/change_each.h"
#include "tests/clients/report/made_session.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::report {
namespace {

using Messages = std::vector<wire::Message>;

/// Each force has its length changed by `change`, which takes and returns newtons.
template <class Change>
void change_forces(Messages& messages, Change change) {
  change_each<msg::StationTicks>(messages, wire::kStationTicks, [&](msg::StationTicks& ticks) {
    for (int i = 0; i < ticks.force_x_size(); ++i) {
      const double force_N = std::hypot(double{ticks.force_x(i)}, double{ticks.force_y(i)}, double{ticks.force_z(i)});
      if (!(force_N > 0.0)) continue;
      for (auto* axis : {ticks.mutable_force_x(), ticks.mutable_force_y(), ticks.mutable_force_z()})
        axis->Set(i, static_cast<float>(double{axis->Get(i)} * change(force_N) / force_N));
    }
  });
}

void remove_each(Messages& messages, const wire::Topic& topic, const std::function<bool(std::size_t)>& is_removed) {
  std::size_t number = 0;
  std::erase_if(messages,
                [&](const wire::Message& message) { return message.topic.name == topic.name && is_removed(number++); });
}

class Gate : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const Messages& messages, const std::string& scene = "") {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::filesystem::remove(file);
    Result<wire::McapWriter> writer = wire::McapWriter::open(
        file, {.program = "telepalp-record", .version = "1", .commit = "c0", .source = "made", .scene = scene});
    EXPECT_TRUE(writer);
    for (const wire::Message& message : messages) EXPECT_TRUE(writer->write(message));
    EXPECT_TRUE(writer->close());
    return file;
  }
  GateOutcome judged(const Messages& other, const std::string& tolerances = "same") {
    Result<GateOutcome> outcome =
        judge_against(write("a.mcap", made_), write("b.mcap", other), parse_tolerances(tolerances, "--assert").value());
    EXPECT_TRUE(outcome);
    return std::move(outcome).value();
  }
  static double value_of(const GateOutcome& outcome, const std::string& name) {
    for (const Difference& one : outcome.differences)
      if (one.tolerance.name == name) return one.value;
    ADD_FAILURE() << name;
    return 0.0;
  }
  static void expect_first_cause(const GateOutcome& outcome, const std::string& words) {
    EXPECT_FALSE(outcome.holds());
    ASSERT_FALSE(outcome.causes.empty());
    EXPECT_NE(outcome.causes.front().find(words), std::string::npos) << in_words(outcome);
  }

  support::TemporaryFolder folder_;
  const Messages made_ = made_messages({.seconds = 4.0});
};

TEST_F(Gate, HoldsForEqualRunsAndForDifferencesThatNobodyFeels) {
  EXPECT_TRUE(judged(made_).holds());
  Messages other = made_;
  change_forces(other, [](double force_N) { return force_N + 0.01; });
  EXPECT_TRUE(judged(other).holds()) << in_words(judged(other));
}

TEST_F(Gate, CatchesTenPercentMoreStiffness) {
  Messages other = made_;
  change_forces(other, [](double force_N) { return 1.1 * force_N; });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "stiffness_pct"), 10.0, 0.01);
  expect_first_cause(outcome, "at equal indentation, the force of B is 10 % larger than that of A");
}

TEST_F(Gate, CatchesImagesThatAreMissingAlthoughTheHandFeelsNoDifference) {
  Messages other = made_;
  remove_each(other, wire::kCameraDepth, [](std::size_t number) { return number % 100 < 31; });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "images_pct"), 43.0, 3.0);
  expect_first_cause(outcome, "B lacks ");
  const Comparison comparison = compare(folder_.path() / "a.mcap", folder_.path() / "b.mcap").value();
  EXPECT_NE(headline(comparison).find("feels no difference"), std::string::npos);
  EXPECT_NE(headline(comparison).find("% of the depth images are in one run alone (120 in A, "), std::string::npos)
      << headline(comparison);
}

TEST_F(Gate, CatchesAForceThatIsClipped) {
  Messages other = made_;
  change_forces(other, [](double force_N) { return std::min(force_N, 2.0); });
  expect_first_cause(judged(other), "the force of B is clipped at 2 N");
}

TEST_F(Gate, CatchesAContactThatBeginsTwoMillimetresDeeper) {
  Messages other = made_;
  change_each<msg::StationTicks>(other, wire::kStationTicks, [](msg::StationTicks& ticks) {
    for (int i = 0; i < ticks.phase_size(); ++i)
      if (ticks.phase(i) == msg::PHASE_IN_BODY && ticks.device_y(i) > -0.002F) {
        ticks.set_phase(i, msg::PHASE_PLANE_TO_BODY);
        for (auto* axis : {ticks.mutable_force_x(), ticks.mutable_force_y(), ticks.mutable_force_z()})
          axis->Set(i, 0.0F);
      }
  });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "contact_mm"), 2.0, 0.1);
  expect_first_cause(outcome, "mm deeper in B than in A");
}

TEST_F(Gate, CatchesAMissingSecond) {
  Messages other = made_;
  std::erase_if(other, [](const wire::Message& message) {
    const double at_s = 1e-9 * static_cast<double>(to_nanoseconds(message.published) - kMadeStart_ns);
    return at_s >= 1.5 && at_s < 2.5;
  });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "missing_s"), 1.0, 0.06);
  expect_first_cause(outcome, "B lacks the ticks of ");
}

TEST_F(Gate, CatchesDepthThatIsScaledByOnePercent) {
  Messages other = made_;
  change_each<msg::DepthImage>(other, wire::kCameraDepth, [](msg::DepthImage& image) {
    DepthImage depth = codec::decode_depth(std::as_bytes(std::span(image.data()))).value();
    for (std::uint16_t& sample : depth.samples) sample = static_cast<std::uint16_t>(std::lround(1.01 * sample));
    image.set_data(codec::encode_depth(depth));
  });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "depth_pct"), 1.0, 0.05);
  expect_first_cause(outcome, "the depth images of B measure 1");
}

TEST_F(Gate, CatchesIntrinsicsOfAnotherSize) {
  Messages other = made_;
  change_each<foxglove::CameraCalibration>(other, wire::kCameraInfo, [](foxglove::CameraCalibration& camera) {
    for (const int entry : {0, 2, 4, 5}) camera.set_k(entry, 0.5 * camera.k(entry));
  });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "camera_pct"), 50.0, 0.1);
  expect_first_cause(outcome, "depth camera: 320x240 pixels");
}

TEST_F(Gate, CatchesFiftyMillisecondsOfLatency) {
  Messages other = made_;
  change_each<msg::StationState>(other, wire::kStationState, [](msg::StationState& state) {
    if (state.surface_captured_ns() > 0) state.set_surface_captured_ns(state.surface_captured_ns() - 50'000'000);
  });
  const GateOutcome outcome = judged(other);
  EXPECT_NEAR(value_of(outcome, "latency_ms"), 50.0, 0.1);
  EXPECT_TRUE(judged(other, "latency_ms<=60,latency_p99_ms<=60").holds()) << "a stated tolerance replaces the default";
}

TEST_F(Gate, ARunWithoutTicksIsNotWithinAnyTolerance) {
  const GateOutcome outcome = judged(made_messages({.seconds = 4.0, .with_station = false}));
  EXPECT_FALSE(outcome.holds());
  EXPECT_TRUE(std::isinf(value_of(outcome, "missing_s")));
}

TEST_F(Gate, TheSceneIsNamedBeforeWhatItChanges) {
  Messages other = made_;
  change_forces(other, [](double force_N) { return 1.1 * force_N; });
  const Result<GateOutcome> outcome = judge_against(write("a.mcap", made_, "skin {\n  stiffness_N_per_m: 300\n}\n"),
                                                    write("b.mcap", other, "skin {\n  stiffness_N_per_m: 330\n}\n"),
                                                    parse_tolerances("same", "--assert").value());
  ASSERT_TRUE(outcome);
  expect_first_cause(*outcome, "scene: line 2: stiffness_N_per_m: 300 in A, stiffness_N_per_m: 330 in B");
  ASSERT_GE(outcome->causes.size(), 2U);
  EXPECT_NE(outcome->causes[1].find("10 % larger"), std::string::npos);
}

TEST_F(Gate, TheProgramEndsWithOneWhereARunDiffersAndWithTwoWhereItCannotCompare) {
  Messages other = made_;
  change_forces(other, [](double force_N) { return 1.1 * force_N; });
  const auto a = write("a/session.mcap", made_).parent_path(), b = write("b/session.mcap", other).parent_path();
  const auto code = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--out", folder_.path() / "out"});
    return support::ChildProcess(TELEPALP_BINARY_DIR "/bin/telepalp-report", words).wait(std::chrono::seconds(60));
  };
  EXPECT_EQ(code({a, a, "--assert", "same"}), 0);
  EXPECT_EQ(code({a, b, "--assert", "same"}), 1);
  EXPECT_EQ(code({a, b}), 0) << "without --assert nothing is judged";
  EXPECT_EQ(code({a, b, "--assert", "force_rms_N<=9,force_p99_N<=9,stiffness_pct<=20"}), 0);
  EXPECT_EQ(code({a, b, "--assert", "stifness_pct<=20"}), 2);
  EXPECT_EQ(code({a, folder_.path() / "none", "--assert", "same"}), 2);
  EXPECT_EQ(code({a, "--assert", "same"}), 2);
}

TEST(Tolerances, AreReplacedByNameAndRefusedWithTheDefaults) {
  const auto tolerances = parse_tolerances("contact_mm<=3,images_pct<=0", "--assert").value();
  EXPECT_EQ(tolerances.size(), default_tolerances().size());
  const auto at_most = [&](std::string_view name) {
    return std::find_if(tolerances.begin(), tolerances.end(), [&](const auto& one) { return one.name == name; })
        ->at_most;
  };
  EXPECT_EQ(at_most("contact_mm"), 3.0);
  EXPECT_EQ(at_most("images_pct"), 0.0);
  EXPECT_EQ(at_most("latency_ms"), 10.0);
  for (const char* wrong : {"", "contact_mm", "contact_mm<3", "contact_mm<=-1", "contact_mm<=x", "contact<=3",
                            "contact_mm<=inf", "contact_mm<=3,"}) {
    const auto refused = parse_tolerances(wrong, "--assert");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_NE(refused.error().fix.find("force_rms_N<=0.1"), std::string::npos);
  }
}

TEST(MetricPair, ADifferenceTooSmallToMatterIsNotWorse) {
  const MetricPair energy{"energy_J", "", -0.24e-6, -0.48e-6, MetricPair::Better::More, 1e-4};
  EXPECT_FALSE(energy.worse());
  EXPECT_TRUE(energy.same());
  const MetricPair more{"energy_J", "", -0.24e-6, -5e-3, MetricPair::Better::More, 1e-4};
  EXPECT_TRUE(more.worse());
  EXPECT_FALSE(more.same());
}

TEST(SceneDifference, NamesTheLinesThatDifferAndThoseThatOneFileLacks) {
  EXPECT_EQ(scene_difference("a\nb\n", "a\n  # a comment\n\n  b\n"), "");
  EXPECT_EQ(scene_difference("a\nb: 1\nc\n", "a\nb: 2\nc\n"), "line 2: b: 1 in A, b: 2 in B");
  EXPECT_EQ(scene_difference("a\ne {\nx\n}\nc\n", "a\nc\n"), "B lacks lines 2 to 4 of A: e { x }");
  EXPECT_EQ(scene_difference("a\n", "a\nb\n"), "A lacks line 2 of B: b");
  EXPECT_EQ(scene_difference("1\na\n2\nb\n3\nc\n4\nd\n", "1\n2\n3\n4\n"),
            "B lacks line 2 of A: a; B lacks line 4 of A: b; B lacks line 6 of A: c; and 1 more place");
}

}  // namespace
}  // namespace telepalp::report
