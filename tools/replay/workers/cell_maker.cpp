#include "tools/replay/workers/cell_maker.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "support/program/files/shipped.h"
#include "support/program/files/whole_file.h"
#include "tools/replay/commands/request.h"
#include "tools/replay/commands/settings.h"
#include "tools/replay/commands/sweep_cells.h"
#include "tools/replay/run/kept_session.h"

namespace telepalp::replay {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_scene_name(std::string_view name) noexcept {
  return !name.empty() && name.size() <= 64 && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

Error another_identity(const std::string& what) {
  return {.what = what + " has another identity than its order states",
          .where = "order of a cell",
          .fix = "give the sweep's command again; if this repeats, report it: it is a defect of telepalp"};
}

Result<Request> read_command(const std::vector<std::string>& command) {
  std::vector<const char*> words{"telepalp-replay"};
  for (const std::string& word : command) words.push_back(word.c_str());
  const auto arguments = program::read_arguments(usage(), static_cast<int>(words.size()), words.data());
  if (!arguments) return arguments.error();
  if (!*arguments) return another_identity("the command line");  // --help, which parse_order() has refused
  return read_request(**arguments);
}

}  // namespace

/// The state that the cells of a sweep share.
struct CellMaker::Kept {
  CellOrder sweep;
  std::string source;  ///< as this program opens it
  Request request;
  std::optional<KeptSession> session;  ///< nullopt: it would need too much memory

  [[nodiscard]] Result<RunResults> run(const Scenario& scenario, const std::atomic<bool>& stop) const {
    if (session) return session->run(scenario, &stop);
    Result<Tape> tape = Tape::open(source, request.tape);
    if (!tape) return tape.error();
    return run_session(*tape, request.run_settings(&stop),
                       {{.scenario = unimpaired(request.scenario)}, {.scenario = scenario}});
  }
};

CellMaker::CellMaker(fs::path scratch, std::size_t most_B) : scratch_(std::move(scratch)), most_B_(most_B) {}
CellMaker::~CellMaker() = default;

Result<fs::path> CellMaker::scene_file_of(const CellOrder& order) const {
  const auto named = order.options.find("scene");
  if (named != order.options.end())
    if (const auto shipped = scene_of_library(named->second, order.scene_text)) return *shipped;
  if (names_a_file(order.scene_text))
    return Error{.what = "the scene names a file, which a worker does not have, or it cannot be read",
                 .where = "order of a cell",
                 .fix = "use a scene of telepalp's library, or one that names no file"};
  if (const Result<void> made = program::make_folder(scratch_, program::Readers::Group); !made) return made.error();
  const fs::path file = scratch_ / ("worker-" + std::to_string(::getpid()) + ".scene.textproto");
  const Result<void> written = program::write_whole_file(file, order.scene_text, program::Readers::Group);
  if (!written) return written.error();
  return file;
}

Result<std::unique_ptr<CellMaker::Kept>> CellMaker::prepare(const CellOrder& order, const std::string& source,
                                                            const std::atomic<bool>& stop) const {
  const Result<fs::path> scene = scene_file_of(order);
  if (!scene) return scene.error();
  Result<Request> request = read_command(command_of(order, source, scene->string()));
  if (scene->parent_path() == scratch_) {
    std::error_code failed;
    fs::remove(*scene, failed);
  }
  if (!request) return request.error();
  auto kept = std::make_unique<Kept>(Kept{sweep_of(order), source, *std::move(request), std::nullopt});
  // Reports state what the user named, not where this computer keeps it.
  kept->request.source = order.source;
  kept->request.source_digest = order.source_digest;
  kept->request.options = order.options;
  kept->request.threads = 1;
  if (identity_of(kept->request, kept->request.scenario) != order.sweep) return another_identity("the sweep");
  Result<Tape> tape = Tape::open(source, kept->request.tape);
  if (!tape) return tape.error();
  auto session = KeptSession::make(*std::move(tape), kept->request.run_settings(&stop),
                                   unimpaired(kept->request.scenario), most_B_);
  if (!session) return session.error();
  if (*session) kept->session.emplace(*std::move(*session));
  return kept;
}

Result<std::string> CellMaker::make(const CellOrder& order, const std::string& source, const std::atomic<bool>& stop) {
  if (!kept_ || kept_->sweep != sweep_of(order)) {
    kept_.reset();  // first: both together may need more memory than there is
    Result<std::unique_ptr<Kept>> prepared = prepare(order, source, stop);
    if (!prepared) return prepared.error();
    kept_ = *std::move(prepared);
  }
  Request& request = kept_->request;
  Result<std::vector<SweepAxis>> axes = parse_axes(axes_of(order));
  if (!axes) return axes.error();
  Result<std::vector<SweepCell>> cells = sweep_cells(*axes, request.scenario, !order.options.contains("deadline-ms"));
  if (!cells) return cells.error();
  request.axes = *std::move(axes);
  const SweepCell& cell = cells->front();
  if (identity_of(request, cell.scenario) != order.cell) return another_identity("the cell");
  const Result<RunResults> results = kept_->run(cell.scenario, stop);
  if (!results) return results.error();
  return cell_report(request, cell, *results);
}

std::optional<fs::path> scene_of_library(const std::string& name, const std::string& text) {
  if (!is_scene_name(name)) return std::nullopt;
  auto file = program::shipped_file("haptic_station/scenes/" + name + ".scene.textproto");
  if (!file || text_of(*file) != text) return std::nullopt;
  return file;
}

CellOrder sweep_of(CellOrder order) {
  order.cell.clear();
  order.at.clear();
  return order;
}

}  // namespace telepalp::replay
