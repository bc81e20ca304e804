// One doctor holds the touch: the lease, and how it passes to another doctor.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;
using keys::Role;

TEST(KeyedLink, OneDoctorHoldsTheTouchAndTheNextOneWaitsUntilItIsGiven) {
  KeyedSite site;
  auto anna = std::make_unique<KeyedClient>(site, site.ring.key("anna", Role::Doctor), "doctor",
                                            std::vector<wire::Topic>{wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna->connected(); }));
  KeyedClient bert(site, site.ring.key("bert", Role::Doctor), "doctor", {wire::kStationState});
  site.run_until([&] { return site.access->counts().refused > 0; });
  EXPECT_FALSE(bert.connected());
  EXPECT_FALSE(bert.refused()) << "it is no matter of the key: the station waits";
  EXPECT_NE(site.ring.audit().find("doctor anna holds the touch"), std::string::npos) << site.ring.audit();
  anna->link.stop("the examination is over");
  ASSERT_TRUE(site.run_until([&] {
    return bert.link.not_served_because() && bert.link.not_served_because()->what.starts_with("the touch is free");
  }));
  site.run_until([&] { return bert.connected(); }, 2500ms);
  EXPECT_FALSE(bert.connected()) << "no device begins to move in an empty room";
  bert.link.accept_touch();
  EXPECT_TRUE(site.run_until([&] { return bert.connected(); }));
  EXPECT_NE(site.ring.audit().find("event=gave-touch who=doctor anna"), std::string::npos) << site.ring.audit();
  EXPECT_NE(site.ring.audit().find("event=took-touch who=doctor bert"), std::string::npos) << site.ring.audit();
}

TEST(KeyedLink, TheServersReasonForNotServingIsKeptAsItsOwnErrorUntilAnotherAttemptEndsOtherwise) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  KeyedClient bert(site, site.ring.key("bert", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return bert.link.not_served_because().has_value(); }));
  EXPECT_TRUE(bert.link.not_served_because()->what.starts_with("doctor anna holds the touch"))
      << bert.link.not_served_because()->what;
  EXPECT_FALSE(bert.link.not_served_because()->fix.empty());
  EXPECT_FALSE(anna.link.not_served_because());
  site.listener.reset();
  EXPECT_TRUE(site.run_until([&] { return !bert.link.not_served_because(); })) << "the server is gone: nobody answers";
}

/// anna's station, which holds the touch, and bert's, which waits for it.
struct TwoDoctors {
  KeyedSite site;
  std::unique_ptr<KeyedClient> anna, bert;
  TwoDoctors() {
    anna = std::make_unique<KeyedClient>(site, site.ring.key("anna", Role::Doctor), "doctor",
                                         std::vector<wire::Topic>{wire::kStationState});
    EXPECT_TRUE(site.run_until([&] { return anna->connected(); }));
    bert = std::make_unique<KeyedClient>(site, site.ring.key("bert", Role::Doctor), "doctor",
                                         std::vector<wire::Topic>{wire::kStationState});
    EXPECT_TRUE(site.run_until([&] { return said_to_bert("doctor anna holds the touch"); }));
  }
  [[nodiscard]] bool said_to_bert(const std::string& phrase) const {
    return std::any_of(bert->details.begin(), bert->details.end(),
                       [&](const std::string& detail) { return detail.find(phrase) != std::string::npos; });
  }
  /// The answer to anna's request.
  std::string hand_over(const std::string& to) {
    const std::size_t before = anna->hand_over_answers.size();
    EXPECT_TRUE(anna->link.hand_over(to));
    EXPECT_TRUE(site.run_until([&] { return anna->hand_over_answers.size() > before; }));
    return anna->hand_over_answers.back();
  }
};

TEST(HandOver, TheHolderOffersTheOtherAcceptsAndTheAuditLogHasBoth) {
  TwoDoctors two;
  EXPECT_EQ(two.hand_over("bert"),
            "done: the touch is offered to doctor bert for 60 s: you keep the touch until that doctor accepts it");
  ASSERT_TRUE(two.site.run_until([&] { return two.said_to_bert("doctor anna offers you the touch"); }));
  EXPECT_TRUE(two.anna->connected()) << "an offer alone takes nothing away";
  EXPECT_FALSE(two.bert->connected());
  two.bert->link.accept_touch();
  ASSERT_TRUE(two.site.run_until([&] { return two.bert->connected(); }));
  ASSERT_TRUE(two.site.run_until([&] { return !two.anna->connected(); }));
  const std::string audit = two.site.ring.audit();
  for (const char* event : {"event=offered-touch who=doctor anna", "to=\"bert\"", "event=took-touch who=doctor bert",
                            "by=hand-over from=\"anna\"", "event=gave-touch who=doctor anna", "to=\"doctor bert\""})
    EXPECT_NE(audit.find(event), std::string::npos) << event << "\n" << audit;
  two.site.run_until([&] { return two.anna->connected(); }, 1500ms);
  EXPECT_FALSE(two.anna->connected()) << "anna waits while bert holds the touch";
  two.bert->link.stop("the examination is over");
  two.anna->link.accept_touch();
  EXPECT_TRUE(two.site.run_until([&] { return two.anna->connected(); }));
}

TEST(HandOver, WhatIsNotOfferedToADoctorCannotBeAccepted) {
  TwoDoctors two;
  two.bert->link.accept_touch();
  two.site.run_until([&] { return two.bert->connected(); }, 2500ms);
  EXPECT_FALSE(two.bert->connected()) << "accepting alone takes nothing";
  EXPECT_EQ(two.hand_over("carla").rfind("done: ", 0), 0u);
  two.site.run_until([&] { return two.bert->connected(); }, 2500ms);
  EXPECT_FALSE(two.bert->connected()) << "it is offered to another doctor";
  EXPECT_TRUE(two.anna->connected());
}

TEST(HandOver, AWithdrawnOfferCannotBeAccepted) {
  TwoDoctors two;
  EXPECT_EQ(two.hand_over("bert").rfind("done: ", 0), 0u);
  EXPECT_EQ(two.hand_over("bert"), "refused: the last offer was made just now. fix: wait 1 s, then offer again");
  two.site.run_until([] { return false; }, 600ms);
  EXPECT_EQ(two.hand_over(""), "done: the offer is withdrawn: you keep the touch");
  two.bert->link.accept_touch();
  two.site.run_until([&] { return two.bert->connected(); }, 2500ms);
  EXPECT_FALSE(two.bert->connected());
  EXPECT_TRUE(two.anna->connected());
}

TEST(HandOver, OnlyTheHolderMayOffer) {
  KeyedSite site;
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer));
  KeyedClient quinn(site, site.ring.key("quinn", Role::Qa), "qa");
  KeyedClient dora(site, site.ring.key("dora", Role::Doctor));  // a doctor who only watches
  ASSERT_TRUE(site.run_until([&] { return vera.connected() && quinn.connected() && dora.connected(); }));
  for (KeyedClient* client : {&vera, &quinn, &dora}) {
    EXPECT_TRUE(client->link.hand_over("bert"));
    ASSERT_TRUE(site.run_until([&] { return !client->hand_over_answers.empty(); }));
  }
  EXPECT_NE(vera.hand_over_answers.front().find("the role viewer of vera lacks the right 'hand over'"),
            std::string::npos);
  EXPECT_NE(quinn.hand_over_answers.front().find("the role qa of quinn lacks the right 'hand over'"),
            std::string::npos);
  EXPECT_NE(dora.hand_over_answers.front().find("does not hold the touch"), std::string::npos);
  EXPECT_NE(site.ring.audit().find("event=refused who=viewer vera"), std::string::npos) << site.ring.audit();
}

TEST(TouchLease, AnOfferIsTakenByItsDoctorAloneAndEndsByTimeOrWithTheLease) {
  const auto start = std::chrono::steady_clock::now();
  const auto offered = [&] {
    access::TouchLease lease;
    EXPECT_TRUE(lease.take({.peer = 1, .serial = "a", .name = "anna"}, start));
    EXPECT_FALSE(lease.offer(2, "bert", start)) << "peer 2 holds nothing";
    EXPECT_TRUE(lease.offer(1, "bert", start));
    return lease;
  };
  access::TouchLease lease = offered();
  EXPECT_FALSE(lease.take({.peer = 2, .serial = "b", .name = "bert"}, start + 1s))
      << "an offer alone takes nothing away";
  EXPECT_FALSE(lease.accept({.peer = 3, .serial = "c", .name = "carla"}, start + 1s));
  EXPECT_EQ(lease.accept({.peer = 2, .serial = "b", .name = "bert"}, start + 1s), 1u);
  EXPECT_FALSE(lease.renew(1, start + 1s));
  EXPECT_FALSE(lease.accept({.peer = 2, .serial = "b", .name = "bert"}, start + 1s)) << "it is taken once";

  access::TouchLease late = offered();
  for (auto now = start; now < start + 61s; now += 5s) EXPECT_TRUE(late.renew(1, now));
  EXPECT_FALSE(late.accept({.peer = 2, .serial = "b", .name = "bert"}, start + 61s)) << "an offer stands for 60 s";

  access::TouchLease silent = offered();
  EXPECT_FALSE(silent.offered_to(start + 11s)) << "the offer ends with the holder's lease";
  EXPECT_TRUE(silent.take({.peer = 3, .serial = "c", .name = "carla"}, start + 11s))
      << "then any doctor may take the touch";

  access::TouchLease left = offered();
  left.leave(1, true, start + 1s);
  EXPECT_FALSE(left.take({.peer = 3, .serial = "c", .name = "carla"}, start + 2s)) << "anna left the touch to bert";
  EXPECT_FALSE(left.take({.peer = 1, .serial = "a", .name = "anna"}, start + 2s));
  EXPECT_TRUE(left.take({.peer = 2, .serial = "b", .name = "bert"}, start + 2s));
}

TEST(TouchLease, AnOfferSurvivesABrokenConnectionOfTheHolder) {
  const auto start = std::chrono::steady_clock::now();
  const auto broken = [&] {
    access::TouchLease lease;
    EXPECT_TRUE(lease.take({.peer = 1, .serial = "a", .name = "anna"}, start));
    EXPECT_TRUE(lease.offer(1, "bert", start));
    lease.leave(1, false, start + 1s);
    return lease;
  };
  access::TouchLease returned = broken();
  EXPECT_TRUE(returned.take({.peer = 4, .serial = "a", .name = "anna"}, start + 2s))
      << "anna comes back within her lease";
  EXPECT_EQ(returned.offered_to(start + 2s), "bert") << "and her offer stands";
  EXPECT_TRUE(returned.offer(4, "", start + 3s)) << "she may withdraw it";
  EXPECT_FALSE(returned.accept({.peer = 2, .serial = "b", .name = "bert"}, start + 4s));

  access::TouchLease accepted = broken();
  EXPECT_FALSE(accepted.accept({.peer = 3, .serial = "c", .name = "carla"}, start + 2s));
  EXPECT_EQ(accepted.accept({.peer = 2, .serial = "b", .name = "bert"}, start + 2s), 0u)
      << "bert accepts while no station has the touch";
  EXPECT_FALSE(accepted.take({.peer = 4, .serial = "a", .name = "anna"}, start + 3s)) << "anna comes back too late";

  access::TouchLease ended = broken();
  EXPECT_FALSE(ended.accept({.peer = 2, .serial = "b", .name = "bert"}, start + 12s))
      << "the offer ends with the holder's lease";
  EXPECT_TRUE(ended.take({.peer = 3, .serial = "c", .name = "carla"}, start + 12s));
}

TEST(TouchLease, ARunThatHadToWaitGoesLiveOnlyWhenItsDoctorAccepts) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_TRUE(lease.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_FALSE(lease.take({.peer = 2, .run = 20, .serial = "b", .name = "bert"}, start));
  EXPECT_FALSE(lease.must_accept(20, start)) << "the touch is not free yet";
  lease.leave(1, true, start + 1s);
  EXPECT_FALSE(lease.take({.peer = 3, .run = 20, .serial = "b", .name = "bert"}, start + 2s));
  EXPECT_TRUE(lease.must_accept(20, start + 2s));
  EXPECT_TRUE(lease.take({.peer = 4, .run = 20, .serial = "b", .name = "bert", .accepts = true}, start + 3s));
  lease.leave(4, true, start + 4s);
  EXPECT_TRUE(lease.take({.peer = 5, .run = 50, .serial = "b", .name = "bert"}, start + 5s))
      << "a doctor who starts the station sits at it";
}

TEST(TouchLease, HolderAndWaitingRunsSurviveARestartWithTenSecondsOfGrace) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease before;
  EXPECT_TRUE(before.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_FALSE(before.take({.peer = 2, .run = 20, .serial = "b", .name = "bert"}, start));
  const auto restarted = [&] {
    access::TouchLease lease;
    lease.restore(before.kept(), start + 1h);
    return lease;
  };
  access::TouchLease lease = restarted();
  EXPECT_EQ(lease.holder(start + 1h), "anna");
  EXPECT_FALSE(lease.take({.peer = 1, .run = 30, .serial = "c", .name = "carla"}, start + 1h + 9s)) << "next in line";
  EXPECT_TRUE(lease.take({.peer = 2, .run = 10, .serial = "a", .name = "anna"}, start + 1h + 9s));
  access::TouchLease gone = restarted();
  EXPECT_FALSE(gone.take({.peer = 1, .run = 20, .serial = "b", .name = "bert"}, start + 1h + 11s))
      << "it waited before the restart, too";
  EXPECT_TRUE(gone.take({.peer = 2, .run = 40, .serial = "c", .name = "carla"}, start + 1h + 11s));
  for (const char* damaged : {"", ";", "x;", "a b c; 1 2 z", "a"}) access::TouchLease().restore(damaged, start);
}

TEST(TouchLease, TheTechnicianTakesItAwayAndTheStationThenWaitsForItsDoctor) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_FALSE(lease.take_away(start)) << "nobody holds it";
  EXPECT_TRUE(lease.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_EQ(lease.take_away(start + 1s), "anna");
  EXPECT_FALSE(lease.renew(1, start + 1s));
  EXPECT_FALSE(lease.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start + 2s));
  EXPECT_TRUE(lease.take({.peer = 3, .run = 10, .serial = "a", .name = "anna", .accepts = true}, start + 3s));
}

TEST(KeyedLink, AfterARestartOfTheServerTheHolderGetsTheTouchAndNotTheNextInLine) {
  TwoDoctors two;
  const std::uint16_t port = two.site.listener->port();
  two.site.listener.reset();  // as a kill: nobody says Goodbye
  ASSERT_TRUE(two.site.run_until([&] { return !two.anna->connected(); }));
  two.site.access.reset();  // its audit log is locked while it lives
  two.site.access = two.site.open();
  KeyedClient carla(two.site, two.site.ring.key("carla", Role::Doctor), "doctor", {wire::kStationState}, "127.0.0.1",
                    port);
  auto made =
      hub::PeerListener::listen(two.site.io, two.site.hub, two.site.clock, {.port = port, .access = two.site.access});
  ASSERT_TRUE(made.ok());
  two.site.listener = std::move(made).value();
  EXPECT_TRUE(
      two.site.run_until([&] { return two.anna->connected() || carla.connected() || two.bert->connected(); }, 9s));
  EXPECT_TRUE(two.anna->connected()) << two.site.ring.audit();
}

TEST(KeyedLink, ATechnicianTakesTheTouchAwayAndSendsAWatcherOutAndBothEnd) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  const auto key = site.ring.key("vera", Role::Viewer);
  KeyedClient vera(site, key);
  ASSERT_TRUE(site.run_until([&] { return anna.connected() && vera.connected(); }));
  ASSERT_EQ(site.access->people().present().size(), 2u);
  ASSERT_TRUE(site.access->take_touch_away("technician tina").ok());
  ASSERT_TRUE(site.run_until([&] {
    anna.link.publish(message(wire::kStationState, ""));
    return !anna.connected();
  }));
  site.run_until([&] { return anna.connected(); }, 2500ms);
  EXPECT_FALSE(anna.connected()) << "the station waits for its doctor";
  EXPECT_FALSE(site.access->send_out("0123", "technician tina").ok()) << "nobody has this key";
  EXPECT_FALSE(site.access->send_out(key->identity.serial, "viewer vera").ok()) << "not oneself";
  ASSERT_TRUE(site.access->send_out(key->identity.serial, "technician tina").ok());
  ASSERT_TRUE(site.run_until([&] { return vera.refused(); }, 2500ms));
  EXPECT_NE(vera.link.refusal().what.find("the technician has sent viewer vera out"), std::string::npos)
      << to_string(vera.link.refusal());
  KeyedClient again(site, key);
  ASSERT_TRUE(site.run_until([&] { return again.refused() || again.connected(); }));
  EXPECT_TRUE(again.refused());
  site.access->let_in(key->identity.serial, "technician tina");
  KeyedClient back(site, key);
  EXPECT_TRUE(site.run_until([&] { return back.connected(); }));
  for (const char* event : {"event=took-away-touch from=\"anna\" by=\"technician tina\"",
                            "event=sent-out who=viewer vera by=\"technician tina\"", "event=let-in who=viewer vera"})
    EXPECT_NE(site.ring.audit().find(event), std::string::npos) << event << "\n" << site.ring.audit();
}

TEST(TouchLease, IsLostBySilenceAndKeptForTheSameDoctorOverALostConnection) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_TRUE(lease.take({.peer = 1, .serial = "a", .name = "anna"}, start));
  EXPECT_FALSE(lease.take({.peer = 2, .serial = "b", .name = "bert"}, start + 5s));
  EXPECT_TRUE(lease.renew(1, start + 9s));
  EXPECT_FALSE(lease.take({.peer = 2, .serial = "b", .name = "bert"}, start + 15s)) << "anna spoke 6 s ago";
  EXPECT_TRUE(lease.take({.peer = 2, .serial = "b", .name = "bert"}, start + 20s)) << "anna was silent for 11 s";
  EXPECT_FALSE(lease.renew(1, start + 20s)) << "anna's station hears that it lost the touch";
  lease.leave(2, false, start + 21s);
  EXPECT_FALSE(lease.take({.peer = 3, .serial = "a", .name = "anna"}, start + 22s))
      << "bert's connection was lost: it may come back";
  EXPECT_TRUE(lease.take({.peer = 4, .serial = "b", .name = "bert"}, start + 23s));
  lease.leave(4, true, start + 24s);
  EXPECT_TRUE(lease.take({.peer = 5, .serial = "a", .name = "anna"}, start + 24s));
}

/// A station whose address has changed connects again seconds before the server notices that the older connection is
/// dead.
TEST(TouchLease, PassesAtOnceToTheNewConnectionOfTheSameRun) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_TRUE(lease.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_EQ(lease.older_connection({.peer = 2, .run = 10, .serial = "a", .name = "anna"}), 1U);
  EXPECT_TRUE(lease.take({.peer = 2, .run = 10, .serial = "a", .name = "anna"}, start + 1s));
  EXPECT_FALSE(lease.renew(1, start + 1s)) << "the older connection has lost the touch";
  lease.leave(1, false, start + 5s);
  EXPECT_TRUE(lease.renew(2, start + 6s)) << "the end of the older connection takes nothing away";
}

TEST(TouchLease, PassesToNoOtherRunAndToNoOtherKeyWhileItsHolderIsThere) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_TRUE(lease.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_FALSE(lease.take({.peer = 2, .run = 11, .serial = "a", .name = "anna"}, start)) << "it moves another device";
  EXPECT_FALSE(lease.take({.peer = 3, .run = 10, .serial = "b", .name = "bert"}, start))
      << "a run's number is no proof";
  EXPECT_TRUE(lease.renew(1, start));
  access::TouchLease old_programs;
  EXPECT_TRUE(old_programs.take({.peer = 1, .serial = "a", .name = "anna"}, start));
  EXPECT_FALSE(old_programs.take({.peer = 2, .serial = "a", .name = "anna"}, start)) << "they state no run";
}

TEST(TouchLease, PassesToNoNewConnectionOfARunFromWhichItWasTakenAway) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_TRUE(lease.take({.peer = 1, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_EQ(lease.take_away(start), "anna");
  EXPECT_FALSE(lease.take({.peer = 2, .run = 10, .serial = "a", .name = "anna"}, start));
  EXPECT_TRUE(lease.must_accept(10, start));
}

}  // namespace
}  // namespace telepalp::server
