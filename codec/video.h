#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/time.h"

namespace telepalp::codec {

/// The name of the video coding in messages: the field `format` of foxglove.CompressedVideo.
inline constexpr const char* kVideoFormat = "vp8";

/// The most pixels of a video frame: 4096 x 2160. It bounds every allocation made for a packet.
inline constexpr std::size_t kMaxVideoPixels = std::size_t{4096} * 2160;

/// The most bytes of a packet that the decoder reads.
inline constexpr std::size_t kMaxVideoPacketBytes = std::size_t{8} << 20;

struct ColorVideoSettings {
  int kbit_per_s = 800;  ///< target rate; single frames may be larger
  int key_every = 60;    ///< length of a group of pictures: frames from one key frame to the next
};

/// One VP8 frame (RFC 6386). To decode it, a decoder needs all frames since the last key frame.
struct EncodedVideo {
  std::string bytes;
  bool key_frame = true;
};

/// Compresses the colour images of one camera in order, as VP8 in real time, on the calling thread alone. Each frame
/// but a key frame is predicted from the one before.
class ColorVideoEncoder {
 public:
  explicit ColorVideoEncoder(const ColorVideoSettings& settings);
  ~ColorVideoEncoder();
  ColorVideoEncoder(ColorVideoEncoder&&) noexcept;
  ColorVideoEncoder& operator=(ColorVideoEncoder&&) noexcept;

  /// True if an image of this size can be encoded: at most kMaxVideoPixels.
  [[nodiscard]] static bool can_encode(const ColorImage& color) noexcept;

  /// `color` must be well formed, not empty, and one that can_encode(). A change of size forces a key frame. The rate
  /// follows from the capture times.
  [[nodiscard]] EncodedVideo encode(const ColorImage& color, SessionTime captured);

  /// Forces the next frame to be a key frame: a receiver joined, or lost a frame.
  void request_key_frame() noexcept;

  /// Sets the target rate from the next frame on.
  void set_rate(int kbit_per_s);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Decodes the frames of one ColorVideoEncoder in order. After a packet that is refused, it refuses all packets until
/// the next key frame, because they are predicted from a frame that is missing. The caller reports a frame that was
/// lost on the way with lose_frame().
class ColorVideoDecoder {
 public:
  ColorVideoDecoder();
  ~ColorVideoDecoder();
  ColorVideoDecoder(ColorVideoDecoder&&) noexcept;
  ColorVideoDecoder& operator=(ColorVideoDecoder&&) noexcept;

  /// Takes in the next frame. Error: the packet is damaged, cut short, too large, or predicted from a missing frame.
  /// The size in a key frame's header is checked before anything is allocated.
  [[nodiscard]] Result<void> take(std::span<const std::byte> packet);

  /// The frame that take() took in last, as RGB. To be called only after a take() without an error.
  [[nodiscard]] ColorImage picture() const;

  /// As take(), then picture().
  [[nodiscard]] Result<ColorImage> decode(std::span<const std::byte> packet);

  /// A frame was lost: refuses all packets until the next key frame.
  void lose_frame() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace telepalp::codec
