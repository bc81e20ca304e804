#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>

#include "proto/link/seal/sealed_channel.h"

namespace telepalp::link {
namespace {

std::array<std::byte, 32> bytes_from_hex(std::string_view hex) {
  std::array<std::byte, 32> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::byte>(std::stoi(std::string(hex.substr(2 * i, 2)), nullptr, 16));
  return bytes;
}

Secret counting_secret() {
  std::array<std::byte, 32> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i);
  return Secret(bytes);
}

SealSettings settings(Cipher cipher = Cipher::Aes256Gcm) {
  return {.session = counting_secret(), .number = 0x0A0B0C0D, .cipher = cipher};
}

std::vector<std::byte> text(std::string_view letters) {
  std::vector<std::byte> bytes;
  for (const char letter : letters) bytes.push_back(static_cast<std::byte>(letter));
  return bytes;
}

std::string hex(std::span<const std::byte> bytes) {
  std::string out;
  for (const std::byte byte : bytes) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", std::to_integer<unsigned>(byte));
    out += two;
  }
  return out;
}

/// Sealer and opener of one direction.
struct Pair {
  explicit Pair(const SealSettings& both = settings())
      : sealer(both, Direction::ClientToServer), opener(std::make_unique<Opener>(both, Direction::ClientToServer)) {}
  Datagram seal(std::string_view letters) {
    Datagram datagram{};
    EXPECT_TRUE(sealer.seal(text(letters), datagram));
    return datagram;
  }
  [[nodiscard]] std::optional<std::string> open(std::span<const std::byte> datagram) {
    const auto opened = opener->open(datagram);
    if (!opened) return std::nullopt;
    std::string out;
    for (const std::byte byte : opened->payload) out += static_cast<char>(byte);
    return out;
  }
  Sealer sealer;
  std::unique_ptr<Opener> opener;
};

TEST(KeySchedule, ExpandIsHkdfOfRfc5869) {  // test case 1, the first 32 of its 42 bytes
  const Secret secret(bytes_from_hex("077709362c2e32df0ddc3f0dc47bba6390b6c73bb50f9c3122ec844ad7c2b3e5"));
  std::string info;
  for (int i = 0xf0; i <= 0xf9; ++i) info += static_cast<char>(i);
  EXPECT_EQ(hex(expand(secret, info).bytes()), "3cb25f25faacd57a90434f64d0362f2a2d2d0a90cf1a5a4c5db02d56ecc4c5bf");
}

TEST(KeySchedule, EachDirectionCipherAndEpochHasAKeyOfItsOwn) {
  std::vector<std::string> keys;
  for (const Cipher cipher : {Cipher::Aes256Gcm, Cipher::ChaCha20Poly1305})
    for (const Direction direction : {Direction::ClientToServer, Direction::ServerToClient}) {
      Secret epoch = first_epoch(counting_secret(), direction, cipher);
      for (int i = 0; i < 3; ++i, epoch = next_epoch(epoch)) {
        keys.push_back(hex(packet_key(epoch).key.bytes()));
        keys.push_back(hex(packet_key(epoch).salt) + std::string(40, '.'));
      }
    }
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST(SealedDatagram, IsAsTheWirePageSays) {
  for (const Cipher cipher : {Cipher::Aes256Gcm, Cipher::ChaCha20Poly1305}) {
    Pair pair(settings(cipher));
    (void)pair.seal("first");
    const Datagram second = pair.seal("second");
    EXPECT_EQ(hex(second.bytes().first(kHeaderBytes)),
              "01000000"
              "0d0c0b0a"
              "0100000000000000");
    EXPECT_EQ(second.size, kHeaderBytes + 6 + kTagBytes);
    EXPECT_EQ(hex(second.bytes().subspan(kHeaderBytes)), cipher == Cipher::Aes256Gcm
                                                             ? "1266c22f3b6cd5bda2c847b017e03b1f806fb64d416d"
                                                             : "0ae818c001e43c338c8b33afa3ac6a31232ff0f6f4f8");
  }
}

TEST(SealedDatagram, TheLargestAndTheEmptyPayloadComeThrough) {
  for (const Cipher cipher : {Cipher::Aes256Gcm, Cipher::ChaCha20Poly1305}) {
    Pair pair(settings(cipher));
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kPayloadBytes}) {
      const std::string payload(size, 'x');
      const Datagram datagram = pair.seal(payload);
      EXPECT_LE(datagram.size, kDatagramBytes);
      EXPECT_EQ(pair.open(datagram.bytes()), payload);
    }
  }
}

TEST(SealedDatagram, AnyFlippedBitIsRefusedAndMovesNothing) {
  Pair pair;
  const Datagram datagram = pair.seal("palpation");
  for (std::size_t bit = 0; bit < datagram.size * 8; ++bit) {
    Datagram flipped = datagram;
    flipped.storage[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    EXPECT_EQ(pair.open(flipped.bytes()), std::nullopt) << "bit " << bit;
  }
  EXPECT_EQ(pair.open(datagram.bytes()), "palpation");  // also with a sequence number of 2^63 forged before it
}

TEST(SealedDatagram, AnyCutOrLongerDatagramIsRefused) {
  Pair pair;
  const Datagram datagram = pair.seal("palpation");
  for (std::size_t size = 0; size < datagram.size; ++size)
    EXPECT_EQ(pair.open(datagram.bytes().first(size)), std::nullopt) << size;
  std::vector<std::byte> longer(datagram.bytes().begin(), datagram.bytes().end());
  for (; longer.size() <= kDatagramBytes + 1; longer.push_back({})) {
    if (longer.size() > datagram.size) {
      EXPECT_EQ(pair.open(longer), std::nullopt);
    }
  }
}

TEST(SealedDatagram, AReplayIsDeliveredOnceHoweverOften) {
  Pair pair;
  const Datagram datagram = pair.seal("once");
  EXPECT_EQ(pair.open(datagram.bytes()), "once");
  for (int i = 0; i < 10; ++i) EXPECT_EQ(pair.open(datagram.bytes()), std::nullopt);
  EXPECT_EQ(pair.opener->statistics().replayed, 10U);
}

TEST(SealedDatagram, ReorderedPacketsAreDeliveredOnceWithinTheWindow) {
  Pair pair;
  std::vector<Datagram> sent;
  for (std::uint64_t i = 0; i < ReplayWindow::kSize + 10; ++i) sent.push_back(pair.seal(std::to_string(i)));
  std::vector<std::size_t> order(sent.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::reverse(order.begin(), order.end());  // the newest first: the oldest ten have left the window
  std::size_t delivered = 0;
  for (int twice = 0; twice < 2; ++twice)
    for (const std::size_t i : order)
      if (pair.open(sent[i].bytes())) {
        ++delivered;
        EXPECT_GE(i, 10U);
      }
  EXPECT_EQ(delivered, ReplayWindow::kSize);
}

TEST(SealedDatagram, OnlyTheNewestMayMoveAnAddress) {
  Pair pair;
  const Datagram first = pair.seal("1");
  const Datagram second = pair.seal("2");
  EXPECT_TRUE(pair.opener->open(second.bytes())->newest);
  EXPECT_FALSE(pair.opener->open(first.bytes())->newest);
}

TEST(SealedDatagram, TheOtherDirectionSessionAndCipherAreRefused) {
  const Datagram datagram = Pair().seal("mine");
  SealSettings other_session = settings();
  other_session.number += 1;
  SealSettings other_secret = settings();
  other_secret.session = Secret(bytes_from_hex(std::string(64, 'a')));
  EXPECT_FALSE(Opener(settings(), Direction::ServerToClient).open(datagram.bytes()));
  EXPECT_FALSE(Opener(other_session, Direction::ClientToServer).open(datagram.bytes()));
  EXPECT_FALSE(Opener(other_secret, Direction::ClientToServer).open(datagram.bytes()));
  EXPECT_FALSE(Opener(settings(Cipher::ChaCha20Poly1305), Direction::ClientToServer).open(datagram.bytes()));
  EXPECT_TRUE(Opener(settings(), Direction::ClientToServer).open(datagram.bytes()));
}

TEST(SealedDatagram, AKeyIsChangedBeforeItsLimitAndReorderingAcrossTheChangeIsSurvived) {
  SealSettings few = settings();
  few.packets_per_epoch = 10;
  Pair pair(few);
  std::vector<Datagram> sent;
  for (int i = 0; i < 200; ++i) sent.push_back(pair.seal(std::to_string(i)));
  for (std::size_t i = 0; i + 4 < sent.size(); i += 5)  // five at a time, backwards
    for (std::size_t j = i + 5; j-- > i;) EXPECT_EQ(pair.open(sent[j].bytes()), std::to_string(j));
  EXPECT_EQ(sent.back().storage[2], std::byte{19});
}

TEST(SealedDatagram, AForgedEpochDoesNotChangeTheKey) {
  SealSettings few = settings();
  few.packets_per_epoch = 10;
  Pair pair(few);
  Datagram forged = pair.seal("0");
  const Datagram honest = forged;
  forged.storage[2] = std::byte{1};
  EXPECT_EQ(pair.open(forged.bytes()), std::nullopt);
  EXPECT_EQ(pair.open(honest.bytes()), "0");
  for (int i = 1; i < 25; ++i) EXPECT_TRUE(pair.open(pair.seal(std::to_string(i)).bytes()));
}

TEST(SealedDatagram, TheLastEpochEndsInSilenceNotInAUsedNonce) {
  SealSettings one = settings();
  one.packets_per_epoch = 1;
  Pair pair(one);
  Datagram datagram{};
  for (int i = 0; i < 65'536; ++i) ASSERT_TRUE(pair.sealer.seal({}, datagram));
  EXPECT_EQ(pair.sealer.seal({}, datagram), std::nullopt);
}

TEST(SealedDatagram, GarbageIsRefused) {
  Pair pair;
  std::mt19937 random(1);
  std::vector<std::byte> garbage;
  for (int i = 0; i < 20'000; ++i) {
    garbage.resize(random() % 1300);
    for (std::byte& byte : garbage) byte = static_cast<std::byte>(random());
    EXPECT_EQ(pair.open(garbage), std::nullopt);
  }
}

}  // namespace
}  // namespace telepalp::link
