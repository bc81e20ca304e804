#include "server/pipeline/capture_thread.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <utility>

namespace telepalp::pipeline {
namespace {

/// One second of depth and colour images. Normally the hub's queues drop messages; this bound limits memory only if the
/// network thread stops completely.
constexpr int kMostOnTheWay = 64;

}  // namespace

CaptureThread::CaptureThread(boost::asio::io_context& network, std::unique_ptr<capture::CaptureSource> source,
                             std::string source_name, EncodeOptions options, wire::SessionClock clock,
                             Handlers handlers)
    : network_(network), source_(std::move(source)), handlers_(std::move(handlers)) {
  thread_ = std::thread([this, name = std::move(source_name), options, clock] { run(name, options, clock); });
}

CaptureThread::~CaptureThread() { stop(); }

void CaptureThread::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void CaptureThread::run(const std::string& source_name, EncodeOptions options, wire::SessionClock clock) {
  CameraPipeline pipeline(
      *source_, source_name, options, clock,
      {.publish = [this](wire::Message message, plan::Grade grade) { return hand_over(std::move(message), grade); },
       .take_key_frame_request = [this](std::string_view topic) { return key_frame_requests_.take(topic); },
       .may_predict = [this] { return may_predict_.load(); },
       .wanted =
           [this] {
             wanted_.take();
             return wanted_.current();
           }});
  while (!stopping_) {
    set_wanted_exposure();
    const bool more = pipeline.step();
    if (frames_.exchange(pipeline.frames()) == 0 && frames_ > 0) report_exposure({});
    if (more) continue;
    boost::asio::post(network_, handlers_.on_end);
    return;
  }
}

void CaptureThread::set_wanted_exposure() {
  if (!wanted_exposure_.take()) return;
  const Result<void> set = source_->set_exposure(wanted_exposure_.current());
  report_exposure(set ? std::string() : to_string(set.error()));
}

void CaptureThread::report_exposure(const std::string& problem) {
  if (!handlers_.on_exposure) return;
  boost::asio::post(network_, [this, report = ExposureReport{.limits = source_->exposure_limits(),
                                                             .exposure = source_->exposure(),
                                                             .problem = problem}] { handlers_.on_exposure(report); });
}

bool CaptureThread::hand_over(wire::Message message, plan::Grade grade) {
  if (on_the_way_ >= kMostOnTheWay) {
    ++dropped_;
    return false;
  }
  ++on_the_way_;
  boost::asio::post(network_, [this, message = std::move(message), grade]() mutable {
    --on_the_way_;
    handlers_.on_message(std::move(message), grade);
  });
  return true;
}

}  // namespace telepalp::pipeline
