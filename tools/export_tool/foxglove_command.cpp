#include "tools/export_tool/foxglove_command.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "proto/words/counted.h"
#include "support/program/log.h"
#include "tools/export_tool/foxglove_session.h"
#include "tools/export_tool/foxglove_size.h"

namespace telepalp::export_tool {
namespace {

namespace fs = std::filesystem;

struct Part {
  const char* name;
  bool FoxgloveParts::*is_wanted;
  std::uint64_t FoxgloveSize::*bytes;
};
constexpr std::array kParts{Part{"points", &FoxgloveParts::points, &FoxgloveSize::points},
                            Part{"depth", &FoxgloveParts::depth, &FoxgloveSize::depth},
                            Part{"color", &FoxgloveParts::color, &FoxgloveSize::color},
                            Part{"station", &FoxgloveParts::station, &FoxgloveSize::station}};

Result<FoxgloveParts> parts_of(const program::Arguments& asked) {
  FoxgloveParts parts;
  if (asked.has("rate")) {
    const Result<double> rate = asked.number("rate", 0.01, 1000.0);
    if (!rate) return rate.error();
    parts.images_per_s = *rate;
  }
  if (!asked.has("parts")) return parts;
  for (const Part& part : kParts) parts.*part.is_wanted = false;
  std::vector<std::string> words;
  boost::split(words, asked.text("parts"), boost::is_any_of(","));
  for (const std::string& word : words) {
    const auto found = std::find_if(kParts.begin(), kParts.end(), [&](const Part& part) { return word == part.name; });
    if (found == kParts.end())
      return Error{.what = "'" + word.substr(0, 64) + "' is not a part of a session",
                   .where = "--parts",
                   .fix = "give one or more of points, depth, color and station, separated by commas"};
    parts.*(found->is_wanted) = true;
  }
  return parts;
}

std::string megabytes(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 10'000'000 ? "%.1f MB" : "%.0f MB", static_cast<double>(bytes) / 1e6);
  return text;
}

/// "session.mcap has 55 MB; view.mcap will have about 629 MB: points 480 MB, depth 120 MB, …".
std::string announced(const std::string& session, const std::string& out, const FoxgloveSize& size) {
  std::error_code unknown;
  std::string text = session + " has " + megabytes(fs::file_size(session, unknown)) + "; " + out + " will have about " +
                     megabytes(size.total());
  const char* separator = ": ";
  for (const Part& part : kParts) {
    if (size.*part.bytes == 0) continue;
    text += separator + std::string(part.name) + " " + megabytes(size.*part.bytes);
    separator = ", ";
  }
  if (size.points + size.depth > size.color + size.station)
    text += ". To write less: --parts color,station leaves parts out, --rate 5 leaves images out";
  return text;
}

Result<void> has_room(const fs::path& out, const FoxgloveSize& size) {
  std::error_code unknown;
  const fs::path folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  const auto room = fs::space(folder, unknown);
  if (unknown || room.available >= size.total()) return {};
  return Error{.what = "needs about " + megabytes(size.total()) + ", but its disk has only " +
                       megabytes(room.available) + " free",
               .where = out.string(),
               .fix = "free space, name a file on another disk, or write less by --parts or --rate"};
}

}  // namespace

int foxglove_command(const std::string& session, const program::Arguments& asked) {
  constexpr const char* kProgram = "telepalp-export";
  const Result<FoxgloveParts> parts = parts_of(asked);
  if (!parts) return program::fail(parts.error(), program::kAskedWrongly);
  const std::string out = asked.text("foxglove");
  const Result<FoxgloveSize> size = estimated_size(session, *parts);
  if (!size) return program::fail(size.error());
  program::log(kProgram, announced(session, out, *size));
  if (const Result<void> room = has_room(out, *size); !room) return program::fail(room.error());
  const Result<Exported> made = write_foxglove(session, out, *parts);
  if (!made) return program::fail(made.error());
  if (const std::string left_out = left_out_in_words(made->left_out, session); !left_out.empty())
    program::log(kProgram, left_out);
  std::error_code unknown;
  program::log(kProgram, "wrote " + counted(made->written, "message", "messages") + ", " +
                             megabytes(fs::file_size(out, unknown)) + ", to " + out);
  return program::kDone;
}

}  // namespace telepalp::export_tool
