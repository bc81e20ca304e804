#include "server/origin/camera_origin.h"

#include <utility>

#include "messages/recording.pb.h"
#include "server/origin/live_notes.h"
#include "support/program/message_json.h"

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

Error wrong_exposure(std::string what) {
  return {
      .what = std::move(what),
      .where = "exposure",
      .fix =
          "send JSON such as {\"automatic\": false, \"exposure\": 8, \"gain\": 2}, within what GET /exposure states"};
}

/// `now` after the command in `json`. Error: the source has no exposure to set, or a value is out of its range.
Result<capture::Exposure> after_command(const pipeline::ExposureReport& now, const std::string& json) {
  msg::ExposureCommand command;
  if (const Result<void> read = program::read_json(json, command, "exposure", wrong_exposure({}).fix); !read)
    return read.error();
  if (!now.limits) return wrong_exposure("this source has no exposure to set");
  capture::Exposure exposure = now.exposure;
  if (command.has_automatic()) exposure.automatic = command.automatic();
  if (command.has_exposure()) exposure.exposure = command.exposure();
  if (command.has_gain()) exposure.gain = command.gain();
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (command.has_exposure() && !within(exposure.exposure, now.limits->least, now.limits->most))
    return wrong_exposure("the exposure is out of the camera's range");
  if (command.has_gain() && !within(exposure.gain, now.limits->least_gain, now.limits->most_gain))
    return wrong_exposure("the gain is out of the camera's range");
  return exposure;
}

msg::ExposureState state_of(const pipeline::ExposureReport& report) {
  msg::ExposureState state;
  state.set_offered(report.limits.has_value());
  state.set_problem(report.problem);
  if (!report.limits) return state;
  state.set_automatic(report.exposure.automatic);
  state.set_exposure(report.exposure.exposure);
  state.set_gain(report.exposure.gain);
  state.set_unit(report.limits->unit);
  state.set_least(report.limits->least);
  state.set_most(report.limits->most);
  state.set_least_gain(report.limits->least_gain);
  state.set_most_gain(report.limits->most_gain);
  return state;
}

class CameraOrigin final : public Origin {
 public:
  CameraOrigin(boost::asio::io_context& network, std::unique_ptr<capture::CaptureSource> source,
               std::string source_name, pipeline::EncodeOptions encode, const wire::SessionClock& clock)
      : network_(network),
        source_(std::move(source)),
        source_name_(std::move(source_name)),
        encode_(encode),
        clock_(clock),
        notes_(clock) {}

  void start(Handlers handlers) override {
    notes_.start(handlers.on_message);
    thread_ = std::make_unique<pipeline::CaptureThread>(
        network_, std::move(source_), source_name_, encode_, clock_,
        pipeline::CaptureThread::Handlers{
            .on_message =
                [all = std::move(handlers.on_message), graded = std::move(handlers.on_graded)](wire::Message message,
                                                                                               plan::Grade grade) {
                  if (grade == plan::Grade::Full)
                    all(std::move(message));
                  else if (graded)
                    graded(std::move(message), grade);
                },
            .on_end = std::move(handlers.on_end),
            .on_exposure = [this](pipeline::ExposureReport report) { exposure_ = std::move(report); }});
  }
  void stop() override {
    if (thread_) thread_->stop();
  }
  void show_again(std::string_view topic) override {
    if (thread_) thread_->request_key_frame(topic);
  }
  void want(const pipeline::Wanted& wanted) override {
    if (thread_) thread_->want(wanted);
  }
  [[nodiscard]] bool is_still() const override { return false; }
  [[nodiscard]] bool withholds(const wire::Topic&, std::size_t) const override { return false; }
  [[nodiscard]] bool chooses_prediction() const override {
    return encode_.depth.mode == codec::DepthMode::Temporal || encode_.depth.mode == codec::DepthMode::Bounded;
  }
  void let_predict(bool may) override {
    if (thread_) thread_->let_predict(may);
  }
  [[nodiscard]] bool chooses_content() const override { return true; }
  [[nodiscard]] std::uint64_t images() const override { return thread_ ? thread_->frames() : 0; }
  [[nodiscard]] std::string in_words(const msg::CaptureStatus& status) const override {
    return "camera " + std::string(word_for(status.state())) + ": " + status.detail();
  }
  [[nodiscard]] Offer offer() override {
    Offer offer;
    offer.resources[kExposure.topic.name] = {
        .state = [this] { return state_message(state_of(exposure_)); },
        .change = at_once([this](const std::string& json, const std::string&) { return expose(json); })};
    offer.resources[kMarks.topic.name] = notes_.resource();
    return offer;
  }

 private:
  Result<void> expose(const std::string& json) {
    Result<capture::Exposure> wanted = after_command(exposure_, json);
    if (!wanted || !thread_) return wanted ? Result<void>{} : wanted.error();
    thread_->set_exposure(*wanted);
    exposure_.exposure = *wanted;  // until the capture thread reports what the camera took
    return {};
  }

  boost::asio::io_context& network_;
  std::unique_ptr<capture::CaptureSource> source_;  // until start()
  std::string source_name_;
  pipeline::EncodeOptions encode_;
  wire::SessionClock clock_;
  LiveNotes notes_;
  pipeline::ExposureReport exposure_;
  std::unique_ptr<pipeline::CaptureThread> thread_;  // from start() on
};

}  // namespace

std::unique_ptr<Origin> of_camera(boost::asio::io_context& network, std::unique_ptr<capture::CaptureSource> source,
                                  std::string source_name, pipeline::EncodeOptions encode,
                                  const wire::SessionClock& clock) {
  return std::make_unique<CameraOrigin>(network, std::move(source), std::move(source_name), encode, clock);
}

}  // namespace telepalp::origin
