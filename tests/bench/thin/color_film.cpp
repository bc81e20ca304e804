#include "tests/bench/thin/color_film.h"

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "codec/color.h"
#include "codec/video.h"
#include "server/capture/capture_source.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/thin/ssim.h"

namespace telepalp::bench {
namespace {

constexpr std::size_t kCompareEvery = 3;  // similarity is measured on each third image

/// Codes each image of `film`. `encode(index)` returns its bytes, and `decode(bytes)` the image.
template <class Encode, class Decode>
Result<FilmPrice> price_of_film(const Film& film, const Encode& encode, const Decode& decode) {
  FilmPrice price;
  double compared = 0.0;
  for (std::size_t i = 0; i < film.images.size(); ++i) {
    const double begun_us = thread_us();
    const std::string bytes = encode(i);
    const double encoded_us = thread_us();
    const Result<ColorImage> back = decode(std::as_bytes(std::span(bytes)));
    price.decode_ms.add(1e-3 * (thread_us() - encoded_us));
    price.encode_ms.add(1e-3 * (encoded_us - begun_us));
    if (!back) return back.error();
    price.bytes += static_cast<double>(bytes.size()) / static_cast<double>(film.images.size());
    if (i % kCompareEvery != 0) continue;
    price.ssim += ssim(film.images[i], *back);
    compared += 1.0;
  }
  price.ssim /= compared;
  return price;
}

}  // namespace

SessionTime Film::captured(std::size_t index) {
  return session_time(static_cast<std::int64_t>(static_cast<double>(index + 1) * 1e9 / kFrames_per_s));
}

Result<Film> film_of(const std::string& spec) {
  Result<std::unique_ptr<capture::CaptureSource>> source =
      capture::open_source(spec, {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = false, .paced = false});
  if (!source) return source.error();
  Film film;
  while (film.images.size() < Film::kFrames) {
    std::optional<RgbdFrame> frame = (*source)->next(std::chrono::milliseconds(100));
    if (!frame && (*source)->state() == capture::CaptureState::Ended) break;
    if (frame && !frame->color.rgb.empty()) film.images.push_back(std::move(frame->color));
  }
  film.recorded = film.images.size();
  if (film.recorded < 2)
    return Error{.what = "the source has no colour images", .where = spec, .fix = "give another --input"};
  const std::size_t period = 2 * (film.recorded - 1);
  while (film.images.size() < Film::kFrames) {
    const std::size_t phase = film.images.size() % period;
    film.images.push_back(film.images[phase < film.recorded ? phase : period - phase]);
  }
  return film;
}

Result<FilmPrice> as_pictures(const Film& film, int quality) {
  return price_of_film(
      film, [&](std::size_t i) { return codec::encode_color(film.images[i], quality); },
      [](std::span<const std::byte> bytes) { return codec::decode_color(bytes); });
}

Result<FilmPrice> as_video(const Film& film, int kbit_per_s) {
  codec::ColorVideoEncoder encoder({.kbit_per_s = kbit_per_s});
  codec::ColorVideoDecoder decoder;
  return price_of_film(
      film, [&](std::size_t i) { return encoder.encode(film.images[i], Film::captured(i)).bytes; },
      [&](std::span<const std::byte> bytes) { return decoder.decode(bytes); });
}

}  // namespace telepalp::bench
