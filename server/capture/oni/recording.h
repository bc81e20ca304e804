#pragma once

#include <chrono>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// Position of one stored image, compressed or not, in the file.
struct OniImage {
  std::chrono::microseconds time{};  ///< time stamp by the recording's clock
  std::uint64_t at = 0;              ///< file offset of the image's first byte
  std::uint32_t bytes = 0;
};

/// Codec of a stream's images.
enum class OniCodec { Uncompressed, Jpeg, Depth16z, Depth16zTable, Unknown };

struct OniStream {
  OniCodec codec = OniCodec::Unknown;
  int width = 0;
  int height = 0;
  double depth_unit_m = 0.001;       ///< of depth: metres per unit of a sample
  double horizontal_view_rad = 0.0;  ///< horizontal field of view; 0: not stated in the file
  double vertical_view_rad = 0.0;
  bool is_jpeg_or_rgb = true;    ///< of colour: the pixel format is JPEG or 8-bit RGB; others are not decoded
  bool cropped = false;          ///< the images show a part of the sensor; they are not decoded
  std::vector<OniImage> images;  ///< in order of time
};

/// The streams of an .oni file, with a description of unreadable parts.
struct OniRecording {
  OniStream depth;
  OniStream color;        ///< without images when no colour is readable
  std::string complaint;  ///< text about damaged or missing parts; empty when the file is intact
};

/// Reads all records of the file without decoding images. Images around a damaged part are kept, and `complaint`
/// describes the damage. `name`: the file's name, for errors. Error: not an .oni file, or no decodable depth stream.
[[nodiscard]] Result<OniRecording> read_oni_recording(std::istream& file, const std::string& name);

/// Decodes the depth image at `image`. An error states the file offset.
[[nodiscard]] Result<DepthImage> read_oni_depth(std::istream& file, const OniStream& depth, const OniImage& image,
                                                const std::string& name);

}  // namespace telepalp::capture
