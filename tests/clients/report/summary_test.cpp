// What a report concludes from the messages of a session: ticks, frames, senders, latency, energy.

#include <gtest/gtest.h>

#include <cmath>

#include "clients/report/figures/energy_figures.h"
#include "clients/report/summary/report_json.h"
#include "proto/wire/datagrams/images_way.h"
#include "tests/clients/report/made_report.h"

namespace telepalp::report {
namespace {

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

msg::StationStats missed(std::uint64_t ticks, std::uint64_t deadlines) {
  msg::StationStats stats = totals(0, ticks, 0);
  stats.set_deadlines_missed(deadlines);
  return stats;
}

TEST(Summary, LateTicksAreNotReplacedByACountOfTheStationThatDoesNotCoverTheRecording) {
  Session session;
  for (const wire::Message& message : made_messages({.seconds = 2.0}))
    if (message.topic.name == wire::kStationTicks.name) add(session, message);
  for (std::size_t i = 0; i < 5; ++i) session.ticks.late_us[100 * i] = 600.0F;
  EXPECT_EQ(summarise(session).deadlines_missed, 5U);
  add(session, wire::kStationStats, 1.0, missed(200'000, 40));  // the station began 100 s before the recording
  EXPECT_EQ(summarise(session).deadlines_missed, 5U) << "one count of a station that began earlier says nothing";
  add(session, wire::kStationStats, 2.0, missed(202'000, 47));
  EXPECT_EQ(summarise(session).deadlines_missed, 7U) << "the station also counts the ticks that it skipped";
}

TEST(Summary, OfAnOlderServerOnlyTheStationsOwnNameIsAStation) {
  Session session;
  msg::ServerStats stats = connection("127.0.0.1:5001", 0, 100, 1);
  msg::ServerStats::PerSubscriber& viewer = *stats.add_subscribers();
  viewer.set_name("nurse's workstation");
  viewer.set_address("127.0.0.1:5003");
  msg::ServerStats::PerTopic& depth = *viewer.add_topics();
  depth.set_topic("/camera/depth");
  depth.set_sent(1000);
  depth.set_dropped(500);
  for (auto& subscriber : *stats.mutable_subscribers()) subscriber.set_sender(0);
  add(session, wire::kServerStats, 0.0, connection("", 0, 0, 0));
  add(session, wire::kServerStats, 1.0, stats);
  add(session, wire::kStationStats, 1.0, totals(0, 2000, 100));
  settle(session);
  const Summary s = summarise(session);
  EXPECT_EQ(s.frames_sent, 100U);
  EXPECT_EQ(s.frames_dropped, 1U);
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
  EXPECT_EQ(verdict.headline, "Check this run: 2 programs published as the station.");
  EXPECT_TRUE(verdict.causes.at(0).what.starts_with(
      "2 programs published as the station: telepalp-station at "
      "127.0.0.1:5001 (4000 ticks, 200 messages of /station/state), telepalp-station at "
      "127.0.0.1:6660 (0 ticks, 1 message of /station/state)"))
      << verdict.causes[0].what;
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
  EXPECT_EQ(verdict.headline, "The run was good, but the station's computer was late.");
  EXPECT_TRUE(verdict.causes.at(0).what.starts_with(
      "the timer of the station's computer misses wake-ups even without work: 5 of 2000"))
      << verdict.causes[0].what;
  EXPECT_NE(verdict.causes[0].to_do.find("real-time priority"), std::string::npos);
  EXPECT_NE(verdict.account.find("18 were late, all of them because of the timer of the station's computer"),
            std::string::npos)
      << verdict.account;
  EXPECT_EQ(with_late_ticks(18, 5, true).causes.at(0).to_do.find("real-time priority"), std::string::npos);
}

TEST(IdleTimer, DoesNotExcuseTicksThatTheRunItselfMadeLate) {
  const Verdict verdict = with_late_ticks(80, 1);
  EXPECT_TRUE(verdict.headline.starts_with("Check this run: the force came late")) << verdict.headline;
  EXPECT_TRUE(
      verdict.causes.at(0).what.starts_with("the force came late: 80 of 8000 deadlines were missed, more than one in "
                                            "a thousand, not counting the wake-ups that the timer of the "
                                            "station's computer misses even without work (1 of 2000"))
      << verdict.causes[0].what;
  EXPECT_NE(verdict.account.find("about 4 of them"), std::string::npos) << verdict.account;
}

TEST(Summary, LatencyStagesAddUpToTheWhole) {
  const Summary s = summarise(session_of({}));
  EXPECT_NEAR(s.capture_to_encoded_ms.p50, 3.0, 0.001);
  EXPECT_NEAR(s.received_to_decoded_ms.p50 + s.encoded_to_received_ms.p50, 4.5, 0.2);
  EXPECT_GE(s.capture_to_touchable_ms.p50, 19.0);
  EXPECT_LE(s.capture_to_touchable_ms.p99, 23.1);
  EXPECT_NEAR(s.clock_error_ms.p50, 4.0, 1e-9);
  EXPECT_NE(judge(s).account.find(" ms old, known to within 4"), std::string::npos) << judge(s).account;
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

void tell(Session& session, std::int64_t at_ns, const std::string& text) {
  msg::StationEvent& event = session.events.emplace_back();
  event.set_kind(msg::EVENT_KIND_LINK);
  event.set_stamp_ns(static_cast<std::uint64_t>(session.first_ns.value_or(0) + at_ns));
  event.set_text(text);
}

TEST(Summary, NamesTheWayOfImagesAndTouch) {
  Session session = session_of({.seconds = 4.0});
  EXPECT_EQ(judge(summarise(session)).account.find("Images and touch went"), std::string::npos);
  tell(session, 500'000'000, wire::images_come_by_datagram("over a relay (UDP), round trip 43 ms"));
  EXPECT_NE(judge(summarise(session))
                .account.find(" Images and touch went by datagrams over a relay (UDP), round trip 43 ms."),
            std::string::npos)
      << judge(summarise(session)).account;
  tell(session, 2'000'000'000, wire::images_come_over_tcp());
  tell(session, 2'100'000'000, "the server's clock stepped by +2.0 s");
  tell(session, 2'500'000'000, wire::images_come_by_datagram(""));
  const Summary s = summarise(session);
  ASSERT_EQ(s.ways.size(), 3U);
  EXPECT_NEAR(s.ways[1].from_s, 2.0, 1e-6);
  EXPECT_NE(judge(s).account.find("; from 2 s on over TCP; from 2.5 s on by datagrams to the server's UDP port."),
            std::string::npos)
      << judge(s).account;
  EXPECT_NE(json_of(session).find("\"way\": \"over TCP\""), std::string::npos) << json_of(session);
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
  add(session, {wire::kStationState, session_time(5), std::make_shared<const std::string>("\xff\xff\xff"), 0, true});
  EXPECT_EQ(session.damaged, 1U);
}

}  // namespace
}  // namespace telepalp::report
