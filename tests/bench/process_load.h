#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace telepalp::bench {

/// Processor time of `process` so far [s].
[[nodiscard]] inline double cpu_s(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(stat, line);
  std::istringstream after_name(line.substr(line.rfind(')') + 2));
  std::string skipped;
  for (int field = 0; field < 11; ++field) after_name >> skipped;
  double user = 0.0, system = 0.0;
  after_name >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Processor time of the threads of `process` that run now, to the nanosecond; cpu_s() counts in steps of 10 ms [s].
[[nodiscard]] inline double run_s(pid_t process) {
  std::error_code ended;
  double sum_ns = 0.0;
  for (std::filesystem::directory_iterator all("/proc/" + std::to_string(process) + "/task", ended), none;
       !ended && all != none; all.increment(ended)) {
    std::ifstream schedstat(all->path() / "schedstat");
    double ns = 0.0;
    if (schedstat >> ns) sum_ns += ns;
  }
  return 1e-9 * sum_ns;
}

/// Memory of `process` that is in RAM [MiB]; 0: it has ended.
[[nodiscard]] inline double resident_MiB(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

/// Files, sockets and other descriptors that `process` has open; 0: it has ended.
[[nodiscard]] inline double descriptors(pid_t process) {
  std::error_code ended;
  double count = 0.0;
  for (std::filesystem::directory_iterator all("/proc/" + std::to_string(process) + "/fd", ended), none;
       !ended && all != none; all.increment(ended))
    count += 1.0;
  return count;
}

}  // namespace telepalp::bench
