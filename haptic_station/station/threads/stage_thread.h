#pragma once

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>

#include "haptic_station/core/stage_step.h"

namespace telepalp::station {

/// A thread on which stages run, one run after the other. Owner: the thread that owns the stages.
class StageThread {
 public:
  using HandOver = std::function<void()>;
  using Work = std::function<HandOver(const core::StepTime&, const std::stop_token&)>;

  /// `owner`: runs on the thread that owns the stages. `now`: session clock; called on this object's thread.
  StageThread(boost::asio::io_context& owner, std::function<SessionTime()> now);
  ~StageThread() { end(); }
  StageThread(const StageThread&) = delete;
  StageThread& operator=(const StageThread&) = delete;

  /// Calls `work` on this object's thread, then its result on the owner's.
  void run(Work work);
  /// Asks the work that runs to stop, and waits for it. What is not handed over yet is dropped.
  void end();

 private:
  boost::asio::io_context& owner_;
  std::function<SessionTime()> now_;
  // shared: a hand-over that waits in `owner_` looks here whether end() was called
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
  std::stop_source stop_;
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stay_;
  std::thread thread_;
};

}  // namespace telepalp::station
