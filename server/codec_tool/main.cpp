// telepalp-codec: compresses depth recordings, gives them back, and says what that cost.

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "proto/program/options.h"
#include "proto/wire/mcap/reader.h"
#include "server/capture/images/image_file.h"
#include "server/codec_tool/depth_files.h"
#include "server/codec_tool/pgm.h"

namespace {

using namespace telepalp;
namespace fs = std::filesystem;

constexpr std::string_view kProgram = "telepalp-codec";
constexpr Nanoseconds kAssumedPeriod{33'333'333};  // of images that do not say when they were taken

program::Usage usage() {
  return {
      .program = kProgram,
      .purpose = "compresses depth recordings (encode), gives them back (decode), describes (info), compares",
      .positional = "encode IN OUT.mcap | decode IN.mcap OUT_DIR | info IN.mcap | compare A B",
      .options = {{"mode", "MODE", "fast, intra, temporal (all without loss) or bounded", "temporal"},
                  {"key-every", "N", "frames from key frame to key frame, temporal and bounded", "30"},
                  {"unit-mm", "MM", "one step of a sample, where images do not say", "1"},
                  {"bound-mm", "MM", "bounded: error that is always allowed", "1"},
                  {"bound-per-z2", "MM", "bounded: error allowed at 1 m, growing with the square of depth", "2.85"},
                  {"to", "KIND", "decode: png or pgm, 16 bits a sample", "png"}},
      .example = "telepalp-codec encode recording.oni depth.mcap && telepalp-codec compare recording.oni depth.mcap"};
}

/// One line on a terminal that says how far the work is; nothing where stderr is a file.
class Progress {
 public:
  explicit Progress(std::size_t total) : total_(total), shown_(isatty(STDERR_FILENO) == 1) {}
  ~Progress() {
    if (shown_ && done_ > 0) std::fputc('\n', stderr);
  }
  void step() {
    ++done_;
    if (!shown_) return;
    constexpr std::size_t kWidth = 40;
    const std::size_t filled = total_ == 0 ? 0 : std::min(kWidth, kWidth * done_ / total_);
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r[%s] %zu%s", bar.c_str(), done_,
                 total_ == 0 ? " frames" : (" of " + std::to_string(total_)).c_str());
  }

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool shown_;
};

Result<codec::DepthStreamSettings> settings_of(const program::Arguments& arguments) {
  const std::optional<codec::DepthMode> mode = codec::depth_mode(arguments.text("mode"));
  if (!mode)
    return Error{.what = "'" + arguments.text("mode") + "' is no depth mode", .where = "--mode", .fix = "see --help"};
  const Result<std::int64_t> key_every = arguments.whole("key-every", 1, 65535);
  if (!key_every) return key_every.error();
  const Result<double> bound = arguments.number("bound-mm", 0.0, 1000.0);
  if (!bound) return bound.error();
  const Result<double> growth = arguments.number("bound-per-z2", 0.0, 1000.0);
  if (!growth) return growth.error();
  return codec::DepthStreamSettings{.mode = *mode,
                                    .key_every = static_cast<int>(*key_every),
                                    .bound = {.least_m = *bound / 1000.0, .per_m = *growth / 1000.0}};
}

Result<double> unit_of(const program::Arguments& arguments) {
  const Result<double> unit_mm = arguments.number("unit-mm", 1e-4, 1000.0);
  if (!unit_mm) return unit_mm.error();
  return *unit_mm / 1000.0;
}

void print_ratio(std::size_t frames, double raw_bytes, double bytes, double pixels) {
  std::printf("%zu frames, %.0f B of samples in %.0f B: ratio %.2f, %.3f bits per pixel\n", frames, raw_bytes, bytes,
              raw_bytes / bytes, 8.0 * bytes / pixels);
}

Result<void> encode(const fs::path& input, const fs::path& output, const program::Arguments& arguments) {
  const Result<codec::DepthStreamSettings> settings = settings_of(arguments);
  if (!settings) return settings.error();
  const Result<double> unit_m = unit_of(arguments);
  if (!unit_m) return unit_m.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(
      output, {.program = std::string(kProgram), .version = {}, .commit = {}, .source = input.string(), .scene = {}});
  if (!writer) return writer.error();
  codec::DepthEncoder encoder(*settings);
  Progress progress(server::count_depth_files(input));
  std::size_t frames = 0;
  double raw_bytes = 0.0;
  double bytes = 0.0;
  Result<void> done = server::for_each_depth(input, *unit_m, [&](server::NamedDepth named) -> Result<void> {
    const SessionTime captured = named.captured == SessionTime{}
                                     ? SessionTime{kAssumedPeriod * static_cast<std::int64_t>(frames)}
                                     : named.captured;
    msg::DepthImage image;
    image.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
    image.set_sequence(++frames);
    image.set_frame_id("camera_depth");
    image.set_width(static_cast<std::uint32_t>(named.depth.width));
    image.set_height(static_cast<std::uint32_t>(named.depth.height));
    image.set_unit_m(named.depth.unit_m);
    image.set_format(std::string(codec::name(settings->mode)));
    image.set_data(encoder.encode(named.depth));
    raw_bytes += 2.0 * static_cast<double>(named.depth.samples.size());
    bytes += static_cast<double>(image.data().size());
    progress.step();
    return writer->write(wire::make_message(wire::kCameraDepth, captured, image));
  });
  if (done && frames == 0)
    done = Error{.what = "holds no depth image", .where = input.string(), .fix = "give 16-bit images"};
  if (!done) {
    writer->discard();
    return done;
  }
  done = writer->close();
  if (done) print_ratio(frames, raw_bytes, bytes, raw_bytes / 2.0);
  return done;
}

Result<void> decode(const fs::path& input, const fs::path& folder, const program::Arguments& arguments) {
  const std::string kind = arguments.text("to");
  if (kind != "png" && kind != "pgm")
    return Error{.what = "'" + kind + "' is neither png nor pgm", .where = "--to", .fix = "say png or pgm"};
  std::error_code code;
  fs::create_directories(folder, code);
  if (code)
    return Error{.what = "cannot be made: " + code.message(), .where = folder.string(), .fix = "choose another"};
  Progress progress(0);
  std::size_t frames = 0;
  const Result<void> done = server::for_each_depth(input, 0.001, [&](server::NamedDepth named) -> Result<void> {
    char name[32];
    std::snprintf(name, sizeof name, "%06zu.%s", frames++, kind.c_str());
    const server::GrayImage16 image{named.depth.width, named.depth.height, std::move(named.depth.samples)};
    progress.step();
    return server::write_file(folder / name, kind == "png" ? server::encode_png(image) : server::encode_pgm(image));
  });
  if (done) std::printf("%zu frames in %s\n", frames, folder.c_str());
  return done;
}

Result<void> info(const fs::path& input) {
  Result<wire::McapReader> reader = wire::McapReader::open(input);
  if (!reader) return reader.error();
  reader->select({.topics = {std::string(wire::kCameraDepth.name)}});
  std::size_t frames = 0;
  double raw_bytes = 0.0;
  double bytes = 0.0;
  while (true) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    msg::DepthImage image;
    const bool parsed = image.ParseFromString(*(*message)->payload);
    const Result<codec::DepthPacketInfo> packet = codec::inspect_depth(std::as_bytes(std::span(image.data())));
    if (!parsed || !packet)
      return packet ? Error{.what = "a message is no DepthImage", .where = input.string(), .fix = {}} : packet.error();
    std::printf("%6zu  %-8s %-10s %d x %d  unit %g mm  %d slices  %s  %zu B  ratio %.2f\n", frames,
                std::string(codec::name(packet->mode)).c_str(), std::string(packet->coding).c_str(), packet->width,
                packet->height, 1000.0 * packet->unit_m, packet->slices,
                packet->since_key == 0 ? "key" : ("key+" + std::to_string(packet->since_key)).c_str(),
                image.data().size(), 2.0 * packet->width * packet->height / static_cast<double>(image.data().size()));
    ++frames;
    raw_bytes += 2.0 * packet->width * packet->height;
    bytes += static_cast<double>(image.data().size());
  }
  if (frames == 0) return Error{.what = "holds no depth", .where = input.string(), .fix = "give a session file"};
  print_ratio(frames, raw_bytes, bytes, raw_bytes / 2.0);
  return {};
}

Result<void> compare(const fs::path& first, const fs::path& second, const program::Arguments& arguments) {
  const Result<double> unit_m = unit_of(arguments);
  if (!unit_m) return unit_m.error();
  std::vector<DepthImage> frames;
  const Result<void> read = server::for_each_depth(first, *unit_m, [&](server::NamedDepth named) -> Result<void> {
    frames.push_back(std::move(named.depth));
    return {};
  });
  if (!read) return read;
  std::size_t at = 0;
  std::size_t flips = 0;
  std::size_t measured = 0;
  double worst_mm = 0.0;
  double squares_mm2 = 0.0;
  const Result<void> done = server::for_each_depth(second, *unit_m, [&](server::NamedDepth named) -> Result<void> {
    const std::string where = second.string() + " frame " + std::to_string(at);
    if (at == frames.size()) return Error{.what = "has more frames than the first", .where = where, .fix = {}};
    const DepthImage& a = frames[at++];
    const DepthImage& b = named.depth;
    if (a.width != b.width || a.height != b.height)
      return Error{.what = "is of another size", .where = where, .fix = {}};
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
      if ((a.samples[i] == 0) != (b.samples[i] == 0)) ++flips;
      if (a.samples[i] == 0 || b.samples[i] == 0) continue;
      const double error_mm = 1000.0 * std::abs(a.samples[i] * a.unit_m - b.samples[i] * b.unit_m);
      worst_mm = std::max(worst_mm, error_mm);
      squares_mm2 += error_mm * error_mm;
      ++measured;
    }
    return {};
  });
  if (!done) return done;
  if (at != frames.size())
    return Error{.what = "has " + std::to_string(at) + " frames, the first " + std::to_string(frames.size()),
                 .where = second.string(),
                 .fix = {}};
  const double rms_mm = measured == 0 ? 0.0 : std::sqrt(squares_mm2 / static_cast<double>(measured));
  std::printf("%zu frames: max error %.3f mm, RMS %.3f mm, %zu validity flips\n", at, worst_mm, rms_mm, flips);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const Result<std::optional<program::Arguments>> read = program::read_arguments(usage(), argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  const program::Arguments& arguments = **read;
  const std::vector<std::string>& words = arguments.positional();
  const std::string verb = words.empty() ? "" : words.front();
  const std::size_t wanted = verb == "info" ? 2 : 3;
  if (verb != "encode" && verb != "decode" && verb != "info" && verb != "compare")
    return program::fail({.what = "'" + verb + "' is nothing this program does",
                          .where = std::string(kProgram),
                          .fix = "telepalp-codec --help"},
                         program::kAskedWrongly);
  if (words.size() != wanted)
    return program::fail({.what = verb + " takes " + std::to_string(wanted - 1) + " files",
                          .where = std::string(kProgram),
                          .fix = "telepalp-codec --help"},
                         program::kAskedWrongly);
  const Result<void> done = verb == "encode"   ? encode(words[1], words[2], arguments)
                            : verb == "decode" ? decode(words[1], words[2], arguments)
                            : verb == "info"   ? info(words[1])
                                               : compare(words[1], words[2], arguments);
  return done ? program::kDone : program::fail(done.error());
}
