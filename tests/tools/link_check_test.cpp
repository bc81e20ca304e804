// What telepalp-link check says of the network; tests/end_to_end/datagrams_test.sh runs it between real sockets.
#include <gtest/gtest.h>

#include <algorithm>

#include "tools/link_check/findings.h"

namespace {

using namespace telepalp;
using link_check::Findings;
using link_check::Port;

Findings good() {
  return {.server = "patient.example:7400",
          .addresses = {"10.0.0.5"},
          .link = {.number = 7400, .answer = Port::Answer::Opens, .opens_after_ms = 12.0},
          .web = {.number = 8765, .answer = Port::Answer::Silent},
          .key = "doctor anna",
          .round_trip_ms = 24.0,
          .udp = Findings::Udp::Arrives,
          .images = link_check::Images{.per_s = 30.0, .Mbit_per_s = 27.0, .age_p50_ms = 15.0, .age_p95_ms = 22.0}};
}

std::string verdict(const Findings& found) {
  const std::string lines = link_check::in_lines(found);
  return lines.substr(lines.rfind("\nso") + 1);
}

TEST(LinkCheck, SaysInAtMostTenLinesWhatItFound) {
  const std::string lines = link_check::in_lines(good());
  EXPECT_LE(std::ranges::count(lines, '\n'), 10);
  for (const char* part : {"10.0.0.5", "TCP 7400", "opens after 12.0 ms", "web 8765", "a firewall drops it",
                           "doctor anna", "round trip 24.0 ms", "in both directions", "30.0 a second", "carries touch"})
    EXPECT_NE(lines.find(part), std::string::npos) << part << "\n" << lines;
}

TEST(LinkCheck, NamesTheFirstObstacleAndWhatHelps) {
  Findings found = good();
  EXPECT_TRUE(link_check::carries_a_session(found));
  found.udp = Findings::Udp::Blocked;
  EXPECT_NE(verdict(found).find("open UDP port 7400"), std::string::npos) << verdict(found);
  found.images->per_s = 4.0;
  EXPECT_NE(verdict(found).find("touch does not"), std::string::npos) << verdict(found);
  found.images->per_s = 0.0;
  EXPECT_FALSE(link_check::carries_a_session(found));

  found.no_session = Error{.what = "the key has expired", .where = {}, .fix = "renew it"};
  EXPECT_FALSE(link_check::carries_a_session(found));
  EXPECT_NE(verdict(found).find("renew it"), std::string::npos) << verdict(found);
  found.link.answer = Port::Answer::Refuses;
  EXPECT_NE(verdict(found).find("start telepalp-server"), std::string::npos) << verdict(found);
  found.link.answer = Port::Answer::Silent;
  EXPECT_NE(verdict(found).find("open this port"), std::string::npos) << verdict(found);
  found.addresses.clear();
  EXPECT_NE(verdict(found).find("the name is unknown"), std::string::npos) << verdict(found);
}

TEST(LinkCheck, SaysWhatIsWrongWithTheRelay) {
  Findings found = good();
  found.notice = "relay: the relay's address is 127.0.1.1";
  const std::string lines = link_check::in_lines(found);
  EXPECT_NE(lines.find("but         relay: the relay's address is 127.0.1.1"), std::string::npos) << lines;
  EXPECT_LE(std::ranges::count(lines, '\n'), 10);
}

TEST(LinkCheck, SaysWhyItAskedForNoImages) {
  Findings found = good();
  found.images.reset();
  found.why_no_images = "were not asked for: give --consent TEXT";
  EXPECT_TRUE(link_check::carries_a_session(found));
  EXPECT_NE(link_check::in_lines(found).find("give --consent"), std::string::npos);
}

}  // namespace
