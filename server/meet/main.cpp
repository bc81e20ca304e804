// telepalp-meet: the meeting point that a patient's site and a doctor's site both dial, so that neither opens a
// firewall.
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "proto/words/counted.h"
#include "proto/words/time.h"
#include "server/access/revoked_file.h"
#include "server/meet/meet.h"
#include "support/program/address.h"
#include "support/program/default_ports.h"
#include "support/program/files/ready_file.h"
#include "support/program/log.h"
#include "support/program/options.h"

namespace {

using namespace telepalp;

constexpr const char* kProgram = "telepalp-meet";
constexpr std::string_view kRelayPort = "3478";  // RFC 8656 §17

void log_line(const std::string& text) { program::log(kProgram, text); }

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "joins doctors with patients' sites, where neither opens a firewall",
          .positional = {},
          .options = {{"key", "FILE", "this meeting point's key file: telepalp-keys server --host ITS-NAME"},
                      {"revoked", "FILE",
                       "list of revoked keys, read again when it changes; default: revoked.crl beside --key"},
                      {"bind", "ADDRESS", "address to listen on", "0.0.0.0"},
                      {"port", "PORT", "port for sites and callers; 0: any free one", program::kMeetPort},
                      {"relay", "HOST[:PORT]", "relay (TURN) for datagrams, as sites reach it; default: none"},
                      {"relay-secret", "FILE", "file with the secret that the relay has, too"},
                      {"seconds", "S", "stop after S seconds; 0: never", "0"},
                      {"ready-file", "FILE", "write the port to FILE once it listens; default: none"}},
          .example = "telepalp-meet --key keys/server.key --port 7443"};
}

/// The list of revoked keys, whose file is looked at again at most once a second.
class LookedAtEachSecond {
 public:
  explicit LookedAtEachSecond(access::RevokedFile file) : file_(std::move(file)) {}

  bool contains(const std::string& serial) {
    const auto now = std::chrono::steady_clock::now();
    if (now - looked_ >= std::chrono::seconds(1)) {
      looked_ = now;
      read_if_changed();
    }
    return file_.list().contains(serial);
  }

 private:
  void read_if_changed() {
    if (!file_.has_changed()) return;
    const Result<void> read = file_.read();
    std::string problem = read ? std::string() : to_string(read.error());
    if (!problem.empty() && problem != said_) log_line("the last good list of revoked keys holds: " + problem);
    said_ = std::move(problem);
  }

  access::RevokedFile file_;
  std::string said_;  // of the last look; a missing file is said once, and not each second
  std::chrono::steady_clock::time_point looked_{};
};

struct Asked {
  meet::Meet::Options meet;  ///< without keys, which read_keys() adds
  std::filesystem::path ready_file;
  double seconds = 0.0;
};

Result<Asked> asked_of(const program::Arguments& arguments) {
  if (!arguments.has("key"))
    return Error{.what = "no key is given",
                 .where = "--key",
                 .fix =
                     "telepalp-keys authority --host ITS-NAME && telepalp-keys server --host ITS-NAME, then --key "
                     "keys/server.key"};
  const Result<std::int64_t> port = arguments.whole("port", 0, 65535);
  if (!port) return port.error();
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e7);
  if (!seconds) return seconds.error();
  Asked asked{.meet = {}, .ready_file = arguments.text("ready-file"), .seconds = *seconds};
  asked.meet.address = arguments.text("bind");
  asked.meet.port = static_cast<std::uint16_t>(*port);
  asked.meet.log = log_line;
  return asked;
}

/// Reads the key and the list of revoked keys, by which sites may join.
Result<void> read_keys(const program::Arguments& arguments, meet::Meet::Options& options) {
  const std::filesystem::path file = arguments.text("key");
  Result<keys::KeyFile> key = keys::load_key(file, std::chrono::system_clock::now());
  if (!key) return key.error();
  if (key->kind != keys::KeyFile::Kind::Server)
    return Error{
        .what = "this is not a server's key", .where = file.string(), .fix = "telepalp-keys server --host ITS-NAME"};
  const std::filesystem::path beside = key->path.parent_path() / "revoked.crl";
  access::RevokedFile revoked(arguments.has("revoked") ? std::filesystem::path(arguments.text("revoked")) : beside,
                              key->authority);
  if (const Result<void> read = revoked.read(); !read) return read.error();
  options.key = std::move(key).value();
  options.is_revoked = [look = LookedAtEachSecond(std::move(revoked))](const keys::Identity& who) mutable {
    return look.contains(who.serial);
  };
  return {};
}

/// Looks up the relay, if there is one.
Result<void> find_relay(const program::Arguments& arguments, meet::Meet::Options& options) {
  if (arguments.has("relay") != arguments.has("relay-secret"))
    return Error{.what = "--relay and --relay-secret belong together",
                 .where = arguments.has("relay") ? "--relay" : "--relay-secret",
                 .fix = "give both, or neither"};
  if (!arguments.has("relay")) return {};
  const Result<program::Address> at = program::parse_address(arguments.text("relay"), "--relay", kRelayPort);
  if (!at) return at.error();
  Result<meet::RelayDoor> door = meet::relay_door(at->host, at->port, arguments.text("relay-secret"));
  if (!door) return door.error();
  options.relay = std::move(door).value();
  return {};
}

int run(const program::Arguments& arguments) {
  Result<Asked> asked = asked_of(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  if (const Result<void> read = read_keys(arguments, asked->meet); !read) return program::fail(read.error());
  if (const Result<void> found = find_relay(arguments, asked->meet); !found) return program::fail(found.error());
  boost::asio::io_context io(1);
  boost::asio::signal_set signals(io, SIGINT, SIGTERM);
  auto meeting = meet::Meet::listen(io, asked->meet);
  if (!meeting) return program::fail(meeting.error());
  meet::Meet& meet = **meeting;
  log_line("listening on " + program::to_text({asked->meet.address, meet.port()}));
  if (const Result<void> written =
          program::write_ready_file(asked->ready_file, "port=" + std::to_string(meet.port()) + "\n");
      !written)
    return program::fail(written.error());
  signals.async_wait([&io](const boost::system::error_code& cancelled, int) {
    if (!cancelled) io.stop();
  });
  boost::asio::steady_timer end(io);
  if (asked->seconds > 0.0) {
    end.expires_after(from_seconds(asked->seconds));
    end.async_wait([&io](const boost::system::error_code& cancelled) {
      if (!cancelled) io.stop();
    });
  }
  io.run();
  log_line("stopping: " + counted(meet.counts().calls, "caller was", "callers were") + " joined with a site, " +
           counted(meet.counts().refused, "was", "were") + " refused");
  return program::kDone;
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run); }
