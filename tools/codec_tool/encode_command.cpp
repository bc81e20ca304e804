#include <csignal>
#include <cstdio>

#include "proto/wire/mcap/writer.h"
#include "server/pipeline/camera_messages.h"
#include "tools/codec_tool/commands.h"
#include "tools/codec_tool/depth_files.h"
#include "tools/codec_tool/progress.h"
#include "tools/codec_tool/totals.h"

namespace telepalp::codec_tool {
namespace {

constexpr Nanoseconds kAssumedPeriod{33'333'333};  // frame period assumed for images without a capture time

SessionTime captured_of(const NamedDepth& named, std::size_t number) {
  if (named.captured != SessionTime{}) return named.captured;
  return SessionTime{kAssumedPeriod * static_cast<std::int64_t>(number)};
}

volatile std::sig_atomic_t interrupted = 0;

extern "C" void interrupt(int /*signal*/) { interrupted = 1; }

/// Fails after Ctrl-C or SIGTERM, so that the unfinished file is removed.
Result<void> go_on(const std::filesystem::path& output) {
  if (interrupted == 0) return {};
  return Error{.what = "encoding was interrupted; the incomplete file is removed",
               .where = output.string(),
               .fix = "run the command again"};
}

/// Prints a note about damage: a recording that was not finished still gives the frames that it has.
void say_what_is_missing(const Error& damage) { std::fprintf(stderr, "note: %s\n", to_string(damage).c_str()); }

}  // namespace

Result<void> encode_recording(const std::filesystem::path& input, const std::filesystem::path& output,
                              const codec::DepthStreamSettings& settings, double unit_m) {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  Result<wire::McapWriter> writer = wire::McapWriter::open(
      output, {.program = "telepalp-codec", .version = {}, .commit = {}, .source = input.string(), .scene = {}});
  if (!writer) return writer.error();
  codec::DepthEncoder encoder(settings);
  Progress progress(count_depth_files(input));
  Totals totals;
  Result<void> done = for_each_depth(
      input, unit_m,
      [&](NamedDepth named) -> Result<void> {
        if (const auto going_on = go_on(output); !going_on) return going_on.error();
        const SessionTime captured = captured_of(named, totals.frames);
        codec::EncodedDepth encoded = encoder.encode(named.depth);
        const bool is_key = encoded.key_frame;
        const RgbdFrame frame{.captured = captured,
                              .sequence = totals.frames + 1,
                              .camera = {},
                              .depth = std::move(named.depth),
                              .color = {},
                              .loss = named.loss};
        const msg::DepthImage image = pipeline::depth_message(frame, std::move(encoded));
        totals.add(static_cast<double>(frame.depth.samples.size()), image.data().size());
        progress.step();
        return writer->write(wire::make_message(wire::kCameraDepth, captured, image, is_key));
      },
      input.extension() == ".oni" ? say_what_is_missing : std::function<void(const Error&)>{});
  if (done && totals.frames == 0)
    done = Error{.what = "holds no depth image",
                 .where = input.string(),
                 .fix = "give a recording, a session or images with 16-bit depth"};
  done = writer->finish(done);
  if (done) totals.print();
  return done;
}

}  // namespace telepalp::codec_tool
