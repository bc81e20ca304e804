#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <utility>

#include "proto/words/result.h"

namespace telepalp::origin {

/// The share of a file's index that has been read, 0 to 1.
using Progress = std::function<void(double share)>;

/// Opens files and cameras on threads of its own, so that the network thread does not wait while they are opened.
/// Owner: the network thread.
class OpeningPool {
 public:
  explicit OpeningPool(boost::asio::io_context& network) : network_(network) {}
  OpeningPool(const OpeningPool&) = delete;
  OpeningPool& operator=(const OpeningPool&) = delete;
  /// Waits for the work that is under way. Its results are dropped.
  ~OpeningPool() {
    pool_.stop();
    pool_.join();
  }

  /// `work` runs on a thread of the pool. `progress` and `done` are called on the network thread, `done` once.
  template <class Value>
  void run(std::function<Result<Value>(const Progress&)> work, Progress progress,
           std::function<void(Result<Value>)> done) {
    auto told = [this, progress = std::move(progress)](double share) {
      post_while_alive([progress, share] { progress(share); });
    };
    boost::asio::post(pool_, [this, work = std::move(work), told = std::move(told), done = std::move(done)] {
      // shared: an Asio handler is copyable, and a Result of a unique_ptr is not
      const auto result = std::make_shared<Result<Value>>(work(told));
      post_while_alive([result, done] { done(std::move(*result)); });
    });
  }

 private:
  static constexpr std::size_t kThreads = 2;  // a slow disk or camera then delays one other opening at most

  template <class Call>
  void post_while_alive(Call call) {
    boost::asio::post(network_, [alive = std::weak_ptr<const bool>(alive_), call = std::move(call)] {
      if (!alive.expired()) call();
    });
  }

  boost::asio::io_context& network_;
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // posted calls hold weak_ptrs to it
  boost::asio::thread_pool pool_{kThreads};
};

}  // namespace telepalp::origin
