#include "tests/bench/depth/depth_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "codec/context/kernel.h"
#include "codec/depth_stream.h"
#include "tests/bench/depth/depth_asked.h"
#include "tests/bench/depth/depth_peers.h"
#include "tests/bench/depth/depth_set.h"
#include "tests/bench/distribution.h"

namespace telepalp::bench {
namespace {

constexpr std::size_t kFrameTimes = 60;  // least number of measured frames per codec; small sets are repeated
constexpr double kMostSeconds = 3;       // of one codec

/// CPU time of this thread [ms]. Other programs lengthen it less than wall time.
double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Results of one codec over all frames.
struct Measured {
  double bytes = 0.0;
  Distribution encode_ms;
  Distribution decode_ms;
  Distribution yard_encode_ms;  // times of zstd-3, measured alternately, if the codec is compared with it
  Distribution yard_decode_ms;
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

/// Encodes and decodes one frame; false if the result differs.
template <class Encode, class Decode>
bool time_both(const DepthImage& frame, Encode& encode, Decode& decode, Distribution& encode_ms,
               Distribution& decode_ms, std::string& packet, DepthImage& got) {
  const double start_ms = cpu_ms();
  packet = encode(frame);
  const double encoded_ms = cpu_ms();
  const bool came_back = decode(packet, got);
  encode_ms.add(encoded_ms - start_ms);
  decode_ms.add(cpu_ms() - encoded_ms);
  return came_back;
}

/// `encode` and `decode` are created for each round, so that each stream begins with a key frame. `yard` is measured
/// alternately with them, frame by frame, so that a temporary slowdown of the machine affects both.
template <class MakeEncode, class MakeDecode>
Measured measure(const std::vector<DepthImage>& frames, MakeEncode make_encode, MakeDecode make_decode,
                 const DepthPeer* yard = nullptr) {
  Measured measured;
  const double begin_ms = cpu_ms();
  const std::size_t rounds = (kFrameTimes + frames.size() - 1) / frames.size();
  for (std::size_t round = 0; round < rounds && cpu_ms() - begin_ms < 1e3 * kMostSeconds; ++round) {
    auto encode = make_encode();
    auto decode = make_decode();
    for (const DepthImage& frame : frames) {
      DepthImage got = frame;
      std::string packet;
      if (yard != nullptr)
        measured.failed |= !time_both(frame, yard->encode, yard->decode, measured.yard_encode_ms,
                                      measured.yard_decode_ms, packet, got);
      measured.failed |= !time_both(frame, encode, decode, measured.encode_ms, measured.decode_ms, packet, got);
      if (round > 0) continue;
      measured.bytes += static_cast<double>(packet.size());
      compare(frame, got, measured);
    }
  }
  return measured;
}

Measured measure_mode(const std::vector<DepthImage>& frames, codec::DepthMode mode, const DepthPeer* yard = nullptr) {
  return measure(
      frames,
      [mode] {
        return [encoder = codec::DepthEncoder({.mode = mode})](const DepthImage& depth) mutable {
          return encoder.encode(depth).bytes;
        };
      },
      [] {
        return [decoder = codec::DepthDecoder()](const std::string& packet, DepthImage& depth) mutable {
          Result<DepthImage> got = decoder.decode(std::as_bytes(std::span(packet)));
          if (got) depth = *std::move(got);
          return got.ok();
        };
      },
      yard);
}

void add_rows(const std::string& name, const Measured& measured, double raw, double ratio_asked, Report& report) {
  const std::string ratio = name + ": compression ratio";
  report.rows.push_back(ratio_asked > 0.0 ? at_least(ratio, raw / measured.bytes, "", ratio_asked)
                                          : bench::measured(ratio, raw / measured.bytes, ""));
  report.rows.push_back(bench::measured(name + ": bits per pixel", 16.0 * measured.bytes / raw, ""));
  report.rows.push_back(bench::measured(name + ": time to encode a frame, p50", measured.encode_ms.p50(), "ms"));
  report.rows.push_back(bench::measured(name + ": time to encode a frame, p99", measured.encode_ms.p99(), "ms"));
  report.rows.push_back(bench::measured(name + ": time to decode a frame, p50", measured.decode_ms.p50(), "ms"));
  report.rows.push_back(bench::measured(name + ": time to decode a frame, p99", measured.decode_ms.p99(), "ms"));
  if (measured.failed || measured.flips != 0) report.notes.push_back(name + ": FAILED to restore the frames");
  report.rows.push_back(at_most(name + ": holes lost or added, in pixels (1 if decoding failed)",
                                measured.failed ? 1.0 : static_cast<double>(measured.flips), "", 0.0));
}

/// Budgets in multiples of zstd-3, so that they hold on any machine: 1 ms of encoding for 1.11 ms of zstd-3's is what
/// "2.0 ms, or 1.8 times" asks of `intra`, and 1 ms of decoding for 0.5 ms what "2.5 ms, or 5 times" does.
struct TimesAsked {
  double encode, decode;
};

TimesAsked times_asked(codec::DepthMode mode) {
  constexpr double kEncodeOf1ms = 1.8 / 2.0;
  constexpr double kDecodeOf1ms = 5.0 / 2.5;
  switch (mode) {
    case codec::DepthMode::Fast:
      return {1.0 * kEncodeOf1ms, 0.8 * kDecodeOf1ms};
    case codec::DepthMode::Intra:
      return {1.8, 5.0};
    case codec::DepthMode::Temporal:
      return {2.5 * kEncodeOf1ms, 3.0 * kDecodeOf1ms};
    case codec::DepthMode::Bounded:
      return {3.0 * kEncodeOf1ms, 3.0 * kDecodeOf1ms};
  }
  return {0.0, 0.0};
}

constexpr std::array kModes{codec::DepthMode::Fast, codec::DepthMode::Intra, codec::DepthMode::Temporal,
                            codec::DepthMode::Bounded};

/// The geometric mean of each mode's ratio over several sets of Kinect frames that were not used for training.
Result<void> add_held_out(const std::string& sets, Report& report) {
  std::array<double, kModes.size()> log_ratio{};
  int count = 0;
  for (const std::string& name : names_in(sets)) {
    const Result<DepthSet> frames = depth_set_of(name);
    if (!frames) return frames.error();
    ++count;
    for (std::size_t i = 0; i < kModes.size(); ++i)
      log_ratio[i] += std::log(raw_bytes(frames->images) / measure_mode(frames->images, kModes[i]).bytes);
  }
  constexpr std::array kAsked{14.0, 19.0, 22.0, 45.0};
  for (std::size_t i = 0; i < kModes.size(); ++i)
    report.rows.push_back(
        at_least(std::string(codec::name(kModes[i])) + ": compression ratio, geometric mean of the held-out recordings",
                 std::exp(log_ratio[i] / count), "", kAsked[i]));
  return {};
}

}  // namespace

Result<Report> run_depth(const program::Arguments& arguments) {
  // Further recordings, after a comma, are those on which the codec's tables were not trained.
  const std::string inputs = arguments.text("input");
  const std::string first = inputs.substr(0, inputs.find(','));
  const Result<DepthSet> read = depth_set_of(first);
  if (!read) return read.error();
  const std::vector<DepthImage>& frames = read->images;
  const RatiosAsked* asked_ratios = ratios_asked(frames.front());
  const double raw = raw_bytes(frames);
  Report report{.bench = "depth", .rows = {}, .notes = {}};
  const bool kinects = is_kinects(frames.front());
  const std::vector<DepthPeer> peers = depth_peers();
  const DepthPeer* yard = nullptr;
  for (const DepthPeer& peer : peers) {
    const Measured measured = measure(
        frames, [&] { return std::cref(peer.encode); }, [&] { return std::cref(peer.decode); });
    add_rows(peer.name, measured, raw, 0.0, report);
    if (peer.name == "zstd-3") yard = &peer;
  }
  for (const codec::DepthMode mode : kModes) {
    const Measured measured = measure_mode(frames, mode, yard);
    const std::string name(codec::name(mode));
    const double ratio = asked_ratios == nullptr ? 0.0 : asked_ratios->of_modes[static_cast<std::size_t>(mode)];
    add_rows(name, measured, raw, ratio, report);
    const double encode = measured.encode_ms.p50() / measured.yard_encode_ms.p50();
    const double decode = measured.decode_ms.p50() / measured.yard_decode_ms.p50();
    const TimesAsked asked = times_asked(mode);
    const auto times = [&](const std::string& what, double value, double most) {
      const std::string row = name + ": time to " + what + ", divided by that of zstd-3";
      report.rows.push_back(kinects ? at_most(row, value, "", most) : bench::measured(row, value, ""));
    };
    times("encode", encode, asked.encode);
    times("decode", decode, asked.decode);
    report.rows.push_back(bench::measured(name + ": largest depth error", measured.worst_mm, "mm"));
    report.rows.push_back(bench::measured(name + ": depth error RMS", measured.rms_mm(), "mm"));
  }
  if (first.size() < inputs.size())
    if (const Result<void> added = add_held_out(inputs.substr(first.size() + 1), report); !added) return added.error();
  if (!kinects) report.notes.push_back("the times have no budget, because the frames are not a Kinect's");
  report.notes.push_back(
      asked_ratios == nullptr
          ? "the ratios have no budget, because these frames are unknown; CRC-32C of the first frame: " +
                std::to_string(set_mark(frames.front()))
          : "the budgets of the ratios are those for " + std::string(asked_ratios->set));
  if (read->left_out > 0)
    report.notes.push_back(std::to_string(read->left_out) +
                           " more frames are left out: the other frames fill the limit of 1 GiB");
  report.notes.push_back(
      std::to_string(frames.size()) + " frames of " + std::to_string(frames[0].width) + " x " +
      std::to_string(frames[0].height) + "; processor time on one core; code path " +
      (codec::v3_context_kernel() != nullptr ? codec::v3_context_kernel() : &codec::portable_context_kernel())->name);
  if (const std::string missing = missing_depth_peers(); !missing.empty())
    report.notes.push_back("codecs left out, because the build did not find them:" + missing);
  return report;
}

}  // namespace telepalp::bench
