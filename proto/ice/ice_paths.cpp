#include "proto/ice/ice_paths.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <string>
#include <utility>

#include "proto/ice/agent/ice_agent.h"

namespace telepalp::ice {
namespace {

using namespace std::chrono_literals;

constexpr auto kLookEvery = 250ms;
constexpr std::chrono::milliseconds kFirstPause = 1s, kLongestPause = 30s;
constexpr auto kOldPathStays = 3s;      // datagrams that are on their way still arrive
constexpr auto kBetterPathWithin = 5s;  // after this, an attempt to find a path without the relay ends
constexpr auto kRelayAnswersWithin = 5s;
constexpr std::size_t kMostAttempts = 3;
constexpr std::size_t kMostRelays = 4;
constexpr std::size_t kLeastUser = 4, kLeastPassword = 22;  // RFC 8839 §5.4

}  // namespace

IcePaths::IcePaths(const boost::asio::any_io_executor& executor, const Settings& settings, Handlers handlers)
    : settings_(settings), handlers_(std::move(handlers)), executor_(executor), timer_(executor), pause_(kFirstPause) {}

IcePaths::~IcePaths() { close(); }

void IcePaths::close() {
  closed_ = true;
  timer_.cancel();
}

const IcePaths::Attempt* IcePaths::used() const noexcept {
  if (const auto taken = attempts_.find(taken_); taken != attempts_.end() && taken->second.path) return &taken->second;
  for (const auto& [number, attempt] : attempts_)
    if (attempt.path) return &attempt;  // the verdict on it is on its way
  return nullptr;
}

std::optional<PathKind> IcePaths::path() const noexcept {
  const Attempt* const present = used();
  return present == nullptr ? std::nullopt : present->path;
}

bool IcePaths::send(std::span<const std::byte> datagram) {
  const Attempt* const present = used();
  return closed_ || present == nullptr || present->agent->send(datagram);
}

void IcePaths::tell_path() {
  const std::pair now{path() ? taken_ : 0, path()};
  if (std::exchange(told_, now) != now && !closed_) handlers_.on_path(now.second);
}

void IcePaths::begin() {
  if (closed_) return;
  wants_attempt_ = true;
  if (last_ == 0) return begin_now();
  look_soon();
}

void IcePaths::lost() {
  is_silent_ = true;
  begin();
}

void IcePaths::begin_now() {
  wants_attempt_ = false;
  const std::vector<msg::IceRelay> relays = handlers_.relays();
  const Number number = last_ + 1;
  if (!start(number, relays)) return;
  msg::IcePath message;
  message.set_attempt(number);
  message.set_user(attempts_.at(number).agent->credentials().user);
  message.set_password(attempts_.at(number).agent->credentials().password);
  for (const msg::IceRelay& relay : relays) *message.add_relays() = relay;
  handlers_.signal(message);
}

std::vector<Relay> IcePaths::usable(const std::vector<msg::IceRelay>& relays) {
  std::vector<Relay> usable_ones;
  for (const msg::IceRelay& message : relays) {
    Result<Relay> relay = read_relay(message, settings_.reach);
    if (relay && usable_ones.size() < kMostRelays) {
      usable_ones.push_back(std::move(relay).value());
      continue;
    }
    ++counts_.refused;
    if (!relay) handlers_.on_unused_relay(relay.error());
  }
  return usable_ones;
}

/// False: the system gives no socket; TCP then carries the images.
bool IcePaths::start(Number number, const std::vector<msg::IceRelay>& relays) {
  last_ = number;
  begun_ = Clock::now();
  ++counts_.attempts;
  const std::vector<Relay> usable_relays = usable(relays);
  auto agent = IceAgent::start(
      executor_,
      {.controlling = settings_.end == End::Server,
       .relays = usable_relays,
       .reach = settings_.reach,
       .type_of_service = settings_.type_of_service},
      {.on_candidate = [this, number](const Candidate& candidate) { tell_candidate(number, candidate); },
       .on_all_candidates = [this, number] { candidates_end(number); },
       .on_path = [this, number](PathKind kind) { on_path(number, kind); },
       .on_failed = [this, number] { on_failed(number); },
       .on_datagram =
           [this](std::span<const std::byte> datagram) {
             if (!closed_) handlers_.on_datagram(datagram);
           }});
  if (!agent) return false;
  Attempt& attempt =
      attempts_.emplace(number, Attempt{.agent = std::move(agent).value(), .since = begun_}).first->second;
  if (!usable_relays.empty()) attempt.waits_for_relay = usable_relays.front();
  look_soon();
  return true;
}

void IcePaths::tell_candidate(Number number, const Candidate& candidate) {
  if (closed_) return;
  const auto attempt = attempts_.find(number);
  if (candidate.kind == Candidate::Kind::Relayed && attempt != attempts_.end()) attempt->second.waits_for_relay.reset();
  msg::IcePath message;
  message.set_attempt(number);
  message.add_candidates(to_text(candidate));
  handlers_.signal(message);
}

/// Reports a relay that has given no address. libnice itself would wait 40 s for a relay that does not answer.
void IcePaths::candidates_end(Number number) {
  const auto attempt = attempts_.find(number);
  if (closed_ || attempt == attempts_.end()) return;
  const std::optional<Relay> relay = std::exchange(attempt->second.waits_for_relay, std::nullopt);
  if (!relay) return;
  handlers_.on_unused_relay(
      {.what = "the relay at " + relay->address + " gives no address: it does not answer, or refuses the credentials",
       .where = "relay",
       .fix = "on the meeting point's computer, look whether coturn runs and has the same secret as the meeting point "
              "(--relay-secret), and open UDP port " +
              std::to_string(relay->port)});
}

void IcePaths::on_path(Number number, PathKind kind) {
  const auto found = attempts_.find(number);
  if (closed_ || found == attempts_.end()) return;
  found->second.path = kind;
  const auto taken = attempts_.find(taken_);
  const bool is_better = taken == attempts_.end() || !taken->second.path || is_silent_ || kind < *taken->second.path;
  if (settings_.end == End::Server && number != taken_ && is_better) take(number);
  tell_path();
}

void IcePaths::on_failed(Number number) {
  if (closed_) return;
  drop(number);
  if (settings_.end == End::Server && !path()) begin();
}

/// From now on datagrams go by this attempt.
void IcePaths::take(Number number) {
  const Number before = std::exchange(taken_, number);
  if (const auto old = attempts_.find(before); old != attempts_.end())
    old->second.ends_at = Clock::now() + kOldPathStays;
  is_silent_ = false;
  if (settings_.end != End::Server) return;
  pause_ = kFirstPause;
  say(number, msg::IcePath::VERDICT_TAKEN);
}

void IcePaths::drop(Number number) {
  if (!attempts_.contains(number)) return;
  end(number);
  if (settings_.end == End::Server) {
    if (!path()) pause_ = std::min<std::chrono::milliseconds>(2 * pause_, kLongestPause);
    say(number, msg::IcePath::VERDICT_DROPPED);
  }
  tell_path();
}

/// The agent may be on the call stack, so it is destroyed later.
void IcePaths::end(Number number) {
  const auto found = attempts_.find(number);
  if (found == attempts_.end()) return;
  boost::asio::post(executor_, [ended = std::shared_ptr<IceAgent>(std::move(found->second.agent))] {});
  attempts_.erase(found);
}

void IcePaths::say(Number number, msg::IcePath::Verdict verdict) const {
  if (closed_) return;
  msg::IcePath message;
  message.set_attempt(number);
  message.set_verdict(verdict);
  handlers_.signal(message);
}

void IcePaths::heard(const msg::IcePath& message) {
  if (closed_) return;
  if (settings_.end == End::Client && message.verdict() != msg::IcePath::VERDICT_NONE) return judge(message);
  if (Attempt* const attempt = joined(message)) learn(*attempt, message);
}

/// The attempt of `message`. A client joins a new one, unless the server begins too many.
IcePaths::Attempt* IcePaths::joined(const msg::IcePath& message) {
  const Number number = message.attempt();
  if (const auto known = attempts_.find(number); known != attempts_.end()) return &known->second;
  if (settings_.end == End::Server || number <= last_) return nullptr;  // it has ended
  const bool too_soon = last_ != 0 && Clock::now() - begun_ < kFirstPause / 2;
  if (too_soon || attempts_.size() >= kMostAttempts ||
      !start(number, {message.relays().begin(), message.relays().end()})) {
    ++counts_.refused;
    return nullptr;
  }
  msg::IcePath answer;
  answer.set_attempt(number);
  answer.set_user(attempts_.at(number).agent->credentials().user);
  answer.set_password(attempts_.at(number).agent->credentials().password);
  handlers_.signal(answer);
  return &attempts_.at(number);
}

void IcePaths::learn(Attempt& attempt, const msg::IcePath& message) {
  if (!attempt.knows_peer) {
    if (!is_credential(message.user(), kLeastUser) || !is_credential(message.password(), kLeastPassword)) {
      ++counts_.refused;
      return;
    }
    attempt.agent->set_peer({.user = message.user(), .password = message.password()});
    attempt.knows_peer = true;
  }
  for (const std::string& text : message.candidates()) {
    const std::optional<Candidate> candidate = read_candidate(text, settings_.reach);
    if (candidate && attempt.candidates < kMostCandidates)
      attempt.agent->add(*candidate), ++attempt.candidates;
    else
      ++counts_.refused;
  }
}

void IcePaths::judge(const msg::IcePath& message) {
  if (!attempts_.contains(message.attempt())) return;
  if (message.verdict() == msg::IcePath::VERDICT_TAKEN)
    take(message.attempt());
  else
    drop(message.attempt());
  tell_path();
}

void IcePaths::look_soon() {
  if (closed_) return;
  timer_.expires_after(kLookEvery);
  timer_.async_wait([this, alive = std::weak_ptr<const bool>(alive_)](const boost::system::error_code& cancelled) {
    if (cancelled || alive.expired() || closed_) return;
    look();
    look_soon();
  });
}

/// Ends attempts whose time is over, and begins one when it is due.
void IcePaths::look() {
  const Clock::time_point now = Clock::now();
  std::vector<Number> over, fruitless, without_relay;
  for (const auto& [number, attempt] : attempts_) {
    if (attempt.waits_for_relay && now - attempt.since >= kRelayAnswersWithin) without_relay.push_back(number);
    if (attempt.ends_at && now >= *attempt.ends_at) over.push_back(number);
    const bool tries = number != taken_ && !attempt.ends_at;
    const bool waits_for_verdict = settings_.end == End::Client;
    const auto lasts =
        attempt.path && !waits_for_verdict ? std::chrono::milliseconds(kBetterPathWithin) : settings_.attempt_lasts;
    if (tries && now - attempt.since >= lasts) fruitless.push_back(number);
  }
  for (const Number number : without_relay) candidates_end(number);
  for (const Number number : over) end(number);
  for (const Number number : fruitless) drop(number);
  if (settings_.end == End::Client) return tell_path();
  if (path() && is_relayed(*path()) && now - begun_ >= settings_.better_every) wants_attempt_ = true;
  if (!path() && last_ != 0) wants_attempt_ = true;
  const bool tries =
      std::ranges::any_of(attempts_, [&](const auto& one) { return one.first != taken_ && !one.second.ends_at; });
  if (wants_attempt_ && !tries && now - begun_ >= pause_) begin_now();
  tell_path();
}

}  // namespace telepalp::ice
