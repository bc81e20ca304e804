#include <gtest/gtest.h>

#include <limits>

#include "tests/tools/study/texts.h"
#include "tools/study/designer/answers.h"
#include "tools/study/designer/command.h"
#include "tools/study/designer/designer_page.h"
#include "tools/study/designer/live/reach.h"
#include "tools/study/designer/live_design.h"
#include "tools/study/task/tools.h"
#include "tools/study/web/door.h"
#include "tools/study/web/reply.h"

namespace telepalp::study {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

Configuration linkage(const std::string& words) { return parse_design(words, "test")->configurations.front(); }

LiveTool tool_of(const std::string& words) {
  static const LiveTool::Model tissue = *tissue::make_tissue(tissue_of(Plant{}));
  return *LiveTool::make(linkage(words), Plant{}, tissue);
}

LiveDesign first_design() {
  static const LiveDesign first = *LiveDesign::make();
  return first;
}

struct Refused {
  std::string message;
  std::string because;
};
class DesignerRefuses : public testing::TestWithParam<Refused> {};

TEST_P(DesignerRefuses, AMessageThatIsNoCommandWithASentence) {
  const Result<Command> read = parse_command(GetParam().message);
  ASSERT_FALSE(read.ok());
  EXPECT_TRUE(says(read.error().what, GetParam().because)) << to_string(read.error());
  EXPECT_FALSE(read.error().fix.empty());
}

INSTANTIATE_TEST_SUITE_P(
    HardCases, DesignerRefuses,
    testing::Values(
        Refused{"", "no message"}, Refused{"open /etc/passwd", "no message"}, Refused{"renew now", "no message"},
        Refused{std::string("\0\xff", 2), "no message"}, Refused{std::string(kMostCommandBytes + 1, 'x'), "bytes"},
        Refused{"design l1", "not a pair"}, Refused{"design l1=nan", "not a finite number"},
        Refused{"design l1=1e400", "not a number"}, Refused{"design l1=0", "l1 is 0 mm"},
        Refused{"design l1=-5", "l1 is -5 mm"}, Refused{"design l9=4", "no parameter"},
        Refused{"design l1=80 l2=150 l3=120 l4=400", "cannot close"}, Refused{"design l1=80\nl1=90", "more than one"},
        Refused{"design", "0 mechanisms"}, Refused{"design l1=1e6 l2=1e6 l3=1e6 l4=1e6", "over 1000 mm"},
        Refused{"design theta=1e9", "full turn"}, Refused{"hand 1", "two numbers"},
        Refused{"hand nan 0", "two numbers"}, Refused{"hand 1 2 3", "two numbers"},
        Refused{"hand 1e99 0", "two numbers"}, Refused{"take link1 1", "no moving part"},
        Refused{"take base 1 2", "no moving part"}, Refused{"take link9 1 2", "no moving part"},
        Refused{"take link1 nan 2", "no moving part"}, Refused{"take", "no moving part"},
        Refused{"press 2", "neither 0 nor 1"}, Refused{"press", "neither 0 nor 1"}, Refused{"turn inf", "one number"},
        Refused{"turn 2", "one number"}, Refused{"search", "from 40 to 2000"},
        Refused{"search 9999999 l1=60:120", "from 40 to 2000"}, Refused{"search 50 l1", "NAME=MIN:MAX"},
        Refused{"search 50 l1=120:60", "above the most"}, Refused{"search 50 l1=nan:nan", "out of bounds"},
        Refused{"search 50 size=1:2", "no parameter"}, Refused{"search 50 l1=80", ""}));

TEST(DesignerCommands, AreReadInMillimetresAndRadians) {
  const Result<Command> design = parse_command("design l1=70 l4=131.25 theta=-0.3");
  ASSERT_TRUE(design.ok());
  const Configuration& chosen = std::get<ChooseDesign>(*design).design;
  EXPECT_DOUBLE_EQ(chosen.bar.l1_m, 0.07);
  EXPECT_TRUE(chosen.l4_given && !chosen.needle_given);
  EXPECT_EQ(std::get<AimHand>(*parse_command("hand 10.5 -120")).at_m, Eigen::Vector2d(0.0105, -0.12));
  EXPECT_EQ(std::get<TakePart>(*parse_command("take needle 10.5 -120")).part, mechanism::LinkPart::Needle);
  EXPECT_TRUE(std::get<PressButton>(*parse_command("press 1")).pressed);
  EXPECT_EQ(std::get<TurnHandle>(*parse_command("turn -0.01")).by_rad, -0.01);
  const Result<Command> search = parse_command("search 50 l1=60:120 l2=150");
  ASSERT_TRUE(search.ok());
  EXPECT_EQ(std::get<BeginSearch>(*search).evaluations, 50);
  EXPECT_EQ(std::get<BeginSearch>(*search).box.ranges.size(), 2U);
}

TEST(LiveTool, PuncturesTheSacAndTheForceAtTheHandFalls) {
  LiveTool tool = tool_of("l_h=140");
  EXPECT_NEAR(tool.depth_m(), -kAbove_m, 1e-4) << "begins outside the skin";
  const std::vector<TracePoint> trace = tool.insert(0.06);
  ASSERT_EQ(tool.frame().punctured, 2U) << "skin and sac";
  const Puncture sac = tool.frame().punctures[1];
  EXPECT_EQ(sac.layer, kSac);
  EXPECT_GT(sac.depth_m, Plant{}.sac_depth_m) << "the sac is pushed in before it gives way";
  EXPECT_LT(sac.after_N, 0.6 * sac.before_N) << "before " << sac.before_N << " N";
  EXPECT_GT(trace.size(), 100U);
  EXPECT_TRUE(std::ranges::all_of(
      trace, [](const TracePoint& one) { return std::isfinite(one.hand_N) && std::isfinite(one.needle_N); }));
}

TEST(LiveTool, TheForceAtTheHandIsThatOfVirtualWork) {
  LiveTool tool = tool_of("l_h=180");
  (void)tool.insert(0.03);
  const LiveFrame now = tool.frame();
  ASSERT_GT(now.needle_N.norm(), 0.05);
  const mechanism::FeltLinkage& felt = tool.linkage();
  const mechanism::HeldLinkage held(felt.bar(), felt.plane(), felt.link3_rad(), mechanism::Branch::Open);
  constexpr double kStep_rad = 1e-6;
  const mechanism::HeldLinkage next(held.bar(), held.plane(), held.link3_rad() + kStep_rad, held.branch());
  const double at_needle = (next.tip().m - held.tip().m).head<2>().dot(now.needle_N);
  const double at_hand = (next.grasp().m - held.grasp().m).head<2>().dot(now.hand_N);
  EXPECT_NEAR(at_hand, at_needle, 1e-4 * std::abs(at_needle));
}

TEST(LiveTool, AnyMovingPartTurnsTheLinkageAndAKeyTurnsTheHandleAgain) {
  for (const auto part : {mechanism::LinkPart::Link1, mechanism::LinkPart::Link2, mechanism::LinkPart::Link3,
                          mechanism::LinkPart::Handle, mechanism::LinkPart::Needle}) {
    LiveTool tool = tool_of("l_h=140");
    const LinkagePlaces at = tool.frame().at;
    const Eigen::Vector2d far_ends[] = {at.p_m, at.p_m, at.b_m, 0.5 * (at.d_m + at.c_m), at.tip_m};
    tool.take(part, far_ends[static_cast<std::size_t>(part)]);
    EXPECT_EQ(tool.frame().held, part);
    const double depth_m = tool.depth_m();
    const Eigen::Vector2d from_m = tool.frame().grasp_m;
    for (const double way_m : {0.01, -0.01, 0.02})
      for (const Eigen::Vector2d& axis : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)}) {
        tool.aim(from_m + way_m * axis);
        for (int i = 0; i < 20; ++i) (void)tool.step(kFrame_s);
      }
    EXPECT_GT(std::abs(tool.depth_m() - depth_m), 0.002) << mechanism::name(part);
    tool.turn(0.05);
    EXPECT_EQ(tool.frame().held, mechanism::LinkPart::Handle);
    EXPECT_LT((tool.frame().grasp_m - tool.frame().at.c_m).norm(), 1e-9);
  }
}

TEST(LiveTool, TheSameMotionGivesTheSameForces) {
  const auto run = [] {
    LiveTool tool = tool_of("l_h=140");
    std::vector<TracePoint> all;
    for (int i = 0; i < 120; ++i) {
      tool.turn(0.004);
      for (const TracePoint& point : tool.step(kFrame_s)) all.push_back(point);
    }
    return all;
  };
  const auto [one, other] = std::pair(run(), run());
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].hand_N, other[i].hand_N) << i;
}

TEST(LiveTool, AHandThatIsNotFiniteOrFarAwayLeavesAPossiblePose) {
  LiveTool tool = tool_of("l_h=140");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  tool.aim({nan, 0.0});
  (void)tool.step(kFrame_s);
  for (const Eigen::Vector2d& far : {Eigen::Vector2d(10.0, -10.0), Eigen::Vector2d(-10.0, 10.0)}) {
    tool.aim(far);
    for (int i = 0; i < 600; ++i) (void)tool.step(kFrame_s);
    const LiveFrame frame = tool.frame();
    EXPECT_TRUE(frame.at.tip_m.allFinite() && frame.hand_N.allFinite());
    EXPECT_NEAR((frame.at.b_m - frame.at.o_m).norm(), 0.12, 1e-9) << "link 3 keeps its length";
    EXPECT_NEAR((frame.at.p_m - frame.at.a_m).norm(), 0.08, 1e-9) << "link 1 keeps its length";
  }
}

TEST(LiveTool, ComesToRestWhenTheHandRests) {
  LiveTool tool = tool_of("l_h=140");
  EXPECT_TRUE(tool.at_rest()) << "a page that nobody touches costs nothing";
  tool.turn(0.1);
  EXPECT_FALSE(tool.at_rest());
  int frames = 0;
  while (!tool.at_rest() && ++frames < 1200) (void)tool.step(kFrame_s);
  EXPECT_LT(frames, 1200);
}

TEST(Reach, EndsAtTheDeadPointsUnlessLink3TurnsFully) {
  const LiveTool rocks = tool_of("l1=80 l2=150 l3=120 l4=131");
  const Reach reach = reach_of(rocks.outside());
  ASSERT_FALSE(reach.range.whole_turn);
  for (const ReachPoint& end : {reach.points.front(), reach.points.back()}) {
    const mechanism::HeldLinkage there(rocks.outside().bar(), rocks.outside().plane(), end.link3_rad,
                                       rocks.outside().branch());
    EXPECT_NEAR(there.sine_of_links(), 0.0, 1e-4);
  }
  for (std::size_t i = 1; i < reach.points.size(); ++i)
    EXPECT_LT(reach.points[i].link3_rad - reach.points[i - 1].link3_rad, 0.035);
}

TEST(LiveDesign, AnotherLinkageHasItsNeedleAsDeep) {
  LiveDesign live = first_design();
  for (int i = 0; i < 200; ++i) {
    live.turn(0.003);
    (void)live.step(kFrame_s);
  }
  const double depth_m = live.tool().depth_m();
  ASSERT_GT(depth_m, 0.01);
  const std::string answer = live.choose(linkage("l_h=220 l4=131"));
  EXPECT_TRUE(says(answer, "\"kind\": \"design\"")) << answer.substr(0, 200);
  EXPECT_NEAR(live.tool().depth_m(), depth_m, 0.002);
  for (int l_h = 0; l_h < 20; ++l_h) (void)live.choose(linkage("l4=131 l_h=" + std::to_string(180 + l_h)));
  EXPECT_NEAR(live.tool().depth_m(), depth_m, 0.002) << "and goes no deeper with each change";
  EXPECT_TRUE(says(live.renew(), "\"kind\": \"design\""));
  EXPECT_LT(live.tool().depth_m(), 0.0);
}

TEST(LiveDesign, ALinkageThatCannotBeUsedIsRefusedAndTheLastOneStays) {
  LiveDesign live = first_design();
  ASSERT_TRUE(says(live.choose(linkage("l_h=200 l4=131")), "\"kind\": \"design\""));
  const std::string answer = live.choose(linkage("l1=80 l2=150 l3=120 l4=180"));
  EXPECT_TRUE(says(answer, "\"kind\": \"refused\"")) << answer;
  EXPECT_TRUE(says(answer, "\"fix\": \""));
  EXPECT_DOUBLE_EQ(live.design().bar.handle_m, 0.2);
  EXPECT_DOUBLE_EQ(live.tool().linkage().bar().handle_m, 0.2);
}

TEST(LiveDesign, AtRestNothingIsSent) {
  LiveDesign live = first_design();
  EXPECT_EQ(live.step(kFrame_s), std::nullopt);
  live.turn(0.01);
  EXPECT_TRUE(says(*live.step(kFrame_s), "\"kind\": \"frame\""));
}

const Door kDoor{.listen = "127.0.0.1", .port = 8766, .token = "0123456789abcdef0123456789abcdef"};

TEST(DesignerDoor, KnowsItsOwnHostByNumberOrAsLocalhost) {
  for (const char* host : {"127.0.0.1:8766", "localhost:8766", "[::1]:8766"}) EXPECT_TRUE(host_is_ours(kDoor, host));
  for (const char* host :
       {"", "localhost", "localhost:8767", "evil.example:8766", "127.0.0.1.evil.example:8766", ":8766"})
    EXPECT_FALSE(host_is_ours(kDoor, host)) << host;
}

TEST(DesignerDoor, APageOfAnotherSiteMayNotTalkToTheProgram) {
  EXPECT_TRUE(origin_is_ours(kDoor, "http://127.0.0.1:8766", "127.0.0.1:8766"));
  EXPECT_TRUE(origin_is_ours(kDoor, "", "127.0.0.1:8766"));
  for (const char* origin : {"null", "https://127.0.0.1:8766", "http://evil.example", "http://localhost:8766"})
    EXPECT_FALSE(origin_is_ours(kDoor, origin, "127.0.0.1:8766")) << origin;
  EXPECT_FALSE(origin_is_ours(kDoor, "http://evil.example:8766", "evil.example:8766"));
}

TEST(DesignerDoor, TakesItsOwnTokenAlone) {
  EXPECT_TRUE(has_token(kDoor, "/live?token=" + kDoor.token));
  for (const std::string& target :
       {std::string("/live"), std::string("/live?token="), "/live?token=" + kDoor.token + "0",
        "/live?token=1" + kDoor.token.substr(1), "/live?" + kDoor.token})
    EXPECT_FALSE(has_token(kDoor, target)) << target;
  EXPECT_FALSE(has_token({.listen = "127.0.0.1", .port = 1, .token = ""}, "/live?token="));
  EXPECT_NE(new_token(), new_token());
  EXPECT_EQ(new_token().size(), kTokenLetters);
}

HttpRequest request(const std::string& target, const std::string& host = "127.0.0.1:8766",
                    boost::beast::http::verb verb = boost::beast::http::verb::get) {
  HttpRequest made{verb, target, 11};
  made.set(boost::beast::http::field::host, host);
  return made;
}

TEST(DesignerReplies, ServeThePageWithAStrictPolicyAndNothingElse) {
  const Result<PageFiles> files = designer_files();
  ASSERT_TRUE(files.ok()) << to_string(files.error());
  const HttpReply page = reply_to(request("/?token=x"), *files, kDoor);
  EXPECT_EQ(page.result_int(), 200U);
  EXPECT_TRUE(says(page.body(), "telepalp"));
  EXPECT_TRUE(says(std::string(page["Content-Security-Policy"]), "default-src 'none'"));
  EXPECT_FALSE(says(std::string(page["Content-Security-Policy"]), "unsafe"));
  EXPECT_EQ(reply_to(request("/designer.js"), *files, kDoor).result_int(), 200U);
  for (const char* target : {"/../designer.cpp", "/nothing", "", "//", "/index.html/..", "*"})
    EXPECT_EQ(reply_to(request(target), *files, kDoor).result_int(), 404U) << target;
  EXPECT_EQ(reply_to(request("/", "evil.example:8766"), *files, kDoor).result_int(), 421U);
  EXPECT_EQ(reply_to(request("/", "127.0.0.1:8766", boost::beast::http::verb::post), *files, kDoor).result_int(), 405U);
}

TEST(DesignerReplies, TheLivePartNeedsHostOriginAddressAndToken) {
  HttpRequest good = request("/live?token=" + kDoor.token);
  EXPECT_FALSE(refusal_of_live(good, kDoor).has_value());
  good.set(boost::beast::http::field::origin, "http://evil.example");
  EXPECT_EQ(refusal_of_live(good, kDoor)->result_int(), 403U);
  EXPECT_EQ(refusal_of_live(request("/live?token=wrong"), kDoor)->result_int(), 401U);
  EXPECT_EQ(refusal_of_live(request("/other?token=" + kDoor.token), kDoor)->result_int(), 404U);
  EXPECT_EQ(refusal_of_live(request("/live?token=" + kDoor.token, "evil.example:8766"), kDoor)->result_int(), 421U);
}

TEST(DesignerAnswers, SayNumbersThatAreNotFiniteAsNull) {
  Judgement nobody;
  nobody.overshoots_mm = {std::numeric_limits<double>::quiet_NaN()};
  nobody.hands_N = nobody.overshoots_mm;
  summarise(nobody);
  const std::string answer = prediction_json(nobody);
  EXPECT_TRUE(says(answer, "null"));
  EXPECT_FALSE(says(answer, "nan"));
}

}  // namespace
}  // namespace telepalp::study
