// Ten thousand joins at the meeting point, as fast as a stranger can make them, beside a session.
#include <atomic>
#include <deque>
#include <iostream>
#include <thread>

#include "server/meet/words/meet_frames.h"
#include "tests/server/meet/greeting.h"
#include "tests/server/meet/met_site.h"

namespace telepalp::server {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kJoins = 10'000;
constexpr std::size_t kHeldByStranger = 200;  // connections that the stranger keeps open at a time

/// Connects kJoins times from 127.0.0.2, sends `words` each time, and holds the newest connections.
class Stranger {
 public:
  Stranger(std::uint16_t port, std::string words) : port_(port), words_(std::move(words)), thread_([this] { run(); }) {}
  ~Stranger() {
    stop_ = true;
    thread_.join();
  }
  [[nodiscard]] bool is_done() const noexcept { return done_; }
  [[nodiscard]] int joins() const noexcept { return joins_; }

 private:
  void run() {
    asio::io_context io;
    std::deque<tcp::socket> held;
    while (!stop_ && joins_ < kJoins) {
      boost::system::error_code failed;
      tcp::socket& socket = held.emplace_back(io);
      socket.open(tcp::v4(), failed);
      socket.bind({asio::ip::make_address("127.0.0.2"), 0}, failed);
      socket.connect({asio::ip::make_address("127.0.0.1"), port_}, failed);
      if (!failed) asio::write(socket, asio::buffer(words_), failed);
      ++joins_;
      if (held.size() > kHeldByStranger) held.pop_front();
    }
    done_ = true;
  }

  std::uint16_t port_;
  std::string words_;
  std::atomic<int> joins_ = 0;
  std::atomic<bool> stop_ = false, done_ = false;
  std::thread thread_;
};

struct Flood {
  const char* of;
  std::string words;
};
void PrintTo(const Flood& flood, std::ostream* out) { *out << flood.of; }

class MeetFlood : public Meeting, public testing::WithParamInterface<Flood> {
 protected:
  /// Publishes an instant each 10 ms; the longest time between two that arrive at `watcher` while `floods()`.
  template <class Floods>
  double longest_gap_s(const Caller& watcher, Floods floods) {
    std::size_t seen = watcher.messages.size();
    Clock::time_point last = Clock::now(), published = last;
    double longest_s = 0.0;
    const auto limit = last + 60s;
    while (floods() && Clock::now() < limit) {
      met.io.run_one_for(1ms);
      const Clock::time_point now = Clock::now();
      if (now - published >= 10ms) met.hub.publish(message(wire::kClock, "tick")), published = now;
      if (watcher.messages.size() == seen) continue;
      seen = watcher.messages.size();
      longest_s = std::max(longest_s, std::chrono::duration<double>(now - last).count());
      last = now;
    }
    return std::max(longest_s, std::chrono::duration<double>(Clock::now() - last).count());
  }
};

TEST_P(MeetFlood, DisturbsNoSessionKeepsNobodyOutAndIsBounded) {
  join();
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return anna.connected(); }));
  const std::size_t lines = met.log.size(), site_lines = met.site_log.size();
  const Clock::time_point begin = Clock::now();
  Stranger stranger(met.meeting->port(), GetParam().words);
  ASSERT_TRUE(met.run_until([&] { return stranger.joins() > kJoins / 20; }, 20s));
  Caller bert(met, "ward3", met.ring.key("bert", keys::Role::Doctor), "viewer");
  const bool bert_joins = met.run_until([&] { return bert.connected(); }, 10s);
  const double bert_s = std::chrono::duration<double>(Clock::now() - begin).count();
  const double gap_s = longest_gap_s(anna, [&] { return !stranger.is_done(); });
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::cout << GetParam().of << ": " << stranger.joins() / seconds << " joins a second for " << seconds
            << " s; longest gap of the session " << gap_s << " s; a colleague is in after " << bert_s << " s\n";
  EXPECT_EQ(stranger.joins(), kJoins);
  EXPECT_TRUE(bert_joins);
  EXPECT_TRUE(anna.connected());
  EXPECT_EQ(anna.link.counts().connections, 1U);
  EXPECT_LT(gap_s, 1.0);
  EXPECT_TRUE(met.dialer->has_joined());
  EXPECT_LE(met.meeting->streams(), 64U + 32U);
  EXPECT_LE(met.log.size() - lines, 2U) << "a stranger fills no log";
  EXPECT_LE(met.site_log.size() - site_lines, 2U);
}

const Flood kFloods[] = {
    {"Callers", meet::greeting("ward3")},
    {"CallersOfNoSite", meet::greeting("ward9")},
    {"Sites", meet::greeting("meet.example")},
    {"GuessedTokens", std::string(meet::kAnswer) + std::string(meet::kTokenBytes, 'x')},
    {"Silence", ""},
};
INSTANTIATE_TEST_SUITE_P(OfTenThousand, MeetFlood, testing::ValuesIn(kFloods),
                         [](const auto& flood) { return std::string(flood.param.of); });

}  // namespace
}  // namespace telepalp::server
