// The report that people and programs read: JSON, verdict and page.

#include <gtest/gtest.h>

#include <cmath>

#include "clients/ar/messages/phases.h"
#include "clients/report/figures/compensation_figures.h"
#include "clients/report/figures/energy_figures.h"
#include "clients/report/figures/events.h"
#include "clients/report/figures/html.h"
#include "clients/report/figures/image_counts.h"
#include "clients/report/figures/motion_figures.h"
#include "clients/report/figures/view.h"
#include "clients/report/summary/report_json.h"
#include "support/plot/number.h"
#include "tests/clients/report/made_report.h"

namespace telepalp::report {
namespace {

TEST(ReportJson, HasEveryKeyThatOthersReadEvenOfASessionWithoutStation) {
  for (const bool with_station : {true, false}) {
    const std::string json = json_of(session_of({.seconds = 1.0, .with_station = with_station}));
    for (const char* key : {"ticks",        "tick_us",       "p50",
                            "p99",          "p999",          "deadlines_missed",
                            "frames",       "sent",          "received",
                            "dropped",      "latency_ms",    "capture_to_touchable",
                            "states",       "entries",       "seconds",
                            "contact_s",    "force_N",       "max",
                            "energy_mJ",    "display_least", "hand_excess_most",
                            "heat_warnings"})
      EXPECT_NE(json.find('"' + std::string(key) + "\":"), std::string::npos) << key;
    for (const ar::PhaseWords& words : ar::kPhases)
      EXPECT_NE(json.find('"' + std::string(words.key) + "\": {"), std::string::npos) << words.key;
    EXPECT_EQ(json.find("nan"), std::string::npos);
    EXPECT_EQ(json.find("inf"), std::string::npos);
  }
}

TEST(ReportJson, AForceThatIsNoNumberIsCountedAndNeverPrinted) {
  Session session = session_of({.seconds = 1.0});
  session.ticks.force[1][700] = std::nanf("");
  const Summary summary = summarise(session);
  EXPECT_EQ(summary.non_finite, 1U);
  EXPECT_FALSE(judge(summary).good);
  EXPECT_EQ(json_of(session).find("nan"), std::string::npos);
  EXPECT_EQ(html_of(session).find(">nan"), std::string::npos);
}

TEST(Verdict, ARunWithinEveryBudgetIsCalledGood) {
  const Verdict verdict = judge(summarise(session_of({})));
  EXPECT_TRUE(verdict.good) << verdict.headline;
  EXPECT_NE(verdict.account.find("2 times"), std::string::npos) << verdict.account;
}

TEST(ReportHtml, SmoothSkinIsExplainedInTheDetailsAndIsNoVerdict) {
  Session session = session_of({});
  if (session.compensations.empty()) session.compensations.resize(10);
  for (msg::StationCompensation& sample : session.compensations) sample.add_objects()->set_slide_unseen(true);
  const Verdict verdict = judge(summarise(session));
  EXPECT_TRUE(verdict.good) << verdict.headline;
  const std::string html = html_of(session);
  EXPECT_NE(html.find("For 100 % of the time, the objects inside the body followed the skin only up and down"),
            std::string::npos);
  EXPECT_EQ(html_of(session_of({})).find("only up and down"), std::string::npos);
}

TEST(Summary, TheForceInContactIsSeparateFromTheOneThatMovesTheFreeDevice) {
  Session session = session_of({.seconds = 2.0});
  session.ticks.force[0][0] = 7.0F;  // at the start the hand is outside the body
  const Summary s = summarise(session);
  EXPECT_EQ(s.force_max_N, 7.0);
  EXPECT_EQ(s.force_of_drive_max_N, 7.0);
  EXPECT_LT(s.force_in_contact_max_N, 6.0);
  EXPECT_NE(json_of(session).find("\"max_of_drive\": 7"), std::string::npos);
  const std::string html = html_of(session);
  EXPECT_NE(html.find("drive |F|, not contact"), std::string::npos);
  EXPECT_NE(html.find("The drive gave at most 7"), std::string::npos);
}

TEST(Verdict, AForceBeyondThePeakIsNamedFirst) {
  Summary summary = summarise(session_of({}));
  summary.force_max_N = 10.2;
  const Verdict verdict = judge(summary);
  EXPECT_FALSE(verdict.good);
  EXPECT_NE(verdict.headline.find("peak force"), std::string::npos);
}

TEST(Verdict, WithoutAStationThereIsNothingToJudge) {
  const Verdict verdict = judge(summarise(session_of({.with_station = false})));
  EXPECT_FALSE(verdict.good);
  EXPECT_NE(verdict.headline.find("no ticks of a station"), std::string::npos) << verdict.headline;
}

/// A run whose depth images took `network_ms` from server to station.
Summary over_a_network(double network_ms) {
  Session session = session_of({});
  const auto more_ns = static_cast<std::uint64_t>(1e6 * network_ms);
  for (msg::SurfaceReport& surface : session.surfaces) {
    surface.set_received_ns(surface.received_ns() + more_ns);
    surface.set_decoded_ns(surface.decoded_ns() + more_ns);
    surface.set_touchable_ns(surface.touchable_ns() + more_ns);
    surface.set_clock_error_s(0.3);
  }
  return summarise(session);
}

TEST(Verdict, ASatelliteIsNamedAsTheCauseAndNothingElse) {
  const Verdict verdict = judge(over_a_network(395.0));
  EXPECT_FALSE(verdict.good);
  EXPECT_TRUE(verdict.headline.starts_with("Check this run: the network made the touch 4")) << verdict.headline;
  ASSERT_EQ(verdict.causes.size(), 1U) << verdict.causes[1].what;
  EXPECT_NE(verdict.causes[0].what.find("resembles the profile “satellite”, on which telepalp allows 450 ms"),
            std::string::npos)
      << verdict.causes[0].what;
  EXPECT_NE(verdict.causes[0].to_do.find("path"), std::string::npos);
  EXPECT_TRUE(judge(over_a_network(395.0), *path_named("satellite")).good) << "by the limits of its own path";
}

TEST(Verdict, AnUncertainClockOnAShortPathIsACause) {
  Session session = session_of({});
  for (msg::SurfaceReport& surface : session.surfaces) surface.set_clock_error_s(0.04);
  const Verdict verdict = judge(summarise(session));
  EXPECT_EQ(verdict.headline, "Check this run: the station's clock was uncertain.");
}

TEST(Verdict, ImagesThatWereSentAndNotReceivedAreACause) {
  Summary summary = summarise(session_of({}));
  summary.frames_received = 80;
  const Verdict verdict = judge(summary);
  EXPECT_EQ(verdict.headline, "Check this run: depth images were lost on the way.");
  EXPECT_NE(verdict.causes.at(0).what.find("80 of 118 depth images"), std::string::npos) << verdict.causes[0].what;
}

TEST(Verdict, ALedgerBelowItsLimitIsNamedBeforeTheNetwork) {
  Summary summary = over_a_network(395.0);
  summary.display_least_mJ = -7.0;
  const Verdict verdict = judge(summary);
  EXPECT_EQ(verdict.headline, "Check this run: the display created energy.");
  summary.hand_excess_most_mJ = 300.0;
  EXPECT_EQ(judge(summary).causes.size(), 3U);
}

TEST(Verdict, TicksThatTheFileLacksAreNoSlowLoop) {
  Session session;
  for (const wire::Message& message : made_messages({}))
    if (message.topic.name != wire::kStationTicks.name || session.messages % 9 != 0)
      add(session, message);
    else
      ++session.messages;
  const Summary summary = summarise(session);
  EXPECT_GT(summary.ticks_missing.value_or(0), 100U);
  const Verdict verdict = judge(summary);
  EXPECT_EQ(verdict.headline, "Check this run: the recording has gaps.") << verdict.causes.at(0).what;
}

TEST(Verdict, ItsHeadlineTakesTwoLinesAtMostHoweverMuchIsWrong) {
  Summary summary = over_a_network(395.0);
  summary.force_max_N = 12.0;
  summary.display_least_mJ = -7.0;
  summary.non_finite = 3;
  summary.tick_us.p999 = 900.0;
  summary.frames_received = 10;
  const Verdict verdict = judge(summary);
  EXPECT_GE(verdict.causes.size(), 5U);
  EXPECT_LE(verdict.headline.size(), 75U) << verdict.headline;
}

TEST(Provenance, StandsInPageAndJsonWithTheNotice) {
  Session session = session_of({.seconds = 1.0});
  session.info = {.program = "telepalp-record",
                  .version = "0.1.0",
                  .commit = "1a2b3c4d",
                  .source = "made",
                  .scene = "name: \"skin\"\n",
                  .recorded_by = "technician tom",
                  .consent = "stated, form 12"};
  const std::string json = json_of(session), html = html_of(session);
  for (const char* text : {"2027-01-15 08:00:00 UTC", "skin", "telepalp-record 0.1.0, commit 1a2b3c4d",
                           "technician tom", "stated, form 12", "telepalp is not a medical device"}) {
    EXPECT_NE(json.find(text), std::string::npos) << text << json;
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  EXPECT_NE(json.find("\"server_software\": null"), std::string::npos) << "of an older version";
  EXPECT_NE(html.find("<dt>station</dt><dd>not stated</dd>"), std::string::npos);
  session.info = {};
  EXPECT_NE(json_of(session).find("\"consent\": null"), std::string::npos);
  EXPECT_NE(html_of(session).find("<dt>patient's consent</dt><dd>not stated</dd>"), std::string::npos) << "said";
}

TEST(Provenance, StatesServerAndStationAsTheyPublishedThemselves) {
  Session session = session_of({.seconds = 1.0});
  msg::ServerStats server;
  server.set_software("telepalp-server 0.1.0, commit 1a2b3c4d");
  add(session, wire::make_message(wire::kServerStats, session_time(kMadeStart_ns), server));
  msg::StationStats station;
  station.set_software("telepalp-station 0.0.9, commit 99887766-modified");
  add(session, wire::make_message(wire::kStationStats, session_time(kMadeStart_ns), station));
  const std::string json = json_of(session), html = html_of(session);
  EXPECT_NE(json.find(R"("server_software": "telepalp-server 0.1.0, commit 1a2b3c4d")"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("station_software": "telepalp-station 0.0.9, commit 99887766-modified")"), std::string::npos);
  EXPECT_NE(html.find("<dt>server</dt><dd>telepalp-server 0.1.0, commit 1a2b3c4d</dd>"), std::string::npos);
  EXPECT_NE(html.find("<dt>station</dt><dd>telepalp-station 0.0.9, commit 99887766-modified</dd>"), std::string::npos);
}

TEST(Provenance, OfAReplayIsItsOneProgram) {
  Session session = session_of({.seconds = 1.0});
  session.info = {.program = "telepalp-replay", .version = "0.1.0", .commit = {}, .source = {}, .scene = {}};
  EXPECT_NE(json_of(session).find(R"("station_software": "simulated by telepalp-replay 0.1.0")"), std::string::npos);
}

/// The made session, one of whose depth images became touchable `late_ms` later, at `at_s`.
Session with_a_late_image(double at_s, double late_ms) {
  Session session = session_of({});
  msg::SurfaceReport& late = session.surfaces.at(static_cast<std::size_t>(30.0 * at_s));
  late.set_touchable_ns(late.touchable_ns() + static_cast<std::uint64_t>(1e6 * late_ms));
  return session;
}

TEST(Moments, OfALateImageSayWhenItWasAndThatTheHandWasNotInContact) {
  const Moments above = moments_beyond(with_a_late_image(2.0, 50.0), Measurement::Latency, 40.0, true);
  EXPECT_EQ(above.passed, 1U);
  EXPECT_EQ(above.in_contact, 0U);
  EXPECT_NEAR(above.first_s, 2.07, 0.01);
  EXPECT_EQ(in_words(above, Measurement::Latency), "1 of 117 depth images, at 2.07 s, not in contact. The worst: " +
                                                       plot::readable(above.worst) + " ms at 2.07 s (Above the skin)");
  const Moments in_body = moments_beyond(with_a_late_image(1.0, 50.0), Measurement::Latency, 40.0, true);
  EXPECT_EQ(in_body.in_contact, 1U);
  EXPECT_EQ(moments_beyond(session_of({}), Measurement::Latency, 40.0, true).passed, 0U);
}

TEST(Moments, StandInPageAndJsonBesideTheirCause) {
  Session session = session_of({});
  session.ticks.force[1][2000] = 12.0F;
  const std::string when = "1 of 8000 ticks, at 1 s, in contact. The worst: 12 N at 1 s (Pressing the skin)";
  const std::string json = json_of(session), html = html_of(session);
  EXPECT_NE(json.find("\"when\": \"" + when + "\""), std::string::npos) << json;
  EXPECT_NE(html.find("<b>When:</b> " + when + "."), std::string::npos);
}

TEST(Moments, OfALimitBelowAreTheSamplesUnderIt) {
  Session session = session_of({});
  session.states.at(100).set_passivity_j(-0.007);
  session.states.at(150).set_passivity_j(-0.009);
  const Moments low = moments_beyond(session, Measurement::Balance, -5.0, false);
  EXPECT_EQ(low.passed, 2U);
  EXPECT_DOUBLE_EQ(low.worst, -9.0);
  EXPECT_DOUBLE_EQ(low.first_s, 1.0);
  EXPECT_DOUBLE_EQ(low.last_s, 1.5);
}

TEST(ImageCounts, TellDroppedFromLostFromOnTheWay) {
  Session session = session_of({});
  Summary summary = summarise(session);
  summary.frames_sent = 110;
  summary.frames_dropped = 10;
  summary.frames_received = 90;
  summary.frames_on_the_way = 12;
  summary.frames_unused = 3;
  const std::string html = image_counts_section(session, summary);
  for (const char* row :
       {"the server had for the station</td><td>120</td><td>100 %", "a newer image came first</td><td>10</td><td>8.3 %",
        "a newer image was complete first</td><td>8</td><td>6.7 %", "(estimated)</td><td>12</td><td>10 %",
        "received by the station</td><td>90</td><td>75 %", "could not be decoded</td><td>3</td><td>2.5 %"})
    EXPECT_NE(html.find(row), std::string::npos) << row << html;
}

TEST(ImageCounts, ImagesThatAreStillOnTheWayAreNotLost) {
  Summary summary = summarise(session_of({}));
  summary.frames_sent = 118;
  summary.frames_received = 106;
  EXPECT_FALSE(judge(summary).good) << "12 of 118 are missing";
  summary.frames_on_the_way = 12;
  EXPECT_TRUE(judge(summary).good) << judge(summary).headline;
}

TEST(ImageCounts, SayThatTcpCameBeforeUdp) {
  Session session;
  for (int second = 0; second < 4; ++second) {
    msg::ServerStats stats;
    auto& subscriber = *stats.add_subscribers();
    subscriber.set_name("telepalp-station");
    subscriber.set_by_datagram(second >= 2);
    add(session, wire::make_message(wire::kServerStats, session_time(kMadeStart_ns + second * 1'000'000'000LL), stats));
  }
  for (const wire::Message& message : made_messages({})) add(session, message);
  Summary summary = summarise(session);
  EXPECT_EQ(carriers_in_words(session, summary), "TCP until 2 s, then UDP (encrypted datagrams) until 4 s, then TCP");
  summary.carriers.resize(1);
  EXPECT_EQ(carriers_in_words(session, summary), "TCP for the whole session");
}

TEST(ImageCounts, SayForHowLongSomethingElseUsedTheLineAndWhatItLeft) {
  Session session;
  for (int second = 0; second < 5; ++second) {
    msg::ServerStats stats;
    auto& subscriber = *stats.add_subscribers();
    subscriber.set_name("telepalp-station");
    if (second >= 2) subscriber.set_share_b_per_s(second == 3 ? 1.2e6 : 2e6);
    add(session, wire::make_message(wire::kServerStats, session_time(kMadeStart_ns + second * 1'000'000'000LL), stats));
  }
  for (const wire::Message& message : made_messages({})) add(session, message);
  EXPECT_EQ(
      shared_line_in_words(summarise(session).shared_line),
      " For 3 s something else used the station's line, such as a download; at least 9.6 Mbit/s were left for the "
      "images.");
  EXPECT_EQ(shared_line_in_words({}), "");
}

TEST(Events, ChangesOfStateAreFoldedAndTheFirstOneIsNoChange) {
  Session session = session_of({.seconds = 1.0});
  for (int change = 0; change < 600; ++change) {
    msg::StationEvent event;
    event.set_kind(msg::EVENT_KIND_PHASE);
    event.set_from(change == 0 ? msg::PHASE_UNSPECIFIED : msg::PHASE_OUT_BODY);
    event.set_to(msg::PHASE_RELEASED);
    session.events.push_back(event);
  }
  const std::string html = events_section(session);
  EXPECT_NE(html.find("<details><summary>600 changes of state</summary>"), std::string::npos);
  EXPECT_NE(html.find("The station begins in the state: Force paused"), std::string::npos);
  EXPECT_EQ(html.find("Start →"), std::string::npos);
  EXPECT_NE(html.find("100 more follow."), std::string::npos);
}

TEST(CompensationFigures, HaveWordsOnTheAxisOfWhatIsSeenOfTheSkin) {
  Session session = session_of({.seconds = 1.0});
  for (msg::StationCompensation& sample : session.compensations) {
    msg::ObjectPlacement& ribs = *sample.add_objects();
    ribs.set_name("ribs");
    ribs.mutable_moved()->set_y(0.002);
    ribs.set_slide_unseen(true);
  }
  const std::vector<plot::Chart> charts = compensation(session);
  const plot::Chart& seen = charts.back();
  ASSERT_EQ(seen.y.ticks.size(), 3U);
  EXPECT_EQ(seen.y.ticks[1].label, "up and down only");
  EXPECT_EQ(seen.series.at(0).y.at(5), 1.0);
  const plot::Chart& moved = charts.at(charts.size() - 2);
  EXPECT_EQ(moved.y.label, "distance [mm]");
  for (const plot::Series& series : moved.series)
    for (const double value : series.y) EXPECT_GE(value, 0.0) << series.name << ": a code on an axis in mm";
}

TEST(ReportHtml, ExplainsItsWordsAndItsTwoBasesOfShares) {
  const std::string html = html_of(session_of({}));
  for (const char* words :
       {"<dt>drive</dt>", "<dt>display</dt>", "<dt>proxy</dt>", "The shares are of the 4 s in which the",
        "Every share is of the images that the server had for the station",
        "depth images that the camera took, per second", "depth, touchable at the station"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
}

TEST(Provenance, TakesTheSceneFromTheStationWhereTheRecorderStatesNone) {
  Session session = session_of({.seconds = 1.0});
  msg::StationEvent event;
  event.set_kind(msg::EVENT_KIND_SCENE);
  event.set_text("the control loop runs scene palpation without real-time priority");
  session.events.push_back(event);
  EXPECT_NE(json_of(session).find("\"scene\": \"palpation\""), std::string::npos);
}

TEST(MotionFigures, TheCylinderIsShownOnlyWhenVisited) {
  EXPECT_TRUE(around_the_cylinder(session_of({.seconds = 2.0})).empty());
  EXPECT_EQ(around_the_cylinder(session_of({.seconds = 4.0})).size(), 3U);
}

TEST(MotionFigures, IndentationIsMeasuredFromTheFirstContact) {
  const auto charts = force_against_indentation(session_of({.seconds = 2.0}));
  ASSERT_EQ(charts.size(), 4U);
  double deepest = 0.0;
  for (const double d : charts[1].series[0].x)
    if (std::isfinite(d)) deepest = std::min(deepest, d);
  EXPECT_NEAR(deepest, -34.0, 0.1);
}

TEST(ReportHtml, IsSelfContained) {
  const std::string html = html_of(session_of({}));
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("src=\"http"), std::string::npos);
  EXPECT_EQ(html.find("href="), std::string::npos);
  EXPECT_LT(html.size(), 3'000'000U);
  for (const char* words : {"The run was good", "Force against indentation", "The whole run", "The 2 kHz loop"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
}

TEST(ReportHtml, CallsTheStatesWhatADoctorWouldAlsoInASessionOfAnOlderStation) {
  Session session = session_of({.seconds = 4.0});
  msg::StationEvent event;
  event.set_kind(msg::EVENT_KIND_PHASE);
  event.set_from(msg::PHASE_PLANE_TO_BODY);
  event.set_to(msg::PHASE_CYLINDER_LATERAL);
  event.set_text("Plane to body → Cylinder lateral");
  session.events.push_back(event);
  const std::string html = html_of(session);
  for (const char* words : {"ylinder", "ut body", "lane to body", "ody to plane", ">in body", "eleased"})
    EXPECT_EQ(html.find(words), std::string::npos) << words;
  EXPECT_NE(html.find("Approaching the skin → Side of an inner object"), std::string::npos);
}

TEST(ReportHtml, WordsFromTheSessionCannotBreakThePage) {
  Session session = session_of({.seconds = 1.0});
  session.name = "<script>alert(1)</script>.mcap";
  msg::StationEvent event;
  event.set_kind(msg::EVENT_KIND_FAULT);
  event.set_text("<img src=x onerror=alert(1)>");
  session.events.push_back(event);
  session.notes.add_notes()->set_text("<img src=x onerror=alert(2)>");
  const std::string html = html_of(session);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("<img src=x"), std::string::npos);
}

TEST(Base64, EqualsTheVectorsOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(DeepestMoment, IsThatOfTheGreatestIndentation) {
  EXPECT_NEAR(static_cast<double>(deepest_moment_ns(session_of({.seconds = 1.9})) - kMadeStart_ns) * 1e-9, 1.0, 0.011);
}

TEST(SessionFile, GivesBackTheFrameNearestToAMoment) {
  const auto file = written({.seconds = 2.0}, "report_nearest.mcap");
  const auto session = read_session(file);
  ASSERT_TRUE(session.ok()) << to_string(session.error());
  EXPECT_EQ(session->origin, "made");
  const auto frame = read_frame(file, *session, kMadeStart_ns + 1'010'000'000);
  ASSERT_TRUE(frame.ok() && frame->has_value());
  EXPECT_NEAR(static_cast<double>(to_nanoseconds((*frame)->captured) - kMadeStart_ns) * 1e-9, 1.0, 1e-6);
  EXPECT_EQ((*frame)->color.width, 320);
  EXPECT_TRUE(is_well_formed(**frame));
}

TEST(SessionFile, GivesAFrameThatDependsOnAKeyFrameLongBeforeIt) {
  const auto file =
      written({.seconds = 6.0, .depth_mode = codec::DepthMode::Temporal, .key_every = 1000}, "report_groups.mcap");
  const auto session = read_session(file);
  ASSERT_TRUE(session.ok()) << to_string(session.error());
  for (const double at_s : {5.5, 0.0, 3.0}) {
    const auto frame = read_frame(file, *session, kMadeStart_ns + static_cast<std::int64_t>(at_s * 1e9));
    ASSERT_TRUE(frame.ok() && frame->has_value()) << at_s;
    EXPECT_NEAR(static_cast<double>(to_nanoseconds((*frame)->captured) - kMadeStart_ns) * 1e-9, at_s, 0.02);
    EXPECT_TRUE(is_well_formed(**frame));
  }
}

TEST(Verdict, SaysThatBoundedDepthWasTouchedAndIsContentWithLosslessDepth) {
  const Summary bounded = summarise(session_of({.seconds = 4.0, .depth_mode = codec::DepthMode::Bounded}));
  EXPECT_EQ(bounded.depth.mode, "bounded");
  EXPECT_FALSE(judge(bounded).good);
  ASSERT_EQ(judge(bounded).causes.size(), 1U);
  EXPECT_EQ(judge(bounded).headline, "Check this run: near-lossless depth was touched.");
  EXPECT_NE(judge(bounded).causes[0].what.find("bounded, off by up to 2.85 mm at 1 m"), std::string::npos);
  EXPECT_NE(judge(bounded).causes[0].to_do.find("--depth-mode fast"), std::string::npos);
  const Summary lossless = summarise(session_of({.seconds = 4.0, .depth_mode = codec::DepthMode::Temporal}));
  EXPECT_EQ(judge(lossless).headline.find("bounded"), std::string::npos);
  EXPECT_NE(json_of(session_of({.seconds = 4.0, .depth_mode = codec::DepthMode::Temporal})).find("temporal"),
            std::string::npos);
}

TEST(Verdict, OfASessionThatNobodyTouchedSaysHowFarItsDepthIsOffAndFindsNoFault) {
  const Summary seen =
      summarise(session_of({.seconds = 1.0, .with_station = false, .depth_mode = codec::DepthMode::Bounded}));
  const Verdict verdict = judge(seen);
  EXPECT_NE(verdict.account.find("The depth of its images is bounded, off by up to 2.85 mm at 1 m."), std::string::npos)
      << verdict.account;
  EXPECT_EQ(verdict.headline.find("bounded"), std::string::npos) << verdict.headline;
}

TEST(Verdict, CountsDepthOfUnknownErrorAsNotMeasured) {
  Session session = session_of({.seconds = 2.0, .depth_mode = codec::DepthMode::Bounded});
  for (msg::SurfaceReport& surface : session.surfaces) surface.clear_depth_bound();
  const Verdict verdict = judge(summarise(session));
  EXPECT_FALSE(verdict.good);
  ASSERT_EQ(verdict.causes.size(), 1U);
  EXPECT_NE(verdict.causes[0].what.find("off by an unknown amount"), std::string::npos) << verdict.causes[0].what;
}

TEST(ReportJson, GivesTheBoundOfTheDepthInMillimetresOrNull) {
  const std::string bounded = json_of(session_of({.seconds = 1.0, .depth_mode = codec::DepthMode::Bounded}));
  EXPECT_NE(bounded.find("\"least\": 1,"), std::string::npos) << bounded;
  EXPECT_NE(bounded.find("\"per_m2\": 2.85"), std::string::npos) << bounded;
  const std::string exact = json_of(session_of({.seconds = 1.0}));
  EXPECT_NE(exact.find("\"depth_bound_mm\": null"), std::string::npos) << exact;
}

}  // namespace
}  // namespace telepalp::report
