#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "proto/words/result.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {

/// The line between two sites, equal in both directions.
struct SiteLine {
  double Mbit_per_s = 40.0;
  double buffer_ms = 30.0;  ///< the queue's length in time; what does not fit is dropped
};

/// Two network namespaces, of a patient's site (10.9.0.1) and of a doctor (10.9.0.2), joined by a pair of virtual
/// Ethernet devices with the kernel's tbf queue at each end. They have no name and end with the processes in them,
/// which end with this process, also when it is killed.
class TwoNetworks {
 public:
  enum class Side { Patient, Doctor };
  static constexpr const char* kPatient = "10.9.0.1";
  static constexpr const char* kDoctor = "10.9.0.2";

  /// Error: this process may not make namespaces, or the kernel lacks veth or tbf.
  [[nodiscard]] static Result<std::unique_ptr<TwoNetworks>> make(const SiteLine& line);

  /// Starts a program at a site; stdout and stderr go to `log`.
  [[nodiscard]] std::unique_ptr<support::ChildProcess> start(Side side, const std::filesystem::path& program,
                                                             const std::vector<std::string>& arguments,
                                                             const std::filesystem::path& log) const;
  /// Runs `work` in a new thread whose sockets belong to the site.
  [[nodiscard]] std::jthread run(Side side, std::function<void(std::stop_token)> work) const;

  /// Takes the line down, or up again: no packet crosses it meanwhile, and nobody is told.
  [[nodiscard]] Result<void> set_joined(bool joined) const;

  /// From now on, no UDP datagram leaves either site. Error: the kernel has no routing rules by protocol.
  [[nodiscard]] Result<void> block_udp() const;

 private:
  TwoNetworks() = default;
  [[nodiscard]] Result<void> join(const SiteLine& line) const;
  [[nodiscard]] pid_t pid(Side side) const noexcept { return holders_[side == Side::Patient ? 0 : 1]->pid(); }
  [[nodiscard]] Result<void> at(Side side, std::vector<std::string> command) const;

  std::array<std::unique_ptr<support::ChildProcess>, 2> holders_;  ///< a sleeping process in each namespace
};

}  // namespace telepalp::bench
