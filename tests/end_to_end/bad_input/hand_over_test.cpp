// Two doctors' stations at one patient, as real programs: the touch goes from one to the other by command.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "tests/end_to_end/bad_input/running_session.h"
#include "where.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;

const std::string kStation = TELEPALP_BINARY_DIR "/bin/telepalp-station";

/// What `telepalp-station hand-over` prints to stdout and stderr at the station with this control socket.
std::string hand_over(const std::filesystem::path& control, const std::string& words) {
  const std::string command =
      kStation + " hand-over --patience 20 --control " + control.string() + " " + words + " 2>&1";
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  std::string said;
  std::array<char, 256> piece{};
  while (std::fgets(piece.data(), piece.size(), pipe) != nullptr) said += piece.data();
  const int status = ::pclose(pipe);
  return (status == 0 ? "ok: " : "failed: ") + said;
}

TEST(HandOver, OneCommandOffersTheTouchAndOneCommandAcceptsIt) {
  RunningSession session;
  const auto anna = session.file("control");
  const auto bert = session.file("bert.control");
  const auto key = session.ring().write(
      "bert.key",
      session.ring().authority.client_key(
          {.name = "bert", .role = keys::Role::Doctor, .now = session.ring().now, .valid = std::chrono::days(1)}));
  const support::ChildProcess station(
      kStation,
      {"--connect", "127.0.0.1:" + std::to_string(session.port()), "--key", key.string(), "--patience", "0",
       "--control", bert.string(), "--state-dir", session.file("bert.state").string()},
      session.file("bert.log"));
  ASSERT_TRUE(comes(session.file("bert.log"), "doctor anna holds the touch", 20s)) << text_of(session.file("bert.log"));
  EXPECT_EQ(hand_over(bert, "--to carla"),
            "failed: error: this station is not connected to its server. fix: wait until the station logs 'link "
            "connected', then try again\n");
  EXPECT_EQ(hand_over(anna, "--to bert"),
            "ok: the touch is offered to doctor bert for 60 s: you keep the touch until that doctor accepts it\n");
  EXPECT_TRUE(comes(session.file("bert.log"), "doctor anna offers you the touch", 20s));
  EXPECT_EQ(session.audit().find("event=gave-touch"), std::string::npos) << "an offer alone takes nothing away";
  EXPECT_EQ(hand_over(bert, "--accept"),
            "ok: this station takes the touch (the permission to palpate) as soon as it is free, or another doctor "
            "offers it\n");
  EXPECT_TRUE(comes(session.file("bert.log"), "control loop runs at 2 kHz", 30s)) << text_of(session.file("bert.log"));
  EXPECT_TRUE(comes(session.file("station.log"), "the touch is handed over to doctor bert", 20s))
      << text_of(session.file("station.log"));
  EXPECT_TRUE(comes(session.file("station.log"), "doctor bert holds the touch", 20s)) << "anna's station now waits";
  for (const char* event : {"event=offered-touch who=doctor anna", "event=gave-touch who=doctor anna",
                            "event=took-touch who=doctor bert", "by=hand-over"})
    EXPECT_NE(session.audit().find(event), std::string::npos) << event << "\n" << session.audit();
}

}  // namespace
}  // namespace telepalp::bad_input
