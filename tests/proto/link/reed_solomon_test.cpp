#include "proto/link/frames/reed_solomon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace telepalp::link {
namespace {

using Shards = std::vector<std::vector<std::byte>>;

Shards random_shards(std::size_t count, std::size_t bytes, std::mt19937& random) {
  Shards shards(count, std::vector<std::byte>(bytes));
  for (auto& shard : shards)
    for (std::byte& byte : shard) byte = static_cast<std::byte>(random());
  return shards;
}

std::vector<RepairShard> repairs_of(const Shards& data, std::size_t first, std::size_t count) {
  std::vector<const std::byte*> in;
  for (const auto& shard : data) in.push_back(shard.data());
  Shards out(count, std::vector<std::byte>(data.front().size()));
  std::vector<std::byte*> at;
  for (auto& shard : out) at.push_back(shard.data());
  make_repair_shards(in, data.front().size(), first, at);
  std::vector<RepairShard> repairs;
  for (std::size_t i = 0; i < count; ++i) repairs.push_back({static_cast<std::uint8_t>(first + i), out[i]});
  return repairs;
}

/// Loses `lost` shards of a random block, and restores them from repair shards `first` onwards.
void lose_and_restore(std::size_t k, std::size_t bytes, std::size_t lost, std::size_t first, std::mt19937& random) {
  const Shards original = random_shards(k, bytes, random);
  std::vector<RepairShard> repairs = repairs_of(original, first, lost);
  std::shuffle(repairs.begin(), repairs.end(), random);
  std::vector<std::uint8_t> missing(k);
  for (std::size_t i = 0; i < k; ++i) missing[i] = static_cast<std::uint8_t>(i);
  std::shuffle(missing.begin(), missing.end(), random);
  missing.resize(lost);
  Shards damaged = original;
  for (const std::uint8_t shard : missing) std::fill(damaged[shard].begin(), damaged[shard].end(), std::byte{0xEE});
  std::vector<std::byte*> data;
  for (auto& shard : damaged) data.push_back(shard.data());
  restore_data_shards(data, missing, bytes, repairs);
  EXPECT_EQ(damaged, original) << k << " shards of " << bytes << " B, " << lost << " lost, repairs from " << first;
}

TEST(ReedSolomon, AnyLossUpToTheNumberOfRepairsIsRestored) {
  std::mt19937 random(7);
  for (const std::size_t k : {1U, 2U, 3U, 24U, 80U, 107U, 128U})
    for (const std::size_t bytes : {1U, 31U, 64U, 1153U})
      for (const std::size_t lost : {std::size_t{0}, std::size_t{1}, k / 2, std::min<std::size_t>(k, 127)})
        lose_and_restore(k, bytes, lost, 0, random);
}

TEST(ReedSolomon, RepairsThatAreMadeLaterFitTheSameCode) {
  std::mt19937 random(8);
  for (const std::size_t first : {1U, 5U, 100U, 117U}) lose_and_restore(128, 200, 10, first, random);
}

TEST(ReedSolomon, AnySetOfRepairRowsRestoresAnySetOfLosses) {
  std::mt19937 random(9);
  for (int round = 0; round < 300; ++round) {
    const std::size_t k = 1 + random() % 128;
    const std::size_t lost = random() % (std::min<std::size_t>(k, 127) + 1);
    lose_and_restore(k, 1 + random() % 40, lost, random() % (128 - lost), random);
  }
}

TEST(ReedSolomon, OneRepairShardOfOneDataShardIsAMultipleOfIt) {  // a slow oracle: GF(2^8) by the polynomial 0x11D
  const auto multiply = [](unsigned a, unsigned b) {
    unsigned product = 0;
    for (; b != 0; b >>= 1U, a = (a << 1U) ^ ((a & 0x80U) != 0 ? 0x11DU : 0U))
      if ((b & 1U) != 0) product ^= a;
    return product & 0xFFU;
  };
  const auto inverse = [&](unsigned a) {
    for (unsigned b = 1; b < 256; ++b)
      if (multiply(a, b) == 1) return b;
    return 0U;
  };
  std::mt19937 random(10);
  const Shards data = random_shards(5, 40, random);
  const auto repairs = repairs_of(data, 0, 6);
  for (unsigned row = 0; row < 6; ++row)
    for (std::size_t b = 0; b < 40; ++b) {
      unsigned sum = 0;
      for (unsigned column = 0; column < 5; ++column)
        sum ^= multiply(inverse((5 + row) ^ column), std::to_integer<unsigned>(data[column][b]));
      ASSERT_EQ(std::to_integer<unsigned>(repairs[row].bytes[b]), sum);
    }
}

}  // namespace
}  // namespace telepalp::link
