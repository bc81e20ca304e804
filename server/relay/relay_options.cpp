#include "server/relay/relay_options.h"

namespace telepalp::relay {

Result<RelayOptions> relay_options_of(const program::Arguments& arguments) {
  RelayOptions options;
  if (arguments.has("publish")) {
    const Result<RelayAddress> address = parse_relay(arguments.text("publish"), "--publish");
    if (!address) return address.error();
    options.publishes = *address;
  }
  if (nats::is_address(arguments.text("source"))) {
    const Result<RelayAddress> address = parse_relay(arguments.text("source"), "--source");
    if (!address) return address.error();
    options.shows = *address;
  }
  if (options.publishes && options.shows && options.publishes->site == options.shows->site)
    return Error{.what = "this edge would publish the site that it shows",
                 .where = "--publish",
                 .fix = "leave --publish out: the site's own server publishes it"};
  return options;
}

}  // namespace telepalp::relay
