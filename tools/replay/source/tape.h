#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "codec/depth_stream.h"
#include "proto/words/result.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "tools/replay/scenario/scenario.h"
#include "tools/replay/scenario/stopwatch.h"
#include "tools/replay/source/content_digest.h"

namespace telepalp::replay {

/// One frame of the source. All runs share it, so that it is read, encoded and decoded once.
struct TapeFrame {
  std::uint32_t number = 0;  ///< from 0
  RgbdFrame frame;           ///< without colour; `captured` is in the replay's session time
  std::string depth;         ///< a serialised msg::DepthImage; empty: each run encodes the frame itself
  std::string color;         ///< a serialised foxglove::CompressedImage; empty: no colour
};
using TapeFrames = std::vector<std::shared_ptr<const TapeFrame>>;  // shared: frames are in flight in many runs

/// The true surface at an instant of the replay's session time.
using TruthAt = std::function<capture::TrueSurface(SessionTime)>;

struct TapeSettings {
  codec::DepthStreamSettings depth{.mode = codec::DepthMode::Fast, .key_every = 12};  ///< as the server's default
  bool color = true;
  bool repeat = false;  ///< a recording begins anew at its end
  int jpeg_quality = 85;
  Nanoseconds encode_time = StageTimes{}.encode;
  CostClock clock = no_clock;
};

/// The images that a tape has read.
struct ImageFacts {
  std::uint64_t frames = 0;
  Intrinsics camera{};         ///< of depth, at the first frame
  std::uint64_t measured = 0;  ///< pixels with a depth
  double depth_sum_m = 0.0;    ///< of these pixels
  ContentDigest depth{};       ///< of all depth samples, in order
  std::string damage{};        ///< capture::CaptureSource::complaint(); empty: each part of the source was readable

  [[nodiscard]] double mean_depth_m() const noexcept {
    return measured > 0 ? depth_sum_m / static_cast<double>(measured) : std::numeric_limits<double>::quiet_NaN();
  }
};

/// The frames of a source in the replay's session time. read_until() reads them piece by piece, so that memory does
/// not grow with the source's length.
class Tape {
 public:
  /// `source`: a *.mcap, *.oni or *.pcd file, or what `--source` of the server names: oni:FILE, images:DIR, pcd:FILE,
  /// session:FILE, synthetic[:MODEL,key=value…]. Error: it cannot be opened, or is a live camera.
  [[nodiscard]] static Result<Tape> open(const std::string& source, const TapeSettings& settings);
  ~Tape();
  Tape(Tape&&) noexcept;
  Tape& operator=(Tape&&) noexcept;

  /// The frames that were captured before `until` and not returned yet. Error: decoding a losslessly encoded frame
  /// does not give the original depth.
  [[nodiscard]] Result<TapeFrames> read_until(SessionTime until);
  /// True when no frame follows.
  [[nodiscard]] bool ended() const noexcept;

  /// The true surface of a synthetic source; empty for a recording.
  [[nodiscard]] const TruthAt& truth() const noexcept;
  /// False in the modes with predicted frames: each run encodes for itself, because its losses decide which frames are
  /// key frames.
  [[nodiscard]] bool is_encoded() const noexcept;
  [[nodiscard]] const TapeSettings& settings() const noexcept;
  [[nodiscard]] const Stopwatch& costs() const noexcept;
  [[nodiscard]] const ImageFacts& images() const noexcept;

 private:
  struct State;
  explicit Tape(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// `source` with the kind that a file's ending tells: "session:a.mcap" for "a.mcap".
[[nodiscard]] std::string with_kind(const std::string& source);

/// The file of a recorded session that `source` names; empty for any other source.
[[nodiscard]] std::string session_file_of(const std::string& source);

}  // namespace telepalp::replay
