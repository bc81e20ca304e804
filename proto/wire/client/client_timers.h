#pragma once

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>

namespace telepalp::wire {

/// A timer whose call is dropped once it was cancelled, restarted or destroyed, even if it has expired before.
class OwnTimer {
 public:
  explicit OwnTimer(boost::asio::io_context& io) : timer_(io) {}

  void call_after(std::chrono::steady_clock::duration time, std::function<void()> call) {
    waiting_ = std::make_shared<const bool>(true);
    timer_.expires_after(time);
    timer_.async_wait([waiting = std::weak_ptr<const bool>(waiting_), call = std::move(call)](const auto& cancelled) {
      if (!cancelled && !waiting.expired()) call();
    });
  }
  void cancel() {
    waiting_.reset();
    timer_.cancel();
  }

 private:
  boost::asio::steady_timer timer_;
  std::shared_ptr<const bool> waiting_;  // the pending call holds a weak_ptr to it
};

/// Exponential back-off between attempts to connect: 0.1 s to 2 s.
class BackOff {
 public:
  explicit BackOff(boost::asio::io_context& io) : timer_(io) {}

  void retry(std::function<void()> attempt) {
    timer_.call_after(wait_, std::move(attempt));
    wait_ = std::min(2 * wait_, kLongest);
  }
  void succeeded() noexcept { wait_ = kFirst; }
  void cancel() { timer_.cancel(); }

 private:
  static constexpr std::chrono::milliseconds kFirst{100};
  static constexpr std::chrono::milliseconds kLongest{2000};

  OwnTimer timer_;
  std::chrono::milliseconds wait_ = kFirst;
};

/// Calls for a clock probe each 50 ms: ten seconds of jitter of 20 ms then give the clock to 1 ms. The first probes of
/// a connection follow each other quickly, so that the clock is accurate before the first image.
class ClockProber {
 public:
  explicit ClockProber(boost::asio::io_context& io) : timer_(io) {}

  void start(std::function<void()> probe) {
    probe_ = std::move(probe);
    probes_ = 0;
    later();
    probe_();
  }
  void stop() { timer_.cancel(); }

 private:
  static constexpr int kEager = 8;

  void later() {
    using namespace std::chrono_literals;
    timer_.call_after(++probes_ < kEager ? 20ms : 50ms, [this] {
      later();  // first, because the probe may end the connection
      probe_();
    });
  }

  OwnTimer timer_;
  std::function<void()> probe_;
  int probes_ = 0;  // on this connection
};

}  // namespace telepalp::wire
