#include "server/meet/caller/calls.h"

#include <openssl/rand.h>

#include <array>
#include <utility>
#include <vector>

#include "proto/words/demand.h"
#include "server/meet/caller/splice.h"
#include "server/meet/words/meet_frames.h"

namespace telepalp::meet {
namespace {

constexpr std::chrono::seconds kTimeToAnswer{5};  // until a site must have answered a call
constexpr std::chrono::seconds kTimeToProve{7};   // the site ends a caller's connection without a Hello after 5 s

std::string new_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  demand(RAND_bytes(bytes.data(), bytes.size()) == 1, "the system gives random bytes");
  return {bytes.begin(), bytes.end()};
}

/// The one of `places` that must go for `newcomer`; nullopt: the newcomer itself.
template <class Place, class Who>
std::optional<Place> one_to_go(const std::vector<Place>& places, Who who, const access::Unproven& newcomer) {
  std::vector<access::Unproven> all;
  for (const Place& place : places) all.push_back(who(place));
  all.push_back(newcomer);
  const std::size_t chosen = access::one_to_close(all, newcomer.since).value_or(places.size());
  return chosen == places.size() ? std::nullopt : std::optional(places[chosen]);
}

}  // namespace

std::optional<std::string> Calls::add(const std::string& site, Socket caller, std::string first) {
  const access::Unproven who = access::newcomer(caller);
  if (!has_place_to_wait(site, who) || !has_place_for_stream(site, who)) {
    refuse_(std::move(caller));
    return std::nullopt;
  }
  std::string token = new_token();
  waiting_.emplace(token, Waiting{.caller = std::move(caller), .first = std::move(first), .site = site, .who = who});
  return token;
}

bool Calls::has_place_to_wait(const std::string& site, const access::Unproven& newcomer) {
  std::vector<std::string> tokens;
  for (const auto& [token, one] : waiting_)
    if (one.site == site) tokens.push_back(token);
  if (tokens.size() < limits_.waiting_per_site) return true;
  const auto leaving = one_to_go(
      tokens, [this](const std::string& token) { return waiting_.at(token).who; }, newcomer);
  if (leaving) declined(*leaving);
  return leaving.has_value();
}

/// A stream that is older than kTimeToProve belongs to somebody whom the site has let in: it does not go.
bool Calls::has_place_for_stream(const std::string& site, const access::Unproven& newcomer) {
  if (streams_->count(site) < limits_.streams_per_site) return true;
  std::vector<Streams::iterator> young;
  const auto [first, last] = streams_->equal_range(site);
  for (auto stream = first; stream != last; ++stream)
    if (newcomer.since - stream->second.who.since < kTimeToProve) young.push_back(stream);
  const auto leaving = one_to_go(
      young, [](const Streams::iterator& stream) { return stream->second.who; }, newcomer);
  if (leaving) (*leaving)->second.end();
  return leaving.has_value();
}

bool Calls::answered(const std::string& token, Socket site) {
  const auto found = waiting_.find(token);
  if (found == waiting_.end()) return false;
  Waiting call = std::move(found->second);
  waiting_.erase(found);
  const auto stream = streams_->emplace(call.site, Stream{.who = call.who, .end = {}});
  stream->second.end = splice(std::move(call.caller), std::move(call.first), std::move(site),
                              [all = streams_, stream] { all->erase(stream); });
  return true;
}

void Calls::declined(const std::string& token) {
  const auto found = waiting_.find(token);
  if (found == waiting_.end()) return;
  refuse_(std::move(found->second.caller));
  waiting_.erase(found);
}

void Calls::refuse_late(TimePoint now) {
  std::vector<std::string> late;
  for (const auto& [token, one] : waiting_)
    if (now - one.who.since > kTimeToAnswer) late.push_back(token);
  for (const std::string& token : late) declined(token);
}

/// Ending a stream closes its sockets; it leaves the list when their operations have ended.
std::size_t Calls::end_streams(const std::string& site) {
  const auto [first, last] = streams_->equal_range(site);
  std::size_t ended = 0;
  for (auto stream = first; stream != last; ++stream, ++ended) stream->second.end();
  return ended;
}

}  // namespace telepalp::meet
