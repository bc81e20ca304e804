#include "tests/bench/cluster/soak_site.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <ranges>
#include <thread>

#include "proto/keys/key_file.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using Clock = Watched::Clock;
using Side = TwoNetworks::Side;

constexpr auto kPatience = 60s;
constexpr std::uint16_t kEdgePort = 7500;
const std::string kPatient = TwoNetworks::kPatient;
const std::string kDoctor = TwoNetworks::kDoctor;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool await_words(const std::filesystem::path& log, const std::string& words) {
  for (const auto until = Clock::now() + kPatience; Clock::now() < until; std::this_thread::sleep_for(50ms))
    if (text_of(log).find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

Result<void> SoakSite::keys(const std::vector<std::string>& command) const {
  const std::filesystem::path log = scratch_ / "keys.log";
  std::vector<std::string> words = command;
  words.insert(words.end(), {"--dir", (scratch_ / "keys").string()});
  if (support::ChildProcess(TELEPALP_BINARY_DIR "/bin/telepalp-keys", words, log).wait(20s) == 0) return {};
  return Error{.what = "telepalp-keys failed: " + text_of(log), .where = log.string(), .fix = "see its message"};
}

/// The station dials the server through the link at the doctor's address, so the server's key names both.
Result<void> SoakSite::make_keys() const {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"authority", "--host", kPatient, "--host", kDoctor},
                                             {"server", "--host", kPatient, "--host", kDoctor},
                                             {"server", "--name", "edge", "--host", kDoctor},
                                             {"client", "--name", "doc", "--role", "doctor"},
                                             {"client", "--name", "rec", "--role", "technician"},
                                             {"client", "--name", "view", "--role", "viewer"}})
    if (Result<void> made = keys(command); !made) return made;
  return {};
}

Result<void> SoakSite::start(Side side, const std::string& name, const std::string& program,
                             const std::vector<std::string>& options, const std::string& ready) {
  const std::filesystem::path log = scratch_ / (name + ".log");
  programs_.push_back({name, networks_.start(side, program, options, log)});
  if (await_words(log, ready)) return {};
  return Error{.what = name + " did not start: " + text_of(log), .where = log.string(), .fix = "see its message"};
}

/// One link carries the station's session, the other the edge's connection to the NATS server.
Result<void> SoakSite::start_links() {
  const std::string program = TELEPALP_BINARY_DIR "/bin/telepalp-link";
  Result<void> began = start(
      Side::Doctor, "link", program,
      {"--listen", kDoctor + ":7401", "--connect", kPatient + ":7400", "--profile", "lte", "--quiet"}, "listens at");
  if (!began) return began;
  return start(
      Side::Doctor, "link_nats", program,
      {"--listen", kDoctor + ":4222", "--connect", kPatient + ":4222", "--profile", "lte", "--seed", "2", "--quiet"},
      "listens at");
}

Result<void> SoakSite::start_site() {
  const std::string programs = TELEPALP_BINARY_DIR "/bin/";
  Result<void> began =
      start(Side::Patient, "nats", "/usr/sbin/nats-server", {"-a", kPatient, "-p", "4222"}, "Server is ready");
  if (began)
    began = start(Side::Patient, "server", programs + "telepalp-server",
                  {"--source", "synthetic", "--depth-mode", "temporal", "--bind", kPatient, "--port", "7400", "--key",
                   key("server.key"), "--publish", "nats://" + kPatient + ":4222/soak"},
                  "listening on");
  if (began)
    began = start(Side::Patient, "recorder", programs + "telepalp-record",
                  {"--connect", kPatient + ":7400", "--key", key("rec.key"), "--consent", "a synthetic patient",
                   "--topics", "/station/*,/server/*", "--out", (scratch_ / "soak.mcap").string()},
                  "recording");
  if (began)
    began = start(Side::Doctor, "station", programs + "telepalp-station",
                  {"--connect", kDoctor + ":7401", "--key", key("doc.key"), "--control", "none", "--state-dir",
                   (scratch_ / "state").string()},
                  "the surface is touchable");
  return began;
}

Result<void> SoakSite::start_edge() {
  return start(
      Side::Doctor, "edge", TELEPALP_BINARY_DIR "/bin/telepalp-server",
      {"--source", "nats://" + kDoctor + ":4222/soak", "--bind", kDoctor, "--port", std::to_string(kEdgePort), "--key",
       key("edge.key"), "--revoked", key("revoked.crl"), "--audit", (scratch_ / "edge_audit.log").string()},
      "listening on");
}

Result<void> SoakSite::add_viewers() {
  const auto own = keys::load_client_key(key("view.key"), std::chrono::system_clock::now());
  if (!own) return own.error();
  viewers_ = std::make_unique<Viewers>(Viewers::Options{.host = kDoctor, .key = *own});
  for (std::size_t i = 0; i < kViewers; ++i) watched_.push_back(&viewers_->add(kEdgePort));
  if (viewers_->all_see()) return {};
  return Error{.what = "a viewer of the edge got no image",
               .where = (scratch_ / "edge.log").string(),
               .fix = "see the edge's messages: " + text_of(scratch_ / "edge.log")};
}

Result<std::unique_ptr<SoakSite>> SoakSite::begin(const TwoNetworks& networks, const std::filesystem::path& scratch) {
  std::unique_ptr<SoakSite> site(new SoakSite(networks, scratch));
  for (const auto step :
       {&SoakSite::start_links, &SoakSite::start_site, &SoakSite::start_edge, &SoakSite::add_viewers}) {
    if (site->programs_.empty())
      if (Result<void> made = site->make_keys(); !made) return made.error();
    if (Result<void> done = (site.get()->*step)(); !done) return done.error();
  }
  return site;
}

std::size_t SoakSite::run(double seconds) {
  std::vector<std::size_t> before;
  for (const Watched* viewer : watched_) before.push_back(viewer->arrived.size());
  viewers_->run_for(std::chrono::duration<double>(seconds));
  std::size_t saw = 0;
  blind_.clear();
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    if (watched_[i]->arrived.size() > before[i])
      ++saw;
    else
      blind_ = watched_[i]->news;
  }
  return saw;
}

Result<void> SoakSite::renew_and_restart_edge() {
  const std::string before = text_of(key("edge.key"));
  if (Result<void> renewed = keys({"renew", key("edge.key")}); !renewed) return renewed;
  if (text_of(key("edge.key")) == before)
    return Error{.what = "the key has not changed", .where = key("edge.key"), .fix = "run telepalp-keys renew"};
  const auto edge = std::ranges::find(programs_, "edge", &Program::name);
  edge->process->signal(SIGTERM);
  (void)edge->process->wait(10s);
  programs_.erase(edge);
  std::filesystem::rename(scratch_ / "edge.log", scratch_ / "edge_before.log");
  return start_edge();
}

double SoakSite::longest_gap_s() const {
  double longest_s = 0.0;
  for (const Watched* viewer : watched_)
    longest_s = std::max(longest_s, viewer->longest_gap_s(viewer->arrived.begin()->second, Clock::now()));
  return longest_s;
}

std::filesystem::path SoakSite::end() {
  viewers_.reset();
  watched_.clear();
  for (Program& program : programs_ | std::views::reverse) {
    program.process->signal(SIGINT);
    (void)program.process->wait(20s);
  }
  programs_.clear();
  return scratch_ / "soak.mcap";
}

}  // namespace telepalp::bench
