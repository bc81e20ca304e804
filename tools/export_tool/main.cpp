#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <functional>
#include <utility>

#include "proto/wire/mcap/reader.h"
#include "proto/words/counted.h"
#include "support/program/ending.h"
#include "support/program/files/shipped.h"
#include "support/program/files/whole_file.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/session_store/session_place.h"
#include "tools/export_tool/cloud_file.h"
#include "tools/export_tool/deidentify_command.h"
#include "tools/export_tool/foxglove_command.h"
#include "tools/export_tool/frames.h"
#include "tools/export_tool/image_folder.h"
#include "tools/export_tool/message_table.h"
#include "tools/export_tool/output.h"

namespace {

using namespace telepalp;

constexpr const char* kProgram = "telepalp-export";
constexpr double kLongest_s = 1e7;

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "writes a session's images, point clouds and numbers in other formats",
          .positional = "SESSION.mcap",
          .options = {{"png", "DIR", "depth and colour of each frame, for telepalp-server --source images:DIR"},
                      {"csv", "TOPIC", "the numbers of a topic, such as /station/ticks"},
                      {"ply", "S", "the point cloud S seconds after the session's beginning"},
                      {"pcd", "S", "the point cloud S seconds after the beginning, as organised PCD"},
                      {"foxglove", "FILE.mcap", "images, point clouds, transforms and force in Foxglove's types"},
                      {"parts", "LIST", "for --foxglove: of points,depth,color,station; default: all"},
                      {"rate", "HZ", "for --foxglove: at most so many images a second; default: all"},
                      {"deidentify", "FILE.mcap",
                       "the session without names, texts, notes and colour; prints what remains"},
                      {"color", "remove|blur", "for --deidentify: what becomes of colour; default: remove"},
                      {"report", "DIR", "the same as telepalp-report SESSION.mcap --out DIR"},
                      {"out", "FILE", "file for --csv, --ply, --pcd, or what --deidentify says; default: stdout"}},
          .example = "telepalp-export session.mcap --ply 1.5 --out skin.ply"};
}

int say(const Result<std::uint64_t>& count, const char* one, const char* more, const std::string& where) {
  if (!count) return program::fail(count.error());
  program::log(kProgram, "wrote " + counted(*count, one, more) + " to " + where);
  return program::kDone;
}

/// Error: `--out` names the session, which must not be overwritten, or the copy that --deidentify writes.
Result<void> check_out(const std::string& session, const program::Arguments& asked) {
  const auto place = [&](const char* option) {
    std::error_code unknown;
    return std::filesystem::absolute(asked.text(option), unknown).lexically_normal();
  };
  if (asked.has("out") && asked.has("deidentify") && place("out") == place("deidentify"))
    return Error{.what = "is the copy of the session itself",
                 .where = "--out " + asked.text("out"),
                 .fix = "name another file for what --deidentify says"};
  if (!asked.has("out") || !program::is_same_file(session, asked.text("out"))) return {};
  return Error{.what = "is the session itself, which is not overwritten",
               .where = "--out " + asked.text("out"),
               .fix = "name another file"};
}

/// Logs how many parts of the session are missing from the export.
void say_left_out(std::uint64_t count, const std::string& file) {
  if (const std::string words = export_tool::left_out_in_words(count, file); !words.empty())
    program::log(kProgram, words);
}

int run_images(const std::string& file, const std::string& folder) {
  const Result<export_tool::Exported> made = export_tool::write_images(file, folder);
  if (!made) return program::fail(made.error());
  say_left_out(made->left_out, file);
  return say(made->written, "frame", "frames", folder);
}

int run_cloud(const std::string& file, const program::Arguments& asked, std::string_view option,
              std::string (*bytes_of)(const RgbdFrame&)) {
  const Result<double> at_s = asked.number(option, 0.0, kLongest_s);
  if (!at_s) return program::fail(at_s.error(), program::kAskedWrongly);
  Result<export_tool::Frames> frames = export_tool::Frames::open(file);
  if (!frames) return program::fail(frames.error());
  const Result<RgbdFrame> frame = frames->at(*at_s);
  if (!frame) return program::fail(frame.error());
  say_left_out(frames->damaged(), file);
  return export_tool::put(asked, bytes_of(*frame));
}

int run_csv(const std::string& file, const program::Arguments& asked) {
  const std::optional<wire::Topic> topic = wire::find_topic(asked.text("csv"));
  if (!topic)
    return program::fail({.what = "'" + asked.text("csv") + "' is not a topic of telepalp",
                          .where = "--csv",
                          .fix = "give one of the topics that are listed by telepalp-record info " + file},
                         program::kAskedWrongly);
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return program::fail(reader.error());
  reader->select({.topics = {std::string(topic->name)}});
  const export_tool::MessageTable table(*topic);
  std::string text = table.header();
  std::uint64_t messages = 0, unreadable = 0;
  for (;;) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) program::log(kProgram, to_string(message.error()));
    if (!message) continue;
    if (!*message) break;
    const std::optional<std::string> lines = table.lines_of(**message);
    if (!lines) ++unreadable;
    text += lines.value_or("");
    ++messages;
  }
  say_left_out(unreadable, file);
  if (messages == 0)
    program::log(kProgram,
                 file + " holds no message of " + std::string(topic->name) +
                     ", so the table has only its header line. To list the contents of the session: telepalp-record "
                     "info " +
                     file);
  return export_tool::put(asked, text);
}

/// Becomes telepalp-report, which is installed beside this program.
int run_report(const std::string& file, const std::string& folder) {
  const std::filesystem::path program = program::sibling_program("telepalp-report");
  ::execl(program.c_str(), program.c_str(), file.c_str(), "--out", folder.c_str(), static_cast<char*>(nullptr));
  return program::fail({.what = std::string("cannot be started: ") + std::strerror(errno),
                        .where = program.string(),
                        .fix = "install telepalp-report in the folder of telepalp-export"});
}

/// What Ctrl-C leaves of an export.
std::string kept(const program::Arguments& asked) {
  if (asked.has("png"))
    return "the images written so far, in " + asked.text("png") + ", are whole; camera.textproto is missing there";
  for (const char* copy : {"foxglove", "deidentify"})
    if (asked.has(copy)) return asked.text(copy) + ".partial holds what was written so far";
  return "no file was written";
}

int run(const std::string& file, const program::Arguments& asked) {
  program::say_when_stopped(std::string(kProgram) + ": stopped: " + kept(asked));
  if (asked.has("png")) return run_images(file, asked.text("png"));
  if (asked.has("foxglove")) return export_tool::foxglove_command(file, asked);
  if (asked.has("deidentify")) return export_tool::deidentify_command(file, asked);
  if (asked.has("report")) return run_report(file, asked.text("report"));
  if (asked.has("ply")) return run_cloud(file, asked, "ply", export_tool::ply_of);
  if (asked.has("pcd")) return run_cloud(file, asked, "pcd", export_tool::pcd_of);
  return run_csv(file, asked);
}

int run_asked(const program::Arguments& asked) {
  int formats = 0;
  for (const char* option : {"png", "csv", "ply", "pcd", "foxglove", "deidentify", "report"})
    formats += asked.has(option) ? 1 : 0;
  if (asked.positional().size() != 1 || formats != 1)
    return program::fail(
        {.what = "the command does not name exactly one session file and one format",
         .where = kProgram,
         .fix = "give a session file, and one of --png, --csv, --ply, --pcd, --foxglove, --deidentify and --report"},
        program::kAskedWrongly);
  if (!asked.has("foxglove") && (asked.has("parts") || asked.has("rate")))
    return program::fail({.what = "the options choose what --foxglove writes, which is not given",
                          .where = "--parts and --rate",
                          .fix = "give --foxglove FILE.mcap, or leave them out"},
                         program::kAskedWrongly);
  if (asked.has("color") && !asked.has("deidentify"))
    return program::fail({.what = "the option chooses what --deidentify writes, which is not given",
                          .where = "--color",
                          .fix = "give --deidentify FILE.mcap, or leave it out"},
                         program::kAskedWrongly);
  if (const Result<void> out = check_out(asked.positional().front(), asked); !out)
    return program::fail(out.error(), program::kAskedWrongly);
  return run(asked.positional().front(), asked);
}

}  // namespace

int main(int argc, char** argv) {
  session_store::use_cluster_sessions();
  return program::run_program(usage(), argc, argv, run_asked);
}
