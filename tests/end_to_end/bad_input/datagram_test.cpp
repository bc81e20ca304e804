// Bad datagrams on real sockets, between the real server and the station of a doctor who feels the patient: an attacker
// sits on the path. Nothing is answered, all is counted, and the doctor's session goes on.

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "tests/end_to_end/bad_input/running_session.h"
#include "tests/end_to_end/bad_input/udp_tap.h"
#include "tests/server/datagram_relay.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;
using To = UdpTap::To;

/// One server, one station and one attacker between them for all tests of this file.
struct Attacked {
  std::unique_ptr<UdpTap> tap;
  RunningSession session{[this](std::uint16_t server_port) {
    tap = std::make_unique<UdpTap>(server_port);
    return tap->port();
  }};
};

class DatagramTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    ASSERT_TRUE(comes(session().file("station.log"), "the images come by sealed datagrams", 20s))
        << text_of(session().file("station.log"));
  }
  static RunningSession& session() { return SharedByTests<Attacked>::get().session; }
  static UdpTap& tap() { return *SharedByTests<Attacked>::get().tap; }

  /// The attack is under way for a second and a half. Checks that each way had datagrams to attack, and that the
  /// session was not disturbed.
  static void expect_undisturbed_by(const UdpTap::Carry& carry) {
    const std::uint64_t up = tap().carried(To::Server);
    const std::uint64_t down = tap().carried(To::Station);
    session().expect_undisturbed_by([&] {
      tap().set_carry(carry);
      std::this_thread::sleep_for(1500ms);
      tap().set_carry({});
    });
    EXPECT_GT(tap().carried(To::Server), up + 5) << "reports of the station";
    EXPECT_GT(tap().carried(To::Station), down + 20) << "images of the patient";
  }
  /// Waits for a count of the server, which publishes its counts each second.
  template <class Count>
  static bool grows(Count count, std::uint64_t beyond) {
    for (int tenth = 0; tenth < 50; ++tenth) {
      if (count(session().datagrams()) > beyond) return true;
      std::this_thread::sleep_for(100ms);
    }
    return false;
  }
};

using Counts = msg::ServerStats::Datagrams;

class BadInput15 : public DatagramTest {};
TEST_F(BadInput15, DatagramsOfAStrangerAreNotAnsweredAndAreAudited) {
  const std::uint64_t before = session().datagrams().strangers();
  std::mt19937 random(15);
  std::vector<std::string> datagrams{"", "GET / HTTP/1.1\r\n\r\n", std::string(1500, '\1'), std::string(60'000, '\0')};
  for (int i = 0; i < 500; ++i) {
    std::string one(1 + random() % 1400, '\0');
    for (char& byte : one) byte = static_cast<char>(random());
    one.front() = '\1';  // the version of sealed datagrams
    datagrams.push_back(one);
  }
  std::size_t answers = 1;
  session().expect_undisturbed_by([&] {
    boost::asio::io_context io;
    answers = server::DatagramRelay::answers_to(io, session().port(), datagrams);
  });
  EXPECT_EQ(answers, 0U) << "seed 15";
  EXPECT_TRUE(grows([](const Counts& counts) { return counts.strangers(); }, before + 400));
  EXPECT_TRUE(comes(session().file("audit.log"), "datagrams were refused", 20s)) << session().audit();
}

class BadInput16 : public DatagramTest {};
TEST_F(BadInput16, DatagramsThatAreReplayedInBothDirectionsAreDeliveredOnce) {
  const std::uint64_t before = session().datagrams().replayed();
  std::array<std::deque<std::string>, 2> heard;
  expect_undisturbed_by([&](UdpTap& path, To to, const std::string& datagram) {
    path.send(to, datagram);
    std::deque<std::string>& old = heard[to == To::Server ? 0 : 1];
    old.push_back(datagram);
    if (old.size() > 200) old.pop_front();
    for (std::size_t i = 0; i < std::min<std::size_t>(old.size(), 5); ++i) path.send(to, old[i * (old.size() / 5)]);
  });
  EXPECT_TRUE(grows([](const Counts& counts) { return counts.replayed(); }, before + 20));
  boost::asio::io_context io;
  EXPECT_EQ(server::DatagramRelay::answers_to(io, session().port(), {heard[0].begin(), heard[0].end()}), 0U)
      << "a replay from another address neither is answered nor draws the images there";
}

class BadInput17 : public DatagramTest {};
TEST_F(BadInput17, AFlippedBitInEveryDatagramIsRefusedAndTheGenuineOneStillPasses) {
  const Counts before = session().datagrams();
  std::mt19937 random(17);
  expect_undisturbed_by([&](UdpTap& path, To to, const std::string& datagram) {
    std::string flipped = datagram;
    flipped[random() % flipped.size()] ^= static_cast<char>(1U << (random() % 8));
    path.send(to, flipped);  // first: a window that moved for it would refuse the genuine one
    path.send(to, datagram);
  });
  EXPECT_TRUE(grows([](const Counts& counts) { return counts.forged() + counts.malformed() + counts.strangers(); },
                    before.forged() + before.malformed() + before.strangers() + 5))
      << "seed 17";
}

class BadInput18 : public DatagramTest {};
TEST_F(BadInput18, DatagramsThatComeTwiceAndInAnotherOrderMakeEachImageTouchableOnce) {
  std::array<std::deque<std::string>, 2> held;
  const auto from = SteadyClock::now();
  expect_undisturbed_by([&](UdpTap& path, To to, const std::string& datagram) {
    std::deque<std::string>& waiting = held[to == To::Server ? 0 : 1];
    waiting.push_front(datagram);  // each group of four is sent backwards, and twice
    if (waiting.size() < 4) return;
    for (int twice = 0; twice < 2; ++twice)
      for (const std::string& one : waiting) path.send(to, one);
    waiting.clear();
  });
  EXPECT_EQ(session().surfaces_felt_twice_since(from), 0U);
}

}  // namespace
}  // namespace telepalp::bad_input
