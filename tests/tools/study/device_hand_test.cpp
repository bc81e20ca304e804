#include "tools/study/protocol/hands/device_hand.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>

#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/topics.h"
#include "tests/support/child_process.h"
#include "tests/support/no_heap_scope.h"
#include "tools/study/protocol/desk.h"
#include "tools/study/protocol/hands/browser_trial.h"
#include "tools/study/task/arm.h"

namespace telepalp::study {
namespace {

using Eigen::Vector3d;

const Design& design() {
  static const Design made = *parse_design("name=short l_h=100\n", "one");
  return made;
}

Prepared prepared() {
  static const std::shared_ptr<const tissue::TissueModel> tissue = *tissue::make_tissue(tissue_of(Plant{}));
  Prepared made{.tool = *linkage_tool(design().configurations[0], Plant{}), .insertion = nullptr};
  made.insertion = std::make_unique<Insertion>(*made.tool, tissue);
  return made;
}

/// An arm that pushes at 40 mm/s until the sac gives way, and then holds its far end.
class PushingArm {
 public:
  PushingArm()
      : tool_(*linkage_tool(design().configurations[0], Plant{})), arm_(browser_arm(), tool_->on_the_way_m(0.0)) {}
  void step(bool through, const Vector3d& force_N) {
    if (!through) way_m_ += 0.04 * kTick_s;
    arm_.step(tool_->on_the_way_m(way_m_), force_N);
  }
  [[nodiscard]] const Vector3d& hand_m() const { return arm_.hand_m(); }
  [[nodiscard]] double way_m() const { return way_m_; }

 private:
  std::unique_ptr<HeldTool> tool_;
  Arm arm_;
  double way_m_ = 0.0;
};

/// The end-effector is somewhere else than the handle.
const Vector3d kElsewhere_m{0.31, -0.12, 0.05};
loop::GatedReading reading_at(const Vector3d& hand_m) { return {.at = {hand_m + kElsewhere_m}, .velocity = {}}; }

TEST(DevicePenetration, AnArmAtADeviceOvershootsAsTheSameArmInABrowser) {
  for (const Condition condition : {Condition::Force, Condition::Vision, Condition::Both}) {
    BrowserTrial browser(prepared(), condition);
    PersonTrial::Ticks ticks;
    while (!browser.view().over) {
      if (!browser.view().outcome.through) browser.push(0.04 * kTick_s);
      browser.step(kTick_s, ticks);
    }
    DevicePenetration at_device(prepared(), condition);
    PushingArm arm;
    Force<HapticBase> given;
    double most_N = 0.0;
    for (int i = 0; i < 80'000 && !at_device.over(); ++i) {
      arm.step(at_device.view().outcome.through, given.N);
      given = at_device.step(reading_at(arm.hand_m()), 0.0);
      most_N = std::max(most_N, given.N.norm());
    }
    const Outcome out = at_device.view().outcome;
    ASSERT_TRUE(out.through && out.stopped) << name(condition);
    EXPECT_NEAR(out.overshoot_m, browser.view().outcome.overshoot_m, 1e-4) << name(condition);
    EXPECT_NEAR(out.hand_drop_N, browser.view().outcome.hand_drop_N, 0.02) << name(condition);
    if (condition == Condition::Vision)
      EXPECT_EQ(most_N, 0.0) << "nothing is felt";
    else
      EXPECT_GT(most_N, 0.5);
  }
}

TEST(DevicePenetration, TheForceRisesAndNoTickAllocates) {
  DevicePenetration at_device(prepared(), Condition::Both);
  PushingArm arm;
  Vector3d before = Vector3d::Zero();
  double most_step_N = 0.0;
  for (int i = 0; i < 2000; ++i) {
    arm.step(false, before);
    const loop::GatedReading reading = reading_at(arm.hand_m() + Vector3d(0.0, 0.0, 0.02));  // out of the plane
    const test::NoHeapScope none;
    const Vector3d now = at_device.step(reading, 0.0).N;
    most_step_N = std::max(most_step_N, (now - before).norm());
    before = now;
  }
  EXPECT_GT(before.norm(), 0.1);
  EXPECT_LT(most_step_N, 0.1);
}

TEST(DevicePenetration, ASilentOrImpossibleDeviceEndsItWithoutForce) {
  const auto lost_after = [](double age_s, double implausible_s) {
    DevicePenetration at_device(prepared(), Condition::Both);
    PushingArm arm;
    for (int i = 0; i < 1000; ++i) {
      arm.step(false, Vector3d::Zero());
      (void)at_device.step(reading_at(arm.hand_m()), 0.0);
    }
    loop::GatedReading reading = reading_at(arm.hand_m());
    reading.implausible_s = implausible_s;
    const double given_N = at_device.step(reading, age_s).N.norm();
    if (at_device.lost() != DevicePenetration::Lost::No) {
      EXPECT_EQ(given_N, 0.0);
      EXPECT_EQ(at_device.step(reading_at(arm.hand_m()), 0.0).N.norm(), 0.0) << "it stays ended";
    }
    return at_device.lost();
  };
  EXPECT_EQ(lost_after(0.01, 0.01), DevicePenetration::Lost::No);
  EXPECT_EQ(lost_after(0.06, 0.0), DevicePenetration::Lost::Silent);
  EXPECT_EQ(lost_after(std::numeric_limits<double>::infinity(), 0.0), DevicePenetration::Lost::Silent);
  EXPECT_EQ(lost_after(std::numeric_limits<double>::quiet_NaN(), 0.0), DevicePenetration::Lost::Silent);
  EXPECT_EQ(lost_after(0.0, 0.06), DevicePenetration::Lost::Implausible);
}

/// What the thread did to the device, and what the person at it does.
struct Felt {
  std::atomic<bool> pushes{false};
  std::atomic<bool> silent{false};
  std::atomic<double> most_N{0.0};
  std::atomic<double> newest_N{0.0};
};

/// A device in the hand of an arm, which pushes far enough to puncture the sac.
constexpr double kThrough_m = 0.14;
class ArmsDevice final : public ports::Device {
 public:
  explicit ArmsDevice(Felt& felt) : felt_(felt) {}
  [[nodiscard]] ports::DeviceReading read() noexcept override {
    return {.at = {arm_.hand_m() + kElsewhere_m},
            .velocity = {},
            .age_s = felt_.silent ? 1.0 : 0.0,
            .power = {.most_N = 1.5}};
  }
  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact&, double) noexcept override {
    felt_.newest_N = wrench.force.N.norm();
    felt_.most_N = std::max(felt_.most_N.load(), felt_.newest_N.load());
    if (felt_.pushes) arm_.step(arm_.way_m() > kThrough_m, wrench.force.N);
  }

 private:
  Felt& felt_;
  PushingArm arm_;
};

TEST(DeviceHand, ASittingAtADeviceIsKeptAsASession) {
  const support::TemporaryFolder folder;
  const Protocol protocol{.design = design(), .seed = 3, .training = 0, .penetrations = 1, .hand = PersonHand::Device};
  const Participant anna = *participant_of("anna");
  Felt felt;
  DeviceThread hand(std::make_unique<ArmsDevice>(felt));
  Place place{.hand = [&](Prepared, Condition condition) { return begin_at_device(hand, prepared(), condition); },
              .file = std::move(*SittingFile::open(folder.path(), "anna", identity_of(protocol)))};
  const std::filesystem::path file = place.file->name();
  EXPECT_EQ(file.filename(), "anna-0001.mcap");
  Result<Journal> journal =
      Journal::open(folder.path() / "anna.csv",
                    {.identity = identity_of(protocol), .participant = "anna", .hand = PersonHand::Device});
  ASSERT_TRUE(journal.ok());
  Desk desk(
      std::move(*Session::make(protocol, anna, {}, "anna.csv")), std::move(*journal), "anna", [] {}, std::move(place));
  ASSERT_TRUE(desk.obey(BeginPenetration{}, session_time(1'000'000'000'000)));
  EXPECT_TRUE(desk.moves()) << "the page need not send anything";
  EXPECT_EQ(desk.session().stage(), Stage::Ready);
  felt.pushes = true;
  const auto wait = [&](auto until) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(40);
    while (!until() && std::chrono::steady_clock::now() < end) {
      (void)desk.step(0.016);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return until();
  };
  ASSERT_TRUE(wait([&] { return desk.session().stage() == Stage::Finished; }));
  EXPECT_LE(felt.most_N, 1.5 + 1e-9) << "no more than the device states";
  EXPECT_GT(felt.most_N, 0.3);
  ASSERT_TRUE(wait([&] { return felt.newest_N < 0.001; })) << "nothing pushes between penetrations";
  ASSERT_TRUE(desk.close().ok());
  ASSERT_EQ(desk.journal().attempts().size(), 1U);
  const Outcome out = desk.journal().attempts()[0].trial.outcome;
  EXPECT_TRUE(out.through);

  Result<wire::McapReader> session = wire::McapReader::open(file);
  ASSERT_TRUE(session.ok()) << to_string(session.error());
  std::size_t ticks = 0, events = 0, notes = 0;
  float deepest_m = 0.0F;
  std::vector<std::string> words;
  while (true) {
    Result<std::optional<wire::Message>> message = session->next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    if ((*message)->topic.name == wire::kStationEvents.name) ++events;
    if ((*message)->topic.name == wire::kSessionNotes.name) ++notes;
    if ((*message)->topic.name != wire::kStationTicks.name) continue;
    msg::StationTicks batch;
    ASSERT_TRUE(batch.ParseFromString(*(*message)->payload));
    ticks += static_cast<std::size_t>(batch.force_x_size());
    for (const float depth_m : batch.indentation_m()) deepest_m = std::max(deepest_m, depth_m);
  }
  EXPECT_NEAR(static_cast<double>(ticks), out.seconds / kTick_s, 0.05 * out.seconds / kTick_s);
  EXPECT_GT(deepest_m, 0.9 * out.depth_at_puncture_m);
  EXPECT_GE(events, 2U);
  EXPECT_EQ(notes, 1U);
}

TEST(DeviceHand, ADeviceThatFallsSilentIsSaidAndThePenetrationComesAgain) {
  const support::TemporaryFolder folder;
  const Protocol protocol{.design = design(), .seed = 3, .training = 0, .penetrations = 1, .hand = PersonHand::Device};
  Felt felt;
  DeviceThread hand(std::make_unique<ArmsDevice>(felt));
  Result<Journal> journal =
      Journal::open(folder.path() / "bert.csv",
                    {.identity = identity_of(protocol), .participant = "bert", .hand = PersonHand::Device});
  Desk desk(
      std::move(*Session::make(protocol, *participant_of("bert"), {}, "bert.csv")), std::move(*journal), "bert", [] {},
      {.hand = [&](Prepared made, Condition condition) { return begin_at_device(hand, std::move(made), condition); }});
  ASSERT_TRUE(desk.obey(BeginPenetration{}));
  felt.silent = true;
  for (int i = 0; i < 400 && desk.session().stage() != Stage::Resting; ++i) {
    (void)desk.step(0.016);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(desk.session().stage(), Stage::Resting);
  ASSERT_TRUE(desk.lost().has_value());
  EXPECT_NE(desk.lost()->what.find("does not answer"), std::string::npos);
  EXPECT_EQ(desk.session().done(), 0U);
  felt.silent = false;
  EXPECT_TRUE(desk.obey(BeginPenetration{}));
  EXPECT_FALSE(desk.lost().has_value());
}

TEST(DeviceThread, HasNoSimulatedDevice) {
  EXPECT_FALSE(connect_device_thread("simulated").ok());
  EXPECT_FALSE(connect_device_thread("mouse").ok());
  EXPECT_FALSE(connect_device_thread("udp:127.0.0.1:1").ok()) << "nobody answers";
}

}  // namespace
}  // namespace telepalp::study
