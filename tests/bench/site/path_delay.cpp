#include "tests/bench/site/path_delay.h"

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <cstring>
#include <memory>
#include <vector>

#include "proto/ice/ice_paths.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::bench {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;
using Datagram = std::array<std::byte, 1200>;

constexpr int kDatagrams = 4000;
constexpr auto kProbeEvery = 500us;

Datagram stamped() {
  Datagram datagram{};
  const auto now = Clock::now();
  std::memcpy(datagram.data(), &now, sizeof now);
  return datagram;
}

/// Time since the datagram was sent [ms].
double age_ms(std::span<const std::byte> datagram) {
  Clock::time_point sent;
  std::memcpy(&sent, datagram.data(), sizeof sent);
  return std::chrono::duration<double, std::milli>(Clock::now() - sent).count();
}

/// Two plain sockets.
class PlainPair {
 public:
  PlainPair(asio::io_context& io, std::vector<double>& ages)
      : ages_(ages), to_(io, udp::endpoint(asio::ip::address_v4::loopback(), 0)), from_(io, udp::v4()) {
    from_.connect(to_.local_endpoint());
    read();
  }
  void send() { from_.send(asio::buffer(stamped())); }

 private:
  void read() {
    to_.async_receive(asio::buffer(bytes_), [this](const boost::system::error_code& failed, std::size_t count) {
      if (failed) return;
      ages_.push_back(age_ms(std::span<const std::byte>(bytes_).first(count)));
      read();
    });
  }

  std::vector<double>& ages_;
  udp::socket to_, from_;
  Datagram bytes_{};
};

/// Two ends that have found a path.
class PathPair {
 public:
  PathPair(asio::io_context& io, std::vector<double>& ages) {
    using End = ice::IcePaths::End;
    const auto make = [&](End end, std::unique_ptr<ice::IcePaths>& other) {
      return std::make_unique<ice::IcePaths>(
          io.get_executor(), ice::IcePaths::Settings{.end = end, .reach = ice::Reach::Loopback},
          ice::IcePaths::Handlers{
              .signal =
                  [&io, &other](const msg::IcePath& message) {
                    asio::post(io, [&other, message] { other->heard(message); });
                  },
              .on_datagram = [&ages](std::span<const std::byte> datagram) { ages.push_back(age_ms(datagram)); },
              .on_path = [](std::optional<ice::PathKind>) {}});
    };
    from_ = make(End::Server, to_);
    to_ = make(End::Client, from_);
    from_->begin();
  }
  [[nodiscard]] bool has_path() const { return from_->path().has_value() && to_->path().has_value(); }
  void send() { (void)from_->send(stamped()); }

 private:
  std::unique_ptr<ice::IcePaths> from_, to_;
};

}  // namespace

Result<PathDelay> measure_path_delay() {
  asio::io_context io(1);
  std::vector<double> plain, by_path;
  PlainPair sockets(io, plain);
  PathPair paths(io, by_path);
  for (const auto end = Clock::now() + 5s; !paths.has_path() && Clock::now() < end;) io.run_one_for(10ms);
  for (int i = 0; i < kDatagrams; ++i) {
    sockets.send();
    io.run_for(kProbeEvery);
    paths.send();
    io.run_for(kProbeEvery);
  }
  io.run_for(100ms);
  if (plain.size() < kDatagrams || by_path.size() < kDatagrams)
    return Error{.what = "of " + std::to_string(kDatagrams) + " datagrams, " + std::to_string(by_path.size()) +
                         " came by the path and " + std::to_string(plain.size()) + " by plain sockets",
                 .where = "telepalp-bench site --part paths",
                 .fix = "run it while nothing else loads the computer"};
  return PathDelay{.plain_p99_ms = quantile_of(plain, 0.99), .path_p99_ms = quantile_of(by_path, 0.99)};
}

}  // namespace telepalp::bench
