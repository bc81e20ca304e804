#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/bench/users/gate_defects.h"
#include "tests/bench/users/sections.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::chrono::minutes kPatience{5};

/// Exit code and output of a program.
struct GateRun {
  int code = -1;
  std::string said;
};

GateRun run(const UsersPlace& place, const std::string& program, Words words) {
  const fs::path log = place.scratch / "said";
  words.insert(words.begin(), {"-c", "exec \"$0\" \"$@\" >&2", program});
  support::ChildProcess process("/bin/sh", words, log);
  const std::optional<int> code = process.wait(kPatience);
  std::ifstream in(log);
  return {code.value_or(-1), {std::istreambuf_iterator<char>(in), {}}};
}

/// One defect: how it is planted, and a word that the first cause must have.
struct Defect {
  std::string name;
  std::string cause;
  Result<void> planted;
  std::string program;  ///< the gate
  Words words;
};

/// The first line after "Likely causes".
std::string first_cause(const std::string& said) {
  const std::size_t place = said.find("\n  1. ");
  return place == std::string::npos ? "" : said.substr(place + 1, said.find('\n', place + 1) - place - 1);
}

/// A session of the real programs, replays of it, and the defects.
class Gate {
 public:
  explicit Gate(const UsersPlace& place) : place_(place) {}

  Result<void> prepare();
  [[nodiscard]] std::vector<Defect> defects() const;
  [[nodiscard]] GateRun judged(const Defect& defect) const { return run(place_, defect.program, defect.words); }
  [[nodiscard]] Words replay_words(const Words& more) const;
  [[nodiscard]] std::string program(const char* name) const { return (place_.programs / name).string(); }
  [[nodiscard]] std::string in(const std::string& name) const { return (place_.scratch / name).string(); }

 private:
  [[nodiscard]] Defect replayed(std::string name, std::string cause, Result<void> planted, const Words& words) const {
    return {std::move(name), std::move(cause), std::move(planted), program("telepalp-replay"), replay_words(words)};
  }
  [[nodiscard]] Defect in_recording(const std::string& name, std::string cause, const char* file,
                                    Result<void> planted) const {
    return {name,
            std::move(cause),
            std::move(planted),
            program("telepalp-report"),
            {in("base"), in(file), "--assert", "same", "--out", in("compared")}};
  }
  [[nodiscard]] Defect in_source(std::string name, std::string cause, const char* file, Result<void> planted) const {
    return {std::move(name),
            std::move(cause),
            std::move(planted),
            program("telepalp-replay"),
            {in(file), "--profile", "lan", "--hand", "tap", "--baseline", in("base")}};
  }

  const UsersPlace& place_;
};

Words Gate::replay_words(const Words& more) const {
  Words words{in("live/session.mcap"), "--profile", "lan", "--hand", "tap"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Records eight seconds of server, station and recorder, and replays them as the baselines.
Result<void> Gate::prepare() {
  const GateRun live =
      run(place_, "/usr/bin/env",
          {"TELEPALP_BIN=" + place_.programs.string(), "bash", (place_.sources / "deploy/demo").string(), "--headless",
           "--seconds", "8", "--out", in("live")});
  if (live.code != 0)
    return Error{.what = "the demo failed:\n" + live.said, .where = "deploy/demo", .fix = "see above"};
  for (const auto& [folder, mode] : {std::pair{"base", "fast"}, {"bounded", "bounded"}}) {
    const GateRun base =
        run(place_, program("telepalp-replay"), replay_words({"--depth-mode", mode, "--out", in(folder)}));
    if (base.code != 0)
      return Error{.what = "no baseline:\n" + base.said, .where = "telepalp-replay", .fix = "see above"};
  }
  return {};
}

std::vector<Defect> Gate::defects() const {
  const fs::path scene = place_.sources / "haptic_station/scenes/palpation.scene.textproto";
  const fs::path live = in("live/session.mcap"), base = in("base/session.mcap");
  const Words against{"--baseline", in("base")};
  const auto with = [&](Words words) {
    words.insert(words.end(), against.begin(), against.end());
    return words;
  };
  return {
      replayed("stiffness + 10 %", "stiffness_N_per_m: 160",
               edit_scene(scene, in("stiff.textproto"), "stiffness_N_per_m: 160", "stiffness_N_per_m: 176"),
               with({"--scene", in("stiff.textproto")})),
      in_recording("force clipped", "clipped", "clipped.mcap", clip_forces(base, in("clipped.mcap"), 1.0)),
      in_recording("contact 2 mm late", "deeper", "late.mcap", begin_contacts_late(base, in("late.mcap"), 0.002)),
      in_source("31 % of images removed", "depth images", "removed.mcap",
                remove_images(live, in("removed.mcap"), 0.31)),
      in_source("depth scaled 1 %", "measure", "scaled.mcap", scale_depths(live, in("scaled.mcap"), 1.01)),
      replayed("depth at a bound", "depth coding", {}, with({"--depth-mode", "bounded"})),
      replayed("clock off 40 ms", "clock", {}, with({"--clock-step", "0s+3600s:40ms"})),
      in_source("intrinsics of another size", "depth camera", "camera.mcap", halve_intrinsics(live, in("camera.mcap"))),
      replayed("one effect off", "cylinder",
               edit_scene(scene, in("off.textproto"), "    stiffness_N_per_m: 800", "    stiffness_N_per_m: 0.001"),
               with({"--scene", in("off.textproto")})),
      replayed("fast for bounded", "depth coding", {}, {"--baseline", in("bounded")}),
      replayed("delay + 50 ms", "network", {}, with({"--delay-ms", "50.2"})),
      in_recording("a missing second", "lacks the ticks", "gap.mcap", remove_a_second(base, in("gap.mcap"))),
  };
}

}  // namespace

Result<std::vector<Row>> run_gate_section(const UsersPlace& place) {
  Gate gate(place);
  if (const Result<void> ready = gate.prepare(); !ready) return ready.error();
  int caught = 0, named = 0;
  for (const Defect& defect : gate.defects()) {
    if (!defect.planted) return defect.planted.error();
    const GateRun outcome = gate.judged(defect);
    const std::string cause = first_cause(outcome.said);
    const bool is_named = cause.find(defect.cause) != std::string::npos;
    caught += outcome.code == 1 ? 1 : 0;
    named += outcome.code == 1 && is_named ? 1 : 0;
    std::fprintf(stderr, "%s: exit %d, %s:%s\n", defect.name.c_str(), outcome.code,
                 is_named ? "named" : "cause not named", cause.empty() ? (" " + outcome.said).c_str() : cause.c_str());
  }
  int failed = 0;
  const Words again{"again:" + gate.in("base"), "--baseline", gate.in("base")};
  for (const GateRun& clean :
       {run(place, gate.program("telepalp-replay"), gate.replay_words({"--baseline", gate.in("base")})),
        run(place, gate.program("telepalp-replay"), again),
        run(place, gate.program("telepalp-report"),
            {gate.in("base"), gate.in("base"), "--assert", "same", "--out", gate.in("same")})}) {
    failed += clean.code == 0 ? 0 : 1;
    if (clean.code != 0) std::fprintf(stderr, "a clean pair: exit %d\n%s\n", clean.code, clean.said.c_str());
  }
  return std::vector<Row>{at_least("planted defects caught by a gate", caught, "of 12", 12),
                          at_least("planted defects whose cause is named first", named, "of 12", 10),
                          at_most("clean pairs that the gate refuses", failed, "of 3", 0)};
}

}  // namespace telepalp::bench
