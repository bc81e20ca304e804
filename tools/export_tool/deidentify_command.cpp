#include "tools/export_tool/deidentify_command.h"

#include "proto/words/counted.h"
#include "support/program/log.h"
#include "tools/export_tool/output.h"

namespace telepalp::export_tool {
namespace {

constexpr const char* kProgram = "telepalp-export";

Result<ColorRule> color_rule(const program::Arguments& asked) {
  const std::string word = asked.has("color") ? asked.text("color") : "remove";
  if (word == "remove") return ColorRule::Remove;
  if (word == "blur") return ColorRule::Blur;
  return Error{.what = "'" + word.substr(0, 64) + "' is not a rule for colour",
               .where = "--color",
               .fix = "give remove, or blur for squares of a sixteenth of the image's width"};
}

std::string topic_line(const std::string& topic, const Deidentified::Messages& messages) {
  std::string line = topic + ": ";
  line += messages.kept > 0 ? counted(messages.kept, "message", "messages") + " kept" : "none kept";
  if (messages.blurred > 0) line += ", all of them blurred";
  if (messages.removed > 0) line += ", " + std::to_string(messages.removed) + " removed";
  if (messages.unreadable > 0) line += ", " + std::to_string(messages.unreadable) + " unreadable and removed";
  return line + "\n";
}

std::string lines_of(const std::map<std::string, std::uint64_t, std::less<>>& fields, const char* what) {
  std::string lines;
  for (const auto& [field, count] : fields) lines += what + field + ", " + counted(count, "time", "times") + "\n";
  return lines;
}

std::string if_any(std::uint64_t count, const char* one, const char* more) {
  return count == 0 ? "" : "removed: " + counted(count, one, more) + "\n";
}

std::string what_remains(ColorRule color) {
  std::string text =
      "still in the copy: the shape of the body in depth, by which a face in view can be recognised\n"
      "still in the copy: dates and times of the session\n";
  if (color == ColorRule::Blur)
    text +=
        "still in the copy: blurred colour; look at it before you pass it on, because a program may recognise a "
        "blurred face\n";
  return text + "not touched: the session itself, and the notes beside it\n";
}

}  // namespace

std::string in_words(const Deidentified& report, ColorRule color) {
  std::string text;
  for (const auto& [topic, messages] : report.topics) text += topic_line(topic, messages);
  text += "removed: who recorded, from which server, and the text of the consent\n";
  text += lines_of(report.texts.removed, "text removed: ");
  text += lines_of(report.texts.numbered, "name replaced by a number: ");
  text +=
      if_any(report.texts.unknown_fields, "message's fields of another version", "messages' fields of another version");
  text += if_any(report.attachments, "attached file", "attached files");
  text += if_any(report.records_of_metadata, "record about the session's files", "records about the session's files");
  if (report.scene_removed) text += "removed: the scene, which this version cannot read\n";
  text += if_any(report.notes, "note on the session", "notes on the session");
  if (report.damaged > 0)
    text += "left out: " + counted(report.damaged, "damaged place", "damaged places") + " of the session\n";
  return text + what_remains(color);
}

int deidentify_command(const std::string& session, const program::Arguments& asked) {
  const Result<ColorRule> color = color_rule(asked);
  if (!color) return program::fail(color.error(), program::kAskedWrongly);
  const std::string out = asked.text("deidentify");
  const Result<Deidentified> report = write_deidentified(session, out, *color);
  if (!report) return program::fail(report.error());
  program::log(kProgram, "wrote " + out);
  return put(asked, in_words(*report, *color));
}

}  // namespace telepalp::export_tool
