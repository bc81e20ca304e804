#include "server/meet/site/told_relay.h"

#include "proto/ice/words/relay.h"

namespace telepalp::meet {
namespace {

msg::IceRelay relay_of(const msg::MeetRelay& told) {
  msg::IceRelay relay;
  relay.set_address(told.address());
  relay.set_port(told.port());
  relay.set_tcp_port(told.tcp_port());
  relay.set_user(told.user());
  relay.set_password(told.password());
  return relay;
}

}  // namespace

void ToldRelay::heard(const msg::MeetRelay& told) {
  relays_ = {relay_of(told)};
  const Result<ice::Relay> read = ice::read_relay(relays_.front(), ice::Reach::Network);
  if (read) return;
  relays_.clear();
  const std::string why = to_string(read.error());
  if (said_.is_new(why)) say_(why);
}

}  // namespace telepalp::meet
