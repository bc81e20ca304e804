#include "server/relay/relay_options.h"

namespace telepalp::relay {

std::vector<program::Option> relay_options() {
  return {{"publish", "URL", "publish for edges to NATS: nats://HOST/SITE; default: none"},
          {"relay-credentials", "FILE", "NATS credentials for --publish or nats:// sources"},
          {"relay-authority", "FILE", "authority's certificate of a tls:// cluster"}};
}

Result<RelayOptions> relay_options_of(const program::Arguments& arguments) {
  RelayOptions options{.publishes = {},
                       .shows = {},
                       .credentials = arguments.text("relay-credentials"),
                       .authority = arguments.text("relay-authority")};
  if (arguments.has("publish")) {
    const Result<RelayAddress> address = parse_relay(arguments.text("publish"), "--publish");
    if (!address) return address.error();
    options.publishes = *address;
  }
  if (is_relay(arguments.text("source"))) {
    const Result<RelayAddress> address = parse_relay(arguments.text("source"), "--source");
    if (!address) return address.error();
    options.shows = *address;
  }
  for (const char* option : {"relay-credentials", "relay-authority"})
    if (arguments.has(option) && !options.publishes && !options.shows)
      return Error{.what = "this option is for a cluster, and none is named",
                   .where = "--" + std::string(option),
                   .fix = "add --publish nats://HOST/SITE or --source nats://HOST/SITE, or leave the option out"};
  if (options.publishes && options.shows && options.publishes->site == options.shows->site)
    return Error{.what = "this edge would publish the site that it shows",
                 .where = "--publish",
                 .fix = "leave --publish out: the site's own server publishes it"};
  return options;
}

}  // namespace telepalp::relay
