#include <cstdio>

#include "support/program/default_ports.h"
#include "support/program/options.h"
#include "tools/link_check/check.h"

namespace telepalp::link_check {
namespace {

program::Usage usage() {
  return {
      .program = "telepalp-link check",
      .purpose = "says in ten lines what the network between this computer and a server allows",
      .positional = {},
      .options = {{"connect", "SERVER", "HOST[:PORT], or SITE@HOST[:PORT]", program::kServerAddress},
                  {"web-port", "PORT", "port of the server's web page; SITE@HOST has the same", program::kViewerPort},
                  {"key", "FILE", "your key or token file, for a server on another machine"},
                  {"consent", "TEXT", "note on the patient's consent; with --key, images need it"},
                  {"seconds", "S", "how long to listen to images", "3"}},
      .example = "telepalp-link check --connect 127.0.0.1"};
}

Result<CheckOptions> options_of(const program::Arguments& arguments) {
  const Result<program::Address> server = program::parse_server(arguments.text("connect"), "--connect");
  if (!server) return server.error();
  const Result<std::int64_t> web_port = arguments.whole("web-port", 1, 65535);
  if (!web_port) return web_port.error();
  const Result<double> seconds = arguments.number("seconds", 0.1, 3600.0);
  if (!seconds) return seconds.error();
  return CheckOptions{.server = *server,
                      .web_port = server->site.empty() ? static_cast<std::uint16_t>(*web_port) : server->port,
                      .key = {},
                      .consent = arguments.text("consent"),
                      .listens_s = std::chrono::duration<double>(*seconds)};
}

int run(const program::Arguments& arguments) {
  Result<CheckOptions> options = options_of(arguments);
  if (!options) return program::fail(options.error(), program::kAskedWrongly);
  Result<std::shared_ptr<const keys::KeyFile>> key =
      keys::load_client_key(arguments.text("key"), std::chrono::system_clock::now());
  if (!key) return program::fail(key.error());
  options->key = std::move(key).value();
  const Findings found = check(*options);
  const int printed = program::print(in_lines(found));
  return carries_a_session(found) ? printed : program::kFailed;
}

}  // namespace

int check_command(int argc, const char* const* argv) { return program::run_program(usage(), argc, argv, run); }

}  // namespace telepalp::link_check
