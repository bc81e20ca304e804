// A site's hub and an edge's hub, with a real NATS server between them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <map>
#include <string>

#include "server/hub/hub.h"
#include "server/relay/publisher.h"
#include "server/relay/relay_origin.h"
#include "tests/support/child_process.h"

namespace {

using namespace telepalp;
using namespace std::chrono_literals;

std::string any_port() { return std::to_string(20000 + ::getpid() % 20000); }

class RelayCluster : public ::testing::Test {
 protected:
  void SetUp() override {
    constexpr const char* kServer = "/usr/sbin/nats-server";  // of Debian's package
    if (::access(kServer, X_OK) != 0) GTEST_SKIP() << "nats-server is not installed";
    nats_.emplace(kServer, std::vector<std::string>{"-a", "127.0.0.1", "-p", port_}, folder_.path() / "log");
  }
  /// Tries for 10 s, because the server may still start.
  std::unique_ptr<relay::Publisher> publisher() {
    for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end;
         io_.run_for(100ms)) {
      auto opened = relay::Publisher::open(io_, site_, clock_, {.address = address_});
      if (opened) return std::move(opened).value();
      why_ = to_string(opened.error());
    }
    return nullptr;
  }
  /// Publishes an image of `bytes` at the site, and lets both ends work.
  void publish(std::size_t bytes, bool is_key) {
    std::string payload(bytes, '\0');
    for (std::size_t i = 0; i < bytes; ++i) payload[i] = static_cast<char>(i * 7 + published_);
    wire::Message message{wire::kCameraDepth, clock_.now(), std::make_shared<const std::string>(std::move(payload)), 0,
                          is_key};
    sent_.insert_or_assign(++published_, message);
    site_.publish(std::move(message));
    io_.restart();
    io_.run_for(20ms);
  }

  support::TemporaryFolder folder_;
  std::string port_ = any_port();
  std::optional<support::ChildProcess> nats_;
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keeps_running_{io_.get_executor()};
  hub::Hub site_;
  wire::SessionClock clock_{std::chrono::hours(1)};
  relay::RelayAddress address_{.cluster = {.url = "nats://127.0.0.1:" + port_}, .site = "ward"};
  std::string why_;
  std::uint64_t published_ = 0;
  std::map<std::uint64_t, wire::Message> sent_;  // by number
};

TEST_F(RelayCluster, AnEdgeGetsEachMessageWithItsNumberTimeAndContent) {
  const auto publisher = this->publisher();
  ASSERT_TRUE(publisher) << why_;
  publish(1000, true);  // before the edge came
  auto upstream = relay::connect_upstream(io_, {.address = address_});
  ASSERT_TRUE(upstream) << to_string(upstream.error());
  EXPECT_LT(upstream->clock_error, 50ms);
  EXPECT_LT((upstream->clock.now() - clock_.now()).count(), 50'000'000) << "the edge has the site's clock";

  std::vector<wire::Message> came;
  upstream->origin->start({.on_message = [&](wire::Message message) { came.push_back(std::move(message)); },
                           .on_end = [] {},
                           .is_wanted = [](std::string_view) { return true; }});
  io_.restart();
  io_.run_for(500ms);  // the edge asks for a key frame
  for (int i = 0; i < 20; ++i) publish(i % 5 == 0 ? 1'500'000 : 60'000, i % 4 == 0);
  io_.restart();
  io_.run_for(500ms);

  ASSERT_GE(came.size(), 17U) << "a key frame comes within four images";
  for (std::size_t i = 0; i < came.size(); ++i) {
    const wire::Message& sent = sent_.at(came[i].sequence);
    EXPECT_EQ(*came[i].payload, *sent.payload);
    EXPECT_EQ(came[i].published, sent.published);
    EXPECT_EQ(bool{came[i].key_frame}, bool{sent.key_frame});
    EXPECT_EQ(came[i].sequence, came.front().sequence + i) << "none is missing";
  }
}

TEST_F(RelayCluster, ASiteIsPublishedByOneServerAndAnEdgeNeedsIt) {
  const auto publisher = this->publisher();
  ASSERT_TRUE(publisher) << why_;
  hub::Hub other;
  const auto second = relay::Publisher::open(io_, other, clock_, {.address = address_});
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().what.find("another server publishes"), std::string::npos) << second.error().what;
  const auto edge = relay::connect_upstream(io_, {.address = {.cluster = address_.cluster, .site = "nobody"}});
  ASSERT_FALSE(edge);
  EXPECT_NE(edge.error().fix.find("--publish"), std::string::npos) << edge.error().fix;
}

}  // namespace
