#pragma once

#include <optional>

#include "proto/wire/key_frame_request.h"

namespace telepalp::pipeline {

/// The encoder of one topic with predicted messages. It exists while a subscriber wants the topic, and its first frame
/// is a key frame. At most every fourth frame becomes a key frame by request. Owner: the capture thread.
template <class Encoder>
class PacedEncoder {
 public:
  void request_key_frame() noexcept { pacing_.requested = true; }
  /// The next frame is a key frame: the last one was not published, or must not be a reference.
  void lost_frame() noexcept {
    if (encoder_) encoder_->request_key_frame();
  }
  /// Frees the encoder, because no subscriber wants the topic, or because its settings change.
  void end() noexcept { encoder_.reset(); }

  /// Encodes the next frame. `settings`: of the encoder, which is made if there is none. `frame`: the arguments of
  /// Encoder::encode().
  template <class Settings, class... Frame>
  [[nodiscard]] auto encode_paced(const Settings& settings, const Frame&... frame) {
    if (!encoder_) encoder_.emplace(settings);
    if (wire::key_frame_is_due(pacing_)) encoder_->request_key_frame();
    auto encoded = encoder_->encode(frame...);
    pacing_ = wire::after_encoding(pacing_, encoded.key_frame);
    return encoded;
  }

 protected:
  [[nodiscard]] std::optional<Encoder>& encoder() noexcept { return encoder_; }

 private:
  std::optional<Encoder> encoder_;
  wire::KeyFramePacing pacing_;
};

}  // namespace telepalp::pipeline
