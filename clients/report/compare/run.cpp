#include "clients/report/compare/run.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include <fstream>
#include <iterator>

#include "clients/report/compare/gate.h"
#include "clients/report/session/session_file.h"
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

/// The numbers of the object `key` of `object`.
std::map<std::string, double> numbers_in(const google::protobuf::Struct& object, const char* key) {
  std::map<std::string, double> numbers;
  const auto found = object.fields().find(key);
  if (found == object.fields().end()) return numbers;
  for (const auto& [name, value] : found->second.struct_value().fields())
    if (value.has_number_value()) numbers[name] = value.number_value();
  return numbers;
}

/// Texts and numbers of the object `key` of `object`, as texts.
std::map<std::string, std::string> texts_in(const google::protobuf::Struct& object, const char* key) {
  std::map<std::string, std::string> texts;
  const auto found = object.fields().find(key);
  if (found == object.fields().end()) return texts;
  const google::protobuf::Struct& inner = found->second.struct_value();
  for (const auto& [name, value] : inner.fields())
    texts[name] = value.has_number_value() ? plot::number(value.number_value(), 6) : value.string_value();
  return texts;
}

/// The settings of the unimpaired run: those of the run without its network and faults.
void remove_network(std::map<std::string, std::string>& settings) {
  for (const char* name : {"network_down", "network_up", "outage", "restart", "tracker_lost", "glitch", "clock_step"})
    if (const auto found = settings.find(name); found != settings.end()) found->second = "none";
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
                    .settings = texts_in(report, "settings"),
                    .figures = {}};
  if (unimpaired) remove_network(facts.settings);
  const std::map<std::string, double> images = numbers_in(report, "images");
  const auto image_fact = [&](const char* name) { return images.contains(name) ? images.at(name) : kUnknown; };
  facts.mean_depth_m = image_fact("mean_depth_m");
  facts.depth_bound_mm = image_fact("coded_within_mm_at_1_m");
  if (images.contains("fx_px"))
    facts.camera_px = {image_fact("fx_px"), image_fact("fy_px"), image_fact("cx_px"), image_fact("cy_px")};
  facts.figures = numbers_in(report, unimpaired ? "unimpaired" : "run");
  return facts;
}

double Run::depth_bound_mm() const noexcept {
  const wire::DepthFidelity& depth = summary.depth;
  if (depth.mode.empty() && !depth.moved) return replay ? replay->depth_bound_mm : kUnknown;
  return depth.within ? wire::at_1_m_mm(*depth.within) : depth.moved ? kUnknown : 0.0;
}

std::vector<double> Run::camera_px() const {
  const auto found = session.calibrations.find("camera_depth");
  if (found == session.calibrations.end() || found->second.k_size() != 9)
    return replay ? replay->camera_px : std::vector<double>();
  return {found->second.k(0), found->second.k(4), found->second.k(2), found->second.k(5)};
}

Result<Run> read_run(const std::filesystem::path& asked) {
  const std::filesystem::path file = session_file(asked);
  Result<Session> session = read_session(file);
  if (!session) return session.error();
  Run run;
  run.file = file;
  run.session = std::move(*session);
  run.summary = summarise(run.session);
  run.verdict = judge(run.summary);
  run.info = run.session.info;
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
