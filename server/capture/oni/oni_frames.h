#pragma once

#include <fstream>
#include <memory>
#include <string>

#include "server/capture/oni/recording.h"
#include "server/capture/pacing/recorded_frames.h"

namespace telepalp::capture {

/// The frames of an .oni recording: each depth image with the colour image nearest in time, at most 0.2 s apart.
class OniFrames final : public RecordedFrames {
 public:
  /// Error: not an .oni recording, or none of its first ten depth images can be decoded.
  [[nodiscard]] static Result<std::unique_ptr<OniFrames>> open(const std::string& file);

  std::optional<SessionTime> peek() override;
  std::optional<RgbdFrame> take() override;
  void skip() override { ++next_; }
  void rewind() override { next_ = 0; }
  [[nodiscard]] std::string complaint() const override;
  [[nodiscard]] std::string describe() const;

 private:
  OniFrames(std::ifstream stream, std::string file, OniRecording recording);
  [[nodiscard]] Result<void> check_first_images();
  [[nodiscard]] ColorImage color_at(std::chrono::microseconds time);
  void note(const std::string& damage);

  std::ifstream stream_;
  std::string file_;
  OniRecording recording_;
  CameraModel camera_;
  std::size_t next_ = 0;
  std::string first_damage_;  // text about the first image that could not be decoded
};

}  // namespace telepalp::capture
