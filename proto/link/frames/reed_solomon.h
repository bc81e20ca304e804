#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace telepalp::link {

/// A systematic Reed-Solomon code over GF(2^8) with a Cauchy matrix: any k of a block's shards give its k data shards.
/// Row r of the matrix does not depend on the number of rows, so that more repair shards can be made later.

/// Writes repair shards `first` to `first + out.size() - 1` of the block `data`. Each shard has `shard_bytes`.
void make_repair_shards(std::span<const std::byte* const> data, std::size_t shard_bytes, std::size_t first,
                        std::span<std::byte* const> out);

struct RepairShard {
  std::uint8_t row = 0;  ///< 0: the first repair shard
  std::vector<std::byte> bytes;
};

/// Restores in place the data shards whose indices are in `missing`. `repairs` has at least as many shards, each row
/// once; with fewer the process aborts. Each square part of a Cauchy matrix is invertible, so that a solution exists.
void restore_data_shards(std::span<std::byte* const> data, std::span<const std::uint8_t> missing,
                         std::size_t shard_bytes, std::span<const RepairShard> repairs);

}  // namespace telepalp::link
