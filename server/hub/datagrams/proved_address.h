#pragma once

#include <boost/asio/ip/udp.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::hub {

/// To which UDP address the datagrams of one peer go. An address is proved when the peer repeats the nonce that was
/// sent there: so nobody can name a third machine as the receiver of a stream (RFC 9000 §8). Until then the address
/// gets at most three times the bytes that came from it, and an older proved address keeps the stream. Pure.
class ProvedAddress {
 public:
  using Endpoint = boost::asio::ip::udp::endpoint;
  static constexpr std::uint64_t kMostOfReceived = 3;
  static constexpr Nanoseconds kChallengeEvery = std::chrono::milliseconds(20);

  /// The peer's newest authenticated datagram, of `bytes`, came from `from`. `draw_nonce()` gives a random number; it
  /// is called if `from` is new.
  template <class DrawNonce>
  void received(const Endpoint& from, std::size_t bytes, const DrawNonce& draw_nonce) {
    if (proved_ == from) return candidate_.reset();
    if (!candidate_ || candidate_->at != from) candidate_ = Candidate{.at = from, .nonce = draw_nonce()};
    candidate_->received_B += bytes;
  }
  /// The peer repeated `nonce`. True: this proves the new address.
  bool answered(std::uint64_t nonce) noexcept {
    if (!candidate_ || candidate_->nonce != nonce) return false;
    proved_ = candidate_->at;
    candidate_.reset();
    return true;
  }

  struct Challenge {
    Endpoint to;
    std::uint64_t nonce = 0;
  };
  /// The challenge to send now; it may be counted by may_send(). nullopt: none.
  [[nodiscard]] std::optional<Challenge> challenge(SessionTime now) noexcept {
    if (!candidate_ || now < candidate_->next_challenge) return std::nullopt;
    candidate_->next_challenge = now + kChallengeEvery;
    return Challenge{.to = candidate_->at, .nonce = candidate_->nonce};
  }

  [[nodiscard]] bool is_proved() const noexcept { return proved_.has_value(); }
  /// The address for datagrams other than challenges; nullopt: no datagram has come yet.
  [[nodiscard]] std::optional<Endpoint> receiver() const noexcept {
    return proved_ || !candidate_ ? proved_ : std::optional(candidate_->at);
  }
  /// True if `bytes` may be sent to `to` now; they count as sent.
  [[nodiscard]] bool may_send(const Endpoint& to, std::size_t bytes) noexcept {
    if (proved_ == to) return true;
    if (!candidate_ || candidate_->at != to) return false;
    if (candidate_->sent_B + bytes > kMostOfReceived * candidate_->received_B) return false;
    candidate_->sent_B += bytes;
    return true;
  }

 private:
  struct Candidate {
    Endpoint at{};
    std::uint64_t nonce = 0;
    std::uint64_t received_B = 0;
    std::uint64_t sent_B = 0;
    SessionTime next_challenge{};
  };
  std::optional<Endpoint> proved_;
  std::optional<Candidate> candidate_;  // the newest address, not proved yet
};

}  // namespace telepalp::hub
