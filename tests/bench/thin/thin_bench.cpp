#include "tests/bench/thin/thin_bench.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "codec/color.h"
#include "codec/video.h"
#include "server/capture/capture_source.h"
#include "server/pipeline/capture_thread.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/thin/live_rows.h"
#include "tests/bench/thin/recorded_room.h"
#include "tests/bench/thin/ssim.h"
#include "tests/bench/thin/voice_rows.h"
#include "tests/bench/thin/window_rows.h"
#include "where.h"

namespace telepalp::bench {
namespace {

constexpr std::size_t kFrames = 120;
constexpr std::size_t kCompareEvery = 3;  // similarity is measured on each third image
constexpr int kLeastRate_kbit_per_s = 50;
constexpr int kMostRate_kbit_per_s = 20'000;
constexpr int kThinLineQuality = 25;  // JPEG quality that pipeline::shrunk() gives a line without room
constexpr int kSteps = 7;             // of the search for a rate, which is then known to 5 %
constexpr double kFrames_per_s = 30.0;

/// Colour images at 30 Hz.
struct Film {
  std::vector<ColorImage> images;
  std::size_t recorded = 0;  ///< number of different images; the others repeat them
  [[nodiscard]] static SessionTime captured(std::size_t index) {
    return session_time(static_cast<std::int64_t>(static_cast<double>(index + 1) * 1e9 / kFrames_per_s));
  }
};

/// The first colour images of a source, kFrames of them. A shorter source is run forwards and backwards, so that no
/// jump needs more bytes than a camera's motion does.
Result<Film> film_of(const std::string& spec) {
  Result<std::unique_ptr<capture::CaptureSource>> source =
      capture::open_source(spec, {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = false, .paced = false});
  if (!source) return source.error();
  Film film;
  while (film.images.size() < kFrames) {
    std::optional<RgbdFrame> frame = (*source)->next(std::chrono::milliseconds(100));
    if (!frame && (*source)->state() == capture::CaptureState::Ended) break;
    if (frame && !frame->color.rgb.empty()) film.images.push_back(std::move(frame->color));
  }
  film.recorded = film.images.size();
  if (film.recorded < 2)
    return Error{.what = "the source has no colour images", .where = spec, .fix = "give another --input"};
  const std::size_t period = 2 * (film.recorded - 1);
  while (film.images.size() < kFrames) {
    const std::size_t phase = film.images.size() % period;
    film.images.push_back(film.images[phase < film.recorded ? phase : period - phase]);
  }
  return film;
}

/// Bytes, similarity and times of one coding of a film.
struct CodedFilm {
  double bytes = 0.0;  ///< mean, of an image
  double ssim = 0.0;   ///< mean
  Distribution encode_ms;
  Distribution decode_ms;
};

/// Codes each image of `film`. `encode(index)` returns its bytes, and `decode(bytes)` the image.
template <class Encode, class Decode>
Result<CodedFilm> coded(const Film& film, const Encode& encode, const Decode& decode) {
  CodedFilm outcome;
  double compared = 0.0;
  for (std::size_t i = 0; i < film.images.size(); ++i) {
    const double begun_us = thread_us();
    const std::string bytes = encode(i);
    const double encoded_us = thread_us();
    const Result<ColorImage> back = decode(std::as_bytes(std::span(bytes)));
    outcome.decode_ms.add(1e-3 * (thread_us() - encoded_us));
    outcome.encode_ms.add(1e-3 * (encoded_us - begun_us));
    if (!back) return back.error();
    outcome.bytes += static_cast<double>(bytes.size()) / static_cast<double>(film.images.size());
    if (i % kCompareEvery != 0) continue;
    outcome.ssim += ssim(film.images[i], *back);
    compared += 1.0;
  }
  outcome.ssim /= compared;
  return outcome;
}

Result<CodedFilm> as_pictures(const Film& film, int quality) {
  return coded(
      film, [&](std::size_t i) { return codec::encode_color(film.images[i], quality); },
      [](std::span<const std::byte> bytes) { return codec::decode_color(bytes); });
}

Result<CodedFilm> as_video(const Film& film, int kbit_per_s) {
  codec::ColorVideoEncoder encoder({.kbit_per_s = kbit_per_s});
  codec::ColorVideoDecoder decoder;
  return coded(
      film, [&](std::size_t i) { return encoder.encode(film.images[i], Film::captured(i)).bytes; },
      [&](std::span<const std::byte> bytes) { return decoder.decode(bytes); });
}

/// The video of the lowest rate whose similarity is at least `wanted`; that of the highest rate if there is none.
Result<CodedFilm> video_as_similar(const Film& film, double wanted) {
  double least = kLeastRate_kbit_per_s;
  double most = kMostRate_kbit_per_s;
  Result<CodedFilm> best = as_video(film, kMostRate_kbit_per_s);
  for (int step = 0; step < kSteps; ++step) {
    if (!best) return best;
    const double rate = std::sqrt(least * most);
    Result<CodedFilm> tried = as_video(film, static_cast<int>(rate));
    if (!tried) return tried;
    const bool enough = tried->ssim >= wanted;
    (enough ? most : least) = rate;
    if (enough) best = std::move(tried);
  }
  return best;
}

/// Figures of VP8 against JPEG of one quality.
Result<void> add_rows(Report& report, const Film& film, const std::string& name, int quality) {
  const Result<CodedFilm> pictures = as_pictures(film, quality);
  if (!pictures) return pictures.error();
  const Result<CodedFilm> video = video_as_similar(film, pictures->ssim);
  if (!video) return video.error();
  const std::string beside = name + ", JPEG " + std::to_string(quality) + ": ";
  const std::string share = beside + "bytes of VP8 at equal SSIM, divided by JPEG's";
  const double ratio = video->bytes / pictures->bytes;
  report.rows.push_back(at_most(share, ratio, "", 0.25));
  const bool as_similar = video->ssim >= pictures->ssim;
  report.rows.push_back(at_least(beside + "VP8 reaches its SSIM (1: yes)", as_similar ? 1.0 : 0.0, "", 1.0));
  report.rows.push_back(measured(beside + "SSIM of JPEG", pictures->ssim, ""));
  report.rows.push_back(measured(beside + "JPEG", 1e-3 * pictures->bytes, "kB an image"));
  report.rows.push_back(measured(beside + "VP8", 1e-3 * video->bytes, "kB an image"));
  report.rows.push_back(at_most(beside + "VP8, encode p50", video->encode_ms.p50(), "ms", 6.0));
  report.rows.push_back(measured(beside + "VP8, encode p99", video->encode_ms.p99(), "ms"));
  report.rows.push_back(measured(beside + "VP8, decode p50", video->decode_ms.p50(), "ms"));
  return {};
}

/// Figures of the rate that the server uses by default.
Result<void> add_default_rows(Report& report, const Film& film, const std::string& name) {
  const int kbit_per_s = pipeline::EncodeOptions{}.video_kbit_per_s;
  const Result<CodedFilm> video = as_video(film, kbit_per_s);
  if (!video) return video.error();
  const std::string at_rate = name + ", VP8 at " + std::to_string(kbit_per_s) + " kbit/s: ";
  report.rows.push_back(measured(at_rate + "rate at 30 Hz", 8e-3 * kFrames_per_s * video->bytes, "kbit/s"));
  report.rows.push_back(measured(at_rate + "SSIM", video->ssim, ""));
  report.rows.push_back(at_most(at_rate + "encode p50", video->encode_ms.p50(), "ms", 6.0));
  return {};
}

Result<void> add_color_rows(Report& report, const std::string& input) {
  std::vector<std::pair<std::string, std::string>> films{{"synthetic patient", "synthetic"},
                                                         {"recorded room", std::string("oni:") + kRoom}};
  if (!input.empty()) films.emplace_back("--input", input);
  for (const auto& [name, spec] : films) {
    const Result<Film> film = film_of(spec);
    if (!film) return film.error();
    const ColorImage& first = film->images.front();
    report.notes.push_back(name + ": " + spec + ", " + std::to_string(film->recorded) + " images of " +
                           std::to_string(first.width) + " x " + std::to_string(first.height));
    const int quality = pipeline::EncodeOptions{}.jpeg_quality;
    for (const int compared : {quality, 60, kThinLineQuality})
      if (const auto added = add_rows(report, *film, name, compared); !added) return added.error();
    if (const auto added = add_default_rows(report, *film, name); !added) return added.error();
  }
  report.notes.emplace_back(
      "a film of fewer than " + std::to_string(kFrames) +
      " images runs forwards and backwards at 30 Hz; the recorded room's images were JPEG before");
  report.notes.emplace_back("SSIM of luma, windows of 8 x 8");
  return {};
}

}  // namespace

Result<Report> run_thin(const program::Arguments& arguments) {
  Report report{.bench = "thin", .rows = {}, .notes = {}};
  const std::string part = arguments.text("part");
  const std::string input = arguments.text("input");
  if (!part.empty() && part != "color" && part != "window" && part != "live" && part != "voice")
    return Error{.what = "'" + part + "' is not a part", .where = "--part", .fix = "give color, window, live or voice"};
  if (part.empty() && !input.empty())
    return Error{.what = "an input belongs to one part of the bench",
                 .where = "--input",
                 .fix = "add --part color or live for a --source of the server, or --part window for sets of depth"};
  const auto has = [&](std::string_view one) { return part.empty() || part == one; };
  if (has("live"))
    if (const auto added = add_live_rows(report, input); !added) return added.error();
  if (has("voice"))
    if (const auto added = add_voice_rows(report); !added) return added.error();
  if (has("color"))
    if (const auto added = add_color_rows(report, input); !added) return added.error();
  if (has("window"))
    if (const auto added = add_window_rows(report, input); !added) return added.error();
  report.notes.emplace_back("times: processor time of one thread");
  return report;
}

}  // namespace telepalp::bench
