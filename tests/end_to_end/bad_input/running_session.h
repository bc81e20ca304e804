#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "messages/station.pb.h"
#include "tests/server/keyed_site.h"
#include "tests/support/child_process.h"

namespace telepalp::bad_input {

using SteadyClock = std::chrono::steady_clock;

/// Most memory that a process ever held, in MiB; 0 if it is gone.
[[nodiscard]] double most_resident_MiB(pid_t process);
[[nodiscard]] std::string text_of(const std::filesystem::path& file);
/// True if `file` has `phrase` within `patience`.
[[nodiscard]] bool comes(const std::filesystem::path& file, const std::string& phrase,
                         std::chrono::milliseconds patience = std::chrono::seconds(8));

/// The messages that a doctor's station published during an attack.
struct Felt {
  std::size_t states = 0;    ///< of /station/state, published at 100 Hz
  std::size_t surfaces = 0;  ///< of /station/surface, one for each depth image that became touchable
  std::size_t released = 0;  ///< states in the phase Released: no force
  std::size_t faults = 0;    ///< states in the phase Faulted
  double longest_without_state_s = 0.0;
  double longest_without_surface_s = 0.0;
  double seconds = 0.0;
};

/// telepalp-server with keys, and telepalp-station as the doctor anna; both are the real programs on loopback. A member
/// of QA listens in this process.
class RunningSession {
 public:
  /// The station connects to the port that `way` returns for the server's port; without `way`, to the server's.
  /// `environment`: NAME=VALUE of both programs.
  explicit RunningSession(const std::function<std::uint16_t(std::uint16_t)>& way = {},
                          const std::vector<std::string>& environment = {});
  ~RunningSession();
  RunningSession(const RunningSession&) = delete;
  RunningSession& operator=(const RunningSession&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  [[nodiscard]] const server::KeyRing& ring() const noexcept { return ring_; }
  [[nodiscard]] support::ChildProcess& server() { return *server_; }
  [[nodiscard]] support::ChildProcess& station() { return *station_; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return ring_.folder.path() / name; }
  [[nodiscard]] std::string audit() const { return text_of(file("audit.log")); }

  /// What the server counted of datagrams, in its newest statistics.
  [[nodiscard]] msg::ServerStats::Datagrams datagrams() const;
  /// Number of images that became touchable more than once.
  [[nodiscard]] std::size_t surfaces_felt_twice_since(SteadyClock::time_point from) const;

  /// The station's messages during `attack`, which runs on this thread, and for a second after it.
  [[nodiscard]] Felt during(const std::function<void()>& attack);
  /// Runs `attack` like during(), and expects at least a third of the states and surfaces that come without an attack
  /// on this machine, no gap of 2 s, and bounded memory.
  void expect_undisturbed_by(const std::function<void()>& attack);

 private:
  class Listener;
  server::KeyRing ring_;
  std::uint16_t port_ = 0;
  std::optional<support::ChildProcess> server_;
  std::optional<support::ChildProcess> station_;
  std::unique_ptr<Listener> listener_;
  Felt usual_;  // without an attack
};

/// One T for all tests of a program: it is made when the first test asks for it, and ends after the last test.
template <class T>
class SharedByTests : public ::testing::Environment {
 public:
  static T& get() {
    static auto* const self = new SharedByTests;  // owned by GoogleTest
    static const auto* const registered = ::testing::AddGlobalTestEnvironment(self);
    if (registered != nullptr && !self->made_) self->made_ = std::make_unique<T>();
    return *self->made_;
  }
  void TearDown() override { made_.reset(); }

 private:
  std::unique_ptr<T> made_;
};

}  // namespace telepalp::bad_input
