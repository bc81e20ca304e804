// telepalp-worker: makes the runs of sweeps that telepalp-replay --sweep … --workers has put into a NATS cluster.

#include <unistd.h>

#include <array>
#include <cstdlib>

#include "proto/words/counted.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "tools/replay/commands/sweep_cells.h"
#include "tools/replay/workers/worker.h"

namespace {

using namespace telepalp;

program::Usage usage() {
  return {.program = "telepalp-worker",
          .purpose = "makes the runs of sweeps that telepalp-replay --workers puts into a NATS cluster",
          .positional = "",
          .options = {{"connect", "nats://HOST[:PORT]", "the cluster; also tls://, ?creds=FILE&ca=FILE"},
                      {"name", "NAME", "unique name in the sweep's log [host name and process number]"},
                      {"cache", "DIR", "folder for recordings [~/.cache/telepalp-worker]"},
                      {"cache-GB", "N", "room for recordings in this folder, in GB", "8"},
                      {"memory-MB", "N", "memory for the images of a sweep's source, in MB", "1024"},
                      {"idle-s", "S", "end after S s without a run; 0: never", "0"}},
          .example = "telepalp-worker --connect nats://127.0.0.1"};
}

std::string own_name() {
  std::array<char, 64> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) return "worker-" + std::to_string(::getpid());
  return std::string(host.data()) + "-" + std::to_string(::getpid());
}

/// The folder for recordings: --cache, or one in the user's cache folder (XDG, systemd's CACHE_DIRECTORY, or HOME).
Result<std::filesystem::path> cache_folder(const program::Arguments& arguments) {
  if (arguments.has("cache")) return std::filesystem::path(arguments.text("cache"));
  for (const auto& [variable, below] : {std::pair{"XDG_CACHE_HOME", ""}, {"CACHE_DIRECTORY", ""}, {"HOME", ".cache"}})
    if (const char* const folder = std::getenv(variable); folder != nullptr && *folder == '/')
      return std::filesystem::path(folder) / below / "telepalp-worker";
  return Error{.what = "there is no home folder", .where = "--cache", .fix = "give a folder for recordings"};
}

Result<replay::WorkerOptions> read_options(const program::Arguments& arguments) {
  if (!arguments.has("connect"))
    return Error{.what = "no cluster is named",
                 .where = "telepalp-worker",
                 .fix = "give --connect nats://HOST, the address that the sweep has as --workers"};
  Result<nats::Address> cluster = nats::parse_address(arguments.text("connect"), "--connect");
  if (!cluster) return cluster.error();
  Result<std::filesystem::path> cache = cache_folder(arguments);
  if (!cache) return cache.error();
  const Result<std::int64_t> cache_GB = arguments.whole("cache-GB", 1, 100'000);
  if (!cache_GB) return cache_GB.error();
  const Result<std::int64_t> memory_MB = arguments.whole("memory-MB", 0, 1'000'000);
  if (!memory_MB) return memory_MB.error();
  const Result<double> idle_s = arguments.number("idle-s", 0.0, 1e9);
  if (!idle_s) return idle_s.error();
  const std::string name = arguments.has("name") ? arguments.text("name").substr(0, 100) : own_name();
  return replay::WorkerOptions{.cluster = *std::move(cluster),
                               .name = name,
                               .cache = *std::move(cache),
                               .cache_B = static_cast<std::uint64_t>(*cache_GB) * 1'000'000'000U,
                               .memory_B = static_cast<std::size_t>(*memory_MB) * 1'000'000U,
                               .idle = std::chrono::duration<double>(*idle_s)};
}

int run(const program::Arguments& arguments) {
  const Result<replay::WorkerOptions> options = read_options(arguments);
  if (!options) return program::fail(options.error(), program::kAskedWrongly);
  const replay::StopOnSignal until_signalled;
  const Result<replay::WorkerCounts> counts = replay::run_worker(*options, replay::StopOnSignal::stopped());
  if (!counts) return program::fail(counts.error());
  program::log("telepalp-worker", "ends: " + counted(counts->finished, "run", "runs") + " finished, " +
                                      std::to_string(counts->given_back) + " given back, " +
                                      std::to_string(counts->refused) + " removed as bad");
  return program::kDone;
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run); }
