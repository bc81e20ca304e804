#include "tests/bench/site/two_networks.h"

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <cmath>

#include "proto/words/demand.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using support::ChildProcess;

constexpr const char* kDevice = "site";
constexpr const char* kLongestRun = "3600";  ///< a holder ends by itself then [s]

std::string in_words(const std::vector<std::string>& command) {
  std::string words;
  for (const std::string& word : command) words += (words.empty() ? "" : " ") + word;
  return words;
}

/// Runs a program that ends with the thread that starts it.
std::unique_ptr<ChildProcess> begin(std::vector<std::string> command, const std::filesystem::path& log) {
  std::vector<std::string> words{"--pdeathsig", "TERM", "--"};
  words.insert(words.end(), command.begin(), command.end());
  return std::make_unique<ChildProcess>("/usr/bin/setpriv", words, log);
}

Result<void> finish(const std::vector<std::string>& command) {
  const std::optional<int> code = begin(command, {})->wait(10s);
  if (code == 0) return {};
  return Error{.what = "'" + in_words(command) + "' failed",
               .where = "this kernel",
               .fix = "run as root where network namespaces, veth and tbf are allowed"};
}

std::string file_of_network(pid_t pid) { return "/proc/" + std::to_string(pid) + "/ns/net"; }

/// Waits until the holder is in a namespace of its own.
bool has_own_network(const ChildProcess& holder) {
  std::error_code ignored;
  const auto ours = std::filesystem::read_symlink(file_of_network(::getpid()), ignored);
  for (int i = 0; i < 200; ++i) {
    const auto its = std::filesystem::read_symlink(file_of_network(holder.pid()), ignored);
    if (!ignored && its != ours) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

}  // namespace

Result<std::unique_ptr<TwoNetworks>> TwoNetworks::make(const SiteLine& line) {
  std::unique_ptr<TwoNetworks> made(new TwoNetworks());
  for (auto& holder : made->holders_) {
    holder = begin({"/usr/bin/unshare", "-n", "/usr/bin/sleep", kLongestRun}, "/dev/null");
    if (!has_own_network(*holder))
      return Error{.what = "no network namespace could be made",
                   .where = "unshare -n",
                   .fix = "run as root, in a container with the capability CAP_SYS_ADMIN"};
  }
  if (Result<void> joined = made->join(line); !joined) return joined.error();
  return made;
}

Result<void> TwoNetworks::at(Side side, std::vector<std::string> command) const {
  command.insert(command.begin(), {"/usr/bin/nsenter", "-t", std::to_string(pid(side)), "-n"});
  return finish(command);
}

Result<void> TwoNetworks::join(const SiteLine& line) const {
  const std::string other = std::to_string(pid(Side::Doctor));
  Result<void> made =
      at(Side::Patient, {"ip", "link", "add", kDevice, "type", "veth", "peer", "name", kDevice, "netns", other});
  if (!made) return made;
  const auto limit_B = std::llround(line.Mbit_per_s * 1e6 / 8.0 * line.buffer_ms * 1e-3);
  const std::string rate = std::to_string(std::llround(line.Mbit_per_s * 1e3)) + "kbit";
  for (const Side side : {Side::Patient, Side::Doctor}) {
    const std::string address = std::string(side == Side::Patient ? kPatient : kDoctor) + "/24";
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"ip", "addr", "add", address, "dev", kDevice},
                                               {"ip", "link", "set", "lo", "up"},
                                               {"ip", "link", "set", kDevice, "up"},
                                               {"tc", "qdisc", "add", "dev", kDevice, "root", "tbf", "rate", rate,
                                                "burst", "32kb", "limit", std::to_string(limit_B)}})
      if (Result<void> done = at(side, command); !done) return done;
  }
  return {};
}

Result<void> TwoNetworks::set_joined(bool joined) const {
  return at(Side::Doctor, {"ip", "link", "set", kDevice, joined ? "up" : "down"});
}

Result<void> TwoNetworks::block_udp() const {
  for (const Side side : {Side::Patient, Side::Doctor})
    if (Result<void> done = at(side, {"ip", "rule", "add", "ipproto", "udp", "blackhole"}); !done) return done;
  return {};
}

std::unique_ptr<ChildProcess> TwoNetworks::start(Side side, const std::filesystem::path& program,
                                                 const std::vector<std::string>& arguments,
                                                 const std::filesystem::path& log) const {
  std::vector<std::string> command{"/usr/bin/nsenter", "-t", std::to_string(pid(side)), "-n", program.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return begin(command, log);
}

std::jthread TwoNetworks::run(Side side, std::function<void(std::stop_token)> work) const {
  return std::jthread([file = file_of_network(pid(side)), work = std::move(work)](const std::stop_token& stop) {
    const int network = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    demand(network >= 0 && ::setns(network, CLONE_NEWNET) == 0, "a thread can enter the site's network");
    ::close(network);
    work(stop);
  });
}

}  // namespace telepalp::bench
