#include "server/capture/pacing/recorded_source.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace telepalp::capture {
namespace {

constexpr Nanoseconds kBetweenRounds{33'333'333};  // time from a recording's last frame to the repeated first one
constexpr Nanoseconds kTooLate{50'000'000};  // a frame that was not fetched for this long is dropped, like a camera's
constexpr Nanoseconds kLongestPause{2'000'000'000};  // a longer pause in a recording is cut to this

class RecordedSource final : public CaptureSource {
 public:
  RecordedSource(std::unique_ptr<RecordedFrames> frames, std::string description, const SourceOptions& options)
      : frames_(std::move(frames)), description_(std::move(description)), options_(options) {}

  std::optional<RgbdFrame> next(Nanoseconds patience) override {
    const SessionTime until = options_.clock.now() + patience;
    do {
      if (!decoded_ && is_over()) {
        std::this_thread::sleep_until(options_.clock.steady(until));
        return std::nullopt;
      }
      if (!decoded_) decode_next();
      if (!decoded_) continue;  // damaged, or too late
      if (options_.paced) {
        std::this_thread::sleep_until(options_.clock.steady(std::min(decoded_->captured, until)));
        if (decoded_->captured > until) return std::nullopt;
      }
      std::optional<RgbdFrame> frame = std::exchange(decoded_, std::nullopt);
      if (is_too_late(frame->captured)) continue;
      state_ = CaptureState::Live;
      frame->sequence = played_++;
      return frame;
    } while (!options_.paced || options_.clock.now() <= until);
    return std::nullopt;
  }
  CaptureState state() const override { return state_; }
  std::string detail() const override {
    const std::string complaint = frames_->complaint();
    return description_ + (complaint.empty() ? "" : "; " + complaint);
  }
  std::string complaint() const override { return frames_->complaint(); }
  const CompressedFrame* compressed() const override { return frames_->compressed(); }

 private:
  /// True at the end of a recording that is not repeated.
  bool is_over() { return !frames_->peek() && !(start_over() && frames_->peek()); }
  /// Decodes the next frame ahead of its time: a camera's frames are decoded, too, when the camera delivers them.
  void decode_next() {
    const SessionTime then = *frames_->peek();
    const SessionTime due = due_of(then);
    moved_to(then, due);
    if (is_too_late(due)) return frames_->skip();
    decoded_ = frames_->take();
    if (decoded_) decoded_->captured = due;
  }
  [[nodiscard]] bool is_too_late(SessionTime due) const {
    return options_.paced && options_.clock.now() - due > kTooLate;
  }
  /// Restarts the recording. False if it is not repeated, or if no frame could be decoded.
  bool start_over() {
    if (state_ == CaptureState::Ended) return false;
    if (!options_.loop || played_ == played_before_round_) {
      state_ = CaptureState::Ended;
      return false;
    }
    played_before_round_ = played_;
    frames_->rewind();
    last_then_.reset();
    return true;
  }
  [[nodiscard]] SessionTime due_of(SessionTime then) const {
    if (!last_due_) return options_.clock.now();
    if (!last_then_) return *last_due_ + kBetweenRounds;
    return *last_due_ + std::clamp(then - *last_then_, Nanoseconds{1}, kLongestPause);
  }
  void moved_to(SessionTime then, SessionTime due) {
    last_then_ = then;
    last_due_ = due;
  }

  std::unique_ptr<RecordedFrames> frames_;
  std::string description_;
  SourceOptions options_;
  CaptureState state_ = CaptureState::Waiting;
  std::optional<RgbdFrame> decoded_;      // waits for its time
  std::optional<SessionTime> last_then_;  // times of the previous frame, in the recording and in this session
  std::optional<SessionTime> last_due_;
  std::uint64_t played_ = 0;
  std::uint64_t played_before_round_ = 0;
};

}  // namespace

std::unique_ptr<CaptureSource> play_recorded(std::unique_ptr<RecordedFrames> frames, std::string description,
                                             const SourceOptions& options) {
  return std::make_unique<RecordedSource>(std::move(frames), std::move(description), options);
}

}  // namespace telepalp::capture
