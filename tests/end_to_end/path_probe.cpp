// telepalp-path-probe SITE@HOST KEY SECONDS [WAY]: a doctor's program at a site behind a meeting point, which holds the
// touch and publishes a hand 100 times a second, as a station does. Prints one line: seconds until it is joined, until
// the first depth image, and until the datagrams' way contains WAY; the longest gap between depth images; the number of
// connections; and the last way. A time that did not come is "-". Ends when WAY is there and a depth image has come;
// without WAY, after SECONDS.
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "messages/station.pb.h"
#include "proto/wire/client/client_link.h"
#include "proto/wire/topics.h"
#include "support/program/address.h"

namespace {

using namespace telepalp;
using Clock = std::chrono::steady_clock;

class Probe {
 public:
  Probe(const program::Address& at, std::shared_ptr<const keys::KeyFile> key, std::string way)
      : wanted_(std::move(way)),
        look_(io_),
        link_(io_,
              {.host = at.host,
               .port = at.port,
               .site = at.site,
               .name = "telepalp-path-probe",
               .role = "doctor",
               .key = std::move(key),
               .consent = "test",
               .subscribes = {"/camera/depth"},
               .publishes = {wire::kStationState}},
              {.on_message = [this](const wire::Message& message) { on_message(message); },
               .on_state =
                   [this](wire::LinkState state, const std::string& detail) {
                     if (state == wire::LinkState::Connected && !joined_) joined_ = since_begin();
                     std::fprintf(stderr, "%.3f %s: %s\n", since_begin(), std::string(name(state)).c_str(),
                                  detail.c_str());
                   },
               .on_datagrams =
                   [this](wire::DatagramPhase, const std::string& detail) {
                     std::fprintf(stderr, "%.3f %s\n", since_begin(), detail.c_str());
                   }}) {}

  void run(std::chrono::duration<double> most) {
    link_.start();
    look();
    io_.run_for(std::chrono::duration_cast<Clock::duration>(most));
    if (last_) longest_gap_ = std::max(longest_gap_, since_begin() - *last_);
    print(joined_), print(first_), print(best_);
    std::printf("%.3f %llu %s\n", longest_gap_, static_cast<unsigned long long>(link_.counts().connections),
                link_.way().empty() ? "over TCP" : link_.way().c_str());
    link_.stop();
    io_.restart();
    io_.run_for(std::chrono::seconds(1));
  }

 private:
  [[nodiscard]] double since_begin() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  static void print(const std::optional<double>& time) {
    if (time)
      std::printf("%.3f ", *time);
    else
      std::printf("- ");
  }
  void on_message(const wire::Message& message) {
    if (message.topic.name != wire::kCameraDepth.name) return;
    const double now = since_begin();
    if (!first_) first_ = now;
    if (last_) longest_gap_ = std::max(longest_gap_, now - *last_);
    last_ = now;
  }
  /// The way counts once images go by it.
  void look() {
    const bool up = link_.datagrams() == wire::DatagramPhase::Up;
    if (!best_ && !wanted_.empty() && up && link_.way().find(wanted_) != std::string::npos) best_ = since_begin();
    if (best_ && first_) return io_.stop();
    publish();
    look_.expires_after(std::chrono::milliseconds(5));
    look_.async_wait([this](const boost::system::error_code& cancelled) {
      if (!cancelled) look();
    });
  }

  void publish() {
    if (link_.state() != wire::LinkState::Connected || ++looks_ % 2 != 0) return;
    msg::StationState state;
    state.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(link_.clock().now())));
    (void)link_.publish(wire::make_message(wire::kStationState, link_.clock().now(), state));
  }

  boost::asio::io_context io_{1};
  Clock::time_point begin_ = Clock::now();
  std::string wanted_;
  std::optional<double> joined_, first_, best_, last_;
  double longest_gap_ = 0.0;
  std::uint64_t looks_ = 0;
  boost::asio::steady_timer look_;
  wire::ClientLink link_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const auto at = program::parse_server(argv[1], "SITE@HOST");
  auto key = keys::load_client_key(argv[2], std::chrono::system_clock::now());
  if (!at || !key) return 1;
  Probe(*at, std::move(key).value(), argc > 4 ? argv[4] : "").run(std::chrono::duration<double>(std::atof(argv[3])));
  return 0;
}
