// Streams and work queues around a real NATS server.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <thread>

#include "support/nats/work_queue.h"
#include "tests/support/child_process.h"

namespace {

using namespace telepalp;
using namespace std::chrono_literals;

constexpr const char* kServer = "/usr/sbin/nats-server";  // of Debian's package

class NatsStreams : public ::testing::Test {
 protected:
  void SetUp() override {
    if (::access(kServer, X_OK) != 0) GTEST_SKIP() << "nats-server is not installed";
  }
  void start(std::vector<std::string> more) {
    std::vector<std::string> words{"-a", "127.0.0.1", "-p", port_};
    words.insert(words.end(), more.begin(), more.end());
    server_.emplace(kServer, words, folder_.path() / "log");
    for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end;
         std::this_thread::sleep_for(50ms)) {
      auto opened = nats::NatsConnection::open({.address = {.url = "nats://127.0.0.1:" + port_}, .name = "test"});
      if (!opened) continue;
      connection_ = *std::move(opened);
      streams_ = *nats::Streams::open(*connection_);
      return;
    }
    FAIL() << "the NATS server does not start";
  }
  void start_with_streams() {
    start({"-js", "-sd", folder_.path() / "store"});
    ASSERT_TRUE(streams_->keep({.name = "WORK", .subjects = {"work.>"}, .is_work_queue = true, .longest_kept = 1h}));
    ASSERT_TRUE(
        streams_->keep({.name = "KEPT", .subjects = {"kept.>", "also.>"}, .is_work_queue = false, .longest_kept = 1h}));
  }
  [[nodiscard]] std::unique_ptr<nats::WorkQueue> queue() const {
    auto opened = nats::WorkQueue::open(*streams_, "WORK", "all", "work.>");
    EXPECT_TRUE(opened) << to_string(opened.error());
    return *std::move(opened);
  }

  support::TemporaryFolder folder_;
  std::string port_ = std::to_string(20000 + (::getpid() + 11) % 20000);
  std::optional<support::ChildProcess> server_;
  std::unique_ptr<nats::NatsConnection> connection_;
  std::unique_ptr<nats::Streams> streams_;
};

TEST_F(NatsStreams, KeepTheNewestMessageOfEachSubject) {
  start_with_streams();
  const std::string chunk(700'000, 'c');
  for (const auto& [subject, payload] :
       {std::pair<std::string, std::string>{"kept.a", "1"}, {"kept.a", "2"}, {"kept.b", chunk}, {"also.c", ""}})
    ASSERT_TRUE(streams_->store(subject, payload));
  EXPECT_EQ(**streams_->newest("KEPT", "kept.a"), "2");
  EXPECT_EQ(**streams_->newest("KEPT", "kept.b"), chunk);
  EXPECT_EQ(**streams_->newest("KEPT", "also.c"), "");
  EXPECT_EQ(*streams_->newest("KEPT", "kept.none"), std::nullopt);
  EXPECT_EQ(streams_->subjects("KEPT", "kept.*")->size(), 2U);
  EXPECT_TRUE(streams_->erase("KEPT", "kept.*"));
  EXPECT_TRUE(streams_->subjects("KEPT", "kept.*")->empty());
  EXPECT_EQ(streams_->subjects("KEPT", "also.*")->size(), 1U);
  EXPECT_TRUE(streams_->keep({.name = "KEPT", .subjects = {"kept.>"}, .is_work_queue = false, .longest_kept = 1h}))
      << "a stream that is there stays";
}

TEST_F(NatsStreams, AMessageWaitsWhileNobodyAnswersForItsStream) {
  start_with_streams();
  const auto refused = streams_->store_patiently("later.a", "lost", 300ms);
  ASSERT_FALSE(refused) << "no stream takes this subject";
  std::jthread elects([&] {
    std::this_thread::sleep_for(500ms);
    EXPECT_TRUE(streams_->keep({.name = "LATER", .subjects = {"later.>"}, .is_work_queue = false, .longest_kept = 1h}));
  });
  EXPECT_TRUE(streams_->store_patiently("later.a", "kept", 10s));
  EXPECT_EQ(**streams_->newest("LATER", "later.a"), "kept");
}

TEST_F(NatsStreams, AnItemIsDeliveredToOneAndAgainWhenItIsGivenBack) {
  start_with_streams();
  ASSERT_TRUE(streams_->store("work.a", "do it"));
  const auto one = queue(), other = queue();
  auto item = one->take(2s);
  ASSERT_TRUE(item && *item);
  EXPECT_EQ((*item)->payload(), "do it");
  EXPECT_EQ((*item)->subject(), "work.a");
  EXPECT_EQ((*item)->deliveries(), 1U);
  const auto nothing = other->take(300ms);
  EXPECT_TRUE(nothing && !*nothing);
  EXPECT_TRUE((*item)->give_back(0ms));
  auto again = other->take(2s);
  ASSERT_TRUE(again && *again);
  EXPECT_EQ((*again)->deliveries(), 2U);
  EXPECT_TRUE((*again)->finished());
  EXPECT_TRUE(streams_->subjects("WORK", "work.>")->empty());
}

TEST_F(NatsStreams, ABadItemLeavesTheQueue) {
  start_with_streams();
  ASSERT_TRUE(streams_->store("work.a", "poison"));
  const auto queue = this->queue();
  auto item = queue->take(2s);
  ASSERT_TRUE(item && *item);
  EXPECT_TRUE((*item)->remove_as_bad());
  const auto nothing = queue->take(500ms);
  EXPECT_TRUE(nothing && !*nothing);
  EXPECT_TRUE(streams_->subjects("WORK", "work.>")->empty());
}

TEST_F(NatsStreams, AnItemThatTakesLongIsNotDeliveredAgainButALostOneIs) {
  start_with_streams();
  ASSERT_TRUE(streams_->store("work.a", "slow"));
  const auto one = queue(), other = queue();
  auto item = one->take(2s);
  ASSERT_TRUE(item && *item);
  const auto nothing = other->take(nats::WorkQueue::kSilence + 4s);
  EXPECT_TRUE(nothing && !*nothing) << "somebody still works on it";
  item = std::optional<nats::WorkItem>();  // as if its program were killed
  auto again = other->take(nats::WorkQueue::kSilence + 4s);
  ASSERT_TRUE(again && *again);
  EXPECT_EQ((*again)->deliveries(), 2U);
}

TEST_F(NatsStreams, AClusterWithoutJetStreamIsSaidWithItsFix) {
  start({});
  const auto kept =
      streams_->keep({.name = "KEPT", .subjects = {"kept.>"}, .is_work_queue = false, .longest_kept = 1h});
  ASSERT_FALSE(kept);
  EXPECT_NE(kept.error().fix.find("nats-server -js"), std::string::npos) << to_string(kept.error());
}

TEST(NatsAddress, HasFilesForTlsAndItsPasswordIsNotShown) {
  const auto address = nats::parse_address("tls://anna:secret@host:4222?creds=a.creds&ca=b.crt", "--workers");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->url, "tls://anna:secret@host:4222");
  EXPECT_EQ(address->credentials, "a.creds");
  EXPECT_EQ(address->authority, "b.crt");
  EXPECT_EQ(nats::without_password(address->url), "tls://host:4222");
  EXPECT_EQ(nats::without_password("nats://anna:secret@host?creds=a@b"), "nats://host?creds=a@b");
  EXPECT_EQ(nats::without_password("nats://host:4222"), "nats://host:4222");
  for (const char* refused : {"nats://anna:secret@host?x=1", "nats://anna:a?secret@host", "nats://anna:secret@host/"})
    EXPECT_EQ(to_string(nats::parse_address(refused, "--workers").error()).find("secret"), std::string::npos);
  for (const char* wrong : {"", "host", "http://host", "nats://", "nats://host/", "nats://host/ward3",
                            "nats://host?x=1", "nats://host?ca="})
    EXPECT_FALSE(nats::parse_address(wrong, "--workers")) << wrong;
}

}  // namespace
