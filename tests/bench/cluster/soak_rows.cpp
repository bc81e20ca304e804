#include "tests/bench/cluster/soak_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <thread>

#include "tests/bench/cluster/force_watch.h"
#include "tests/bench/cluster/soak_site.h"
#include "tests/bench/distribution.h"
#include "tests/bench/process_load.h"
#include "tests/bench/site/two_networks.h"

namespace telepalp::bench {
namespace {

constexpr double kLeastSoak_s = 60.0;
constexpr double kWarm_s = 15.0;                                          // until a program has made what it keeps
constexpr double kWindow_s = 10.0;                                        // memory is the median of so many seconds
constexpr SiteLine kSoakedLine{.Mbit_per_s = 1000.0, .buffer_ms = 30.0};  // the profile lte is telepalp-link's

/// What a program has.
struct Load {
  double MiB = 0.0;
  double descriptors = 0.0;
};
using Loads = std::map<std::string, Load>;

/// Of each program, the median of kWindow_s seconds.
Loads loads_of(SoakSite& site) {
  std::map<std::string, Distribution> MiB, open;
  for (int second = 0; second < static_cast<int>(kWindow_s); ++second) {
    (void)site.run(1.0);
    for (const SoakSite::Program& program : site.programs()) {
      MiB[program.name].add(resident_MiB(program.process->pid()));
      open[program.name].add(descriptors(program.process->pid()));
    }
  }
  Loads loads;
  for (const auto& [name, values] : MiB) loads[name] = {values.p50(), open.at(name).p50()};
  return loads;
}

/// The outcome of a soak, without the recording's.
struct Soaked {
  Loads before, after;                  ///< of the edge, `before` is after its restart
  double edge_descriptors_first = 0.0;  ///< of the edge that was ended
  std::size_t see_at_end = 0;
  double longest_gap_s = 0.0;
  double ran_s = 0.0;
  std::filesystem::path session;
};

Result<Soaked> soak(const TwoNetworks& networks, const std::filesystem::path& scratch, double seconds) {
  Result<std::unique_ptr<SoakSite>> begun = SoakSite::begin(networks, scratch);
  if (!begun) return begun.error();
  SoakSite& site = **begun;
  const auto began = Watched::Clock::now();
  Soaked soaked;
  (void)site.run(kWarm_s);
  soaked.before = loads_of(site);
  (void)site.run(std::max(0.0, seconds / 3.0 - kWarm_s - kWindow_s));
  if (Result<void> done = site.renew_and_restart_edge(); !done) return done.error();
  (void)site.run(kWarm_s);
  soaked.edge_descriptors_first = soaked.before.at("edge").descriptors;
  soaked.before.at("edge") = loads_of(site).at("edge");
  const auto ran_s = [&] { return std::chrono::duration<double>(Watched::Clock::now() - began).count(); };
  (void)site.run(std::max(0.0, seconds - kWindow_s - ran_s()));
  soaked.after = loads_of(site);
  soaked.see_at_end = site.run(2.0);
  if (!site.blind().empty())
    std::fprintf(stderr, "telepalp-bench cluster: soak: a viewer sees nothing: %s\n", site.blind().c_str());
  soaked.longest_gap_s = site.longest_gap_s();
  soaked.ran_s = ran_s();
  soaked.session = site.end();
  return soaked;
}

void add_loads(const Soaked& soaked, std::vector<Row>& rows) {
  double most_descriptors = soaked.after.at("edge").descriptors - soaked.edge_descriptors_first;
  for (const auto& [name, after] : soaked.after) {
    const Load& before = soaked.before.at(name);
    rows.push_back(at_most("soak: memory of " + name + ", change (" + std::to_string(std::lround(after.MiB)) + " MiB)",
                           100.0 * std::abs(after.MiB / before.MiB - 1.0), "%", 5.0));
    most_descriptors = std::max(most_descriptors, after.descriptors - before.descriptors);
  }
  rows.push_back(at_most("soak: descriptors more, of the program with most", most_descriptors, "", 0.0));
}

void add_force(const ForceFacts& force, std::vector<Row>& rows) {
  rows.push_back(at_most("soak: faults", static_cast<double>(force.faults), "", 0.0));
  rows.push_back(at_most("soak: rules that the force broke", force.violation ? 1.0 : 0.0, "", 0.0));
  rows.push_back(at_least(
      "soak: ticks judged, of those between the first and the last",
      100.0 * static_cast<double>(force.ticks) / std::max(1.0, static_cast<double>(force.ticks + force.missing)), "%",
      99.0));
  rows.push_back(at_least("soak: ticks in contact", static_cast<double>(force.touching), "", 1000.0));
  rows.push_back(measured("soak: largest force", force.most_N, "N"));
  if (force.violation) std::fprintf(stderr, "telepalp-bench cluster: soak: %s\n", in_words(*force.violation).c_str());
}

}  // namespace

Result<void> add_soak_rows(const std::filesystem::path& scratch, double seconds, std::vector<Row>& rows) {
  const auto networks = TwoNetworks::make(kSoakedLine);
  if (!networks) return networks.error();
  std::optional<Result<Soaked>> soaked;
  (*networks)
      ->run(TwoNetworks::Side::Doctor,
            [&](const std::stop_token&) { soaked.emplace(soak(**networks, scratch, std::max(seconds, kLeastSoak_s))); })
      .join();
  if (!*soaked) return soaked->error();
  const Result<ForceFacts> force = force_facts((*soaked)->session);
  if (!force) return force.error();
  rows.push_back(measured("soak: ran", (*soaked)->ran_s, "s"));
  add_loads(**soaked, rows);
  add_force(*force, rows);
  rows.push_back(at_least("soak: viewers of the restarted edge that see at the end, of 20",
                          static_cast<double>((*soaked)->see_at_end), "", double{SoakSite::kViewers}));
  rows.push_back(measured("soak: longest gap at a viewer, while the edge restarts", (*soaked)->longest_gap_s, "s"));
  return {};
}

}  // namespace telepalp::bench
