// Many sites at one meeting point: the real telepalp-meet, and a thousand sites that wait for callers.
#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "proto/keys/authority.h"
#include "server/meet/site/meet_dialer.h"
#include "tests/bench/choice.h"
#include "tests/bench/process_load.h"
#include "tests/bench/site/section.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kSites = 1000;
constexpr auto kIdle = 20s;
constexpr auto kLongest = 60s;  // until all have joined

Result<fs::path> written(const fs::path& file, const Result<std::string>& text) {
  if (!text) return text.error();
  std::ofstream(file) << *text;
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  return file;
}

/// The sites, each with a key of its own, on one thread.
class Sites {
 public:
  Sites(const keys::Authority& authority, keys::WallTime now) : authority_(authority), now_(now) {}

  Result<void> dial(std::uint16_t port) {
    for (std::size_t site = 0; site < kSites; ++site) {
      const std::string name = "site" + std::to_string(site);
      const Result<std::string> text =
          authority_.server_key({.name = name, .now = now_, .valid = std::chrono::days(1)}, {name});
      if (!text) return text.error();
      Result<keys::KeyFile> key = keys::read_key(*text, name);
      if (!key) return key.error();
      auto started = meet::MeetDialer::start(io_, {.host = "127.0.0.1",
                                                   .port = port,
                                                   .key = std::make_shared<const keys::KeyFile>(std::move(key).value()),
                                                   .on_caller = [](boost::asio::ip::tcp::socket, const auto&) {}});
      if (!started) return started.error();
      dialers_.push_back(std::move(started).value());
    }
    return {};
  }

  /// How long it takes until `count` sites are joined [s]; infinite: kLongest was not enough.
  double time_until(std::size_t count) {
    const auto begin = Clock::now();
    while (Clock::now() - begin < kLongest) {
      io_.run_for(20ms);
      if (joined() == count) return std::chrono::duration<double>(Clock::now() - begin).count();
    }
    return std::numeric_limits<double>::infinity();
  }
  void run_for(std::chrono::seconds time) { io_.run_for(time); }
  [[nodiscard]] std::size_t joined() const {
    return static_cast<std::size_t>(std::ranges::count_if(dialers_, [](const auto& one) { return one->has_joined(); }));
  }

 private:
  const keys::Authority& authority_;
  keys::WallTime now_;
  boost::asio::io_context io_;
  std::vector<std::unique_ptr<meet::MeetDialer>> dialers_;
};

}  // namespace

Result<SiteRows> run_meeting_section(const SitePlace& place) {
  if (!contains_one_of("meeting point", place.wanted)) return SiteRows{};
  const keys::WallTime now = std::chrono::system_clock::now();
  Result<keys::Authority> authority = keys::Authority::create("bench", now, std::chrono::days(1));
  if (!authority) return authority.error();
  const Result<fs::path> key =
      written(place.scratch / "meet.key",
              authority->server_key({.name = "meet", .now = now, .valid = std::chrono::days(1)}, {"127.0.0.1"}));
  if (!key) return key.error();
  if (const auto list = written(place.scratch / "revoked.crl", authority->revocation_list({}, now, 1)); !list)
    return list.error();
  const fs::path ready = place.scratch / "ready";
  std::string port = "0";
  const auto start = [&] {
    fs::remove(ready);
    return std::make_unique<support::ChildProcess>(
        place.programs / "telepalp-meet",
        std::vector<std::string>{"--key", key->string(), "--bind", "127.0.0.1", "--port", port, "--ready-file",
                                 ready.string()},
        place.scratch / "meet.log");
  };
  auto meeting = start();
  const std::optional<std::string> at = support::await_ready(ready, "port");
  if (!at) {
    std::ifstream log(place.scratch / "meet.log");
    return Error{.what = "telepalp-meet did not start: " + std::string(std::istreambuf_iterator<char>(log), {}),
                 .where = "telepalp-bench site",
                 .fix = "see its message"};
  }
  port = *at;

  Sites sites(*authority, now);
  if (const Result<void> dialled = sites.dial(static_cast<std::uint16_t>(std::stoi(port))); !dialled)
    return dialled.error();
  const double all_in_s = sites.time_until(kSites);
  const double before_s = cpu_s(meeting->pid());
  sites.run_for(kIdle);
  const double idle_share = (cpu_s(meeting->pid()) - before_s) / std::chrono::duration<double>(kIdle).count();
  const double memory = resident_MiB(meeting->pid());
  const bool stayed = sites.joined() == kSites;

  meeting->signal(SIGKILL);
  (void)meeting->wait(5s);
  meeting = start();
  (void)sites.time_until(0);
  const double back_s = sites.time_until(kSites);

  const std::string who = "meeting point, 1000 idle sites: ";
  SiteRows rows;
  rows.rows = {
      measured(who + "all joined within", all_in_s, "s"),
      at_least(who + "still there after 20 s", stayed ? 1000.0 : static_cast<double>(sites.joined()), "sites", 1000.0),
      at_most(who + "memory", memory, "MiB", 64.0), at_most(who + "processor", 100.0 * idle_share, "% of a core", 1.0),
      at_most(who + "killed and started: all back within", back_s, "s", 10.0)};
  return rows;
}

}  // namespace telepalp::bench
