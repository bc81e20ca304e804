#include "proto/wire/datagrams/datagram_end.h"

#include <algorithm>
#include <utility>

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

/// Time between reports on a path without frames: the path counts as silent when ten in a row are lost.
constexpr Nanoseconds kReportEvery = 100ms;
/// A client sends its first report once it has the offer and a synchronised clock. That takes two round trips: 1.2 s
/// by satellite.
constexpr Nanoseconds kUntilClientBegins = 1500ms;
constexpr Nanoseconds kFullSocket = 1ms;
/// The most datagrams sent in one go; then the thread serves its other sockets. A depth image has about a hundred.
constexpr int kMostSentAtOnce = 64;
/// Clients send poses and states of less than a kilobyte, and must not fill a server's memory with halves of frames.
constexpr std::size_t kMostAssemblingAtServer_B = std::size_t{64} << 10U;

}  // namespace

DatagramEnd::DatagramEnd(const boost::asio::any_io_executor& executor, const link::SealSettings& seal, link::End end,
                         Handlers handlers)
    : end_(end),
      handlers_(std::move(handlers)),
      link_({.seal = seal,
             .takes_frames = handlers_.on_frame != nullptr,
             .most_assembling_B =
                 end == link::End::Client ? link::FrameReceiver::kMostAssembling_B : kMostAssemblingAtServer_B},
            end),
      timer_(executor) {}

void DatagramEnd::start() {
  watch_.offered(handlers_.now() + (end_ == link::End::Server ? kUntilClientBegins : 0ms));
  pump();
}

void DatagramEnd::way_changed() {
  if (closed_) return;
  watch_.way_changed(handlers_.now());
  pump();
}

void DatagramEnd::close() noexcept {
  closed_ = true;
  timer_.cancel();
}

std::optional<bool> DatagramEnd::received(std::span<const std::byte> datagram) {
  if (closed_) return std::nullopt;
  const SessionTime now = handlers_.now();
  const std::optional<bool> newest = link_.received(datagram, now);
  if (!newest) return newest;
  heard_at_ = now;
  if (std::exchange(answers_, link_.path().answers()) != link_.path().answers()) watch_.answered(now);
  take_frames(now);
  if (!closed_) request_key_frames(now);
  return newest;
}

void DatagramEnd::take_frames(SessionTime now) {
  while (std::optional<link::Frame> frame = closed_ ? std::nullopt : link_.take(now)) {
    if (frame->newest)
      handlers_.on_frame(std::move(*frame));
    else
      ++late_;
  }
}

void DatagramEnd::request_key_frames(SessionTime now) {
  const std::uint16_t wanted = link_.key_frames_wanted();
  for (std::uint8_t channel = 0; channel < link::kMostChannels; ++channel) {
    const bool wants = ((wanted >> channel) & 1U) != 0;
    if (wants && handlers_.on_key_frame_needed && repair_.is_due(channel, now, link_.path().round_trip()))
      handlers_.on_key_frame_needed(channel);
  }
}

/// True while this end sends reports: a client unless the path is blocked, a server while the client sends them.
bool DatagramEnd::reports(SessionTime now) const noexcept {
  if (end_ == link::End::Server) return heard_at_ != SessionTime{} && now - heard_at_ <= PathWatch::kSilence;
  return watch_.phase() == DatagramPhase::Trying || watch_.phase() == DatagramPhase::Up;
}

void DatagramEnd::report_when_due(SessionTime now) {
  if (!reports(now) || now - reported_at_ < kReportEvery) return;
  reported_at_ = now;
  link_.want_report();
}

void DatagramEnd::report_phase() {
  const DatagramPhase phase = watch_.phase();
  const bool settled = phase == DatagramPhase::Up || phase == DatagramPhase::Blocked;
  if (settled && std::exchange(reported_phase_, phase) != phase && handlers_.on_phase) handlers_.on_phase(phase);
}

void DatagramEnd::offer_next(SessionTime now) {
  if (!handlers_.next_frame || watch_.phase() != DatagramPhase::Up) return;
  const bool takes_any = link_.ready_for_frame(now);
  if (!takes_any && !link_.ready_for_urgent(now)) return;
  std::shared_ptr<const link::SharedFrame> frame = handlers_.next_frame(takes_any ? Wanted::Any : Wanted::Urgent);
  if (!frame) return;
  if (frame->label().key_frame) repair_.key_frame_sent(frame->label().channel, now);
  (void)link_.offer(std::move(frame));
}

/// False: nothing more can be sent now.
bool DatagramEnd::send_next(SessionTime now) {
  if (!has_unsent_) {
    offer_next(now);
    has_unsent_ = link_.next(now, unsent_);
  }
  if (!has_unsent_ || !handlers_.send(unsent_.bytes())) return false;
  has_unsent_ = false;
  return true;
}

void DatagramEnd::pump() {
  if (closed_) return;
  const SessionTime now = handlers_.now();
  watch_.step(now);
  report_phase();
  if (closed_) return;  // the handler may have closed this end
  report_when_due(now);
  int sent = 0;
  while (sent < kMostSentAtOnce && send_next(now)) ++sent;
  if (sent == kMostSentAtOnce) return wake_at(now, now);
  if (has_unsent_) return wake_at(now + kFullSocket, now);
  SessionTime next = link_.due(now).value_or(now + kReportEvery);
  if (reports(now)) next = std::min(next, reported_at_ + kReportEvery);
  if (const auto change = watch_.due()) next = std::min(next, *change);
  wake_at(next, now);
}

void DatagramEnd::wake_at(SessionTime at, SessionTime now) {
  if (wakes_at_ && *wakes_at_ <= at) return;  // the timer already runs, and pump() sets it anew
  wakes_at_ = at;
  timer_.expires_after(std::max<Nanoseconds>(at - now, 0ns));
  timer_.async_wait([this, alive = std::weak_ptr<const bool>(alive_)](const boost::system::error_code& cancelled) {
    if (cancelled || alive.expired()) return;
    wakes_at_.reset();
    pump();
  });
}

}  // namespace telepalp::wire
