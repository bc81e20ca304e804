#include "tests/bench/thin/window_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "codec/depth_stream.h"
#include "proto/words/depth/depth_window.h"
#include "tests/bench/depth/depth_peers.h"
#include "tests/bench/depth/depth_set.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/thin/recorded_room.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using codec::DepthMode;
using codec::WindowGrowth;

constexpr double kShare = 0.15;      // of the image's pixels
constexpr std::size_t kFewest = 15;  // least number of images that are coded; a smaller set is repeated
constexpr std::size_t kMostImages = 30;

struct Growth {
  WindowGrowth growth;
  const char* name;
  double most_bytes;  ///< budget, divided by the bytes of intra
};
constexpr std::array kGrowths{Growth{WindowGrowth::Flat, "bound 2x", 0.55},
                              Growth{WindowGrowth::Growing, "bound 2x to 4x", 0.45}};

/// The window in image `index`. Every three images it moves on among five places, the middle of the image and one
/// towards each corner, because an image is not equally detailed everywhere.
PixelRect window_in(const DepthImage& image, std::size_t index) {
  constexpr std::array<std::array<double, 2>, 5> kPlaces{{{.5, .5}, {.3, .3}, {.7, .7}, {.7, .3}, {.3, .7}}};
  const int width = std::max(1, static_cast<int>(std::lround(std::sqrt(kShare) * image.width)));
  const int fourth = static_cast<int>(std::lround(0.25 * std::sqrt(kShare) * image.height));
  const int height = std::min(image.height, std::max(1, 4 * fourth));  // slices of equal height are decoded fastest
  const auto& [x, y] = kPlaces[index / 3 % kPlaces.size()];
  const int column = std::clamp(static_cast<int>(x * image.width) - width / 2, 0, image.width - width);
  const int row = std::clamp(static_cast<int>(y * image.height) - height / 2, 0, image.height - height);
  return {.column = column, .row = row, .width = width, .height = height};
}

/// Figures of one coding over the images of a set.
struct CodedWindow {
  double bytes = 0.0;
  Distribution encode_us;
  Distribution decode_us;
  double off_in_window = 0.0;  ///< pixels in the window that differ, and all pixels of images that cannot be decoded
  double beyond_bound = 0.0;   ///< pixels outside the window that exceed their bound, and holes lost or added
};

/// Counts the pixels of `back` that differ from `sent` by more than the packet states.
void check(const DepthImage& sent, const codec::DecodedDepth& back, CodedWindow& into) {
  for (int row = 0; row < sent.height; ++row)
    for (int column = 0; column < sent.width; ++column) {
      const int was = sent.at(column, row);
      const int is = back.image.at(column, row);
      const auto bound =
          back.window ? bound_at(*back.window, sent.width, sent.height, column, row) : std::optional<DepthErrorBound>{};
      const double off_m = std::abs(is - was) * sent.unit_m;
      if (!bound && is != was) into.off_in_window += 1.0;
      if (bound && ((is == 0) != (was == 0) || off_m > bound->at(was * sent.unit_m) + 1e-9)) into.beyond_bound += 1.0;
    }
}

/// Times of zstd-3, measured alternately with a coding, so that a slowdown of the machine affects both.
struct Yard {
  const DepthPeer* peer = nullptr;
  Distribution encode_us;
  Distribution decode_us;

  void run(const DepthImage& image) {
    DepthImage got = image;
    const double begun_us = thread_us();
    const std::string packet = peer->encode(image);
    const double encoded_us = thread_us();
    (void)peer->decode(packet, got);
    encode_us.add(encoded_us - begun_us);
    decode_us.add(thread_us() - encoded_us);
  }
};

/// Codes `set` in `mode`; with windows if `growth` names their bounds.
CodedWindow coded(const DepthSet& set, DepthMode mode, std::optional<WindowGrowth> growth, Yard& yard) {
  CodedWindow outcome;
  codec::DepthEncoder encoder({.mode = mode, .key_every = 12});
  codec::DepthReader reader;
  const std::size_t count = std::clamp(set.images.size(), kFewest, kMostImages);
  for (std::size_t i = 0; i < count; ++i) {
    const DepthImage& image = set.images[i % set.images.size()];
    std::optional<DepthWindow> window;
    if (growth) window = codec::window_around(window_in(image, i), *growth);
    yard.run(image);
    const double begun_us = thread_us();
    const codec::EncodedDepth encoded = encoder.encode(image, window);
    const double encoded_us = thread_us();
    const Result<codec::DecodedDepth> back = reader.read(std::as_bytes(std::span(encoded.bytes)));
    outcome.decode_us.add(thread_us() - encoded_us);
    outcome.encode_us.add(encoded_us - begun_us);
    outcome.bytes += static_cast<double>(encoded.bytes.size()) / static_cast<double>(count);
    if (back)
      check(image, *back, outcome);
    else
      outcome.off_in_window += static_cast<double>(image.samples.size());
  }
  return outcome;
}

/// Sums over sets of images, for geometric means.
struct Means {
  std::array<double, kGrowths.size()> log_ratio{};
  int sets = 0;
};

void add_set_rows(Report& report, const std::string& name, const DepthSet& set, const DepthPeer& zstd, bool has_budget,
                  Means& means) {
  Yard intra_yard{.peer = &zstd, .encode_us = {}, .decode_us = {}};
  const double whole = coded(set, DepthMode::Intra, std::nullopt, intra_yard).bytes;
  const auto row = [&](const std::string& what, double value, double most) {
    report.rows.push_back(has_budget ? at_most(what, value, "", most) : measured(what, value, ""));
  };
  report.rows.push_back(measured(name + ": intra, exact everywhere", 1e-3 * whole, "kB an image"));
  for (const DepthMode mode : {DepthMode::Intra, DepthMode::Temporal})
    for (std::size_t i = 0; i < kGrowths.size(); ++i) {
      Yard yard{.peer = &zstd, .encode_us = {}, .decode_us = {}};
      const CodedWindow part = coded(set, mode, kGrowths[i].growth, yard);
      const std::string window = name + ", window of 15 %, " + std::string(codec::name(mode)) + ", " + kGrowths[i].name;
      report.rows.push_back(measured(window + ": bytes, divided by intra's", part.bytes / whole, ""));
      report.rows.push_back(at_most(window + ": pixels that are not exact in the window", part.off_in_window, "", 0.0));
      report.rows.push_back(at_most(window + ": pixels beyond the stated bound", part.beyond_bound, "", 0.0));
      row(window + ": time to encode, divided by that of zstd-3", part.encode_us.p50() / yard.encode_us.p50(), 2.7);
      row(window + ": time to decode, divided by that of zstd-3", part.decode_us.p50() / yard.decode_us.p50(), 6.0);
      if (mode == DepthMode::Intra) means.log_ratio[i] += std::log(part.bytes / whole);
    }
  ++means.sets;
}

}  // namespace

Result<void> add_window_rows(Report& report, const std::string& inputs) {
  const std::vector<DepthPeer> peers = depth_peers();
  const auto zstd =
      std::find_if(peers.begin(), peers.end(), [](const DepthPeer& peer) { return peer.name == "zstd-3"; });
  Means kinects;
  for (const std::string& input : inputs.empty() ? std::vector<std::string>{kRoom, ""} : names_in(inputs)) {
    const Result<DepthSet> set = depth_set_of(input);
    if (!set) return set.error();
    const std::string name = input.empty() ? "synthetic patient" : std::filesystem::path(input).filename().string();
    const bool has_budget = is_kinects(set->images.front());
    Means others;
    add_set_rows(report, name, *set, *zstd, has_budget, has_budget ? kinects : others);
  }
  for (std::size_t i = 0; i < kGrowths.size() && kinects.sets > 0; ++i)
    report.rows.push_back(at_most("window of 15 %, intra, " + std::string(kGrowths[i].name) +
                                      ": bytes, divided by intra's, geometric mean of the Kinect's sets",
                                  std::exp(kinects.log_ratio[i] / kinects.sets), "", kGrowths[i].most_bytes));
  report.notes.push_back(
      "window: every three images it moves between the middle and four places towards the corners; " +
      std::to_string(kinects.sets) + " sets of a Kinect v1");
  return {};
}

}  // namespace telepalp::bench
