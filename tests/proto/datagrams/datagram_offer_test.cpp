#include "proto/wire/datagrams/datagram_offer.h"

#include <gtest/gtest.h>

namespace telepalp::wire {
namespace {

KeyingMaterial secret_of(unsigned char fill) {
  KeyingMaterial secret(std::in_place);
  secret->fill(std::byte{fill});
  return secret;
}

/// True when a datagram that the server seals opens at the client.
bool fit(const DatagramOffer& offer, const link::SealSettings& accepted) {
  link::Sealer server(offer.seal, link::Direction::ServerToClient);
  link::Opener client(accepted, link::Direction::ServerToClient);
  link::Datagram datagram;
  const std::array<std::byte, 3> payload{};
  return server.seal(payload, datagram) && client.open(datagram.bytes()).has_value();
}

TEST(DatagramOffer, WithTlsTheSecretIsTheSessionsAndIsNotInTheMessage) {
  const auto offer = make_offer(7, quick_cipher(), secret_of(1));
  ASSERT_TRUE(offer);
  EXPECT_TRUE(offer->message.secret().empty());
  EXPECT_EQ(offer->message.session(), 7U);
  ASSERT_TRUE(accept_offer(offer->message, secret_of(1)));
  EXPECT_TRUE(fit(*offer, *accept_offer(offer->message, secret_of(1))));
  EXPECT_FALSE(fit(*offer, *accept_offer(offer->message, secret_of(2))));
}

TEST(DatagramOffer, WithoutTlsTheMessageCarriesASecretThatDiffersEachTime) {
  const auto one = make_offer(7, quick_cipher(), std::nullopt);
  const auto other = make_offer(7, quick_cipher(), std::nullopt);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->message.secret().size(), link::Secret::kBytes);
  EXPECT_NE(one->message.secret(), other->message.secret());
  EXPECT_TRUE(fit(*one, *accept_offer(one->message, std::nullopt)));
}

TEST(DatagramOffer, ASecretInTheMessageCannotReplaceTheOneOfTls) {
  auto offer = make_offer(7, quick_cipher(), secret_of(1));
  offer->message.set_secret(std::string(link::Secret::kBytes, '\2'));
  EXPECT_TRUE(fit(*offer, *accept_offer(offer->message, secret_of(1))));
}

TEST(DatagramOffer, ChaCha20IsAgreedOnWhenEitherEndIsSlowWithAes) {
  const auto offer = make_offer(7, msg::DATAGRAM_CIPHER_CHACHA20_POLY1305, secret_of(1));
  EXPECT_EQ(offer->message.cipher(), msg::DATAGRAM_CIPHER_CHACHA20_POLY1305);
  EXPECT_TRUE(fit(*offer, *accept_offer(offer->message, secret_of(1))));
}

TEST(DatagramOffer, IsRefusedWithoutACipherOrASecretOfTheRightSize) {
  EXPECT_FALSE(make_offer(7, msg::DATAGRAM_CIPHER_NONE, secret_of(1)));
  EXPECT_FALSE(make_offer(7, static_cast<msg::DatagramCipher>(99), secret_of(1)));
  msg::DatagramOffer offer;
  offer.set_cipher(msg::DATAGRAM_CIPHER_AES_256_GCM);
  EXPECT_FALSE(accept_offer(offer, std::nullopt));
  offer.set_secret("short");
  EXPECT_FALSE(accept_offer(offer, std::nullopt));
  offer.set_secret(std::string(32, 'x'));
  EXPECT_TRUE(accept_offer(offer, std::nullopt));
  offer.set_cipher(static_cast<msg::DatagramCipher>(99));
  EXPECT_FALSE(accept_offer(offer, std::nullopt));
}

}  // namespace
}  // namespace telepalp::wire
