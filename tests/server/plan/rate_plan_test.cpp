// What is given up for which line. The lines are simulated in virtual time: they carry the images of the plan, and the
// planner learns only what a server can learn of them.

#include "server/plan/rate_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "proto/words/numbers/quantile.h"
#include "tests/server/plan/simulated_line.h"

namespace telepalp::plan {
namespace {

constexpr double kMbit = 1e6 / 8.0;  // [B]
constexpr double kStep_s = 1e-3;
constexpr int kDepth = 0;
constexpr int kColor = 1;

/// Bytes of a depth image with a window that the planner cannot know beforehand.
double window_bytes(const ImageSettings& sent, double at_full_B) {
  const double around = sent.outside_factor <= 1.0 ? 1.0 : sent.outside_factor <= 2.0 ? 0.8 : 0.65;
  return at_full_B * (0.5 + 0.5 * around / sent.outside_every);
}

struct Subscriber {
  Line line;
  SimulatedLine path;
  double depth_B = 12'000.0;
};

Line hand(std::uint64_t number) {
  return {.subscriber = number, .kind = Line::Kind::Hand, .takes_window = true, .takes_video = true};
}
Line viewer(std::uint64_t number) {
  return {.subscriber = number, .kind = Line::Kind::Viewer, .takes_whole = true, .takes_pictures = true};
}

/// A server with its planner, a camera of 30 Hz, and subscribers.
class Site {
 public:
  explicit Site(std::vector<Subscriber> subscribers) : subscribers_(std::move(subscribers)) {}

  void run(double until_s) {
    for (; step_ * kStep_s < until_s; ++step_) {
      const double now_s = step_ * kStep_s;
      if (step_ % 33 == 0) capture(now_s);
      for (Subscriber& one : subscribers_) one.path.run(now_s);
      if (step_ % 200 == 0) plan(now_s);
    }
  }

  [[nodiscard]] const RatePlan& now() const { return planner_.plan(); }
  [[nodiscard]] const std::string& said() const { return notice_.text(); }
  [[nodiscard]] const ImageSettings& of(Grade grade) const { return now().settings[index_of(grade)]; }
  [[nodiscard]] Grade grade_of(std::uint64_t number) const { return now().grade_of(number); }

  /// Images of a stream that arrived at the first subscriber, per second.
  [[nodiscard]] double rate(int stream, double from_s, double until_s) const {
    double count = 0.0;
    for (const SimulatedLine::Arrived& one : subscribers_.front().path.arrived())
      count += one.stream == stream && one.at_s >= from_s && one.at_s < until_s ? 1.0 : 0.0;
    return count / (until_s - from_s);
  }
  /// 95 % of the depth images are at most this old when they arrive at the first subscriber [s].
  [[nodiscard]] double age_p95(double from_s, double until_s) const {
    std::vector<double> ages;
    for (const SimulatedLine::Arrived& one : subscribers_.front().path.arrived())
      if (one.stream == kDepth && one.at_s >= from_s && one.at_s < until_s) ages.push_back(one.at_s - one.captured_s);
    return ages.empty() ? 1e9 : quantile_of(ages, 0.95);
  }
  /// Share of the first subscriber's line that images take.
  [[nodiscard]] double use(double from_s, double until_s) const {
    double sent = 0.0;
    for (const auto& [at_s, total_B] : sent_)
      if (at_s <= until_s) sent = total_B;
    for (const auto& [at_s, total_B] : sent_)
      if (at_s >= from_s) return (sent - total_B) / (until_s - from_s) / subscribers_.front().path.rate_B_per_s();
    return 0.0;
  }
  /// Changes of the rates of the hand's images in this time.
  [[nodiscard]] int changes(double from_s, double until_s) const {
    int count = 0;
    for (const double at_s : changed_s_) count += at_s >= from_s && at_s < until_s ? 1 : 0;
    return count;
  }

 private:
  void capture(double now_s) {
    ++image_;
    std::array<bool, kGrades.size()> counted{};
    for (Subscriber& one : subscribers_) {
      const Grade grade = grade_of(one.line.subscriber);
      const ImageSettings& sent = of(grade);
      Made& made = made_[index_of(grade)];
      const bool first = !std::exchange(counted[index_of(grade)], true);
      if (sends(sent.depth_share, image_)) {
        const double whole = one.depth_B * (sent.whole_factor > 0.0 ? 0.4 : sent.level > 0 ? 0.7 : 1.0);
        const double bytes = one.line.takes_window ? window_bytes(sent, one.depth_B) : whole;
        one.path.offer(kDepth, bytes, now_s);
        Made::Count& count = one.line.takes_window ? made.window : made.whole;
        if (first) ++count.images, count.bytes += static_cast<std::uint64_t>(bytes);
      }
      if (!sends(sent.color_share, image_)) continue;
      const double video = 125.0 * std::min(800, sent.video_kbit_per_s) / (30.0 * sent.color_share);
      const double picture = 57'000.0 * std::pow(std::min(85, sent.jpeg_quality) / 85.0, 0.9);
      one.path.offer(kColor, one.line.takes_video ? video : picture, now_s);
      if (first && one.line.takes_pictures)
        ++made.pictures.images, made.pictures.bytes += static_cast<std::uint64_t>(picture);
    }
  }
  void plan(double now_s) {
    PlanInput input{.made = std::exchange(made_, {})};
    for (Subscriber& one : subscribers_) {
      one.line.report = one.path.report();
      input.lines.push_back(one.line);
    }
    const ImageSettings before = of(Grade::Touch);
    const SessionTime now = session_time(static_cast<std::int64_t>(1e9 * (now_s + 1.0)));
    notice_.step(planner_.step(input, now).sacrifice, now);
    const ImageSettings& after = of(Grade::Touch);
    if (std::abs(before.depth_share - after.depth_share) > 0.1 || before.color_share != after.color_share)
      changed_s_.push_back(now_s);
    sent_.emplace_back(now_s, static_cast<double>(subscribers_.front().path.report().sent_B));
  }

  RatePlanner planner_;
  SacrificeNotice notice_;
  std::vector<Subscriber> subscribers_;
  std::array<Made, kGrades.size()> made_{};
  std::vector<double> changed_s_;
  std::vector<std::pair<double, double>> sent_;
  std::uint64_t image_ = 0;
  int step_ = 0;
};

SimulatedLine steady(double Mbit_per_s, double repairs = 0.0) {
  return SimulatedLine([=](double) { return Mbit_per_s * kMbit; }, repairs);
}

struct Row {
  const char* name;
  double Mbit_per_s;
  double depth_B;    ///< of a window image if nothing is given up
  double window_hz;  ///< at least
  double color_hz;   ///< at least
  double use;        ///< at least
  double age_s;      ///< p95, at most
  bool too_thin = false;

  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }
};
constexpr Row kRows[] = {
    {"20 Mbit/s", 20.0, 12'000.0, 29.5, 29.5, 0.0, 0.05},
    {"4 Mbit/s, recorded room", 4.0, 12'000.0, 27.0, 10.0, 0.8, 0.12},
    {"4 Mbit/s, synthetic patient", 4.0, 22'000.0, 25.0, 10.0, 0.8, 0.12},
    {"2 Mbit/s, recorded room", 2.0, 12'000.0, 25.0, 4.5, 0.75, 0.15},
    {"2 Mbit/s, synthetic patient", 2.0, 22'000.0, 14.5, 2.5, 0.7, 0.2},
    {"1 Mbit/s, recorded room", 1.0, 12'000.0, 13.0, 2.0, 0.6, 0.2},
    {"0.5 Mbit/s, recorded room", 0.5, 12'000.0, 4.0, 1.0, 0.5, 0.4, true},
};

class RatePlanTable : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Lines, RatePlanTable, testing::ValuesIn(kRows));

TEST_P(RatePlanTable, TheHandGetsWhatTheLineCarriesAndThePlanIsSteadyAfterThreeSeconds) {
  const Row row = GetParam();
  SCOPED_TRACE(row.name);
  Site site({{.line = hand(1), .path = steady(row.Mbit_per_s, 0.05), .depth_B = row.depth_B}});
  site.run(20.0);
  EXPECT_GE(site.rate(kDepth, 3.0, 20.0), row.window_hz);
  EXPECT_GE(site.rate(kColor, 3.0, 20.0), row.color_hz);
  EXPECT_GE(site.use(3.0, 20.0), row.use);
  EXPECT_LE(site.age_p95(3.0, 20.0), row.age_s);
  EXPECT_LE(site.changes(3.0, 20.0), 4);
  EXPECT_EQ(site.now().sacrifice.too_thin_to_touch, row.too_thin);
  EXPECT_EQ(site.said().starts_with("too thin to touch"), row.too_thin) << site.said();
  EXPECT_TRUE(row.Mbit_per_s < 10.0 || site.said().empty()) << site.said();
}

TEST(RatePlan, AWideLineGetsEverythingAsItIs) {
  Site site({{.line = hand(1), .path = steady(20.0)}, {.line = viewer(2), .path = steady(100.0), .depth_B = 60'000}});
  site.run(10.0);
  EXPECT_TRUE(site.now().grades.empty());
  EXPECT_EQ(site.of(Grade::Touch), ImageSettings{});
  EXPECT_TRUE(site.said().empty());
}

TEST(RatePlan, AFallTo2MbitIsFollowedAtOnceAndEverythingComesBackWithinFiveSeconds) {
  const auto falls = [](double at_s) { return (at_s < 5.0 || at_s >= 15.0 ? 20.0 : 2.0) * kMbit; };
  Site site({{.line = hand(1), .path = SimulatedLine(falls), .depth_B = 12'000.0}});
  site.run(15.0);
  EXPECT_GE(site.rate(kDepth, 6.0, 15.0), 15.0);
  EXPECT_LE(site.age_p95(5.0, 15.0), 0.25);
  EXPECT_NE(site.grade_of(1), Grade::Full);
  site.run(20.0);
  EXPECT_EQ(site.grade_of(1), Grade::Full) << site.said();
  EXPECT_TRUE(site.said().empty()) << site.said();
}

TEST(RatePlan, ALineThatLetsABurstPassIsNotTakenForAWideOne) {
  // Full speed for 1 s after each pause of the bucket, else 2 Mbit/s: the tries for more cost little.
  const auto lies = [](double at_s) { return (std::fmod(at_s, 6.0) < 1.0 ? 20.0 : 2.0) * kMbit; };
  Site site({{.line = hand(1), .path = SimulatedLine(lies), .depth_B = 12'000.0}});
  site.run(40.0);
  EXPECT_GE(site.rate(kDepth, 3.0, 40.0), 20.0);
  EXPECT_LE(site.age_p95(3.0, 40.0), 0.25);
}

TEST(RatePlan, LossWithoutAQueueTakesNothingAway) {
  Site site({{.line = hand(1), .path = steady(20.0, 0.3), .depth_B = 12'000.0}});  // 5 % of loss, repaired
  site.run(10.0);
  EXPECT_EQ(site.grade_of(1), Grade::Full);
}

TEST(RatePlan, AViewerOnAThinLineGetsBoundedDepthAndLittleColourWhileTheHandKeepsAll) {
  Site site({{.line = hand(1), .path = steady(20.0), .depth_B = 12'000.0},
             {.line = viewer(2), .path = steady(3.0), .depth_B = 37'000.0},
             {.line = viewer(3), .path = steady(100.0), .depth_B = 37'000.0},
             {.line = {.subscriber = 4, .kind = Line::Kind::Keeper, .takes_whole = true, .takes_pictures = true},
              .path = steady(1.0),
              .depth_B = 37'000.0}});
  site.run(10.0);
  EXPECT_EQ(site.grade_of(1), Grade::Full);
  EXPECT_EQ(site.grade_of(2), Grade::View);
  EXPECT_EQ(site.grade_of(3), Grade::Full) << "a viewer with room is not thinned for another";
  EXPECT_EQ(site.grade_of(4), Grade::Full) << "a recorder keeps everything exact";
  EXPECT_GT(site.of(Grade::View).whole_factor, 0.0);
  EXPECT_LT(site.of(Grade::View).color_share, 0.5);
  EXPECT_NE(site.said().find("to a viewer"), std::string::npos) << site.said();
}

TEST(RatePlan, WhileTheHandsLineIsThinViewersColourGoesFirst) {
  Site site({{.line = hand(1), .path = steady(3.0), .depth_B = 12'000.0},
             {.line = viewer(2), .path = steady(100.0), .depth_B = 37'000.0}});
  site.run(6.0);
  EXPECT_EQ(site.grade_of(2), Grade::View);
  EXPECT_LT(site.of(Grade::View).color_share, 0.5);
  EXPECT_EQ(site.of(Grade::View).whole_factor, 0.0) << "its line has room for exact depth";
}

TEST(RatePlan, AnotherStationsLineDoesNotThinTheHandThatIsFollowed) {
  Line observer = hand(2);
  observer.kind = Line::Kind::Station;
  Site site({{.line = hand(1), .path = steady(20.0), .depth_B = 12'000.0},
             {.line = observer, .path = steady(1.0), .depth_B = 12'000.0}});
  site.run(8.0);
  EXPECT_EQ(site.grade_of(1), Grade::Full);
}

TEST(RatePlan, ASentenceStaysForThreeSecondsAndEndsAtOnce) {
  SacrificeNotice notice;
  Sacrifice thin{.touch_rung = 1, .hand_B_per_s = 500'000.0};
  notice.step(thin, session_time(0));
  const std::string first = notice.text();
  EXPECT_EQ(first,
            "the line to the station carries about 4.0 Mbit/s of images; given up: colour comes 15 times a second");
  thin = {.touch_rung = touch_rungs().size() - 1, .too_thin_to_touch = true, .hand_B_per_s = 50'000.0};
  notice.step(thin, session_time(2'900'000'000));
  EXPECT_EQ(notice.text(), first);
  notice.step(thin, session_time(3'100'000'000));
  EXPECT_TRUE(notice.text().starts_with("too thin to touch")) << notice.text();
  notice.step({}, session_time(3'200'000'000));
  EXPECT_EQ(notice.text(), "");
}

TEST(RatePlan, ViewersGiveUpColourAloneBeforeDepth) {
  for (std::size_t i = 1; i <= color_given_up(); ++i) {
    EXPECT_EQ(view_rungs()[i].settings.whole_factor, 0.0);
    EXPECT_EQ(view_rungs()[i].settings.depth_share, 1.0);
  }
  EXPECT_GT(view_rungs()[color_given_up() + 1].settings.whole_factor, 0.0);
}

TEST(RatePlan, TheOrderOfSacrificeIsFixed) {
  const auto rungs = touch_rungs();
  for (std::size_t i = 1; i < rungs.size(); ++i) {
    SCOPED_TRACE(i);
    const ImageSettings& before = rungs[i - 1].settings;
    const ImageSettings& now = rungs[i].settings;
    EXPECT_LE(now.color_share, before.color_share);
    EXPECT_GE(now.outside_factor, before.outside_factor);
    EXPECT_GE(now.outside_every, before.outside_every);
    EXPECT_LE(now.depth_share, before.depth_share);
    if (now.outside_factor > before.outside_factor) {
      EXPECT_LT(now.color_share, 0.5) << "colour's rate goes first";
    }
    if (now.outside_every > before.outside_every) {
      EXPECT_GT(now.outside_factor, 1.0) << "then the bound";
    }
    if (now.depth_share < before.depth_share) {
      EXPECT_GT(now.outside_every, 1) << "the window goes last";
    }
    EXPECT_EQ(now.depth_share < 0.5, i + 1 == rungs.size());
    EXPECT_EQ(is_too_thin_to_touch(rungs[i]), i + 1 == rungs.size());
  }
}

TEST(RatePlan, TheSentImagesAreEvenlySpaced) {
  for (const double share : {1.0, 2.0 / 3.0, 0.5, 1.0 / 3.0, 0.1}) {
    int sent = 0, longest = 0, gap = 0;
    for (std::uint64_t image = 0; image < 300; ++image) {
      const bool is_sent = sends(share, image);
      sent += is_sent ? 1 : 0;
      gap = is_sent ? 0 : gap + 1;
      longest = std::max(longest, gap);
    }
    EXPECT_NEAR(sent, 300.0 * share, 1.0) << share;
    EXPECT_LE(longest, static_cast<int>(std::ceil(1.0 / share))) << share;
  }
}

}  // namespace
}  // namespace telepalp::plan
