#pragma once

#include <chrono>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// Where one compressed image lies in the file.
struct OniImage {
  std::chrono::microseconds time{};  ///< of the recording's own clock
  std::uint64_t at = 0;
  std::uint32_t bytes = 0;
};

/// How OpenNI compressed a stream's images.
enum class OniCodec { Uncompressed, Jpeg, Depth16z, Depth16zTable, Unknown };

struct OniStream {
  OniCodec codec = OniCodec::Unknown;
  int width = 0;
  int height = 0;
  double depth_unit_m = 0.001;
  double horizontal_view_rad = 0.0;  ///< 0: the file does not say
  double vertical_view_rad = 0.0;
  bool is_jpeg_or_rgb = true;  ///< of a colour stream
  bool cropped = false;
  std::vector<OniImage> images;  ///< by time
};

/// What an .oni file holds, and what of it cannot be read.
struct OniRecording {
  OniStream depth;
  OniStream color;        ///< without images when there is none that can be read
  std::string complaint;  ///< for people: what is damaged or missing, and where; empty when the file is whole
};

/// Reads the whole file's records, but not its images. Damage between images leaves the images that can be found, and a
/// complaint; a file without a depth image that could be decoded is an error.
[[nodiscard]] Result<OniRecording> read_oni_recording(std::istream& file, const std::string& name);

/// The depth image at `image`, decoded; an error names the byte where it lies.
[[nodiscard]] Result<DepthImage> read_oni_depth(std::istream& file, const OniStream& depth, const OniImage& image,
                                                const std::string& name);

}  // namespace telepalp::server
