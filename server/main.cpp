#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "server/command_line.h"
#include "server/parts.h"
#include "server/self_check.h"
#include "support/program/address.h"
#include "support/program/ending.h"
#include "support/program/files/ready_file.h"
#include "support/program/options.h"
#include "support/session_store/session_place.h"

namespace {

using namespace telepalp;
using server::Asked;
using server::Parts;

std::string ports_text(const Parts& parts) {
  std::string text = "port=" + std::to_string(parts.server->port()) + "\n";
  if (parts.gateway) text += "http_port=" + std::to_string(parts.gateway->port()) + "\n";
  if (parts.health) text += "health_port=" + std::to_string(parts.health->port()) + "\n";
  return text;
}

/// Ends a server once: on a signal, after a time, or when its source has ended.
class Ending {
 public:
  explicit Ending(Parts& parts) : parts_(parts), signals_(parts.io, SIGINT, SIGTERM), time_is_up_(parts.io) {
    signals_.async_wait([this](const boost::system::error_code& cancelled, int) {
      if (!cancelled) stop("Ctrl-C or another program stopped the server");
    });
  }

  void end_after(std::chrono::duration<double> time) {
    time_is_up_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(time));
    time_is_up_.async_wait([this](const boost::system::error_code& cancelled) {
      if (!cancelled) stop("the time of --seconds is over");
    });
  }

  void stop(const std::string& reason) {
    if (std::exchange(stopped_, true)) return;
    server::log_line("stopping: " + reason);
    boost::system::error_code ignored;
    signals_.cancel(ignored);  // not clear(): the handlers stay installed, so a second signal has no further effect
    program::end_within(program::kTimeToEnd,
                        "telepalp-server: the camera or another part did not stop within 5 s; the program ends without "
                        "closing the camera");
    time_is_up_.cancel();
    parts_.meet.reset();
    parts_.publisher.reset();
    parts_.health.reset();
    parts_.gateway.reset();
    parts_.voice.reset();
    parts_.recorder.reset();  // before the server ends, so that the recorder completes its file; it gets at most 3 s
    parts_.server->stop(reason);
  }

 private:
  Parts& parts_;
  boost::asio::signal_set signals_;
  boost::asio::steady_timer time_is_up_;
  bool stopped_ = false;
};

void begin(Parts& parts, const Asked& asked, std::function<void()> on_end) {
  parts.server->start(std::move(parts.origin), std::move(on_end));
  server::log_line("listening on " + program::to_text({asked.server.bind, parts.server->port()}) +
                   (asked.keys ? ", TLS with keys" : ""));
  asked.server.access->note_own(access::AuditEvent::Started, "port=" + std::to_string(parts.server->port()));
  if (parts.gateway) server::log_line("viewer at " + parts.gateway->url());
}

int run(Asked asked) {
  Parts parts;
  if (const Result<void> opened = server::open_parts(parts, asked); !opened) return program::fail(opened.error());
  Ending ending(parts);
  if (asked.seconds.count() > 0.0) ending.end_after(asked.seconds);
  begin(parts, asked, [&ending] { ending.stop("the source has ended"); });
  std::optional<Error> revoked;
  asked.server.access->on_revoked([&](const Error& why) {
    revoked = why;
    ending.stop(why.what);
  });
  const Result<void> written = program::write_ready_file(asked.ready_file, ports_text(parts));
  if (!written) return program::fail(written.error());
  parts.io.run();
  asked.server.access->note_own(access::AuditEvent::Stopped, {});
  server::log_line(parts.server->summary());
  return revoked ? program::fail(*revoked) : program::kDone;
}

int run_asked(const program::Arguments& arguments) {
  const Result<Asked> asked = server::read_asked(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  if (!arguments.has("check")) return run(*asked);
  const server::Findings found = server::self_check(*asked, std::chrono::system_clock::now());
  const int printed = program::print(server::in_lines(found));
  return server::has_problem(found) ? program::kFailed : printed;
}

}  // namespace

int main(int argc, char** argv) {
  program::say_when_stopped("telepalp-server: stopped before it listened; nothing was sent");
  session_store::use_cluster_sessions();
  return program::run_program(server::usage(), argc, argv, run_asked);
}
