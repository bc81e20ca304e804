#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proto/keys/identity.h"

namespace telepalp::access {

/// A stream of the patient that is open now, and who sees it.
struct Present {
  keys::Identity who;
  std::string program;  ///< "telepalp-station", "browser"
  std::string from;     ///< ADDRESS:PORT
  std::string since;    ///< UTC, as 2026-11-22T00:12:33Z
};

/// Who sees the patient now, and whom the technician has sent out. Whoever is sent out stays out for kSentOut, with
/// each program that has this key or token. Pure; owner: the server's network thread.
class People {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::minutes kSentOut{15};

  std::uint64_t enter(Present stream) {
    present_.emplace(++last_, std::move(stream));
    return last_;
  }
  /// The stream that ends; nullopt: there is none of this number.
  std::optional<Present> leave(std::uint64_t number) {
    const auto found = present_.find(number);
    if (found == present_.end()) return std::nullopt;
    Present left = std::move(found->second);
    present_.erase(found);
    return left;
  }
  [[nodiscard]] const std::map<std::uint64_t, Present>& present() const noexcept { return present_; }

  void send_out(const keys::Identity& who, TimePoint now) { sent_out_[who.serial] = {who, now + kSentOut}; }
  void let_in(const std::string& serial) { sent_out_.erase(serial); }
  [[nodiscard]] bool is_sent_out(const std::string& serial, TimePoint now) const {
    const auto found = sent_out_.find(serial);
    return found != sent_out_.end() && now < found->second.until;
  }
  [[nodiscard]] std::vector<keys::Identity> sent_out(TimePoint now) const {
    std::vector<keys::Identity> all;
    for (const auto& [serial, one] : sent_out_)
      if (now < one.until) all.push_back(one.who);
    return all;
  }

 private:
  struct SentOut {
    keys::Identity who;
    TimePoint until;
  };
  std::map<std::uint64_t, Present> present_;  // by a number of its own
  std::map<std::string, SentOut> sent_out_;   // by serial
  std::uint64_t last_ = 0;
};

}  // namespace telepalp::access
