#include "server/origin/camera_origin.h"

#include <utility>

namespace telepalp::origin {
namespace {

std::string_view word_for(msg::CaptureState state) noexcept {
  switch (state) {
    case msg::CAPTURE_STATE_LIVE:
      return "live";
    case msg::CAPTURE_STATE_WAITING:
      return "waiting for a frame";
    case msg::CAPTURE_STATE_LOST:
      return "lost, connecting again";
    case msg::CAPTURE_STATE_ENDED:
      return "has no more images";
    default:
      return "in an unknown state";
  }
}

class CameraOrigin final : public Origin {
 public:
  CameraOrigin(boost::asio::io_context& network, std::unique_ptr<capture::CaptureSource> source,
               std::string source_name, pipeline::EncodeOptions encode, const wire::SessionClock& clock)
      : network_(network),
        source_(std::move(source)),
        source_name_(std::move(source_name)),
        encode_(encode),
        clock_(clock) {}

  void start(Handlers handlers) override {
    thread_ = std::make_unique<pipeline::CaptureThread>(
        network_, std::move(source_), source_name_, encode_, clock_,
        pipeline::CaptureThread::Handlers{.on_message = std::move(handlers.on_message),
                                          .on_end = std::move(handlers.on_end)});
  }
  void stop() override {
    if (thread_) thread_->stop();
  }
  void show_again() override {
    if (thread_) thread_->request_key_frame();
  }
  [[nodiscard]] bool is_still() const override { return false; }
  [[nodiscard]] bool withholds(const wire::Topic&, std::size_t) const override { return false; }
  [[nodiscard]] bool chooses_prediction() const override {
    return encode_.depth.mode == codec::DepthMode::Temporal || encode_.depth.mode == codec::DepthMode::Bounded;
  }
  void let_predict(bool may) override {
    if (thread_) thread_->let_predict(may);
  }
  [[nodiscard]] std::uint64_t images() const override { return thread_ ? thread_->frames() : 0; }
  [[nodiscard]] std::string in_words(const msg::CaptureStatus& status) const override {
    return "camera " + std::string(word_for(status.state())) + ": " + status.detail();
  }

 private:
  boost::asio::io_context& network_;
  std::unique_ptr<capture::CaptureSource> source_;  // until start()
  std::string source_name_;
  pipeline::EncodeOptions encode_;
  wire::SessionClock clock_;
  std::unique_ptr<pipeline::CaptureThread> thread_;  // from start() on
};

}  // namespace

std::unique_ptr<Origin> of_camera(boost::asio::io_context& network, std::unique_ptr<capture::CaptureSource> source,
                                  std::string source_name, pipeline::EncodeOptions encode,
                                  const wire::SessionClock& clock) {
  return std::make_unique<CameraOrigin>(network, std::move(source), std::move(source_name), encode, clock);
}

}  // namespace telepalp::origin
