#include "tests/bench/thin/voice_rows.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <cmath>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "codec/voice_playout.h"
#include "proto/wire/client/client_link.h"
#include "proto/wire/voice/voice_message.h"
#include "server/hub/peer_listener.h"
#include "support/speech/voice_packets.h"
#include "tests/bench/distribution.h"
#include "tests/support/speech.h"
#include "tools/link_proxy/link_proxy.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kOneWay = 25ms;
constexpr double kRate_B_per_s = 4e6 / 8.0;
constexpr std::uint32_t kSpokenFrames = 1'500;  // 30 s
constexpr std::uint32_t kSettled = 250;         // 5 s, in which the jitter buffer has met the first bursts

SessionTime steady_now() {
  return SessionTime{std::chrono::duration_cast<Nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())};
}

/// An io_context with a thread of its own.
class Network {
 public:
  Network() : thread_([this] { io.run(); }) {}
  ~Network() { end(); }
  /// Ends the thread when its work is done, or at once after io.stop(); what waits is not run any more.
  void end() {
    work_.reset();
    if (thread_.joinable()) thread_.join();
  }
  /// Runs `act` on the thread, and returns when it is done.
  void run(const std::function<void()>& act) {
    std::promise<void> done;
    boost::asio::post(io, [&] {
      act();
      done.set_value();
    });
    done.get_future().wait();
  }
  boost::asio::io_context io{1};

 private:
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_ = make_work_guard(io);
  std::thread thread_;
};

/// A server's hub with its listener, to which a microphone speaks.
class Mouth {
 public:
  Mouth() {
    network_.run([this] {
      auto made = hub::PeerListener::listen(network_.io, hub_, clock_, {});
      if (made) listener_ = std::move(*made);
    });
  }
  ~Mouth() {
    network_.run([this] {
      if (listener_) listener_->close("the bench ends");
    });
    network_.io.stop();
    network_.end();
    listener_.reset();  // handlers that wait would call it
  }
  [[nodiscard]] std::uint16_t port() const { return listener_ ? listener_->port() : 0; }

  /// Says frame `number`, whose last sample was spoken now, and publishes an image of `image_B`; 0: none.
  void say(std::uint32_t number, std::size_t image_B) {
    msg::VoiceFrame frame;
    frame.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(clock_.now() - Nanoseconds(kVoiceFrameTime))));
    frame.set_talker(1);
    frame.set_number(number);
    frame.set_opus(encoder_.encode(support::speech(number)));
    for (const std::string& packet : earlier_) frame.add_earlier(packet);
    earlier_.push_front(frame.opus());
    if (earlier_.size() > wire::kMaxEarlierVoicePackets) earlier_.pop_back();
    network_.run([&] {
      hub_.publish(wire::make_message(wire::kDoctorVoice, clock_.now(), frame));
      if (image_B > 0)
        hub_.publish({wire::kCameraColor, clock_.now(), std::make_shared<const std::string>(image_B, 'x'), 0, true});
    });
  }
  [[nodiscard]] const wire::SessionClock& clock() const noexcept { return clock_; }
  [[nodiscard]] double coding_delay_ms() const { return 1e3 * encoder_.delay_samples() / kVoiceRate_hz; }

 private:
  hub::Hub hub_;
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  std::unique_ptr<hub::PeerListener> listener_;
  codec::VoiceEncoder encoder_;
  std::deque<std::string> earlier_;  // the newest first
  Network network_;
};

/// A client that looks and listens: a screen, which shows the newest image as soon as it is complete, and a
/// loudspeaker.
class Ear {
  /// A frame whose sound began at `at`.
  struct Heard {
    SessionTime at{};
    SessionTime spoken{};
  };

 public:
  /// `clock`: the server's, which a client knows to within half a round trip.
  Ear(std::uint16_t port, const wire::SessionClock& clock, Nanoseconds coding_delay)
      : clock_(clock),
        coding_delay_(coding_delay),
        link_(network_.io,
              {.port = port,
               .name = "telepalp-bench",
               .subscribes = {std::string(wire::kDoctorVoice.name), std::string(wire::kCameraColor.name)}},
              {.on_message = [this](const wire::Message& message) { on_message(message); }}) {
    network_.run([this] { link_.start(); });
  }
  ~Ear() {
    network_.run([this] { link_.stop(); });
  }
  [[nodiscard]] bool is_ready() {
    bool ready = false;
    network_.run(
        [&] { ready = link_.state() == wire::LinkState::Connected && link_.datagrams() == wire::DatagramPhase::Up; });
    return ready;
  }
  /// The sound of the next 20 ms.
  codec::VoicePlayout::Played pull() {
    using Kind = codec::VoicePlayout::Kind;
    const std::lock_guard lock(mutex_);
    const SessionTime now = clock_.now();
    const codec::VoicePlayout::Played played = playout_.next(now);
    heard_.reset();
    if (played.kind != Kind::Silence && played.kind != Kind::Stretched && played.number >= kSettled)
      heard_ = Heard{.at = now, .spoken = frame_0_ + played.number * Nanoseconds(kVoiceFrameTime) - coding_delay_};
    return played;
  }
  /// Of each image when it was shown: how far its capture was from the instant of the sound that was heard then.
  [[nodiscard]] Distribution apart_ms() {
    const std::lock_guard lock(mutex_);
    return apart_ms_;
  }
  [[nodiscard]] codec::VoicePlayout::Counts counts() {
    const std::lock_guard lock(mutex_);
    return playout_.counts();
  }
  [[nodiscard]] std::uint64_t messages() {
    const std::lock_guard lock(mutex_);
    return messages_;
  }

 private:
  void on_image(SessionTime captured) {
    const std::lock_guard lock(mutex_);
    if (captured <= shown_) return;  // a newer one is on the screen
    shown_ = captured;
    const SessionTime now = clock_.now();
    if (!heard_ || now - heard_->at > Nanoseconds(kVoiceFrameTime)) return;
    apart_ms_.add(std::abs(to_milliseconds(heard_->spoken + (now - heard_->at) - captured)));
  }
  void on_message(const wire::Message& message) {
    if (message.topic.name != wire::kDoctorVoice.name) return on_image(message.published);
    const auto frame = wire::read_voice_frame(*message.payload);
    if (!frame) return;
    const std::lock_guard lock(mutex_);
    ++messages_;
    const SessionTime now = clock_.now();
    frame_0_ =
        session_time(static_cast<std::int64_t>(frame->captured_ns())) - frame->number() * Nanoseconds(kVoiceFrameTime);
    for (codec::VoicePacket& packet : speech::packets_of(*frame)) playout_.add(std::move(packet), now);
  }

  const wire::SessionClock clock_;
  const Nanoseconds coding_delay_;
  std::mutex mutex_;  // guards the members below
  codec::VoicePlayout playout_;
  std::optional<Heard> heard_;  // nullopt: silence
  SessionTime frame_0_{};       // when the talker's frame 0 was spoken
  SessionTime shown_{};         // capture of the newest image
  Distribution apart_ms_;
  std::uint64_t messages_ = 0;
  Network network_;
  wire::ClientLink link_;
};

struct Talk {
  Distribution mouth_to_ear_ms;  ///< beyond the path's own delay, of the frames from kSettled on
  codec::VoicePlayout::Counts counts;
  std::uint64_t messages = 0;  ///< that arrived
  Distribution apart_ms{};     ///< capture of the image shown from the instant of the sound heard
};

/// Speaks kSpokenFrames frames, with an image of `image_B` beside each, and listens. Two threads: a late loudspeaker
/// must not delay the microphone.
Talk talk(Mouth& mouth, Ear& ear, std::size_t image_B) {
  Talk result;
  std::mutex mutex;
  std::map<std::uint32_t, SessionTime> begun;  // when the first sample of each frame was spoken
  const SessionTime start = steady_now();
  std::thread microphone([&] {
    for (std::uint32_t number = 0; number < kSpokenFrames; ++number) {
      const SessionTime first = start + number * Nanoseconds(kVoiceFrameTime);
      std::this_thread::sleep_until(
          std::chrono::steady_clock::time_point((first + kVoiceFrameTime).time_since_epoch()));
      {
        const std::lock_guard lock(mutex);
        begun.emplace(number, first);
      }
      mouth.say(number, image_B);
    }
  });
  for (std::uint32_t call = 0; call < kSpokenFrames + 75; ++call) {
    const SessionTime due = start + 7ms + call * Nanoseconds(kVoiceFrameTime);
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(due.time_since_epoch()));
    const codec::VoicePlayout::Played played = ear.pull();
    if (played.kind != codec::VoicePlayout::Kind::Voice || played.number < kSettled) continue;
    const std::lock_guard lock(mutex);
    const double took_ms = to_milliseconds(steady_now() - begun.at(played.number) - kOneWay);
    result.mouth_to_ear_ms.add(took_ms + mouth.coding_delay_ms());
  }
  microphone.join();
  result.counts = ear.counts();
  result.messages = ear.messages();
  result.apart_ms = ear.apart_ms();
  return result;
}

struct VoiceLine {
  double loss = 0.0;
  double burst_packets = 1.0;  ///< mean number of packets in a burst of loss
  std::size_t image_B = 0;     ///< of the image beside each frame
};

Result<void> add_rows(Report& report, const std::string& name, const VoiceLine& line) {
  Mouth mouth;
  Network network;
  const impaired::Impairment both{.delay = kOneWay,
                                  .loss = line.loss,
                                  .burst_packets = line.burst_packets,
                                  .rate_B_per_s = kRate_B_per_s,
                                  .queue_B = static_cast<std::size_t>(0.5 * kRate_B_per_s)};
  auto proxy = link_proxy::LinkProxy::start(network.io, {.listen = {.host = "127.0.0.1", .port = 0},
                                                         .server = {.host = "127.0.0.1", .port = mouth.port()},
                                                         .down = both,
                                                         .up = both,
                                                         .trace = {}});
  if (!proxy) return proxy.error();
  Result<Talk> talked = Error{.what = "the ear has no datagrams within 20 s", .where = name, .fix = "try again"};
  {
    Ear ear((*proxy)->port(), mouth.clock(), from_seconds(1e-3 * mouth.coding_delay_ms()));
    const auto deadline = std::chrono::steady_clock::now() + 20s;
    while (!ear.is_ready() && std::chrono::steady_clock::now() < deadline) std::this_thread::sleep_for(50ms);
    if (ear.is_ready()) talked = talk(mouth, ear, line.image_B);
  }
  network.run([&] { (*proxy)->stop(); });
  network.io.stop();
  if (!talked) return talked.error();
  const codec::VoicePlayout::Counts& counts = talked->counts;
  const double percent = 100.0 / kSpokenFrames;
  report.rows.push_back(at_most(name + ": mouth to ear beyond the path's own delay, p95",
                                talked->mouth_to_ear_ms.quantile(0.95), "ms", 120.0));
  report.rows.push_back(
      measured(name + ": mouth to ear beyond the path's own delay, p50", talked->mouth_to_ear_ms.p50(), "ms"));
  report.rows.push_back(at_least(name + ": frames played", percent * static_cast<double>(counts.played), "%", 99.0));
  report.rows.push_back(measured(name + ": frames concealed", percent * static_cast<double>(counts.concealed), "%"));
  report.rows.push_back(
      measured(name + ": frames restored by Opus", percent * static_cast<double>(counts.restored), "%"));
  report.rows.push_back(
      measured(name + ": frames left out to shorten the delay", percent * static_cast<double>(counts.skipped), "%"));
  report.rows.push_back(
      measured(name + ": messages that arrived", percent * static_cast<double>(talked->messages), "%"));
  if (line.image_B > 0)
    report.rows.push_back(at_most(name + ": capture of the picture shown from the sound heard, p95",
                                  talked->apart_ms.quantile(0.95), "ms", 40.0));
  const std::uint64_t told = counts.played + counts.concealed + counts.restored + counts.skipped;
  const double untold = static_cast<double>(kSpokenFrames) - static_cast<double>(told);
  report.rows.push_back(at_most(name + ": frames of which no count tells", std::abs(untold), "", 5.0));
  return {};
}

}  // namespace

Result<void> add_voice_rows(Report& report) {
  constexpr std::size_t kImage_B = 6'000;  // 50 a second are 2.4 Mbit/s, as depth and colour have on this line
  for (const auto& [name, line] : {std::pair{"no loss", VoiceLine{}},
                                   std::pair{"10 % loss in bursts of 4", VoiceLine{.loss = 0.1, .burst_packets = 4.0}},
                                   std::pair{"1 % loss, beside images", VoiceLine{.loss = 0.01, .image_B = kImage_B}},
                                   std::pair{"10 % loss in bursts of 4, beside images",
                                             VoiceLine{.loss = 0.1, .burst_packets = 4.0, .image_B = kImage_B}}})
    if (const auto added = add_rows(report, name, line); !added) return added;
  report.notes.emplace_back(
      "voice: a hub, its sockets and a client with a jitter buffer, 4 Mbit/s, 50 ms there and back; 24 kbit/s of Opus, "
      "six earlier packets in each message; mouth to ear holds the frame's own 20 ms and Opus's delay");
  return {};
}

}  // namespace telepalp::bench
