#include "server/oidc/browser/started_log_in.h"

#include <cjose/base64.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>

#include "proto/keys/audit_chain.h"
#include "proto/keys/seal/site_key.h"
#include "proto/keys/token.h"
#include "proto/words/demand.h"

namespace telepalp::oidc {
namespace {

constexpr std::size_t kMacDigits = 64;

std::string base64url(const std::array<unsigned char, 32>& bytes) {
  char* text = nullptr;
  std::size_t size = 0;
  cjose_err ignored{};
  demand(cjose_base64url_encode(bytes.data(), bytes.size(), &text, &size, &ignored), "memory is left for 44 bytes");
  const std::unique_ptr<char, decltype(&std::free)> owned(text, &std::free);
  return {text, size};
}

bool is_equal(std::string_view one, std::string_view other) {
  return one.size() == other.size() && CRYPTO_memcmp(one.data(), other.data(), one.size()) == 0;
}

std::int64_t seconds_of(StartedLogIns::TimePoint time) {
  return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

/// The second field of "SECRET.SECONDS.PAGE".
std::optional<std::int64_t> begun_s(std::string_view body) {
  const std::size_t dot = body.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::int64_t seconds = 0;
  const auto [end, failed] = std::from_chars(body.data() + dot + 1, body.data() + body.size(), seconds);
  if (failed != std::errc() || end == body.data() + body.size() || *end != '.') return std::nullopt;
  return seconds;
}

}  // namespace

StartedLogIns::StartedLogIns() : key_(keys::random_secret()) {}

std::string StartedLogIns::mac(std::string_view label, std::string_view text) const {
  const std::string all = std::string(label) + ":" + std::string(text);
  std::array<unsigned char, EVP_MAX_MD_SIZE> code{};
  unsigned size = 0;
  HMAC(EVP_sha256(), key_.data(), static_cast<int>(key_.size()), reinterpret_cast<const unsigned char*>(all.data()),
       all.size(), code.data(), &size);
  return keys::in_hexadecimal_digits({reinterpret_cast<const char*>(code.data()), size});
}

std::string StartedLogIns::begin(std::string_view page, TimePoint now) const {
  const std::string body = keys::random_secret() + "." + std::to_string(seconds_of(now)) + "." + std::string(page);
  return mac("cookie", body) + "." + body;
}

std::optional<LogIn> StartedLogIns::read(std::string_view cookie, TimePoint now) const {
  if (cookie.size() <= kMacDigits || cookie[kMacDigits] != '.') return std::nullopt;
  const std::string_view body = cookie.substr(kMacDigits + 1);
  if (!is_equal(cookie.substr(0, kMacDigits), mac("cookie", body))) return std::nullopt;
  const std::optional<std::int64_t> begun = begun_s(body);
  const std::int64_t age_s = begun ? seconds_of(now) - *begun : -1;
  if (age_s < 0 || age_s > kLongest.count()) return std::nullopt;
  LogIn log_in{.state = mac("state", body),
               .nonce = mac("nonce", body),
               .verifier = mac("verifier", body),
               .challenge = {},
               .page = std::string(body.substr(body.find('.', body.find('.') + 1) + 1))};
  log_in.challenge = base64url(keys::sha256(log_in.verifier));
  return log_in;
}

std::optional<LogIn> StartedLogIns::end(std::string_view cookie, std::string_view state, TimePoint now) {
  std::optional<LogIn> log_in = read(cookie, now);
  if (!log_in || !is_equal(log_in->state, state)) return std::nullopt;
  if (!ended_.insert(log_in->state).second) return std::nullopt;
  order_.push_back(log_in->state);
  if (order_.size() > kMost) {
    ended_.erase(order_.front());
    order_.pop_front();
  }
  return log_in;
}

}  // namespace telepalp::oidc
