#include <google/protobuf/text_format.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "haptic_station/device/trial.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/bill/scene_bill.h"
#include "messages/scene.pb.h"
#include "proto/words/numbers/quantile.h"
#include "support/program/text/text_format.h"
#include "tests/bench/users/body_session.h"
#include "tests/bench/users/sections.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using support::ChildProcess;

constexpr int kPairs = 5;
constexpr double kLeastOff = 0.5;  // % of a core
constexpr double kOff = 0.2;       // of the measured value

/// Processor time of a station's threads so far [ns], from the kernel's scheduler.
struct Spent {
  double surface_ns = 0.0;  ///< of the surface thread, the first that a station starts
  double others_ns = 0.0;
};

Spent spent_by(pid_t pid) {
  std::vector<std::pair<int, double>> threads;
  std::error_code code;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(pid) + "/task", code)) {
    double ns = 0.0;
    if (std::ifstream(thread.path() / "schedstat") >> ns)
      threads.emplace_back(std::atoi(thread.path().filename().c_str()), ns);
  }
  std::ranges::sort(threads);
  Spent spent;
  for (std::size_t i = 0; i < threads.size(); ++i) (i == 1 ? spent.surface_ns : spent.others_ns) += threads[i].second;
  return spent;
}

fs::path body_file(const UsersPlace& place) { return place.scratch / "body.mcap"; }

/// A server and the station that it serves, as real programs. The server serves the body that the bill is made of: what
/// an object inside costs depends on the skin above it.
class Site {
 public:
  Site(const UsersPlace& place, const fs::path& scene, const std::string& name) : folder_(place.scratch / name) {
    fs::create_directories(folder_);
    const fs::path ready = folder_ / "ready";
    fs::remove(ready);
    server_.emplace(place.programs / "telepalp-server",
                    std::vector<std::string>{"--port", "0", "--ready-file", ready.string(), "--source",
                                             "session:" + body_file(place).string()},
                    folder_ / "server.log");
    const auto port = support::await_ready(ready, "port");
    if (!port) return;
    fs::remove(log());
    station_.emplace(place.programs / "telepalp-station",
                     std::vector<std::string>{"--connect", "127.0.0.1:" + *port, "--scene", scene.string(), "--control",
                                              "none", "--state-dir", folder_.string()},
                     log());
  }

  /// Waits until the control loop runs and, if the scene `has_layers`, until their surfaces for viewers are made, once.
  [[nodiscard]] bool runs(bool has_layers) {
    for (int tenth = 0; station_ && tenth < 600; ++tenth, std::this_thread::sleep_for(100ms)) {
      const std::string text = said();
      if (text.find("control loop runs at 2 kHz") == std::string::npos) continue;
      if (!began_) began_ = std::chrono::steady_clock::now();
      if (!has_layers || text.find("inner surfaces for viewers are made") != std::string::npos) return true;
    }
    return false;
  }
  /// Since the control loop runs [s].
  [[nodiscard]] double ran_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_.value()).count();
  }
  [[nodiscard]] Spent spent() const { return spent_by(station_->pid()); }

  /// Ends the station. Returns the number of images of which it made a surface; 0: it touches a model.
  [[nodiscard]] double stop() {
    station_->signal(SIGINT);
    (void)station_->wait(10s);
    const std::string text = said();
    const std::size_t at = text.find(" images: their surfaces");
    return at == std::string::npos ? 0.0 : std::strtod(text.c_str() + text.rfind(' ', at - 1), nullptr);
  }

 private:
  [[nodiscard]] fs::path log() const { return folder_ / "station.log"; }
  [[nodiscard]] std::string said() const {
    std::ostringstream text;
    text << std::ifstream(log()).rdbuf();
    return text.str();
  }

  fs::path folder_;
  std::optional<ChildProcess> server_;
  std::optional<ChildProcess> station_;
  std::optional<std::chrono::steady_clock::time_point> began_;
};

/// Shares of a core [%] of two stations in the same seconds.
struct Shares {
  double with = 0.0;
  double without = 0.0;
};

/// Share of a core [%] of a station that keeps up with its camera, from what it spent in `seconds`. A station on a busy
/// computer drops images, so its surface thread's share is that of 30 images a second.
double share_of(Site& site, const Spent& before, const Spent& after, double seconds) {
  constexpr double kImages_per_s = 30.0;
  const double ran_s = site.ran_s();
  const double images = site.stop();
  const double dropped = images > 0.0 ? std::max(1.0, kImages_per_s * ran_s / images) : 1.0;
  const double surface_ns = dropped * (after.surface_ns - before.surface_ns);
  return 1e-7 * (surface_ns + after.others_ns - before.others_ns) / seconds;
}

/// Both stations run in the same seconds. `turned`: the other one is started first.
std::optional<Shares> measured_pair(const UsersPlace& place, const fs::path& with, const fs::path& without,
                                    bool has_layers, double window_s, bool turned) {
  std::optional<Site> sites[2];
  for (const int i : turned ? std::array{1, 0} : std::array{0, 1})
    sites[i].emplace(place, i == 0 ? with : without, i == 0 ? "with" : "without");
  if (!sites[0]->runs(has_layers) || !sites[1]->runs(false)) return std::nullopt;
  const Spent before[2] = {sites[0]->spent(), sites[1]->spent()};
  const auto start = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(window_s));
  const Spent after[2] = {sites[0]->spent(), sites[1]->spent()};
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return Shares{share_of(*sites[0], before[0], after[0], seconds), share_of(*sites[1], before[1], after[1], seconds)};
}

/// The scene with one effect, a skin without force, and without probe, as a file.
fs::path bare_file(const UsersPlace& place, const fs::path& file) {
  msg::Scene bare;
  (void)program::read_text_format(file, bare);  // the scene has been read from it
  bare.clear_effects();
  bare.add_effects()->mutable_skin()->set_alpha_n_per_m2(1.0);
  bare.clear_probe();
  if (bare.patient_surface().has_static_model()) {
    std::string& model = *bare.mutable_patient_surface()->mutable_static_model()->mutable_file();
    model = (file.parent_path() / model).string();
  }
  std::string text;
  google::protobuf::TextFormat::PrintToString(bare, &text);
  const fs::path made = place.scratch / ("bare." + file.filename().string());
  std::ofstream(made) << text;
  return made;
}

/// How far the bill is off, as a share of what it may be off: 20 % of the measured value or 0.5 % of a core, the
/// larger.
double off(double billed, double truth) {
  return std::abs(billed - truth) / std::max(kLeastOff, kOff * std::abs(truth));
}

/// A whole trial [s], so that it does not matter in which of its legs the measurement begins.
double window_of(const scenes::Scene& scene) {
  constexpr double kRecorded_s = 12.0;
  return scene.hand_trace ? kRecorded_s : device::duration_s(scene.trial);
}

Result<void> add_rows(const UsersPlace& place, const fs::path& file, std::vector<Row>& rows) {
  const Result<scenes::Scene> scene = scenes::read_scene(file);
  if (!scene) return scene.error();
  const fs::path bare = bare_file(place, file);
  const double window_s = window_of(*scene);
  std::vector<double> whole;
  std::vector<double> added;
  for (int pair = 0; pair < kPairs; ++pair) {
    const std::optional<Shares> shares =
        measured_pair(place, file, bare, !scene->layers().empty(), window_s, pair % 2 == 1);
    if (!shares)
      return Error{.what = "the station does not run its control loop within 60 s",
                   .where = file.string(),
                   .fix = "see the logs of the station and of its server"};
    whole.push_back(shares->with);
    added.push_back(shares->with - shares->without);
  }
  const Result<station::SceneBill> bill = station::bill_of(*scene, file, window_s, station::Detail::Together);
  if (!bill) return bill.error();
  const double billed = bill->share();
  const double billed_effects = bill->prices.back().total_share;
  const std::string name = "bill of " + scene->name;
  rows.push_back(measured(name + ": the station, measured", median_of(whole), "% of a core"));
  rows.push_back(measured(name + ": the station, billed", billed, "% of a core"));
  rows.push_back(measured(name + ": what its effects add, measured", median_of(added), "% of a core"));
  rows.push_back(measured(name + ": what its effects add, billed", billed_effects, "% of a core"));
  rows.push_back(at_most(name + ": error of the station's cost, over 20 % or 0.5 % of a core",
                         off(billed, median_of(whole)), "", 1.0));
  rows.push_back(at_most(name + ": error of what the effects add, over 20 % or 0.5 % of a core",
                         off(billed_effects, median_of(added)), "", 1.0));
  return {};
}

}  // namespace

Result<std::vector<Row>> run_bill_section(const UsersPlace& place) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(place.sources / "haptic_station/scenes"))
    if (entry.path().extension() == ".textproto") files.push_back(entry.path());
  std::ranges::sort(files);
  constexpr double kSession_s = 30.0;
  if (const Result<void> written = write_body_session(body_file(place), kSession_s); !written) return written.error();
  std::vector<Row> rows;
  for (const fs::path& file : files)
    if (const Result<void> done = add_rows(place, file, rows); !done) return done.error();
  return rows;
}

}  // namespace telepalp::bench
