#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/time.h"
#include "tests/bench/distribution.h"

namespace telepalp::bench {

/// Colour images at 30 Hz.
struct Film {
  static constexpr std::size_t kFrames = 120;
  static constexpr double kFrames_per_s = 30.0;
  std::vector<ColorImage> images;
  std::size_t recorded = 0;  ///< number of different images; the others repeat them
  [[nodiscard]] static SessionTime captured(std::size_t index);
};

/// The first colour images of a server's --source, Film::kFrames of them. A shorter source is run forwards and
/// backwards, so that no jump needs more bytes than a camera's motion does. Error: the source has fewer than two colour
/// images.
[[nodiscard]] Result<Film> film_of(const std::string& spec);

/// Bytes, similarity and times of one coding of a film.
struct FilmPrice {
  double bytes = 0.0;      ///< mean, of an image
  double ssim = 0.0;       ///< mean over each third image
  Distribution encode_ms;  ///< processor time of one thread, as that to decode
  Distribution decode_ms;
};

/// The film as JPEG pictures of `quality`. Error: a picture cannot be decoded.
[[nodiscard]] Result<FilmPrice> as_pictures(const Film& film, int quality);
/// The film as VP8 at a target rate. Error: a frame cannot be decoded.
[[nodiscard]] Result<FilmPrice> as_video(const Film& film, int kbit_per_s);

}  // namespace telepalp::bench
