// telepalp-codec: compresses and decompresses depth recordings and prints the errors and sizes.

#include "server/pipeline/depth_options.h"
#include "support/program/ending.h"
#include "support/program/options.h"
#include "tools/codec_tool/commands.h"

namespace {

using namespace telepalp;

constexpr std::string_view kProgram = "telepalp-codec";

program::Usage usage() {
  return {
      .program = kProgram,
      .purpose = "compresses, decompresses, describes and compares depth recordings",
      .positional = {},
      .options = {{"mode", "MODE", "lossless: fast, intra, temporal; near-lossless: bounded", "temporal"},
                  {"key-every", "N", "modes temporal, bounded: every Nth frame is a key frame", "30"},
                  {"unit-mm", "MM", "image files: millimetres for a pixel value of 1", "1"},
                  {"bound", "LEAST,PER_M2",
                   "largest error of a depth of z m: max(LEAST, PER_M2 z²) mm; encode: default 1,2.85; compare: fail "
                   "if a depth differs by more"},
                  {"to", "KIND", "decode: png or pgm, 16 bits a pixel", "png"},
                  {"json", "", "info: print JSON instead of a table"}},
      .example = "telepalp-codec encode recording.oni depth.mcap && telepalp-codec compare recording.oni depth.mcap",
      .commands = {{"encode", "IN OUT.mcap", "compress the depth of a recording, session or folder of images"},
                   {"decode", "IN.mcap OUT_DIR", "write each depth image as a file"},
                   {"info", "IN.mcap", "print how each depth image is compressed"},
                   {"compare", "A B", "print the differences between the depth of A and B"}},
      .needs_command = true};
}

struct Asked {
  std::vector<std::string> words;  ///< the command and its files
  codec::DepthStreamSettings settings;
  std::optional<DepthErrorBound> bound_to_keep;  ///< for `compare`: the bound that the second recording must keep
  double unit_m = 0.001;
  std::string to;
  bool json = false;
};

Result<Asked> read_asked(const program::Arguments& arguments) {
  Asked asked{.words = arguments.positional(),
              .settings = {},
              .bound_to_keep = {},
              .to = arguments.text("to"),
              .json = arguments.has("json")};
  const std::string command = asked.words.empty() ? "" : asked.words.front();
  if (command != "encode" && command != "decode" && command != "info" && command != "compare")
    return Error{.what = asked.words.empty() ? "no command is given" : "'" + command + "' is not a command",
                 .where = std::string(kProgram),
                 .fix = "see telepalp-codec --help"};
  const std::size_t wanted = command == "info" ? 2 : 3;
  if (asked.words.size() != wanted)
    return Error{.what = command + " takes " + std::to_string(wanted - 1) +
                         (wanted == 2 ? " argument, not " : " arguments, not ") +
                         std::to_string(asked.words.size() - 1),
                 .where = std::string(kProgram),
                 .fix = "see telepalp-codec --help"};
  if (command == "compare" && arguments.has("bound")) {
    const Result<DepthErrorBound> bound = pipeline::read_depth_bound(arguments.text("bound"), "bound");
    if (!bound) return bound.error();
    asked.bound_to_keep = *bound;
  } else {
    const Result<codec::DepthStreamSettings> settings =
        pipeline::read_depth_settings(arguments, {.mode = "mode", .bound = "bound"});
    if (!settings) return settings.error();
    asked.settings = *settings;
  }
  const Result<double> unit_mm = arguments.number("unit-mm", 1e-4, 1000.0);
  if (!unit_mm) return unit_mm.error();
  asked.unit_m = *unit_mm / 1000.0;
  if (asked.to != "png" && asked.to != "pgm")
    return Error{.what = "'" + asked.to + "' is neither png nor pgm", .where = "--to", .fix = "give png or pgm"};
  return asked;
}

Result<void> run(const Asked& asked) {
  const std::string& command = asked.words[0];
  program::say_when_stopped(std::string(kProgram) + ": stopped: " +
                            (command == "decode" ? "the images written so far, in " + asked.words[2] + ", are whole"
                                                 : std::string("it has no result, and wrote no file")));
  if (command == "info") return codec_tool::describe_recording(asked.words[1], asked.json);
  if (command == "decode") return codec_tool::decode_recording(asked.words[1], asked.words[2], asked.to);
  if (command == "compare")
    return codec_tool::compare_recordings(asked.words[1], asked.words[2], asked.unit_m, asked.bound_to_keep);
  return codec_tool::encode_recording(asked.words[1], asked.words[2], asked.settings, asked.unit_m);
}

int run_asked(const program::Arguments& arguments) {
  const Result<Asked> asked = read_asked(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  const Result<void> done = run(*asked);
  return done ? program::kDone : program::fail(done.error());
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run_asked); }
