#include "tests/bench/depth_bench.h"

#include <cmath>
#include <ctime>

#include "codec/context_kernel.h"
#include "codec/depth_stream.h"
#include "server/capture/capture_source.h"
#include "server/codec_tool/depth_files.h"
#include "tests/bench/depth_peers.h"
#include "tests/bench/distribution.h"

namespace telepalp::bench {
namespace {

constexpr int kMostFrames = 20;
constexpr int kRounds = 5;          // over the frames, for times that stand above the noise
constexpr double kMostSeconds = 3;  // of one codec

/// CPU time of this thread [ms]: a busy machine does not lengthen it as it does wall time.
double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Result<std::vector<DepthImage>> frames_of(const program::Arguments& arguments) {
  std::vector<DepthImage> frames;
  if (arguments.has("input")) {
    const Result<void> read =
        server::for_each_depth(arguments.text("input"), 0.001, [&](server::NamedDepth named) -> Result<void> {
          if (frames.size() < kMostFrames) frames.push_back(std::move(named.depth));
          return {};
        });
    if (!read) return read.error();
  } else {
    auto source =
        server::open_source("synthetic", {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = true, .paced = false});
    if (!source) return source.error();
    while (frames.size() < kMostFrames)
      if (auto frame = (*source)->next(std::chrono::milliseconds{100})) frames.push_back(std::move(frame->depth));
  }
  if (frames.empty())
    return Error{.what = "holds no depth", .where = arguments.text("input"), .fix = "give depth images"};
  return frames;
}

/// What one codec did with all frames.
struct Measured {
  double bytes = 0.0;
  Distribution encode_ms;
  Distribution decode_ms;
  double worst_mm = 0.0;
  double squares_mm2 = 0.0;
  double measured = 0.0;
  std::size_t flips = 0;
  bool failed = false;

  [[nodiscard]] double rms_mm() const { return measured == 0.0 ? 0.0 : std::sqrt(squares_mm2 / measured); }
};

void compare(const DepthImage& sent, const DepthImage& got, Measured& into) {
  for (std::size_t i = 0; i < sent.samples.size(); ++i) {
    if ((sent.samples[i] == 0) != (got.samples[i] == 0)) ++into.flips;
    if (sent.samples[i] == 0) continue;
    const double error_mm = 1000.0 * sent.unit_m * std::abs(sent.samples[i] - got.samples[i]);
    into.worst_mm = std::max(into.worst_mm, error_mm);
    into.squares_mm2 += error_mm * error_mm;
    ++into.measured;
  }
}

/// `encode` and `decode` are made anew for each round, so that streams begin with a key frame each time.
template <class MakeEncode, class MakeDecode>
Measured measure(const std::vector<DepthImage>& frames, MakeEncode make_encode, MakeDecode make_decode) {
  Measured measured;
  const double begin_ms = cpu_ms();
  for (int round = 0; round < kRounds && cpu_ms() - begin_ms < 1e3 * kMostSeconds; ++round) {
    auto encode = make_encode();
    auto decode = make_decode();
    for (const DepthImage& frame : frames) {
      DepthImage got = frame;
      const double start_ms = cpu_ms();
      const std::string packet = encode(frame);
      const double encoded_ms = cpu_ms();
      measured.failed |= !decode(packet, got);
      measured.encode_ms.add(encoded_ms - start_ms);
      measured.decode_ms.add(cpu_ms() - encoded_ms);
      if (round > 0) continue;
      measured.bytes += static_cast<double>(packet.size());
      compare(frame, got, measured);
    }
  }
  return measured;
}

Measured measure_mode(const std::vector<DepthImage>& frames, codec::DepthMode mode) {
  return measure(
      frames,
      [mode] {
        return [encoder = codec::DepthEncoder({.mode = mode})](const DepthImage& depth) mutable {
          return encoder.encode(depth);
        };
      },
      [] {
        return [decoder = codec::DepthDecoder()](const std::string& packet, DepthImage& depth) mutable {
          Result<DepthImage> got = decoder.decode(std::as_bytes(std::span(packet)));
          if (got) depth = *std::move(got);
          return got.ok();
        };
      });
}

double raw_bytes(const std::vector<DepthImage>& frames) {
  double bytes = 0.0;
  for (const DepthImage& frame : frames) bytes += 2.0 * static_cast<double>(frame.samples.size());
  return bytes;
}

void add_rows(const std::string& name, const Measured& measured, double raw, Report& report) {
  report.rows.push_back(bench::measured(name + ": ratio", raw / measured.bytes, ""));
  report.rows.push_back(bench::measured(name + ": bits per pixel", 16.0 * measured.bytes / raw, ""));
  report.rows.push_back(bench::measured(name + ": encode p50", measured.encode_ms.p50(), "ms"));
  report.rows.push_back(bench::measured(name + ": encode p99", measured.encode_ms.p99(), "ms"));
  report.rows.push_back(bench::measured(name + ": decode p50", measured.decode_ms.p50(), "ms"));
  report.rows.push_back(bench::measured(name + ": decode p99", measured.decode_ms.p99(), "ms"));
  if (measured.failed || measured.flips != 0) report.notes.push_back(name + ": FAILED to give the frames back");
  report.rows.push_back(at_most(name + ": frames given back wrong, holes lost",
                                measured.failed ? 1.0 : static_cast<double>(measured.flips), "", 0.0));
}

}  // namespace

Result<Report> run_depth(const program::Arguments& arguments) {
  const Result<std::vector<DepthImage>> read = frames_of(arguments);
  if (!read) return read.error();
  const std::vector<DepthImage>& frames = *read;
  const double raw = raw_bytes(frames);
  Report report{.bench = "depth", .rows = {}, .notes = {}};
  double zstd_encode_ms = 0.0;
  double zstd_decode_ms = 0.0;
  for (const DepthPeer& peer : depth_peers()) {
    const Measured measured = measure(
        frames, [&] { return std::cref(peer.encode); }, [&] { return std::cref(peer.decode); });
    add_rows(peer.name, measured, raw, report);
    if (peer.name != "zstd-3") continue;
    zstd_encode_ms = measured.encode_ms.p50();
    zstd_decode_ms = measured.decode_ms.p50();
  }
  for (const auto mode :
       {codec::DepthMode::Fast, codec::DepthMode::Intra, codec::DepthMode::Temporal, codec::DepthMode::Bounded}) {
    const Measured measured = measure_mode(frames, mode);
    const std::string name(codec::name(mode));
    add_rows(name, measured, raw, report);
    const double encode = measured.encode_ms.p50() / zstd_encode_ms;
    const double decode = measured.decode_ms.p50() / zstd_decode_ms;
    const bool asked = mode == codec::DepthMode::Intra;
    report.rows.push_back(asked ? at_most(name + ": encode, times zstd-3", encode, "", 1.8)
                                : bench::measured(name + ": encode, times zstd-3", encode, ""));
    report.rows.push_back(asked ? at_most(name + ": decode, times zstd-3", decode, "", 5.0)
                                : bench::measured(name + ": decode, times zstd-3", decode, ""));
    report.rows.push_back(bench::measured(name + ": largest error", measured.worst_mm, "mm"));
    report.rows.push_back(bench::measured(name + ": RMS error", measured.rms_mm(), "mm"));
  }
  report.notes.push_back(
      std::to_string(frames.size()) + " frames of " + std::to_string(frames[0].width) + " x " +
      std::to_string(frames[0].height) + ", one core, CPU time; kernel " +
      (codec::v3_context_kernel() != nullptr ? codec::v3_context_kernel() : &codec::portable_context_kernel())->name);
  if (const std::string missing = missing_depth_peers(); !missing.empty())
    report.notes.push_back("left out, as the build did not find them:" + missing);
  return report;
}

}  // namespace telepalp::bench
