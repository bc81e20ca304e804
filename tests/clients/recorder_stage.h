#pragma once

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "proto/wire/mcap/reading/stream_reader.h"
#include "server/hub/peer_listener.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/child_process.h"
#include "where.h"

/// The program telepalp-record and a hub on loopback, for its tests.
namespace telepalp::record {

using namespace std::chrono_literals;
using wire::samples::bytes_of;

inline const std::filesystem::path kRecorder = TELEPALP_BINARY_DIR "/bin/telepalp-record";

/// A hub on a free loopback port, with its own thread.
class Server {
 public:
  explicit Server(std::uint16_t port = 0) {
    auto made = hub::PeerListener::listen(io_, hub_, clock_, {.port = port});
    EXPECT_TRUE(made) << to_string(made.error());
    listener_ = std::move(made).value();
    port_ = listener_->port();
    thread_ = std::thread([this] { io_.run(); });
  }
  ~Server() {
    boost::asio::post(io_, [this] { listener_->close("end of the test"); });
    thread_.join();
  }
  void publish(const wire::Message& message) {
    boost::asio::post(io_, [this, message] { hub_.publish(message); });
  }
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  [[nodiscard]] std::uint16_t port() const { return port_; }

 private:
  boost::asio::io_context io_;
  hub::Hub hub_;
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  std::unique_ptr<hub::PeerListener> listener_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

class Recorder : public testing::Test {
 protected:
  std::filesystem::path in(const std::string& name) const { return folder_.path() / name; }
  std::filesystem::path session() const { return in("session.mcap"); }

  std::unique_ptr<support::ChildProcess> start(const Server& server, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"--connect", server.address(), "--out", session(), "--ready-file", in("ready")};
    words.insert(words.end(), more.begin(), more.end());
    auto recorder = std::make_unique<support::ChildProcess>(kRecorder, words, in("log"));
    EXPECT_EQ(support::await_ready(in("ready"), "recording"), session().string()) << bytes_of(in("log"));
    return recorder;
  }
  int run(const std::vector<std::string>& words) const {
    support::ChildProcess recorder(kRecorder, words, in("log"));
    return recorder.wait(20s).value_or(-1);
  }
  std::string log() const { return bytes_of(in("log")); }
  template <class Done>
  static bool wait_for(Done done) {
    for (int tries = 0; tries < 1000 && !done(); ++tries) std::this_thread::sleep_for(10ms);
    return done();
  }
  /// Number of messages that can be read sequentially from the unfinished file.
  std::size_t flushed_messages(const std::filesystem::path& file) const {
    auto stream = wire::McapStreamReader::open(file);
    std::size_t count = 0;
    if (stream)
      for (auto next = stream->next(); next && *next; next = stream->next()) ++count;
    return count;
  }
  support::TemporaryFolder folder_;
};

/// Publishes slowly, because a subscriber's queue holds only a short history.
inline void publish_slowly(Server& server, const std::vector<wire::Message>& messages) {
  for (const wire::Message& message : messages) {
    server.publish(message);
    std::this_thread::sleep_for(1ms);
  }
}

inline std::vector<wire::Message> states(double seconds) {
  std::vector<wire::Message> all = wire::samples::session(seconds, 5000);
  std::erase_if(all, [](const wire::Message& message) { return message.topic.name != wire::kStationState.name; });
  return all;
}

}  // namespace telepalp::record
