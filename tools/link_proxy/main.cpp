// telepalp-link: a proxy for UDP and TCP that delays, loses, damages and limits what passes.
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdio>
#include <string>

#include "support/program/files/ready_file.h"
#include "support/program/log.h"
#include "tools/edge_plan/edges_command.h"
#include "tools/link_check/check.h"
#include "tools/link_proxy/link_options.h"

namespace {

using namespace telepalp;
using boost::system::error_code;

constexpr const char* kProgram = "telepalp-link";

/// Logs a line every second until the timer is cancelled.
void log_each_second(boost::asio::steady_timer& timer, link_proxy::LinkProxy& proxy) {
  timer.expires_after(std::chrono::seconds(1));
  timer.async_wait([&](const error_code& cancelled) {
    if (cancelled) return;
    program::log(kProgram, proxy.live_line());
    log_each_second(timer, proxy);
  });
}

int run(const program::Arguments& arguments, const link_proxy::ProxyOptions& options, double seconds) {
  boost::asio::io_context io(1);
  boost::asio::signal_set signals(io, SIGINT, SIGTERM);  // from now on, a signal waits until the proxy can say its end
  const auto started = link_proxy::LinkProxy::start(io, options);
  if (!started) return program::fail(started.error());
  link_proxy::LinkProxy& proxy = **started;
  const std::string port = std::to_string(proxy.port());
  program::log(kProgram, "listens at " + program::to_text({options.listen.host, proxy.port()}) + ", relays to " +
                             program::to_text(options.server));
  const Result<void> written = program::write_ready_file(arguments.text("ready-file"), "port=" + port + "\n");
  if (!written) return program::fail(written.error());

  boost::asio::steady_timer each_second(io);
  boost::asio::steady_timer end(io);
  std::string reason = "the time of --seconds is over";
  signals.async_wait([&](const error_code& cancelled, int) {
    if (cancelled) return;
    reason = "Ctrl-C or another program stopped it";
    io.stop();
  });
  if (seconds > 0.0) {
    end.expires_after(from_seconds(seconds));
    end.async_wait([&](const error_code& cancelled) {
      if (!cancelled) io.stop();
    });
  }
  if (!arguments.has("quiet")) log_each_second(each_second, proxy);
  io.run();
  proxy.stop();
  program::log(kProgram, "stopping: " + reason + "; the connections through it end" +
                             (arguments.has("json") ? "" : "; totals are printed only with --json"));
  if (arguments.has("json")) std::fputs(proxy.totals_json().c_str(), stdout);
  return program::kDone;
}

int run_asked(const program::Arguments& arguments) {
  const auto options = link_proxy::proxy_options(arguments);
  if (!options) return program::fail(options.error(), program::kAskedWrongly);
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e7);
  if (!seconds) return program::fail(seconds.error(), program::kAskedWrongly);
  return run(arguments, *options, *seconds);
}

program::Usage usage() {
  program::Usage usage = link_proxy::usage();
  usage.commands = {{"check", "", "say what the network to a server allows", link_check::check_command},
                    {"edges", "", "say how many edges a number of viewers needs", edge_plan::edges_command}};
  return usage;
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run_asked); }
