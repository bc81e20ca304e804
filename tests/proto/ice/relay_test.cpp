#include "proto/ice/words/relay.h"

#include <gtest/gtest.h>

#include <ostream>

namespace telepalp::ice {
namespace {

msg::IceRelay relay_at(const std::string& address) {
  msg::IceRelay relay;
  relay.set_address(address);
  relay.set_port(3478);
  relay.set_tcp_port(443);
  relay.set_user("1700000000:ward3");
  relay.set_password("password");
  return relay;
}

msg::IceRelay with_port(std::uint32_t port, std::uint32_t tcp_port) {
  msg::IceRelay relay = relay_at("192.0.2.1");
  relay.set_port(port);
  relay.set_tcp_port(tcp_port);
  return relay;
}

msg::IceRelay with_user(std::size_t bytes) {
  msg::IceRelay relay = relay_at("192.0.2.1");
  relay.set_user(std::string(bytes, 'u'));
  return relay;
}

struct RefusedMessage {
  const char* why;
  msg::IceRelay relay;
  const char* says;
};
void PrintTo(const RefusedMessage& one, std::ostream* out) { *out << one.why; }

const RefusedMessage kRefusedMessages[] = {
    {"loopback, as Debian names a computer in /etc/hosts", relay_at("127.0.1.1"), "address is 127.0.1.1, a loopback"},
    {"loopback of IPv6", relay_at("::1"), "address is ::1, a loopback"},
    {"unspecified", relay_at("0.0.0.0"), "address is 0.0.0.0"},
    {"link-local, where clouds keep secrets", relay_at("169.254.169.254"), "address is 169.254.169.254"},
    {"multicast", relay_at("224.0.0.251"), "address is 224.0.0.251"},
    {"loopback in the clothes of IPv6", relay_at("::ffff:127.0.0.1"), "address is ::ffff:127.0.0.1"},
    {"a name", relay_at("relay.example"), "is not an IP address"},
    {"nothing", relay_at(""), "is not an IP address"},
    {"terminal codes, which are not repeated", relay_at("\033[2J"), "relay: the relay's address is not an IP address"},
    {"a port of 17 bits", with_port(65536, 443), "port above 65535"},
    {"a TCP port of 17 bits", with_port(3478, 65536), "port above 65535"},
    {"a long user", with_user(257), "longer than 256 B"},
};

class RefusedRelay : public testing::TestWithParam<RefusedMessage> {};
TEST_P(RefusedRelay, IsNamedWithARemedy) {
  const Result<Relay> read = read_relay(GetParam().relay, Reach::Network);
  ASSERT_FALSE(read.ok());
  const std::string said = to_string(read.error());
  EXPECT_NE(said.find(GetParam().says), std::string::npos) << said;
  EXPECT_NE(said.find("fix: on the meeting point's computer"), std::string::npos) << said;
  EXPECT_EQ(said.find('\033'), std::string::npos);
}
INSTANTIATE_TEST_SUITE_P(HardCases, RefusedRelay, testing::ValuesIn(kRefusedMessages));

TEST(Relay, IsReadWholeAtAnAddressOfAnotherComputer) {
  const Result<Relay> read = read_relay(relay_at("192.0.2.1"), Reach::Network);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->address, "192.0.2.1");
  EXPECT_EQ(read->port, 3478);
  EXPECT_EQ(read->tcp_port, 443);
  EXPECT_EQ(read->user, "1700000000:ward3");
  EXPECT_EQ(read->password, "password");
  EXPECT_TRUE(read_relay(relay_at("127.0.0.1"), Reach::Loopback).ok()) << "for tests";
}

}  // namespace
}  // namespace telepalp::ice
