#include "clients/report/compare/run.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include <fstream>
#include <iterator>

#include "clients/report/session/session_file.h"
#include "proto/wire/mcap/reader.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

constexpr std::uintmax_t kMostReportBytes = 1'000'000;

std::string text_of(const std::filesystem::path& file) {
  std::error_code failed;
  if (std::filesystem::file_size(file, failed) > kMostReportBytes || failed) return {};
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string text_in(const google::protobuf::Struct& object, const char* key) {
  const auto found = object.fields().find(key);
  if (found == object.fields().end()) return {};
  if (found->second.has_number_value()) return plot::number(found->second.number_value(), 0);
  return found->second.string_value();
}

/// The last `parts` parts of a path.
std::string tail(const std::filesystem::path& path, int parts) {
  std::filesystem::path end = path.filename(), rest = path.parent_path();
  for (; parts > 1 && !rest.empty() && rest != rest.root_path(); --parts, rest = rest.parent_path())
    end = rest.filename() / end;
  return end.string();
}

}  // namespace

std::optional<ReplayFacts> replay_facts(const std::string& json, bool unimpaired) {
  google::protobuf::Struct report;
  if (!google::protobuf::util::JsonStringToMessage(json, &report).ok()) return std::nullopt;
  if (text_in(report, "program") != "telepalp-replay") return std::nullopt;
  ReplayFacts facts{.network = unimpaired ? "unimpaired (no delay, loss or fault)" : text_in(report, "network"),
                    .seed = text_in(report, "seed"),
                    .hand = text_in(report, "hand"),
                    .figures = {}};
  const auto figures = report.fields().find(unimpaired ? "unimpaired" : "run");
  if (figures == report.fields().end()) return facts;
  for (const auto& [name, value] : figures->second.struct_value().fields())
    if (value.has_number_value()) facts.figures[name] = value.number_value();
  return facts;
}

Result<Run> read_run(const std::filesystem::path& asked) {
  const std::filesystem::path file = std::filesystem::is_directory(asked) ? asked / "session.mcap" : asked;
  Result<Session> session = read_session(file);
  if (!session) return session.error();
  Run run;
  run.file = file;
  run.session = std::move(*session);
  run.summary = summarise(run.session);
  run.verdict = judge(run.summary);
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  if (Result<wire::SessionInfo> info = reader->session()) run.info = std::move(*info);
  if (run.info.program == "telepalp-replay")
    run.replay = replay_facts(text_of(file.parent_path() / "report.json"), file.filename() == "unimpaired.mcap");
  return run;
}

void label(Run& a, Run& b) {
  constexpr int kMostParts = 12;
  const std::filesystem::path first = std::filesystem::absolute(a.file), second = std::filesystem::absolute(b.file);
  int parts = 1;
  while (parts < kMostParts && tail(first, parts) == tail(second, parts)) ++parts;
  a.label = tail(first, parts);
  b.label = tail(second, parts);
}

}  // namespace telepalp::report
