#include "tools/replay/commands/request.h"

#include <fstream>
#include <iterator>
#include <set>

#include "codec/depth.h"
#include "support/program/files/whole_file.h"
#include "support/program/parallel.h"
#include "tools/replay/commands/diff_command.h"
#include "tools/replay/source/content_digest.h"
#include "tools/replay/source/session_hand.h"
#include "tools/replay/words/network_options.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

constexpr std::string_view kDefaultScene = "palpation";
constexpr double kSyntheticSeconds = 20.0;
constexpr double kMostSeconds = 86400.0;
constexpr std::int64_t kMostThreads = 256;
constexpr std::int64_t kMostSeeds = 1'000'000;

Result<void> read_scene(const program::Arguments& arguments, Request& request) {
  const Result<std::filesystem::path> file = scenes::find_scene(arguments.text("scene"));
  if (!file) return file.error();
  request.scene_file = *file;
  Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  if (scene->model)
    return Error{.what = "the scene's patient_surface is a static model, which does not cross the network",
                 .where = file->string(),
                 .fix = "give a scene whose patient_surface is streamed"};
  const std::string& name = scene->surface;
  const Result<surface::SurfaceSettings> surface =
      name.empty() ? surface::SurfaceSettings{} : surface::surface_settings(name);
  if (!surface) return surface.error();
  request.surface = *surface;
  request.scene_text = scene->text;
  request.scene = std::make_unique<const scenes::Scene>(std::move(*scene));
  return {};
}

Result<void> read_depth_mode(const program::Arguments& arguments, Request& request) {
  const std::string text = arguments.text("depth-mode");
  const std::optional<codec::DepthMode> mode = codec::depth_mode(text);
  if (!mode)
    return Error{.what = "'" + text + "' is not a depth mode",
                 .where = "--depth-mode",
                 .fix = "give fast, intra, temporal or bounded"};
  request.tape.depth.mode = *mode;
  return {};
}

/// The recorded hand of a session that has one, unless another is asked for.
Result<void> read_hand(const program::Arguments& arguments, Request& request) {
  const std::string asked = arguments.text("hand");
  if (!asked.empty() && asked != "recorded" && !hand_script(asked))
    return Error{.what = "'" + asked + "' is neither recorded nor a script of the hand",
                 .where = "--hand",
                 .fix = "give recorded, examine, tap, search or scene"};
  if (hand_script(asked) == HandScript::Scene && request.scene->hand_trace)
    return Error{.what = "the scene's hand is a recording of a tracker, and no script",
                 .where = "--hand scene",
                 .fix = "give --hand examine, tap or search"};
  const std::string session = session_file_of(request.source);
  if (hand_script(asked) || (session.empty() && asked.empty())) return {};
  if (session.empty())
    return Error{.what = "the source has no recorded hand: only a session file holds a hand",
                 .where = "--hand recorded",
                 .fix = "give --hand examine, tap, search or scene"};
  Result<RecordedHand> hand = read_session_hand(session);
  if (!hand) return hand.error();
  if (hand->empty() && asked == "recorded")
    return Error{
        .what = "holds no recorded hand: a hand needs messages on /station/ticks, /camera/info and /camera/depth",
        .where = session,
        .fix = "give --hand examine, tap, search or scene"};
  request.recorded = std::move(*hand);
  return {};
}

Result<void> read_length(const program::Arguments& arguments, Request& request) {
  const Result<double> seconds = arguments.number("seconds", 0.0, kMostSeconds);
  if (!seconds) return seconds.error();
  const Result<std::int64_t> threads = arguments.whole("threads", 0, kMostThreads);
  if (!threads) return threads.error();
  request.threads = *threads == 0 ? program::processors() : static_cast<int>(*threads);
  request.seconds = *seconds;
  request.tape.repeat = request.seconds > 0.0;
  if (request.seconds == 0.0 && request.source.starts_with("synthetic")) request.seconds = kSyntheticSeconds;
  return {};
}

Result<void> read_source(const program::Arguments& arguments, Request& request) {
  if (arguments.positional().empty())
    return Error{.what = "no source is named",
                 .where = "telepalp-replay",
                 .fix = "give a session, a recording or synthetic:torso,motion=irregular"};
  request.source = arguments.positional().front();
  request.source_digest = digest_of_source(request.source);
  return {};
}

/// Keeps the options that a run of the same result needs; those of outputs, checks and speed are left out.
void keep_options(const program::Arguments& arguments, Request& request) {
  for (const std::string_view name : names_of_run_options())
    if (arguments.has(name)) request.options[std::string(name)] = arguments.text(name);
}

Result<void> read_baseline(const program::Arguments& arguments, Request& request) {
  const Error alone{.what = "only one run at a time is compared with a baseline",
                    .where = "--baseline",
                    .fix = "leave out --sweep, or leave out --baseline"};
  if (!arguments.has("baseline")) return {};
  if (arguments.has("sweep")) return alone;
  const std::string text = arguments.text("baseline");
  const std::size_t comma = text.find(',');
  const std::string folder = text.substr(0, comma);
  request.baseline = report::session_file(folder);
  if (!std::filesystem::is_regular_file(request.baseline))
    return Error{.what = request.baseline.string() + " is no file",
                 .where = "--baseline",
                 .fix = "make the baseline with the same command, with --out " + folder + " in place of --baseline"};
  if (!request.out.empty() && program::is_same_file(request.baseline, request.out / "session.mcap"))
    return Error{.what = "the run would overwrite its baseline", .where = "--out", .fix = "give another folder"};
  Result<std::vector<report::Tolerance>> tolerances =
      report::parse_tolerances(comma == std::string::npos ? "same" : text.substr(comma + 1), "--baseline");
  if (!tolerances) return tolerances.error();
  request.tolerances = std::move(*tolerances);
  return {};
}

/// The axes of a sweep: --sweep's own value, and the words after the source.
Result<void> read_sweep(const program::Arguments& arguments, Request& request) {
  std::vector<std::string> words(arguments.positional().begin() + 1, arguments.positional().end());
  if (!arguments.has("sweep")) {
    if (words.empty()) return {};
    return Error{.what = "'" + words.front() + "' after the source is not understood",
                 .where = "telepalp-replay",
                 .fix = "leave this word out, or write --sweep before the first axis, such as --sweep delay=0:50:300"};
  }
  if (request.check)
    return Error{.what = "a sweep does not check force, energy and contact",
                 .where = "--check",
                 .fix = "check one network at a time, without --sweep"};
  words.insert(words.begin(), arguments.text("sweep"));
  Result<std::vector<SweepAxis>> axes = parse_axes(words);
  if (!axes) return axes.error();
  Result<std::vector<SweepCell>> cells = sweep_cells(*axes, request.scenario, !arguments.has("deadline-ms"));
  if (!cells) return cells.error();
  request.axes = std::move(*axes);
  request.cells = std::move(*cells);
  return {};
}

/// Refuses the source, and each option that is not in `goes_with`: the option `mode` would ignore it. `why`: what
/// `mode` does instead.
Result<void> refuse_beside(const program::Arguments& arguments, const std::string& mode, const std::string& why,
                           const std::set<std::string_view>& goes_with) {
  const auto refused = [&](const std::string& where) {
    return Error{.what = "cannot be combined with " + mode + ", " + why,
                 .where = where,
                 .fix = "leave out " + where + ", or leave out " + mode};
  };
  if (!arguments.positional().empty()) return refused(arguments.positional().front());
  for (const program::Option& option : usage().options) {
    const bool given =
        arguments.has(option.name) && (option.initial.empty() || arguments.text(option.name) != option.initial);
    if (given && !goes_with.contains(option.name)) return refused("--" + std::string(option.name));
  }
  return {};
}

Result<Request> read_journal(const program::Arguments& arguments) {
  if (const Result<void> alone =
          refuse_beside(arguments, "--journal", "which holds its own source and scene", {"journal", "out"});
      !alone)
    return alone.error();
  Request request;
  request.journal = arguments.text("journal");
  request.out = arguments.text("out");
  return request;
}

Result<void> read_storm(const program::Arguments& arguments, Request& request) {
  if (!arguments.has("storm")) return {};
  if (const Result<void> alone = refuse_beside(arguments, "--storm", "which draws source, network and faults at random",
                                               {"storm", "seed", "threads"});
      !alone)
    return alone;
  const Result<std::int64_t> seeds = arguments.whole("storm", 1, kMostSeeds);
  if (!seeds) return seeds.error();
  request.storm_seeds = static_cast<int>(*seeds);
  const Result<std::int64_t> first = arguments.whole("seed", 0, std::int64_t{1} << 53);
  if (!first) return first.error();
  request.scenario.seed = static_cast<std::uint64_t>(*first);
  return {};
}

Result<void> read_outputs(const program::Arguments& arguments, Request& request) {
  request.out = arguments.text("out");
  request.junit = arguments.text("junit");
  request.json = arguments.has("json");
  request.check = arguments.has("check");
  Result<std::vector<Assertion>> assertions = parse_assertions(arguments.text("assert"));
  if (!assertions) return assertions.error();
  request.assertions = std::move(*assertions);
  if (!request.junit.empty() && request.assertions.empty() && !arguments.has("baseline"))
    return Error{
        .what = "a JUnit report needs assertions", .where = "--junit", .fix = "give --assert or --baseline as well"};
  const std::filesystem::path folder = request.junit.has_parent_path() ? request.junit.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    return Error{.what = folder.string() + " is not a folder",
                 .where = "--junit",
                 .fix = "make this folder, or name a file in another folder"};
  return {};
}

Result<void> read_workers(const program::Arguments& arguments, Request& request) {
  if (!arguments.has("workers")) return {};
  if (!arguments.has("sweep"))
    return Error{.what = "only the runs of a sweep are shared out among workers",
                 .where = "--workers",
                 .fix = "add --sweep, such as --sweep delay=0:50:300, or leave out --workers"};
  Result<nats::Address> cluster = nats::parse_address(arguments.text("workers"), "--workers");
  if (!cluster) return cluster.error();
  request.workers = *std::move(cluster);
  return {};
}

}  // namespace

std::vector<std::string_view> names_of_run_options() {
  std::vector<std::string_view> names{"scene", "hand", "depth-mode", "seconds"};
  const std::vector<program::Option> network = network_options();
  for (const program::Option& option : network) names.push_back(option.name);
  return names;
}

program::Usage usage() {
  program::Usage usage{
      .program = "telepalp-replay",
      .purpose = "measures the effect of a simulated bad network on the force",
      .positional = "SESSION.mcap|FILE.oni|synthetic:MODEL|again:DIR",
      .options = {{"scene", "FILE|NAME", "file, or one of telepalp's own scenes", kDefaultScene}},
      .example = "telepalp-replay synthetic:torso,motion=irregular --delay-ms 80 --loss 5% --burst 4 --seconds 12",
      .commands = {{"diff", "", "print the first message in which two sessions differ", diff_command}}};
  for (const program::Option& option : network_options()) usage.options.push_back(option);
  usage.options.insert(usage.options.end(),
                       {{"hand", "HAND", "recorded, or a script: examine, tap, search or scene"},
                        {"depth-mode", "MODE", "depth codec: fast, intra, temporal or bounded", "fast"},
                        {"seconds", "S", "length; 0: whole recording, 20 s if simulated", "0"},
                        {"threads", "N", "0: one per core; no influence on the results", "0"},
                        {"sweep", "AXIS=… AXIS=…", "run all combinations: delay=0:50:300 loss=0,1,5%"},
                        {"workers", "nats://HOST", "telepalp-worker makes the runs of the sweep"},
                        {"storm", "SEEDS", "make this many random runs, and check each of them"},
                        {"journal", "FILE", "compute a live run again; fail if a force differs"},
                        {"check", "", "check force, energy and contact as --storm does"},
                        {"out", "DIR", "folder for sessions, reports, tables and heat maps"},
                        {"assert", "LIST", "METRIC<NUMBER,…; exit code 1 if any is false"},
                        {"baseline", "DIR[,LIST]", "exit code 1 if the run differs from DIR: docs/qa.md"},
                        {"junit", "FILE", "write the assertions as a JUnit report"},
                        {"json", "", "print report.json instead of the table"}});
  return usage;
}

Result<Request> read_request(const program::Arguments& arguments) {
  if (arguments.has("journal")) return read_journal(arguments);
  Request request;
  if (const Result<void> read = read_storm(arguments, request); !read) return read.error();
  if (request.storm_seeds) {
    if (const Result<void> read = read_length(arguments, request); !read) return read.error();
    return request;
  }
  if (const Result<void> read = read_source(arguments, request); !read) return read.error();
  if (const Result<void> read = read_outputs(arguments, request); !read) return read.error();
  if (const Result<void> read = read_baseline(arguments, request); !read) return read.error();
  if (const Result<void> read = read_workers(arguments, request); !read) return read.error();
  keep_options(arguments, request);
  const Result<Scenario> scenario = read_scenario(arguments);
  if (!scenario) return scenario.error();
  request.scenario = *scenario;
  request.scenario.hand = hand_script(arguments.text("hand")).value_or(HandScript::Examine);
  if (const Result<void> read = read_sweep(arguments, request); !read) return read.error();
  if (const Result<void> read = read_depth_mode(arguments, request); !read) return read.error();
  if (const Result<void> read = read_length(arguments, request); !read) return read.error();
  if (const Result<void> read = read_scene(arguments, request); !read) return read.error();
  if (const Result<void> read = read_hand(arguments, request); !read) return read.error();
  return request;
}

}  // namespace telepalp::replay
