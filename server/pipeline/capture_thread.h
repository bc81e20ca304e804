#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "proto/words/latest_value.h"
#include "server/capture/capture_source.h"
#include "server/pipeline/camera_pipeline.h"
#include "server/pipeline/key_frame_requests.h"

namespace telepalp::pipeline {

/// What is known of the source's exposure.
struct ExposureReport {
  std::optional<capture::ExposureLimits> limits{};  ///< nullopt: the source has no exposure to set
  capture::Exposure exposure{};
  std::string problem{};  ///< why the exposure that was set last is not in effect; empty: it is
};

/// The thread that owns the source: waits for frames, encodes them, and posts the messages to the network thread.
class CaptureThread {
 public:
  struct Handlers {
    std::function<void(wire::Message, plan::Grade)> on_message;  ///< on the network thread
    std::function<void()> on_end;  ///< on the network thread, once, when the source has ended
    /// On the network thread: after the first image, and after each set_exposure().
    std::function<void(ExposureReport)> on_exposure{};
  };

  CaptureThread(boost::asio::io_context& network, std::unique_ptr<capture::CaptureSource> source,
                std::string source_name, EncodeOptions options, wire::SessionClock clock, Handlers handlers);
  /// Stops the thread and waits until it ends: at most 0.1 s and the encoding of one frame.
  ~CaptureThread();

  void stop();  ///< as the destructor; may be called more than once
  /// Requests a key frame of `topic`; at most one of four frames becomes a requested key frame. Any thread.
  void request_key_frame(std::string_view topic) noexcept { key_frame_requests_.request(topic); }
  /// From the next image on, images are encoded as `wanted` says. Network thread.
  void want(const Wanted& wanted) { wanted_.put(wanted); }
  /// False: from the next image on, each depth image is a key frame. Any thread.
  void let_predict(bool may) noexcept { may_predict_ = may; }
  void set_exposure(const capture::Exposure& exposure) { wanted_exposure_.put(exposure); }  ///< network thread
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  /// Messages dropped because the network thread was too far behind.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  void run(const std::string& source_name, EncodeOptions options, wire::SessionClock clock);
  [[nodiscard]] bool hand_over(wire::Message message, plan::Grade grade);
  void report_exposure(const std::string& problem);
  void set_wanted_exposure();

  boost::asio::io_context& network_;
  std::unique_ptr<capture::CaptureSource> source_;
  Handlers handlers_;
  LatestValue<capture::Exposure> wanted_exposure_;  // from the network thread to the capture thread
  LatestValue<Wanted> wanted_;                      // the same
  std::atomic<bool> stopping_{false};
  KeyFrameRequests key_frame_requests_;
  std::atomic<bool> may_predict_{true};
  std::atomic<int> on_the_way_{0};  // messages posted and not yet handled
  std::atomic<std::uint64_t> frames_{0};
  std::atomic<std::uint64_t> dropped_{0};
  std::thread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::pipeline
