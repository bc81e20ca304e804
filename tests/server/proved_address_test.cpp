// To which UDP address a peer's datagrams go, and how much an unproved one gets.

#include "server/hub/datagrams/proved_address.h"

#include <gtest/gtest.h>

namespace telepalp::hub {
namespace {

using namespace std::chrono_literals;

ProvedAddress::Endpoint at(std::uint16_t port) { return {boost::asio::ip::make_address("10.0.0.7"), port}; }
constexpr SessionTime kStart{1s};

template <std::uint64_t kValue>
std::uint64_t nonce() {
  return kValue;
}

ProvedAddress proved_at(std::uint16_t port) {
  ProvedAddress address;
  address.received(at(port), 100, nonce<1>);
  EXPECT_TRUE(address.answered(1));
  return address;
}

TEST(ProvedAddress, AnUnprovedAddressGetsAtMostThreeTimesTheReceivedBytes) {
  ProvedAddress address;
  address.received(at(1), 100, nonce<42>);
  EXPECT_EQ(address.receiver(), at(1));
  EXPECT_TRUE(address.may_send(at(1), 200));
  EXPECT_TRUE(address.may_send(at(1), 100));
  EXPECT_FALSE(address.may_send(at(1), 1));
  address.received(at(1), 1, nonce<43>);
  EXPECT_TRUE(address.may_send(at(1), 3));
  EXPECT_FALSE(address.is_proved());
}

TEST(ProvedAddress, TheNonceThatWasSentThereProvesIt) {
  ProvedAddress address;
  address.received(at(1), 100, nonce<42>);
  address.received(at(1), 100, nonce<43>);  // the nonce stays while the address stays
  EXPECT_EQ(address.challenge(kStart)->nonce, 42U);
  EXPECT_FALSE(address.answered(43));
  EXPECT_TRUE(address.answered(42));
  EXPECT_TRUE(address.may_send(at(1), 1'000'000));
}

TEST(ProvedAddress, TheProvedAddressKeepsTheStreamUntilTheNewOneIsProved) {
  ProvedAddress address = proved_at(1);
  address.received(at(2), 100, nonce<7>);
  EXPECT_EQ(address.receiver(), at(1));
  EXPECT_EQ(address.challenge(kStart)->to, at(2));
  EXPECT_TRUE(address.answered(7));
  EXPECT_EQ(address.receiver(), at(2));
  EXPECT_FALSE(address.may_send(at(1), 1));
}

TEST(ProvedAddress, ADatagramFromTheProvedAddressEndsTheChallenge) {
  ProvedAddress address = proved_at(1);
  address.received(at(2), 100, nonce<7>);
  address.received(at(1), 100, nonce<8>);
  EXPECT_FALSE(address.challenge(kStart));
  EXPECT_FALSE(address.answered(7));
}

TEST(ProvedAddress, AChallengeIsRepeatedEach20Ms) {
  ProvedAddress address;
  address.received(at(1), 100, nonce<42>);
  EXPECT_TRUE(address.challenge(kStart));
  EXPECT_FALSE(address.challenge(kStart + 19ms));
  EXPECT_TRUE(address.challenge(kStart + 20ms));
}

}  // namespace
}  // namespace telepalp::hub
