#include <array>
#include <optional>
#include <string>
#include <utility>

#include "codec/depth.h"
#include "server/pipeline/capture_thread.h"
#include "support/program/files/shipped.h"
#include "tests/bench/accuracy/accuracy_depth.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/thin/color_film.h"

namespace telepalp::bench {
namespace {

using codec::DepthMode;
using codec::WindowGrowth;

struct Shape {
  double share;  ///< of the image's pixels
  WindowGrowth growth;
  const char* bound;
};
constexpr std::array kShapes{
    Shape{0.30, WindowGrowth::Flat, "2 times the default bound"}, Shape{0.15, WindowGrowth::Flat, "2 times"},
    Shape{0.15, WindowGrowth::Growing, "2 to 4 times"}, Shape{0.07, WindowGrowth::Growing, "2 to 4 times"}};

/// The shares of a core that encoding and decoding at 30 Hz need [%].
std::string shares(double encode_ms, double decode_ms) {
  return cell(0.1 * encode_ms * Film::kFrames_per_s) + " / " + cell(0.1 * decode_ms * Film::kFrames_per_s);
}

Result<std::string> window_table(const DepthSequence& sequence, std::vector<Row>& rows) {
  PageTable table{.head = {"exact in", "bound outside", "Mbit/s at 30 Hz", "bytes, of all exact",
                           "depth error outside mm, RMS / max", "force error in the window mN, max",
                           "places that can be touched", "encode / decode, % of a core"},
                  .rows = {}};
  const Result<DepthPrice> whole = price_of(sequence, DepthMode::Intra, {});
  if (!whole) return whole.error();
  const auto add = [&](const std::string& exact, const std::string& bound, const DepthPrice& price) {
    const double pixels = static_cast<double>(sequence.frames.front().samples.size());
    table.rows.push_back({exact, bound, cell(1e-6 * price.bits_per_pixel * pixels * Film::kFrames_per_s),
                          cell(price.bits_per_pixel / whole->bits_per_pixel),
                          cell(price.rms_mm) + " / " + cell(price.worst_mm), cell(1e3 * price.force_max_N),
                          std::to_string(price.places), shares(price.encode_p50_ms, price.decode_p50_ms)});
  };
  add("the whole image (`intra`)", "–", *whole);
  for (const Shape& shape : kShapes) {
    const DepthWindow window = codec::window_around(rect_of_the_hand(sequence, shape.share), shape.growth);
    const Result<DepthPrice> price = price_of(sequence, DepthMode::Intra, {}, window);
    if (!price) return price.error();
    const std::string share = cell(100.0 * shape.share) + " % of the image";
    add(share, shape.bound, *price);
    const std::string name = sequence.name + ", window of " + share + ", bound " + shape.bound;
    rows.push_back(measured(name + ": bytes, divided by intra's", price->bits_per_pixel / whole->bits_per_pixel, ""));
    rows.push_back(at_most(name + ": force error in the window, max", price->force_max_N, "N", 0.0));
    rows.push_back(at_least(name + ": places pressed", price->places, "", 1.0));
  }
  return to_markdown(table);
}

Result<std::string> video_table(const std::string& name, const std::string& spec, std::vector<Row>& rows) {
  const Result<Film> film = film_of(spec);
  if (!film) return film.error();
  PageTable table{.head = {"colour", "kB an image", "Mbit/s at 30 Hz", "SSIM", "encode / decode, % of a core"},
                  .rows = {}};
  const auto add = [&](const std::string& coding, const FilmPrice& price) {
    table.rows.push_back({coding, cell(1e-3 * price.bytes), cell(8e-6 * price.bytes * Film::kFrames_per_s),
                          cell(price.ssim), shares(price.encode_ms.p50(), price.decode_ms.p50())});
    rows.push_back(measured(name + ", " + coding + ": SSIM", price.ssim, ""));
    rows.push_back(measured(name + ", " + coding + ": bytes", 1e-3 * price.bytes, "kB an image"));
  };
  const pipeline::EncodeOptions usual;
  for (const int quality : {usual.jpeg_quality, 60, 25}) {
    const Result<FilmPrice> price = as_pictures(*film, quality);
    if (!price) return price.error();
    add("JPEG " + std::to_string(quality) + (quality == usual.jpeg_quality ? " (default)" : ""), *price);
  }
  for (const int kbit_per_s : {3200, 1600, usual.video_kbit_per_s, 400, 200}) {
    const Result<FilmPrice> price = as_video(*film, kbit_per_s);
    if (!price) return price.error();
    add("VP8, " + std::to_string(kbit_per_s) + " kbit/s" + (kbit_per_s == usual.video_kbit_per_s ? " (default)" : ""),
        *price);
  }
  return to_markdown(table);
}

}  // namespace

Result<Section> thin_section() {
  const auto sequences = depth_sequences();
  if (!sequences) return sequences.error();
  Section section;
  std::string windows, videos;
  for (const DepthSequence& sequence : *sequences) {
    const Result<std::string> table = window_table(sequence, section.rows);
    if (!table) return table.error();
    windows += (windows.empty() ? "**" : "\n**") + sequence.name + "**:\n\n" + *table;
  }
  const auto room = program::shipped_file("deploy/demo_data/oni/3dj_test.oni");
  const std::vector<std::pair<std::string, std::string>> films{{"recorded room", "oni:" + (room ? room->string() : "")},
                                                               {"synthetic patient", "synthetic"}};
  for (const auto& [name, spec] : films) {
    const Result<std::string> table = video_table(name, spec, section.rows);
    if (!table) return table.error();
    videos += (videos.empty() ? "**" : "\n**") + name + "**:\n\n" + *table;
  }
  section.parts = {{"window", windows}, {"video", videos}};
  return section;
}

}  // namespace telepalp::bench
