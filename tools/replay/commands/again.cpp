#include "tools/replay/commands/again.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

namespace telepalp::replay {
namespace {

using google::protobuf::Struct;

constexpr std::string_view kAgain = "again:";

const Struct* object_in(const Struct& object, const char* key) {
  const auto found = object.fields().find(key);
  return found == object.fields().end() || !found->second.has_struct_value() ? nullptr : &found->second.struct_value();
}

std::string text_in(const Struct& object, const char* key) {
  const auto found = object.fields().find(key);
  return found == object.fields().end() ? std::string() : found->second.string_value();
}

Error not_a_report(const std::filesystem::path& file) {
  return {.what = "does not say how a run of telepalp-replay is made again",
          .where = file.string(),
          .fix = "give report.json of a folder that telepalp-replay --out wrote, or that folder"};
}

Error changed(const std::string& what, const std::string& where, const char* option) {
  return {.what = what + " has changed since the run that again: names",
          .where = where,
          .fix = std::string("restore the file, or name the file to use as ") + option};
}

bool is_option(const std::string& word, const std::string& name) {
  return word == "--" + name || word.starts_with("--" + name + "=");
}

bool gives(const std::vector<std::string>& words, const std::string& name) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return is_option(word, name); });
}

/// `word`, of a command line, without user and password if it is the address of a cluster.
std::string without_password(const std::string& word) {
  constexpr std::string_view kWorkers = "--workers=";
  const std::size_t begin = word.starts_with(kWorkers) ? kWorkers.size() : 0;
  const std::string value = word.substr(begin);
  return nats::is_address(value) ? word.substr(0, begin) + nats::without_password(value) : word;
}

/// `words` as a line to paste into a shell. It is shown, so it holds no password.
std::string line_of(const std::vector<std::string>& words) {
  constexpr std::string_view kPlain = "_@%+=:,./-";
  std::string line = "telepalp-replay";
  for (const std::string& given : words) {
    const std::string word = without_password(given);
    const bool plain = std::all_of(word.begin(), word.end(), [&](char letter) {
      return std::isalnum(static_cast<unsigned char>(letter)) != 0 || kPlain.find(letter) != std::string_view::npos;
    });
    line += " ";
    if (plain) {
      line += word;
      continue;
    }
    line += "'";
    for (const char letter : word) line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    line += "'";
  }
  return line;
}

Result<std::optional<program::Arguments>> arguments_of(const std::vector<std::string>& words) {
  std::vector<const char*> all{"telepalp-replay"};
  for (const std::string& word : words) all.push_back(word.c_str());
  return program::read_arguments(usage(), static_cast<int>(all.size()), all.data());
}

}  // namespace

Result<Again> read_again(const std::filesystem::path& asked) {
  const std::filesystem::path file = std::filesystem::is_directory(asked) ? asked / "report.json" : asked;
  std::ifstream in(file);
  const std::string json{std::istreambuf_iterator<char>(in), {}};
  Struct report;
  if (!google::protobuf::util::JsonStringToMessage(json, &report).ok()) return not_a_report(file);
  const Struct* const object = object_in(report, "again");
  const Struct* const options = object == nullptr ? nullptr : object_in(*object, "options");
  if (options == nullptr || text_in(*object, "source").empty()) return not_a_report(file);
  Again again{.source = text_in(*object, "source"),
              .source_digest = text_in(*object, "source_digest"),
              .scene_text = text_in(*object, "scene_text"),
              .options = {}};
  for (const auto& [name, value] : options->fields()) again.options[name] = value.string_value();
  return again;
}

std::vector<std::string> words_again(const Again& again, const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (const std::string& word : words) all.push_back(word.starts_with(kAgain) ? again.source : word);
  for (const auto& [name, text] : again.options)
    if (!gives(words, name)) all.insert(all.end(), {"--" + name, text});
  return all;
}

Result<Request> read_command_line(const program::Arguments& given, const std::vector<std::string>& words) {
  const std::vector<std::string>& positional = given.positional();
  const bool is_again = !positional.empty() && positional.front().starts_with(kAgain);
  const Result<Again> again = is_again ? read_again(positional.front().substr(kAgain.size())) : Again{};
  if (!again) return again.error();
  const auto merged = arguments_of(is_again ? words_again(*again, words) : words);
  if (!merged) return merged.error();
  Result<Request> request = read_request(**merged);
  if (!request) return request.error();
  if (is_again && request->source_digest != again->source_digest)
    return changed("the source", request->source, "the source");
  if (is_again && !gives(words, "scene") && request->scene_text != again->scene_text)
    return changed("the scene", request->scene_file.string(), "--scene");
  request->command = line_of(words);
  return request;
}

}  // namespace telepalp::replay
