// Peers with a valid key, and strangers without one, send bad bytes to the real server over TCP while a doctor's
// station feels the patient. Each is refused, counted and audited; the doctor's session goes on.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <thread>

#include "tests/end_to_end/bad_input/insider.h"
#include "tests/end_to_end/bad_input/running_session.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;
using boost::asio::ip::tcp;

class InsiderTest : public ::testing::Test {
 protected:
  static RunningSession& session() { return SharedByTests<RunningSession>::get(); }
  static std::shared_ptr<const keys::KeyFile> mallory() { return session().ring().key("mallory", keys::Role::Viewer); }
  /// A viewer says `bytes` after its Hello. Checks that its connection ends with `reason` in the server's log.
  static void expect_ended(const std::string& bytes, const std::string& reason) {
    session().expect_undisturbed_by([&] {
      Insider insider(session().port(), mallory());
      insider.say(greeting("mallory") + bytes);
      EXPECT_TRUE(insider.is_ended_within(8s));
    });
    EXPECT_TRUE(comes(session().file("server.log"), reason)) << text_of(session().file("server.log"));
    EXPECT_NE(session().audit().find("event=left who=viewer mallory"), std::string::npos) << session().audit();
  }
};

class BadInput02 : public InsiderTest {};
TEST_F(BadInput02, AHeaderThatDeclaresMoreThanAPeerMaySendIsRefusedBeforeItsPayload) {
  expect_ended(server::frame_bytes({.payload_bytes = 1U << 30U, .kind = wire::FrameKind::Data, .channel = 1}, ""),
               "declares a payload of 1073741824 B");
}

class BadInput06 : public InsiderTest {};
TEST_F(BadInput06, ALengthPrefixOfFourGibibytesIsRefused) {
  expect_ended(server::frame_bytes({.payload_bytes = 0xffffffffU}, ""), "declares a payload of 4294967295 B");
}

/// Groups within groups of an unknown field, `depth` of them: what a recursive parser would follow.
std::string nested_groups(int depth) {
  std::string bytes;
  for (int i = 0; i < depth; ++i) bytes += static_cast<char>(0x7b);  // field 15, begins a group
  for (int i = 0; i < depth; ++i) bytes += static_cast<char>(0x7c);
  return bytes;
}

class BadInput07 : public InsiderTest {};
TEST_F(BadInput07, DeeplyNestedProtobufIsRefusedWithoutRecursion) {
  const std::string nested = nested_groups(4'000);
  expect_ended(server::frame_bytes({.payload_bytes = static_cast<std::uint32_t>(nested.size())}, nested),
               "damaged control");
}

class BadInput13 : public InsiderTest {};
TEST_F(BadInput13, APeerThatFallsSilentIsRemoved) {
  session().expect_undisturbed_by([&] {
    Insider half_open(session().port(), mallory());
    half_open.say(greeting("half-open") + subscription("/camera/status"));
    EXPECT_TRUE(half_open.is_ended_within(9s));
  });
  EXPECT_TRUE(comes(session().file("server.log"), "no message arrived for 5 s"))
      << text_of(session().file("server.log"));
}

class BadInput14 : public InsiderTest {};
TEST_F(BadInput14, AViewerThatDoesNotReadLosesItsOwnFramesAlone) {
  Insider stalled(session().port(), mallory());
  session().expect_undisturbed_by([&] {
    stalled.say(greeting("stalled") + subscription("*"));
    std::this_thread::sleep_for(4s);
  });
}

/// True if the server ends a connection that has sent `bytes`, within `patience`.
bool is_ended_after(std::uint16_t port, const std::string& bytes, std::chrono::milliseconds patience) {
  boost::asio::io_context io;
  tcp::socket socket(io);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  boost::asio::write(socket, boost::asio::buffer(bytes));
  bool ended = false;
  std::array<char, 1024> heard{};
  std::function<void()> read = [&] {
    socket.async_read_some(boost::asio::buffer(heard), [&](const boost::system::error_code& code, std::size_t) {
      ended = static_cast<bool>(code);
      if (!ended) read();
    });
  };
  read();
  const auto until = SteadyClock::now() + patience;
  while (!ended && SteadyClock::now() < until) io.run_one_for(20ms);
  return ended;
}

class BadInput11 : public InsiderTest {};
TEST_F(BadInput11, AHandshakeThatStopsInTheMiddleIsEndedBesideTheDoctor) {
  session().expect_undisturbed_by(
      [&] { EXPECT_TRUE(is_ended_after(session().port(), std::string("\x16\x03\x01", 3), 20s)); });
  EXPECT_TRUE(
      comes(session().file("audit.log"), "no Hello message (the greeting of a telepalp program) arrived within 5 s"))
      << session().audit();
}

/// The running process may open `more` further files while this lives.
struct FewDescriptorsOf {
  pid_t process;
  rlimit before{};
  FewDescriptorsOf(pid_t of, std::size_t more) : process(of) {
    std::size_t open = 0;
    for ([[maybe_unused]] const auto& one :
         std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/fd"))
      ++open;
    EXPECT_EQ(::prlimit(process, RLIMIT_NOFILE, nullptr, &before), 0);
    rlimit few = before;
    few.rlim_cur = static_cast<rlim_t>(open + more);
    EXPECT_EQ(::prlimit(process, RLIMIT_NOFILE, &few, nullptr), 0);
  }
  ~FewDescriptorsOf() { EXPECT_EQ(::prlimit(process, RLIMIT_NOFILE, &before, nullptr), 0); }
};

class BadInput33 : public InsiderTest {};
TEST_F(BadInput33, WithoutFreeDescriptorsTheServerServesTheDoctorAndLaterAcceptsAgain) {
  session().expect_undisturbed_by([&] {
    const FewDescriptorsOf few(session().server().pid(), 4);
    boost::asio::io_context io;
    std::vector<tcp::socket> greedy;
    for (int i = 0; i < 12; ++i) {  // few, because the audit log has room for 20 strangers in 10 s
      greedy.emplace_back(io);
      boost::system::error_code ignored;
      greedy.back().connect({boost::asio::ip::make_address("127.0.0.1"), session().port()}, ignored);
    }
    std::this_thread::sleep_for(1s);
  });
  Insider later(session().port(), mallory());
  EXPECT_TRUE(later.say(greeting("later")));
  EXPECT_TRUE(comes(session().file("server.log"), "later (viewer mallory) joined"))
      << text_of(session().file("server.log"));
  EXPECT_NE(session().audit().find("accepting pauses"), std::string::npos) << session().audit();
}

class BadInput12 : public InsiderTest {};
TEST_F(BadInput12, AFloodOfHandshakesDoesNotDisturbTheDoctor) {
  session().expect_undisturbed_by([&] {
    boost::asio::io_context io;
    std::vector<tcp::socket> flood;
    for (int i = 0; i < 200; ++i) {
      flood.emplace_back(io);
      boost::system::error_code ignored;
      flood.back().connect({boost::asio::ip::make_address("127.0.0.1"), session().port()}, ignored);
      boost::asio::write(flood.back(), boost::asio::buffer("\x16\x03\x01", 3), ignored);
      std::this_thread::sleep_for(5ms);
    }
  });
  EXPECT_NE(session().audit().find("have not sent their Hello message yet"), std::string::npos) << session().audit();
}

class BadInput23 : public InsiderTest {};
TEST_F(BadInput23, AViewerThatPublishesTheStationsStateIsDenied) {
  msg::Control control;
  msg::Advertise::Topic& topic = *control.mutable_advertise()->add_topics();
  topic.set_channel(1);
  topic.set_name(std::string(wire::kStationState.name));
  topic.set_schema(std::string(wire::kStationState.schema));
  session().expect_undisturbed_by([&] {
    Insider insider(session().port(), mallory());
    insider.say(greeting("mallory") + server::control_frame(control));
    EXPECT_TRUE(insider.is_ended_within(8s));
  });
  EXPECT_TRUE(comes(session().file("audit.log"), "event=refused who=viewer mallory")) << session().audit();
}

class BadInput34 : public InsiderTest {};
TEST_F(BadInput34, ANameWithNewlinesAndTerminalCodesIsEscapedInLogAndAudit) {
  session().expect_undisturbed_by([&] {
    Insider insider(session().port(), mallory());
    insider.say(greeting("x\nevent=took-touch\x1b[2J") + subscription("/clock"));
    std::this_thread::sleep_for(500ms);
  });
  for (const std::string& text : {text_of(session().file("server.log")), session().audit()}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
    EXPECT_EQ(text.find("\nevent=took-touch"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace telepalp::bad_input
