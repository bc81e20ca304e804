#include "tests/bench/link/beside_run.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "proto/impaired/impaired_link.h"
#include "proto/link/datagram_link.h"
#include "proto/link/path/content_level.h"
#include "server/plan/line_budget.h"

namespace telepalp::bench::link {
namespace {

using namespace std::chrono_literals;
using telepalp::link::DatagramLink;

constexpr Nanoseconds kPeriod = 33'333'333ns;
constexpr Nanoseconds kReportEvery = 100ms;  // period of the reports of wire::DatagramEnd
constexpr double kDepthShare = 0.4;
constexpr std::uint64_t kFirstRival = 1000;
constexpr Nanoseconds kPlanEvery = 200ms;  // as server::ContentChoice
constexpr double kLeastImage_B = 4000.0;

/// Share of the images that are sent at `level`.
constexpr double sent_share(std::size_t level) {
  constexpr std::uint64_t kImages = 1000;
  std::uint64_t sent = 0;
  for (std::uint64_t number = 0; number < kImages; ++number)
    sent += telepalp::link::ContentLevel::leaves_out(level, number) ? 0 : 1;
  return static_cast<double>(sent) / kImages;
}
constexpr double kSentAtLast = sent_share(telepalp::link::ContentLevel::kLast);

telepalp::link::DatagramLinkSettings settings_of(std::uint32_t number) {
  std::array<std::byte, 32> secret{};
  std::memcpy(secret.data(), &number, sizeof number);
  return {.seal = {.session = telepalp::link::Secret(secret),
                   .number = number,
                   .cipher = telepalp::link::preferred_cipher()}};
}

/// One session: both ends of its link, its camera, and what arrived.
class Session {
 public:
  Session(std::uint32_t number, const BesideScenario& scenario)
      : number_(number),
        scenario_(scenario),
        server_(settings_of(number), telepalp::link::End::Server),
        client_(settings_of(number), telepalp::link::End::Client),
        up_({.delay = scenario.back}, number) {}

  void step(Nanoseconds now, Nanoseconds queue, impaired::ImpairedLink& down) {
    const SessionTime at{now};
    while (const auto packet = up_.receive(now)) (void)server_.received(packet->bytes, at);
    if (now % kReportEvery == 0ns) {
      server_.want_report();
      client_.want_report();
    }
    if (now >= next_image_) capture(now, queue);
    while (const auto datagram = server_.next(at)) {
      const auto bytes = datagram->bytes();
      down.send(now, {.bytes = {bytes.begin(), bytes.end()}, .flow = number_});
      if (measures(now)) ++sent_;
    }
    while (const auto datagram = client_.next(at)) {
      const auto bytes = datagram->bytes();
      up_.send(now, {.bytes = {bytes.begin(), bytes.end()}});
    }
    note(now);
  }
  void arrived(const impaired::Packet& packet, Nanoseconds now) {
    (void)client_.received(packet.bytes, SessionTime{now});
    if (measures(now)) {
      received_B_ += static_cast<double>(packet.bytes.size());
      ++arrived_;
    }
    while (const auto frame = client_.take(SessionTime{now})) complete(*frame, now);
  }
  [[nodiscard]] BesideOutcome outcome() {
    const double span_s = scenario_.measured_until_s - scenario_.measured_from_s;
    outcome_.images_per_s = images_ / span_s;
    outcome_.share = received_B_ / span_s / scenario_.down.rate_B_per_s;
    outcome_.beside /= std::max(1.0, noted_);
    outcome_.level /= std::max(1.0, noted_);
    outcome_.loss = 1.0 - arrived_ / std::max(1.0, sent_);
    return outcome_;
  }
  [[nodiscard]] bool measures(Nanoseconds now) const {
    return to_seconds(now) >= scenario_.measured_from_s && to_seconds(now) < scenario_.measured_until_s;
  }

 private:
  void capture(Nanoseconds now, Nanoseconds queue) {
    next_image_ += kPeriod;
    if (scenario_.planned)
      plan(now);
    else
      choose_level(now);
    if (!scenario_.planned && telepalp::link::ContentLevel::leaves_out(level_.level(), ++captured_)) return;
    queue_at_capture_[numbers_ % queue_at_capture_.size()] = queue;
    for (const std::uint8_t channel : {std::uint8_t{0}, std::uint8_t{1}}) {
      const double share = channel == 0 ? kDepthShare : 1.0 - kDepthShare;
      ++offered_;
      server_.offer({.channel = channel,
                     .number = numbers_,
                     .captured = SessionTime{now},
                     .bytes = std::vector<std::byte>(static_cast<std::size_t>(image_B() * share))});
    }
    ++numbers_;
  }
  [[nodiscard]] double image_B() const {
    if (!scenario_.planned) return scenario_.image_B[std::min(level_.level(), scenario_.image_B.size() - 1)];
    return std::clamp(budget_.B_per_s().value_or(full_B_per_s()) * to_seconds(kPeriod), kLeastImage_B,
                      scenario_.image_B.front());
  }
  [[nodiscard]] double full_B_per_s() const { return scenario_.image_B.front() / to_seconds(kPeriod); }
  void choose_level(Nanoseconds now) {
    const auto& sender = server_.sender();
    level_.step(
        {.share_B_per_s = server_.path().share_B_per_s(),
         .demand_B_per_s = image_B() / to_seconds(kPeriod) * (level_.level() == level_.kLast ? kSentAtLast : 1.0),
         .dropped = drops_.step(offered_, sender.replaced + sender.expired)},
        SessionTime{now});
  }
  void plan(Nanoseconds now) {
    if (now < planned_at_ + kPlanEvery) return;
    planned_at_ = now;
    const auto& sender = server_.sender();
    budget_.step({.offered = offered_,
                  .dropped = sender.replaced + sender.expired,
                  .sent_B = sender.data_shards * telepalp::link::kDatagramBytes,
                  .share_B_per_s = server_.path().share_B_per_s(),
                  .queue = server_.path().queue_delay()},
                 full_B_per_s(), SessionTime{now});
  }
  void complete(const telepalp::link::Frame& frame, Nanoseconds now) {
    if (!frame.newest || frame.channel != 0) return;
    if (measures(now)) {
      ++images_;
      outcome_.age_ms.add(to_milliseconds(now - frame.captured.time_since_epoch()));
      outcome_.above_queue_ms.add(to_milliseconds(now - frame.captured.time_since_epoch() -
                                                  queue_at_capture_[frame.number % queue_at_capture_.size()]));
      outcome_.longest_gap = std::max(outcome_.longest_gap, now - last_image_);
    }
    last_image_ = now;
  }
  void note(Nanoseconds now) {
    if (!measures(now)) return;
    ++noted_;
    outcome_.beside += server_.path().beside_others() ? 1.0 : 0.0;
    outcome_.level += static_cast<double>(level_.level());
  }

  std::uint32_t number_;
  const BesideScenario& scenario_;
  DatagramLink server_;
  DatagramLink client_;
  impaired::ImpairedLink up_;
  Nanoseconds next_image_{0};
  std::uint64_t captured_ = 0;
  std::uint32_t numbers_ = 0;
  std::array<Nanoseconds, 256> queue_at_capture_{};
  telepalp::link::ContentLevel level_;
  telepalp::link::DropShare drops_;
  plan::LineBudget budget_;
  Nanoseconds planned_at_{0};
  std::uint64_t offered_ = 0;  ///< frames of both channels
  Nanoseconds last_image_{0};
  double images_ = 0.0;
  double received_B_ = 0.0;
  double sent_ = 0.0;
  double arrived_ = 0.0;
  double noted_ = 0.0;
  BesideOutcome outcome_;
};

/// The bottleneck and all flows through it.
class BesideRun {
 public:
  explicit BesideRun(const BesideScenario& scenario) : scenario_(scenario), down_(scenario.down, 1, scenario.trace) {
    for (int i = 0; i < scenario.sessions; ++i)
      sessions_.push_back(std::make_unique<Session>(static_cast<std::uint32_t>(i + 1), scenario));
    for (const Rival& rival : scenario.rivals)
      rivals_.emplace_back(rival.kind, kFirstRival + rivals_.size(), scenario.back);
  }
  std::vector<BesideOutcome> outcomes() {
    for (Nanoseconds now = 0ns; to_seconds(now) < scenario_.seconds; now += kStep) step(now);
    std::vector<BesideOutcome> outcomes;
    const double span_s = scenario_.measured_until_s - scenario_.measured_from_s;
    for (const auto& session : sessions_) {
      outcomes.push_back(session->outcome());
      outcomes.back().rivals_share = rivals_B_ / span_s / scenario_.down.rate_B_per_s;
      outcomes.back().queue_ms = queue_ms_;
    }
    return outcomes;
  }

 private:
  void step(Nanoseconds now) {
    while (const auto packet = down_.receive(now)) deliver(*packet, now);
    const Nanoseconds queue = from_seconds(static_cast<double>(down_.queued_B(now)) / scenario_.down.rate_B_per_s);
    if (now % 1ms == 0ns && sessions_.front()->measures(now)) queue_ms_.add(to_milliseconds(queue));
    for (std::size_t i = 0; i < sessions_.size(); ++i)
      if (now >= i * 1s) sessions_[i]->step(now, queue, down_);
    for (std::size_t i = 0; i < rivals_.size(); ++i)
      if (now >= scenario_.rivals[i].from && now < scenario_.rivals[i].until) rivals_[i].step(now, down_);
  }
  void deliver(const impaired::Packet& packet, Nanoseconds now) {
    if (packet.flow < kFirstRival) return sessions_[packet.flow - 1]->arrived(packet, now);
    rivals_[packet.flow - kFirstRival].arrived(packet, now);
    if (sessions_.front()->measures(now)) rivals_B_ += static_cast<double>(packet.bytes.size());
  }

  const BesideScenario& scenario_;
  impaired::ImpairedLink down_;
  std::vector<std::unique_ptr<Session>> sessions_;
  std::deque<RivalFlow> rivals_;
  double rivals_B_ = 0.0;
  Distribution queue_ms_;
};

}  // namespace

std::vector<BesideOutcome> run_beside(const BesideScenario& scenario) { return BesideRun(scenario).outcomes(); }

}  // namespace telepalp::bench::link
