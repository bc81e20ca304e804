#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <string_view>

#include "proto/keys/identity.h"
#include "proto/words/repeats/repeated_errors.h"
#include "proto/words/result.h"
#include "server/access/access.h"
#include "server/access/unproven.h"
#include "server/oidc/browser/started_log_in.h"
#include "server/oidc/provider.h"
#include "server/oidc/settings.h"

namespace telepalp::oidc {

/// Signs people in at the hospital's provider: leave() sends a browser there, arrive() takes it back. The provider is
/// asked on a thread of its own, one request after the other, so nothing waits on the network thread. Owner: the
/// network thread.
class HospitalSignIn {
 public:
  static constexpr std::size_t kMostWaiting = 64;  ///< most browsers that wait until the provider is asked

  /// `say`: takes log lines for the technician, about the provider.
  HospitalSignIn(boost::asio::io_context& network, Settings settings, std::function<void(const std::string&)> say);
  HospitalSignIn(const HospitalSignIn&) = delete;
  HospitalSignIn& operator=(const HospitalSignIn&) = delete;
  /// Ends the request that is under way; those that wait get no answer.
  ~HospitalSignIn();

  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }

  struct Departure {
    std::string address;  ///< of the provider's page, with this log-in in its query
    std::string cookie;   ///< for this browser, for StartedLogIns::kLongest
  };
  /// Calls `done` once, now or later. `page`: where the browser goes after signing in. Error: the provider is not
  /// reached, or too many people sign in at the same time.
  void leave(const std::string& page, const boost::asio::ip::address& from,
             std::function<void(Result<Departure>)> done);

  /// What a browser brings back from the provider, as it came.
  struct Return {
    std::string_view cookie;
    std::string_view state;
    std::string_view code;
    std::string_view error;  ///< the provider's word for its refusal; empty: it did not refuse
  };
  struct Arrival {
    Person person;
    std::string page;
  };
  /// Calls `done` once, now or later. Error: this browser did not begin the log-in, or has ended it already; the
  /// provider refuses; or as for leave() and Provider::person().
  void arrive(const Return& brought, const boost::asio::ip::address& from, std::function<void(Result<Arrival>)> done);

 private:
  /// A question to the provider; its answer is for a browser at `from`.
  struct Job {
    access::Unproven browser;
    std::function<std::function<void()>()>
        ask;  // called on pool_'s thread; what it returns is called on the network thread
    std::function<void(const Error&)> dropped;
  };
  void add(Job job);
  void say(const Error& failed);
  void drop_one();
  void start_next();
  [[nodiscard]] Departure departure(const std::string& log_in_address, const std::string& page) const;

  boost::asio::io_context& network_;
  const Settings settings_;
  std::function<void(const std::string&)> say_;
  RepeatedErrors failed_;
  StartedLogIns started_;
  access::TokenBackOff back_off_;
  std::list<Job> waiting_;
  bool is_asking_ = false;
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // posted calls hold weak_ptrs to it
  Provider provider_;                                                       // used by pool_ alone, except stop()
  boost::asio::thread_pool pool_{1};
};

/// Error: the provider cannot be reached, or is not as `settings` describe it. Waits for its answer.
[[nodiscard]] Result<void> check_provider(const Settings& settings);

}  // namespace telepalp::oidc
