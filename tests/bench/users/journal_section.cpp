#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

#include "tests/bench/users/sections.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using support::ChildProcess;

constexpr std::array kSettings{"fast", "cloud", "paper"};

double from_environment(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atof(text);
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Threads that compete with the station for the processors.
class Load {
 public:
  Load() {
    for (std::thread& thread : threads_)
      thread = std::thread([this] {
        while (!stop_.load(std::memory_order_relaxed)) {
        }
      });
  }
  ~Load() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::atomic<bool> stop_{false};
  std::array<std::thread, 2> threads_;
};

/// Counts of all runs of one setting.
struct Differences {
  double ticks = 0.0;
  double force = 0.0;
  double phase = 0.0;
  double proxy = 0.0;
  double other_files = 0.0;  ///< runs whose forces, written as text, are not the same bytes
};

/// The number that follows `word` in a text.
double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? -1.0 : std::strtod(text.c_str() + at + word.size(), nullptr);
}

Result<void> record(const UsersPlace& place, const fs::path& folder, const char* setting, double seconds) {
  const fs::path ready = folder / "ready";
  ChildProcess server(place.programs / "telepalp-server", {"--port", "0", "--ready-file", ready.string()},
                      folder / "server.log");
  const auto port = support::await_ready(ready, "port");
  if (!port) return Error{.what = "telepalp-server does not start", .where = folder.string(), .fix = "see server.log"};
  const Load load;
  ChildProcess station(
      place.programs / "telepalp-station",
      {"--connect", "127.0.0.1:" + *port, "--surface", setting, "--control", "none", "--state-dir", folder.string(),
       "--seconds", std::to_string(seconds), "--patience", "600", "--journal", folder / "run.journal"},
      folder / "station.log");
  if (station.wait(std::chrono::milliseconds(static_cast<int>(1e3 * seconds) + 120'000)) == 0) return {};
  return Error{.what = "telepalp-station fails: " + text_of(folder / "station.log"), .where = setting, .fix = ""};
}

Result<void> compute_again(const UsersPlace& place, const fs::path& folder, Differences& sum) {
  ChildProcess replay("/bin/sh",
                      {"-c", "exec \"$0\" --journal \"$1\" --out \"$2\" > \"$3\"", place.programs / "telepalp-replay",
                       folder / "run.journal", folder / "forces", folder / "verdict"},
                      folder / "replay.log");
  (void)replay.wait(20min);
  const std::string verdict = text_of(folder / "verdict");
  std::fputs(verdict.c_str(), stderr);
  const double ticks = number_after(verdict, "replayed: ");
  if (ticks <= 0.0 || verdict.find("stopped: ") != std::string::npos)
    return Error{.what = "a journal is not replayed to its end: " + verdict + text_of(folder / "replay.log"),
                 .where = folder.string(),
                 .fix = ""};
  sum.ticks += ticks;
  sum.force += number_after(verdict, "\nforce ");
  sum.phase += number_after(verdict, "\nphase ");
  sum.proxy += number_after(verdict, "\nproxy ");
  if (text_of(folder / "forces/forces-live.csv") != text_of(folder / "forces/forces-replayed.csv")) ++sum.other_files;
  return {};
}

}  // namespace

Result<std::vector<Row>> run_journal_section(const UsersPlace& place) {
  const int runs = static_cast<int>(from_environment("TELEPALP_JOURNAL_RUNS", 10.0));
  const double seconds = from_environment("TELEPALP_JOURNAL_SECONDS", 60.0);
  std::map<std::string, Differences> all;
  for (int i = 0; i < runs; ++i) {
    const char* setting = kSettings[static_cast<std::size_t>(i) % kSettings.size()];
    const fs::path folder = place.scratch / ("run" + std::to_string(i));
    fs::create_directories(folder);
    if (const Result<void> kept = record(place, folder, setting, seconds); !kept) return kept.error();
    if (const Result<void> again = compute_again(place, folder, all[setting]); !again) return again.error();
    fs::remove_all(folder);
  }
  std::vector<Row> rows;
  for (const auto& [setting, sum] : all) {
    rows.push_back(measured("journal/" + setting + ": ticks", sum.ticks, ""));
    rows.push_back(at_most("journal/" + setting + ": forces that differ as doubles", sum.force, "", 0.0));
    rows.push_back(at_most("journal/" + setting + ": phases that differ", sum.phase, "", 0.0));
    rows.push_back(at_most("journal/" + setting + ": proxies that differ as doubles", sum.proxy, "", 0.0));
    rows.push_back(at_most("journal/" + setting + ": runs whose files of forces differ", sum.other_files, "", 0.0));
  }
  return rows;
}

}  // namespace telepalp::bench
