#include "haptic_station/station/threads/stage_thread.h"

#include <boost/asio/post.hpp>
#include <utility>

namespace telepalp::station {

StageThread::StageThread(boost::asio::io_context& owner, std::function<SessionTime()> now)
    : owner_(owner), now_(std::move(now)), stay_(boost::asio::make_work_guard(io_)), thread_([this] { io_.run(); }) {}

void StageThread::run(Work work) {
  boost::asio::post(io_, [this, work = std::move(work)] {
    HandOver hand_over = work([this](core::StageStep) { return now_(); }, stop_.get_token());
    boost::asio::post(owner_, [alive = std::weak_ptr(alive_), hand_over = std::move(hand_over)] {
      if (!alive.expired()) hand_over();
    });
  });
}

void StageThread::end() {
  stop_.request_stop();
  io_.stop();
  if (thread_.joinable()) thread_.join();
  alive_.reset();
}

}  // namespace telepalp::station
