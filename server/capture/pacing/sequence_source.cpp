#include "server/capture/pacing/sequence_source.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "server/capture/pacing/frame_pacer.h"

namespace telepalp::capture {
namespace {

class SequenceSource final : public CaptureSource {
 public:
  SequenceSource(FrameSequence sequence, const SourceOptions& options)
      : sequence_(std::move(sequence)), loop_(options.loop), pacer_(options.clock, sequence_.period, options.paced) {}

  std::optional<RgbdFrame> next(Nanoseconds patience) override {
    if (state_ == CaptureState::Ended) {
      std::this_thread::sleep_for(patience);
      return std::nullopt;
    }
    const std::optional<FrameSlot> slot = pacer_.next(patience);
    if (!slot) return std::nullopt;
    if (!loop_ && slot->index >= sequence_.count) return ended("");
    Result<RgbdFrame> frame = sequence_.load(slot->index % sequence_.count);
    if (!frame) return ended(to_string(frame.error()));
    state_ = CaptureState::Live;
    frame->captured = slot->due;
    frame->sequence = played_++;
    return std::move(*frame);
  }
  CaptureState state() const override { return state_; }
  std::string detail() const override { return failure_.empty() ? sequence_.description : failure_; }
  std::string complaint() const override { return failure_; }

 private:
  std::optional<RgbdFrame> ended(std::string failure) {
    state_ = CaptureState::Ended;
    failure_ = std::move(failure);
    return std::nullopt;
  }

  FrameSequence sequence_;
  bool loop_;
  FramePacer pacer_;
  CaptureState state_ = CaptureState::Waiting;
  std::uint64_t played_ = 0;
  std::string failure_;
};

}  // namespace

std::unique_ptr<CaptureSource> play(FrameSequence sequence, const SourceOptions& options) {
  return std::make_unique<SequenceSource>(std::move(sequence), options);
}

}  // namespace telepalp::capture
