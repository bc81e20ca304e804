#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

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

/// Memory of `process` that is in RAM [MiB]; 0: it has ended.
[[nodiscard]] inline double resident_MiB(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

}  // namespace telepalp::bench
