#include "tests/bench/thin/thin_bench.h"

#include <cmath>
#include <utility>
#include <vector>

#include "server/pipeline/capture_thread.h"
#include "tests/bench/thin/color_film.h"
#include "tests/bench/thin/live_rows.h"
#include "tests/bench/thin/recorded_room.h"
#include "tests/bench/thin/voice_rows.h"
#include "tests/bench/thin/window_rows.h"

namespace telepalp::bench {
namespace {

constexpr int kLeastRate_kbit_per_s = 50;
constexpr int kMostRate_kbit_per_s = 20'000;
constexpr int kThinLineQuality = 25;  // JPEG quality that pipeline::shrunk() gives a line without room
constexpr int kSteps = 7;             // of the search for a rate, which is then known to 5 %

/// The video of the lowest rate whose similarity is at least `wanted`; that of the highest rate if there is none.
Result<FilmPrice> video_as_similar(const Film& film, double wanted) {
  double least = kLeastRate_kbit_per_s;
  double most = kMostRate_kbit_per_s;
  Result<FilmPrice> best = as_video(film, kMostRate_kbit_per_s);
  for (int step = 0; step < kSteps; ++step) {
    if (!best) return best;
    const double rate = std::sqrt(least * most);
    Result<FilmPrice> tried = as_video(film, static_cast<int>(rate));
    if (!tried) return tried;
    const bool enough = tried->ssim >= wanted;
    (enough ? most : least) = rate;
    if (enough) best = std::move(tried);
  }
  return best;
}

/// Figures of VP8 against JPEG of one quality.
Result<void> add_rows(Report& report, const Film& film, const std::string& name, int quality) {
  const Result<FilmPrice> pictures = as_pictures(film, quality);
  if (!pictures) return pictures.error();
  const Result<FilmPrice> video = video_as_similar(film, pictures->ssim);
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
  const Result<FilmPrice> video = as_video(film, kbit_per_s);
  if (!video) return video.error();
  const std::string at_rate = name + ", VP8 at " + std::to_string(kbit_per_s) + " kbit/s: ";
  report.rows.push_back(measured(at_rate + "rate at 30 Hz", 8e-3 * Film::kFrames_per_s * video->bytes, "kbit/s"));
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
      "a film of fewer than " + std::to_string(Film::kFrames) +
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
