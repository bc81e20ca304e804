// Two ends of a connection find paths over loopback, with libnice; their messages pass in memory.
#include "proto/ice/ice_paths.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <string>

namespace telepalp::ice {
namespace {

using namespace std::chrono_literals;

struct TwoEnds {
  struct End {
    std::unique_ptr<IcePaths> paths;
    std::vector<std::optional<PathKind>> told;
    std::size_t datagrams = 0;
    std::vector<msg::IcePath> said;
    std::vector<std::string> unused_relays;
  };

  boost::asio::io_context io{1};
  End server, client;
  std::vector<msg::IceRelay> relays;
  std::function<bool(const msg::IcePath&)> passes = [](const msg::IcePath&) { return true; };

  TwoEnds() {
    make(server, client, IcePaths::End::Server);
    make(client, server, IcePaths::End::Client);
  }
  ~TwoEnds() {
    server.paths.reset();
    client.paths.reset();
    io.restart();
    io.poll();  // attempts that end are destroyed by the executor
  }
  TwoEnds(const TwoEnds&) = delete;
  TwoEnds& operator=(const TwoEnds&) = delete;

  void make(End& end, End& other, IcePaths::End which) {
    end.paths = std::make_unique<IcePaths>(
        io.get_executor(), IcePaths::Settings{.end = which, .reach = Reach::Loopback, .attempt_lasts = 3s},
        IcePaths::Handlers{
            .signal =
                [this, &end, &other](const msg::IcePath& message) {
                  end.said.push_back(message);
                  if (!passes(message)) return;
                  boost::asio::post(io, [&other, message] {
                    if (other.paths) other.paths->heard(message);
                  });
                },
            .on_datagram = [&end](std::span<const std::byte>) { ++end.datagrams; },
            .on_path = [&end](std::optional<PathKind> path) { end.told.push_back(path); },
            .relays = [this] { return relays; },
            .on_unused_relay = [&end](const Error& why) { end.unused_relays.push_back(to_string(why)); }});
  }
  template <class Condition>
  bool run_until(Condition condition, std::chrono::milliseconds most = 10s) {
    const auto end = std::chrono::steady_clock::now() + most;
    io.restart();
    while (!condition() && std::chrono::steady_clock::now() < end) io.run_one_for(20ms);
    return condition();
  }
  bool both_have_paths() {
    return run_until([this] { return server.paths->path().has_value() && client.paths->path().has_value(); });
  }
  bool datagrams_pass() {
    const std::array<std::byte, 1200> datagram{};
    const std::size_t before = client.datagrams, back_before = server.datagrams;
    return run_until(
        [&] {
          (void)server.paths->send(datagram);
          (void)client.paths->send(datagram);
          return client.datagrams > before && server.datagrams > back_before;
        },
        2s);
  }
};

TEST(IcePaths, CarryDatagramsOfTwoEndsOnOneNetworkDirectly) {
  TwoEnds ends;
  ends.server.paths->begin();
  ASSERT_TRUE(ends.both_have_paths());
  EXPECT_EQ(ends.server.paths->path(), PathKind::Direct);
  EXPECT_EQ(ends.client.paths->path(), PathKind::Direct);
  EXPECT_TRUE(ends.datagrams_pass());
}

TEST(IcePaths, TakeANewPathForASilentOneWithoutAMomentInWhichNonePasses) {
  TwoEnds ends;
  ends.server.paths->begin();
  ASSERT_TRUE(ends.both_have_paths());
  ends.server.paths->lost();
  EXPECT_TRUE(ends.run_until([&] {
    EXPECT_TRUE(ends.server.paths->path() && ends.client.paths->path());
    return ends.server.told.size() == 2 && ends.client.told.size() == 2;
  }));
  EXPECT_EQ(ends.server.paths->counts().attempts, 2U);
  EXPECT_TRUE(ends.datagrams_pass());
}

TEST(IcePaths, TryAgainWhenNothingArrives) {
  TwoEnds ends;
  ends.passes = [](const msg::IcePath& message) { return message.attempt() != 1; };
  ends.server.paths->begin();
  EXPECT_TRUE(ends.both_have_paths());
  EXPECT_GE(ends.server.paths->counts().attempts, 2U);
}

TEST(IcePaths, IgnoreWhatAPeerMustNotSay) {
  TwoEnds ends;
  msg::IcePath message;
  message.set_attempt(1);
  message.set_user("short");
  message.set_password("shorter than 22");
  ends.client.paths->heard(message);
  EXPECT_EQ(ends.client.paths->counts().refused, 1U) << "a password that can be guessed";
  message.set_password(std::string(22, 'p'));
  for (int i = 0; i < 40; ++i)
    message.add_candidates("candidate:1 1 udp 1 127.0.0.1 " + std::to_string(40000 + i) + " typ host");
  message.add_candidates("candidate:1 1 udp 1 secret.example 80 typ host");
  ends.client.paths->heard(message);
  EXPECT_EQ(ends.client.paths->counts().refused, 1U + 8U + 1U) << "32 candidates are taken";
  for (std::uint32_t attempt = 2; attempt < 100; ++attempt) {
    message.set_attempt(attempt);
    ends.client.paths->heard(message);
  }
  EXPECT_EQ(ends.client.paths->counts().attempts, 1U) << "attempts that follow each other at once are not joined";
  ends.server.paths->heard(message);
  EXPECT_EQ(ends.server.paths->counts().attempts, 0U) << "a client begins no attempt";
}

TEST(IcePaths, SayAtBothEndsThatARelayDoesNotAnswer) {
  TwoEnds ends;
  boost::asio::ip::udp::socket silent(ends.io, {boost::asio::ip::address_v4::loopback(), 0});
  msg::IceRelay& relay = ends.relays.emplace_back();
  relay.set_address("127.0.0.1");
  relay.set_port(silent.local_endpoint().port());
  relay.set_user("1700000000:ward3");
  relay.set_password("password");
  ends.server.paths->begin();
  ASSERT_TRUE(ends.both_have_paths()) << "a direct path needs no relay";
  ASSERT_TRUE(
      ends.run_until([&] { return !ends.server.unused_relays.empty() && !ends.client.unused_relays.empty(); }, 8s));
  EXPECT_TRUE(ends.server.unused_relays.front().starts_with("relay: the relay at 127.0.0.1 gives no address"))
      << ends.server.unused_relays.front();
  EXPECT_EQ(ends.client.unused_relays.size(), 1U);
}

TEST(IcePaths, SayThatNothingIsSentToARelay) {
  TwoEnds ends;
  ends.relays.emplace_back().set_address("224.0.0.1");
  ends.server.paths->begin();
  ASSERT_TRUE(ends.both_have_paths());
  EXPECT_EQ(ends.server.unused_relays.size(), 1U);
  ASSERT_EQ(ends.client.unused_relays.size(), 1U);
  EXPECT_NE(ends.client.unused_relays.front().find("224.0.0.1"), std::string::npos);
}

TEST(IcePaths, ThatAreClosedSayNothingMore) {
  TwoEnds ends;
  ends.server.paths->begin();
  ASSERT_TRUE(ends.both_have_paths());
  ends.server.paths->close();
  const std::size_t said = ends.server.said.size(), told = ends.server.told.size(), came = ends.server.datagrams;
  ends.server.paths->begin();
  (void)ends.run_until([&] { return !ends.client.paths->send(std::array<std::byte, 9>{}); }, 500ms);
  EXPECT_EQ(ends.server.said.size(), said);
  EXPECT_EQ(ends.server.told.size(), told);
  EXPECT_EQ(ends.server.datagrams, came);
}

}  // namespace
}  // namespace telepalp::ice
