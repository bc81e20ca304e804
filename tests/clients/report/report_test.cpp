#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "clients/ar/messages/phases.h"
#include "clients/report/figures/energy_figures.h"
#include "clients/report/figures/html.h"
#include "clients/report/figures/motion_figures.h"
#include "clients/report/figures/report_html.h"
#include "clients/report/figures/view.h"
#include "clients/report/session/session_file.h"
#include "clients/report/summary/report_json.h"
#include "proto/wire/mcap/writer.h"
#include "tests/clients/report/made_session.h"
#include "where.h"

namespace telepalp::report {
namespace {

Session session_of(const MadeSession& made) {
  Session session;
  session.name = "made.mcap";
  for (const wire::Message& message : made_messages(made)) add(session, message);
  return session;
}

std::filesystem::path written(const MadeSession& made, const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  std::filesystem::remove(file);
  auto writer = wire::McapWriter::open(
      file, {.program = "report_test", .version = {}, .commit = {}, .source = "made", .scene = {}});
  EXPECT_TRUE(writer.ok());
  for (const wire::Message& message : made_messages(made)) EXPECT_TRUE(writer->write(message).ok());
  EXPECT_TRUE(writer->close().ok());
  return file;
}

std::string json_of(const Session& session) {
  const Summary summary = summarise(session);
  return report_json(session, summary, judge(summary));
}

std::string html_of(const Session& session) {
  const Summary summary = summarise(session);
  return report_html(session, summary, judge(summary), "");
}

TEST(Quantiles, AreByNearestRankAndLeaveOutValuesThatAreNotFinite) {
  std::vector<double> samples;
  for (int i = 1; i <= 1000; ++i) samples.push_back(i);
  samples.push_back(std::nan(""));
  const Quantiles q = quantiles(samples);
  EXPECT_EQ(q.p50, 500.0);
  EXPECT_EQ(q.p99, 990.0);
  EXPECT_EQ(q.p999, 999.0);
  EXPECT_EQ(q.samples, 1000U);
  EXPECT_TRUE(std::isnan(quantiles({}).p50));
}

TEST(Summary, CountsTicksContactAndStatesAsTheyWerePublished) {
  const Summary s = summarise(session_of({.seconds = 4.0}));
  EXPECT_EQ(s.ticks, 8000U);
  EXPECT_EQ(s.touches, 2U);
  EXPECT_NEAR(s.contact_s, 2.0, 0.01);
  EXPECT_NEAR(s.ticks_per_s, 2000.0, 0.5);
  EXPECT_NEAR(s.camera_depth_per_s, 30.0, 0.01);
  EXPECT_NEAR(s.states_per_s, 100.0, 0.01);
  EXPECT_NEAR(s.indentation_max_mm, 35.0, 0.1);
  EXPECT_EQ(s.deadlines_missed, 3U);
  EXPECT_EQ(s.non_finite, 0U);
  double total = 0.0;
  for (const Dwell& dwell : s.dwells) total += dwell.seconds;
  EXPECT_NEAR(total, 4.0, 1e-6);
}

TEST(Summary, FramesAreThoseOfTheStationNotOfEverySubscriber) {
  const Summary s = summarise(session_of({}));
  EXPECT_EQ(s.frames_sent, 118U);
  EXPECT_EQ(s.frames_dropped, 2U);
  EXPECT_EQ(s.frames_received, 118U);
}

msg::StationStats totals(std::uint32_t sender, std::uint64_t ticks, std::uint64_t frames) {
  msg::StationStats stats;
  stats.set_sender(sender);
  stats.set_ticks(ticks);
  stats.set_frames_received(frames);
  return stats;
}

/// The server's statistics of one connection of the station, and of a recorder that is always connected.
msg::ServerStats connection(const std::string& address, std::uint32_t sender, std::uint64_t sent,
                            std::uint64_t dropped) {
  msg::ServerStats stats;
  for (const bool is_station : {false, true}) {
    msg::ServerStats::PerSubscriber& subscriber = *stats.add_subscribers();
    subscriber.set_name(is_station ? "telepalp-station" : "telepalp-record");
    subscriber.set_address(is_station ? address : "127.0.0.1:4000");
    subscriber.set_sender(is_station ? sender : 99);
    msg::ServerStats::PerTopic& depth = *subscriber.add_topics();
    depth.set_topic("/camera/depth");
    depth.set_sent(sent);
    depth.set_dropped(dropped);
    if (address.empty()) break;
  }
  return stats;
}

void add(Session& session, const wire::Topic& topic, double at_s, const auto& proto) {
  add(session, wire::make_message(topic, session_time(kMadeStart_ns + static_cast<std::int64_t>(at_s * 1e9)), proto));
}

TEST(Summary, CountsFramesOfAllConnectionsOfAStationThatCameBack) {
  Session session;
  add(session, wire::kServerStats, 0.0, connection("", 0, 5, 0));
  add(session, wire::kServerStats, 10.0, connection("127.0.0.1:5001", 7, 280, 20));
  add(session, wire::kStationStats, 10.0, totals(7, 20'000, 279));
  add(session, wire::kServerStats, 15.0, connection("127.0.0.1:5002", 7, 83, 0));
  add(session, wire::kStationStats, 15.0, totals(7, 30'000, 362));
  settle(session);
  const Summary s = summarise(session);
  EXPECT_EQ(s.frames_sent, 363U);
  EXPECT_EQ(s.frames_received, 362U);
  EXPECT_EQ(s.frames_dropped, 20U);
  EXPECT_EQ(s.senders.size(), 1U) << "a station that comes back is the same sender";
}

TEST(Summary, CountsOnlyWhatHappenedWhileItWasRecorded) {
  Session session;
  add(session, wire::kServerStats, 0.0, connection("127.0.0.1:5001", 7, 3000, 10));
  add(session, wire::kStationStats, 0.5, totals(7, 200'000, 3010));
  add(session, wire::kServerStats, 5.0, connection("127.0.0.1:5001", 7, 3150, 12));
  add(session, wire::kStationStats, 5.5, totals(7, 210'000, 3160));
  settle(session);
  const Summary s = summarise(session);
  EXPECT_EQ(s.frames_sent, 150U);
  EXPECT_EQ(s.frames_received, 150U);
  EXPECT_EQ(s.frames_dropped, 2U);
}

TEST(Senders, AForgedStateIsSeparatedAndIsAWarningOnTheFirstLine) {
  Session session;
  msg::StationState forged;
  forged.set_sender(666);
  forged.set_phase(msg::PHASE_IN_BODY);
  forged.set_indentation_m(0.5);
  add(session, wire::kStationState, 0.0, forged);  // before the station's first message
  for (wire::Message message : made_messages({.seconds = 2.0})) {
    if (message.topic.name.starts_with("/station/")) {
      msg::Sender sender;
      sender.set_sender(7);
      message.payload = std::make_shared<const std::string>(*message.payload + sender.SerializeAsString());
    }
    add(session, message);
  }
  add(session, wire::kServerStats, 1.9, connection("127.0.0.1:5001", 7, 60, 0));
  add(session, wire::kServerStats, 2.0, connection("127.0.0.1:6660", 666, 0, 0));
  settle(session);
  EXPECT_EQ(session.sender, 7U);
  const Summary s = summarise(session);
  EXPECT_EQ(s.ticks, 4000U);
  ASSERT_EQ(s.senders.size(), 2U);
  EXPECT_EQ(s.senders[1].sender, 666U);
  EXPECT_EQ(s.senders[1].messages, 1U);
  const Verdict verdict = judge(s);
  EXPECT_FALSE(verdict.good);
  EXPECT_TRUE(
      verdict.headline.starts_with("Check the senders: 2 senders published as a station: telepalp-station at "
                                   "127.0.0.1:5001 (4000 ticks, 200 states), telepalp-station at "
                                   "127.0.0.1:6660 (0 ticks, 1 states)"))
      << verdict.headline;
  EXPECT_NE(html_of(session).find("<h2>Senders"), std::string::npos);
}

TEST(Senders, TwoStationsAreNotMergedIntoOneVerdict) {
  Session session;
  const std::vector<wire::Message> messages = made_messages({.seconds = 4.0});
  for (const std::uint32_t station : {1U, 2U})
    for (wire::Message message : messages) {
      if (!message.topic.name.starts_with("/station/")) continue;
      msg::Sender sender;
      sender.set_sender(station);
      message.payload = std::make_shared<const std::string>(*message.payload + sender.SerializeAsString());
      add(session, message);
    }
  settle(session);
  const Summary s = summarise(session);
  EXPECT_EQ(s.touches, 2U);
  EXPECT_EQ(s.ticks, 8000U);
  ASSERT_EQ(s.senders.size(), 2U);
  EXPECT_EQ(s.senders[1].touches, 2U);
}

TEST(Source, IsWhatTheServerCapturedAndNotWhereTheRecorderConnectedTo) {
  Session session = session_of({.seconds = 1.0});
  session.origin = "127.0.0.1:45633";
  msg::CaptureStatus status;
  status.set_source("synthetic:torso,amplitude_mm=8");
  session.capture = status;
  EXPECT_NE(json_of(session).find("\"source\": \"synthetic:torso,amplitude_mm=8\""), std::string::npos);
  EXPECT_NE(html_of(session).find("synthetic:torso,amplitude_mm=8"), std::string::npos);
  session.capture.reset();
  EXPECT_NE(json_of(session).find("\"source\": \"127.0.0.1:45633\""), std::string::npos);
}

/// A run of 8000 ticks of which `missed` were late, on a computer whose idle timer missed `idle` of 2000.
Verdict with_late_ticks(std::uint64_t missed, std::uint64_t idle, bool realtime = false) {
  Summary summary = summarise(session_of({.seconds = 4.0}));
  summary.deadlines_missed = missed;
  summary.idle_timer = IdleTimer{.wakeups = 2000, .missed = idle};
  summary.realtime = realtime;
  return judge(summary);
}

TEST(IdleTimer, ExplainsLateTicksThatAreTheComputersAndSaysWhatToDo) {
  const Verdict verdict = with_late_ticks(18, 5);
  EXPECT_TRUE(
      verdict.headline.starts_with("Look at this computer, the run itself was good: its timer misses "
                                   "wake-ups without any work: 5 of 2000"))
      << verdict.headline;
  EXPECT_NE(verdict.headline.find("real-time priority"), std::string::npos);
  EXPECT_NE(verdict.account.find("18 came too late, about 18 of them because of this computer's timer"),
            std::string::npos)
      << verdict.account;
  EXPECT_EQ(with_late_ticks(18, 5, true).headline.find("real-time priority"), std::string::npos);
}

TEST(IdleTimer, DoesNotExcuseTicksThatTheRunItselfMadeLate) {
  const Verdict verdict = with_late_ticks(80, 1);
  EXPECT_TRUE(verdict.headline.starts_with(
      "Look at this run: the force was late more often than one tick in a "
      "thousand, beyond the wake-ups that this computer's timer misses without work (1 of 2000"))
      << verdict.headline;
  EXPECT_NE(verdict.account.find("about 4 of them"), std::string::npos) << verdict.account;
}

TEST(Summary, LatencyStagesAddUpToTheWhole) {
  const Summary s = summarise(session_of({}));
  EXPECT_NEAR(s.capture_to_encoded_ms.p50, 3.0, 0.001);
  EXPECT_NEAR(s.received_to_decoded_ms.p50 + s.encoded_to_received_ms.p50, 4.5, 0.2);
  EXPECT_GE(s.capture_to_touchable_ms.p50, 19.0);
  EXPECT_LE(s.capture_to_touchable_ms.p99, 23.1);
  EXPECT_NEAR(s.clock_error_ms.p50, 4.0, 1e-9);
  EXPECT_NE(judge(s).account.find(" ms old, known within 4"), std::string::npos) << judge(s).account;
}

TEST(Summary, GivesHowFarPredictionCarriedHandAndSurfaceWithoutTheirSign) {
  const Summary s = summarise(session_of({.seconds = 4.0}));
  EXPECT_NEAR(s.surface_carried_mm.p50, 0.2, 1e-9);
  EXPECT_NEAR(s.surface_carried_mm.p99, 0.2, 1e-9);
  EXPECT_NEAR(s.hand_carried_mm.p50, 1.0, 1e-9);
}

TEST(Summary, TellsBothLedgersAndTheWarningsOfHeat) {
  Session session = session_of({.seconds = 4.0});
  session.states[50].set_passivity_j(-0.003);
  session.states[60].set_hand_excess_j(0.007);
  session.events.emplace_back().set_kind(msg::EVENT_KIND_HEAT);
  const Summary s = summarise(session);
  EXPECT_NEAR(s.display_least_mJ, -3.0, 1e-9);
  EXPECT_NEAR(s.hand_excess_most_mJ, 7.0, 1e-9);
  EXPECT_EQ(s.heat_warnings, 1U);
  EXPECT_NE(json_of(session).find("\"hand_excess_most\": 7"), std::string::npos);
}

TEST(EnergyFigures, DrawBothLedgersAndHeatOnlyWhereItWasNear) {
  const Session warm = session_of({.seconds = 4.0});
  ASSERT_EQ(energy(warm).size(), 1U);
  EXPECT_EQ(energy(warm)[0].series.size(), 3U);
  ASSERT_EQ(heat(warm).size(), 1U);
  const auto warned = std::ranges::count_if(heat(warm)[0].series[0].y, [](double s) { return std::isfinite(s); });
  EXPECT_NEAR(static_cast<double>(warned), 29.0, 2.0) << "0.3 s of states, the rest is a gap";
  EXPECT_TRUE(heat(session_of({.seconds = 1.0})).empty());
  EXPECT_TRUE(energy(session_of({.seconds = 1.0, .with_station = false})).empty());
}

TEST(Summary, AStageThatWasNotStampedIsUnknownRatherThanHuge) {
  Session session;
  msg::SurfaceReport surface;
  surface.set_captured_ns(1'800'000'000'000'000'000);
  session.surfaces.push_back(surface);
  EXPECT_TRUE(std::isnan(summarise(session).capture_to_touchable_ms.p50));
}

TEST(Session, ABatchWithColumnsOfDifferentLengthIsCountedAsDamaged) {
  Session session;
  msg::StationTicks batch;
  batch.add_late_ns(1);
  batch.add_work_us(1.0F);
  add(session, wire::make_message(wire::kStationTicks, session_time(5), batch));
  EXPECT_EQ(session.damaged, 1U);
  EXPECT_EQ(session.ticks.size(), 0U);
}

TEST(Session, APayloadThatIsNoProtobufIsCountedAsDamaged) {
  Session session;
  add(session, {wire::kStationState, session_time(5), std::make_shared<const std::string>("\xff\xff\xff")});
  EXPECT_EQ(session.damaged, 1U);
}

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

TEST(Summary, TheForceInContactIsSeparateFromTheOneThatMovesTheFreeDevice) {
  Session session = session_of({.seconds = 2.0});
  session.ticks.force[0][0] = 7.0F;  // at the start the hand is outside the body
  const Summary s = summarise(session);
  EXPECT_EQ(s.force_max_N, 7.0);
  EXPECT_LT(s.force_in_contact_max_N, 6.0);
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
  EXPECT_NE(verdict.headline.find("no station"), std::string::npos) << verdict.headline;
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

TEST(ReportHtml, WordsFromTheSessionCannotBreakThePage) {
  Session session = session_of({.seconds = 1.0});
  session.name = "<script>alert(1)</script>.mcap";
  msg::StationEvent event;
  event.set_kind(msg::EVENT_KIND_FAULT);
  event.set_text("<img src=x onerror=alert(1)>");
  session.events.push_back(event);
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
  EXPECT_NE(judge(bounded).headline.find("bounded, off by up to 2.85 mm at 1 m"), std::string::npos);
  const Summary lossless = summarise(session_of({.seconds = 4.0, .depth_mode = codec::DepthMode::Temporal}));
  EXPECT_EQ(judge(lossless).headline.find("bounded"), std::string::npos);
  EXPECT_NE(json_of(session_of({.seconds = 4.0, .depth_mode = codec::DepthMode::Temporal})).find("temporal"),
            std::string::npos);
}

TEST(Verdict, OfASessionThatNobodyTouchedSaysHowFarItsDepthIsOffAndFindsNoFault) {
  const Summary seen =
      summarise(session_of({.seconds = 1.0, .with_station = false, .depth_mode = codec::DepthMode::Bounded}));
  const Verdict verdict = judge(seen);
  EXPECT_NE(verdict.account.find("Its depth is bounded, off by up to 2.85 mm at 1 m."), std::string::npos)
      << verdict.account;
  EXPECT_EQ(verdict.headline.find("bounded"), std::string::npos) << verdict.headline;
}

TEST(Verdict, CountsDepthOfUnknownErrorAsNotMeasured) {
  Session session = session_of({.seconds = 2.0, .depth_mode = codec::DepthMode::Bounded});
  for (msg::SurfaceReport& surface : session.surfaces) surface.clear_depth_bound();
  const Verdict verdict = judge(summarise(session));
  EXPECT_FALSE(verdict.good);
  EXPECT_NE(verdict.headline.find("off by an unknown amount"), std::string::npos) << verdict.headline;
}

TEST(ReportJson, GivesTheBoundOfTheDepthInMillimetresOrNull) {
  const std::string bounded = json_of(session_of({.seconds = 1.0, .depth_mode = codec::DepthMode::Bounded}));
  EXPECT_NE(bounded.find("\"least\": 1,"), std::string::npos) << bounded;
  EXPECT_NE(bounded.find("\"per_m2\": 2.85"), std::string::npos) << bounded;
  const std::string exact = json_of(session_of({.seconds = 1.0}));
  EXPECT_NE(exact.find("\"depth_bound_mm\": null"), std::string::npos) << exact;
}

TEST(SessionFile, WithoutACameraThereIsNoFrameAndNoError) {
  const auto file = written({.seconds = 1.0, .with_camera = false}, "report_no_camera.mcap");
  const auto session = read_session(file);
  ASSERT_TRUE(session.ok());
  const auto frame = read_frame(file, *session, kMadeStart_ns);
  ASSERT_TRUE(frame.ok());
  EXPECT_FALSE(frame->has_value());
}

TEST(SessionFile, OneThatWasCutOffSaysHowToRepairIt) {
  const auto file = written({.seconds = 1.0}, "report_cut.mcap");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const auto session = read_session(file);
  ASSERT_FALSE(session.ok());
  EXPECT_NE(to_string(session.error()).find("telepalp-record repair"), std::string::npos) << to_string(session.error());
}

TEST(SessionFile, AnEmptyOneIsAnErrorThatSaysSo) {
  const auto file = written({.seconds = 0.0, .with_station = false, .with_camera = false}, "report_empty.mcap");
  const auto session = read_session(file);
  ASSERT_FALSE(session.ok());
  EXPECT_NE(to_string(session.error()).find("holds no message"), std::string::npos) << to_string(session.error());
}

TEST(SessionFile, OneThatIsNotThereIsAnError) {
  const auto session = read_session("/no/such/session.mcap");
  ASSERT_FALSE(session.ok());
  EXPECT_NE(to_string(session.error()).find("/no/such/session.mcap"), std::string::npos);
}

std::string output_of(const std::string& command, int& code) {
  std::string text;
  std::array<char, 512> block{};
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  while (std::fgets(block.data(), static_cast<int>(block.size()), pipe) != nullptr) text += block.data();
  code = WEXITSTATUS(::pclose(pipe));
  return text;
}

const std::string kProgram = std::string(TELEPALP_BINARY_DIR) + "/bin/telepalp-report ";

TEST(Program, WritesItsThreeFiles) {
  const auto file = written({.seconds = 2.0}, "report_program.mcap");
  const std::filesystem::path out = std::filesystem::path(::testing::TempDir()) / "report_program_out";
  std::filesystem::remove_all(out);
  int code = -1;
  const std::string said = output_of(kProgram + file.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 0) << said;
  for (const char* name : {"report.json", "report.html", "view.png"})
    EXPECT_GT(std::filesystem::file_size(out / name), 1000U) << name;
  std::stringstream png;
  png << std::ifstream(out / "view.png", std::ios::binary).rdbuf();
  EXPECT_EQ(png.str().substr(1, 3), "PNG");
}

/// A new folder for one run of the program.
std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  return folder;
}

std::filesystem::perms mode_of(const std::filesystem::path& file) {
  return std::filesystem::symlink_status(file).permissions();
}

TEST(Program, KeepsWhatShowsThePatientFromOthersAndWritesThroughNoPlantedLink) {
  const auto file = written({.seconds = 1.0}, "report_private.mcap");
  const std::filesystem::path top = fresh_folder("report_private_out"), out = top / "new";
  const std::string command = "umask 022; " + kProgram + file.string() + " --out " + out.string();
  int code = -1;
  std::string said = output_of(command, code);
  ASSERT_EQ(code, 0) << said;
  EXPECT_EQ(mode_of(out), std::filesystem::perms{0750});
  for (const char* name : {"report.json", "report.html", "view.png"}) {
    EXPECT_EQ(mode_of(out / name), std::filesystem::perms{0640}) << name;
    std::filesystem::remove(out / name);
    std::filesystem::create_symlink(top / "victim", out / name);
  }
  said = output_of(command, code);
  ASSERT_EQ(code, 0) << said;
  EXPECT_FALSE(std::filesystem::exists(top / "victim"));
}

TEST(Program, FinishesASessionWhoseRecorderWasCutOffAndSaysSo) {
  const auto file = written({.seconds = 2.0}, "report_unfinished.mcap");
  const std::filesystem::path partial = file.string() + ".partial";
  std::filesystem::rename(file, partial);
  std::filesystem::resize_file(partial, std::filesystem::file_size(partial) * 3 / 4);
  const std::filesystem::path out = fresh_folder("report_unfinished_out");
  int code = -1;
  const std::string said = output_of(kProgram + file.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("was not finished by its recorder; finished it now"), std::string::npos) << said;
  EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
  EXPECT_TRUE(read_session(file).ok());
  EXPECT_FALSE(std::filesystem::exists(partial));
}

TEST(Program, OnAFullDiskSaysSoAndLeavesNoHalfReport) {
  const auto file = written({.seconds = 2.0}, "report_full.mcap");
  const std::filesystem::path out = fresh_folder("report_full_out");
  int code = -1;
  const std::string said =
      output_of("trap '' XFSZ; ulimit -f 40; " + kProgram + file.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 1) << said;
  EXPECT_NE(said.find("fix: free space"), std::string::npos) << said;
  for (const char* name : {"report.html", "view.png"}) EXPECT_FALSE(std::filesystem::exists(out / name)) << name;
}

TEST(Program, SaysWhatIsWrongAndLeavesWithItsCode) {
  int code = -1;
  EXPECT_NE(output_of(kProgram, code).find("fix:"), std::string::npos);
  EXPECT_EQ(code, 2);
  EXPECT_NE(output_of(kProgram + "/no/such/session.mcap", code).find("fix:"), std::string::npos);
  EXPECT_EQ(code, 1);
}

}  // namespace
}  // namespace telepalp::report
