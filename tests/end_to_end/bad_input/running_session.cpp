#include "tests/end_to_end/bad_input/running_session.h"

#include <atomic>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "where.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;

const std::filesystem::path kPrograms = TELEPALP_BINARY_DIR "/bin";
constexpr double kMostServer_MiB = 200.0;
constexpr double kMostStation_MiB = 300.0;

double seconds_between(SteadyClock::time_point from, SteadyClock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

double longest_gap_s(const std::vector<SteadyClock::time_point>& at, SteadyClock::time_point from,
                     SteadyClock::time_point to) {
  double longest = 0.0;
  for (const auto& one : at) {
    longest = std::max(longest, seconds_between(from, one));
    from = one;
  }
  return std::max(longest, seconds_between(from, to));
}

}  // namespace

double most_resident_MiB(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool comes(const std::filesystem::path& file, const std::string& phrase, std::chrono::milliseconds patience) {
  const auto until = SteadyClock::now() + patience;
  while (text_of(file).find(phrase) == std::string::npos) {
    if (SteadyClock::now() > until) return false;
    std::this_thread::sleep_for(50ms);
  }
  return true;
}

/// Listens to the station on a thread of its own.
class RunningSession::Listener {
 public:
  Listener(std::uint16_t port, std::shared_ptr<const keys::KeyFile> key)
      : link_(io_,
              {.port = port,
               .name = "listener",
               .role = "qa",
               .key = std::move(key),
               .subscribes = {"/station/state", "/station/surface", "/server/stats"}},
              {.on_message = [this](const wire::Message& message) { hear(message); }}) {
    link_.start();
    thread_ = std::thread([this] {
      while (!ended_) io_.run_for(20ms);
    });
  }
  ~Listener() {
    ended_ = true;
    thread_.join();
  }
  [[nodiscard]] Felt since(SteadyClock::time_point from) {
    const std::lock_guard guard(mutex_);
    const auto now = SteadyClock::now();
    const auto later = [from](const auto& times) {
      return std::vector(std::lower_bound(times.begin(), times.end(), from), times.end());
    };
    const auto states = later(states_);
    const auto surfaces = later(surfaces_);
    return {.states = states.size(),
            .surfaces = surfaces.size(),
            .released = later(released_).size(),
            .faults = later(faults_).size(),
            .longest_without_state_s = longest_gap_s(states, from, now),
            .longest_without_surface_s = longest_gap_s(surfaces, from, now),
            .seconds = seconds_between(from, now)};
  }
  [[nodiscard]] msg::ServerStats::Datagrams datagrams() {
    const std::lock_guard guard(mutex_);
    return datagrams_;
  }
  [[nodiscard]] std::size_t felt_twice_since(SteadyClock::time_point from) {
    const std::lock_guard guard(mutex_);
    std::set<std::uint64_t> images;
    std::size_t twice = 0;
    for (const auto& [at, captured_ns] : captured_)
      if (at >= from && !images.insert(captured_ns).second) ++twice;
    return twice;
  }
  [[nodiscard]] bool has_heard(std::size_t surfaces) {
    const std::lock_guard guard(mutex_);
    return surfaces_.size() >= surfaces;
  }

 private:
  void hear(const wire::Message& message) {
    const std::lock_guard guard(mutex_);
    if (message.topic.name == wire::kServerStats.name) {
      msg::ServerStats stats;
      if (stats.ParseFromString(*message.payload)) datagrams_ = stats.datagrams();
    }
    if (message.topic.name == wire::kStationSurface.name) {
      surfaces_.push_back(SteadyClock::now());
      msg::SurfaceReport surface;
      if (surface.ParseFromString(*message.payload)) captured_.emplace_back(surfaces_.back(), surface.captured_ns());
    }
    if (message.topic.name != wire::kStationState.name) return;
    states_.push_back(SteadyClock::now());
    msg::StationState state;
    if (!state.ParseFromString(*message.payload)) return;
    if (state.phase() == msg::PHASE_FAULTED) faults_.push_back(SteadyClock::now());
    if (state.phase() == msg::PHASE_RELEASED) released_.push_back(SteadyClock::now());
  }

  boost::asio::io_context io_;
  std::mutex mutex_;
  std::vector<SteadyClock::time_point> states_;
  std::vector<SteadyClock::time_point> surfaces_;
  std::vector<std::pair<SteadyClock::time_point, std::uint64_t>> captured_;  // of each surface
  msg::ServerStats::Datagrams datagrams_;
  std::vector<SteadyClock::time_point> released_;
  std::vector<SteadyClock::time_point> faults_;
  wire::ClientLink link_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

RunningSession::RunningSession(const std::function<std::uint16_t(std::uint16_t)>& way,
                               const std::vector<std::string>& environment) {
  const auto start = [&](std::optional<support::ChildProcess>& child, const char* program,
                         const std::vector<std::string>& arguments) {
    std::vector<std::string> words = environment;  // env(1) sets them and becomes the program
    words.push_back((kPrograms / program).string());
    words.insert(words.end(), arguments.begin(), arguments.end());
    child.emplace("/usr/bin/env", words, file(std::string(program).substr(std::string("telepalp-").size()) + ".log"));
  };
  const std::filesystem::path key = ring_.server_key(ring_.now);
  start(server_, "telepalp-server",
        {"--source", "synthetic", "--port", "0", "--key", key.string(), "--ready-file", file("ready").string()});
  const auto port = support::await_ready(file("ready"), "port");
  if (!port) throw std::runtime_error("the server does not start: " + text_of(file("server.log")));
  port_ = static_cast<std::uint16_t>(std::stoi(*port));
  const auto anna = ring_.write(
      "anna.key", ring_.authority.client_key(
                      {.name = "anna", .role = keys::Role::Doctor, .now = ring_.now, .valid = std::chrono::days(1)}));
  start(station_, "telepalp-station",
        {"--connect", "127.0.0.1:" + std::to_string(way ? way(port_) : port_), "--key", anna.string(), "--control",
         file("control").string(), "--state-dir", file("state").string()});
  listener_ = std::make_unique<Listener>(port_, ring_.key("quentin", keys::Role::Qa));
  const auto hears = [this](std::size_t surfaces) {
    for (int tenth = 0; tenth < 300 && !listener_->has_heard(surfaces); ++tenth) std::this_thread::sleep_for(100ms);
    return listener_->has_heard(surfaces);
  };
  EXPECT_TRUE(hears(5)) << text_of(file("station.log"));
  const auto from = SteadyClock::now();
  std::this_thread::sleep_for(1s);
  EXPECT_TRUE(hears(30)) << text_of(file("station.log"));
  usual_ = listener_->since(from);
}

RunningSession::~RunningSession() = default;

msg::ServerStats::Datagrams RunningSession::datagrams() const { return listener_->datagrams(); }

std::size_t RunningSession::surfaces_felt_twice_since(SteadyClock::time_point from) const {
  return listener_->felt_twice_since(from);
}

Felt RunningSession::during(const std::function<void()>& attack) {
  const auto from = SteadyClock::now();
  attack();
  std::this_thread::sleep_for(1s);
  return listener_->since(from);
}

void RunningSession::expect_undisturbed_by(const std::function<void()>& attack) {
  const Felt felt = during(attack);
  const double usually =
      felt.seconds / usual_.seconds / 3.0;  // a busy machine has fewer states and surfaces even without an attack
  EXPECT_GT(static_cast<double>(felt.states), usually * static_cast<double>(usual_.states)) << "the station ticks";
  EXPECT_GT(static_cast<double>(felt.surfaces), usually * static_cast<double>(usual_.surfaces))
      << "images still become touchable";
  EXPECT_LT(felt.longest_without_state_s, 2.0);
  EXPECT_LT(felt.longest_without_surface_s, 2.0);
  EXPECT_EQ(felt.faults, 0u);
  EXPECT_LT(most_resident_MiB(server_->pid()), kMostServer_MiB);
  EXPECT_LT(most_resident_MiB(station_->pid()), kMostStation_MiB);
  EXPECT_GT(most_resident_MiB(server_->pid()), 0.0) << "the server is gone: " << text_of(file("server.log"));
}

}  // namespace telepalp::bad_input
