#include "tools/link_proxy/link_options.h"

#include "proto/impaired/profiles.h"
#include "support/program/default_ports.h"

namespace telepalp::link_proxy {
namespace {

/// An option that sets one figure of both directions.
struct Figure {
  program::Option option;
  double most;
  void (*set)(impaired::Impairment& impairment, double value);
};

const std::vector<Figure>& figures() {
  using impaired::Impairment;
  static const std::vector<Figure> all{
      {{"delay-ms", "MS", "delay in each direction"},
       60e3,
       [](Impairment& i, double v) { i.delay = from_seconds(v * 1e-3); }},
      {{"jitter-ms", "MS", "uniform variation of the delay, plus or minus MS"},
       60e3,
       [](Impairment& i, double v) { i.jitter = from_seconds(v * 1e-3); }},
      {{"loss-percent", "P", "share of the packets that is lost"},
       100,
       [](Impairment& i, double v) { i.loss = v * 1e-2; }},
      {{"burst-packets", "N", "mean length of a loss burst"},
       1e4,
       [](Impairment& i, double v) { i.burst_packets = v; }},
      {{"reorder-percent", "P", "share of the packets that is reordered"},
       100,
       [](Impairment& i, double v) { i.reorder = v * 1e-2; }},
      {{"duplicate-percent", "P", "share of the packets that arrives twice"},
       100,
       [](Impairment& i, double v) { i.duplicate = v * 1e-2; }},
      {{"corrupt-percent", "P", "share of the packets with one inverted bit"},
       100,
       [](Impairment& i, double v) { i.corrupt = v * 1e-2; }},
      {{"rate-kbit-per-s", "R", "rate of the bottleneck; 0: unlimited"},
       1e7,
       [](Impairment& i, double v) { i.rate_B_per_s = v * 125.0; }},
      {{"queue-kilobytes", "KB", "size of the queue before the bottleneck"},
       1e6,
       [](Impairment& i, double v) { i.queue_B = static_cast<std::size_t>(v * 1e3); }},
      {{"outage-s", "S", "length of an outage"}, 3600, [](Impairment& i, double v) { i.outage_for = from_seconds(v); }},
      {{"outage-every-s", "S", "period of the outages; 0: none"},
       86400,
       [](Impairment& i, double v) { i.outage_every = from_seconds(v); }},
  };
  return all;
}

Result<void> apply_profile(const program::Arguments& arguments, ProxyOptions& options) {
  if (arguments.has("profile")) {
    const Result<impaired::Profile> profile = impaired::profile_named(arguments.text("profile"));
    if (!profile) return profile.error();
    options.down = profile->down;
    options.up = profile->up;
  }
  if (!arguments.has("trace")) return {};
  Result<impaired::Trace> trace = impaired::read_trace(arguments.text("trace"));
  if (!trace) return trace.error();
  options.trace = *std::move(trace);
  return {};
}

Result<void> apply_figures(const program::Arguments& arguments, ProxyOptions& options) {
  for (const Figure& figure : figures()) {
    if (!arguments.has(figure.option.name)) continue;
    const Result<double> value = arguments.number(figure.option.name, 0.0, figure.most);
    if (!value) return value.error();
    figure.set(options.down, *value);
    figure.set(options.up, *value);
  }
  return {};
}

/// `--listen` may name port 0, which parse_address refuses.
Result<program::Address> listen_address(const std::string& text) {
  const bool any_port = text.ends_with(":0");
  Result<program::Address> address =
      program::parse_address(any_port ? text.substr(0, text.size() - 1) + "1" : text, "--listen");
  if (address && any_port) address->port = 0;
  return address;
}

}  // namespace

program::Usage usage() {
  program::Usage usage{
      .program = "telepalp-link",
      .purpose = "relays between clients and a server, and impairs the network between them",
      .positional = {},
      .options = {{"listen", "HOST:PORT", "where clients connect (TCP and UDP); port 0: any free", "127.0.0.1:7401"},
                  {"connect", "HOST:PORT", "the server to relay to", program::kServerAddress},
                  {"profile", "NAME", "a network by name: lan, lte, satellite or hostile"},
                  {"trace", "FILE.csv", "CSV of delay, jitter, loss and rate over time"},
                  {"seed", "N", "seed of the random numbers", "1"},
                  {"seconds", "S", "stop after S seconds; 0: until Ctrl-C", "0"},
                  {"json", "", "at the end, print all counters to stdout"},
                  {"quiet", "", "do not print statistics each second"},
                  {"ready-file", "FILE", "write the port to FILE once clients can connect"}},
      .example = "telepalp-link --profile lte --seconds 60"};
  for (const Figure& figure : figures()) usage.options.push_back(figure.option);
  return usage;
}

Result<ProxyOptions> proxy_options(const program::Arguments& arguments) {
  ProxyOptions options;
  const Result<program::Address> listen = listen_address(arguments.text("listen"));
  if (!listen) return listen.error();
  const Result<program::Address> server = program::parse_address(arguments.text("connect"), "--connect");
  if (!server) return server.error();
  if (listen->port == server->port && listen->host == server->host)
    return Error{.what = "is also the address of --listen, so that the proxy would relay to itself",
                 .where = "--connect " + program::to_text(*server),
                 .fix = "give the server's address, or another port for --listen"};
  const Result<std::int64_t> seed = arguments.whole("seed", 0, std::int64_t{1} << 53);
  if (!seed) return seed.error();
  options.listen = *listen;
  options.server = *server;
  options.seed = static_cast<std::uint64_t>(*seed);
  if (const Result<void> applied = apply_profile(arguments, options); !applied) return applied.error();
  if (const Result<void> applied = apply_figures(arguments, options); !applied) return applied.error();
  return options;
}

}  // namespace telepalp::link_proxy
