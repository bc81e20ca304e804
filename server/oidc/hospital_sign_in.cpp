#include "server/oidc/hospital_sign_in.h"

#include <boost/asio/post.hpp>
#include <utility>
#include <vector>

#include "proto/keys/audit_chain.h"
#include "server/oidc/web/web_address.h"

namespace telepalp::oidc {
namespace {

constexpr std::size_t kLongestCode = 4096;
constexpr std::chrono::seconds kLongestWaiting{15};  // the provider may hang for 5 s each time

Error too_many() {
  return error_without_place("too many people sign in at the hospital's provider now",
                             "wait a few seconds, then try again");
}

/// The provider's word for a refusal is shown on a page and written to the audit log: only letters and '_' (RFC 6749).
std::string word(std::string_view error) {
  const std::size_t end = error.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
  return std::string(error.substr(0, std::min(end, std::size_t{64})));
}

}  // namespace

HospitalSignIn::HospitalSignIn(boost::asio::io_context& network, Settings settings,
                               std::function<void(const std::string&)> say)
    : network_(network), settings_(std::move(settings)), say_(std::move(say)), provider_(settings_) {}

HospitalSignIn::~HospitalSignIn() {
  provider_.stop();
  pool_.stop();
  pool_.join();
}

HospitalSignIn::Departure HospitalSignIn::departure(const std::string& log_in_address, const std::string& page) const {
  const auto now = std::chrono::system_clock::now();
  const std::string cookie = started_.begin(page, now);
  const LogIn log_in = *started_.read(cookie, now);
  std::string address = log_in_address + (log_in_address.find('?') == std::string::npos ? "?" : "&");
  address += "response_type=code&code_challenge_method=S256";
  const std::pair<const char*, std::string> told[] = {{"client_id", settings_.client_id},
                                                      {"redirect_uri", settings_.back()},
                                                      {"scope", settings_.scope},
                                                      {"state", log_in.state},
                                                      {"nonce", log_in.nonce},
                                                      {"code_challenge", log_in.challenge}};
  for (const auto& [name, value] : told) address += std::string("&") + name + "=" + percent_encoded(value);
  return {.address = address, .cookie = cookie};
}

void HospitalSignIn::leave(const std::string& page, const boost::asio::ip::address& from,
                           std::function<void(Result<Departure>)> done) {
  add({.browser = {.from = from, .since = std::chrono::steady_clock::now()},
       .ask = [this, page, done]() -> std::function<void()> {
         return [this, page, done, address = provider_.log_in_address()] {
           if (!address) say(address.error());
           done(address ? Result<Departure>(departure(*address, page)) : Result<Departure>(address.error()));
         };
       },
       .dropped = done});
}

void HospitalSignIn::arrive(const Return& brought, const boost::asio::ip::address& from,
                            std::function<void(Result<Arrival>)> done) {
  const std::string tried = keys::sha256_hex(brought.state);
  if (!back_off_.may_try(from.to_string(), tried, std::chrono::steady_clock::now())) return done(too_many());
  const std::optional<LogIn> log_in = started_.end(brought.cookie, brought.state, std::chrono::system_clock::now());
  if (!log_in || brought.code.empty() || brought.code.size() > kLongestCode) {
    back_off_.failed(from.to_string(), tried, std::chrono::steady_clock::now());
    return done(
        log_in
            ? error_without_place("the hospital's provider did not sign you in (" + word(brought.error) + ")",
                                  "sign in again, or ask who runs the provider")
            : error_without_place("this browser did not begin this log-in, has ended it already, or took longer than "
                                  "10 minutes",
                                  "sign in again"));
  }
  const auto answered = [this, address = from.to_string(), tried, page = log_in->page,
                         done](const Result<Person>& person) {
    if (!person) back_off_.failed(address, tried, std::chrono::steady_clock::now());
    if (!person) say(person.error());
    done(person ? Result<Arrival>(Arrival{*person, page}) : Result<Arrival>(person.error()));
  };
  add({.browser = {.from = from, .since = std::chrono::steady_clock::now()},
       .ask = [this, answered, code = std::string(brought.code), log_in = *log_in]() -> std::function<void()> {
         return [answered, person = provider_.person(code, log_in.verifier, log_in.nonce)] { answered(person); };
       },
       .dropped = done});
}

void HospitalSignIn::say(const Error& failed) {
  if (const auto line = failed_.line("a log-in at the hospital failed", failed, std::chrono::steady_clock::now()))
    say_(*line);
}

void HospitalSignIn::add(Job job) {
  waiting_.push_back(std::move(job));
  if (waiting_.size() > kMostWaiting) drop_one();
  start_next();
}

/// Tells one waiting browser to come again: one of the network from which most wait.
void HospitalSignIn::drop_one() {
  std::vector<access::Unproven> browsers;
  for (const Job& job : waiting_) browsers.push_back(job.browser);
  const auto chosen = access::one_to_close(browsers, std::chrono::steady_clock::now());
  const auto dropped = std::next(waiting_.begin(), static_cast<std::ptrdiff_t>(chosen.value_or(0)));
  const auto tell = std::move(dropped->dropped);
  waiting_.erase(dropped);
  tell(too_many());
}

void HospitalSignIn::start_next() {
  if (is_asking_ || waiting_.empty()) return;
  if (std::chrono::steady_clock::now() - waiting_.front().browser.since > kLongestWaiting) {
    const auto tell = std::move(waiting_.front().dropped);
    waiting_.pop_front();
    tell(too_many());
    return start_next();
  }
  is_asking_ = true;
  auto ask = std::move(waiting_.front().ask);
  waiting_.pop_front();
  boost::asio::post(pool_, [this, ask = std::move(ask), alive = std::weak_ptr<const bool>(alive_)]() mutable {
    std::function<void()> answer = ask();
    boost::asio::post(network_, [this, ask = std::move(ask), answer = std::move(answer), alive] {
      if (alive.expired()) return;
      is_asking_ = false;
      answer();
      start_next();
    });
  });
}

Result<void> check_provider(const Settings& settings) {
  const Result<std::string> address = Provider(settings).log_in_address();
  return address ? Result<void>() : Result<void>(address.error());
}

}  // namespace telepalp::oidc
