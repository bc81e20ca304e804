#include "proto/link/frames/reed_solomon.h"

#include <isa-l.h>

#include <algorithm>

#include "proto/words/demand.h"

namespace telepalp::link {
namespace {

using Bytes = std::vector<unsigned char>;

/// The Cauchy matrix's entry for repair shard `row` and data shard `column` of `k`; as gf_gen_cauchy1_matrix makes it.
unsigned char coefficient(std::size_t k, std::size_t row, std::size_t column) {
  return gf_inv(static_cast<unsigned char>((k + row) ^ column));
}

/// out[i] = sum over j of matrix[i][j] * in[j].
void multiply(std::size_t shard_bytes, Bytes& matrix, std::vector<unsigned char*>& in,
              std::vector<unsigned char*>& out) {
  const int columns = static_cast<int>(in.size());
  const int rows = static_cast<int>(out.size());
  Bytes tables(32 * in.size() * out.size());
  ec_init_tables(columns, rows, matrix.data(), tables.data());
  ec_encode_data(static_cast<int>(shard_bytes), columns, rows, tables.data(), in.data(), out.data());
}

unsigned char* for_isa_l(const std::byte* data) {  // ISA-L takes its inputs without const
  return reinterpret_cast<unsigned char*>(const_cast<std::byte*>(data));
}

}  // namespace

void make_repair_shards(std::span<const std::byte* const> data, std::size_t shard_bytes, std::size_t first,
                        std::span<std::byte* const> out) {
  if (out.empty()) return;
  Bytes matrix;
  for (std::size_t row = first; row < first + out.size(); ++row)
    for (std::size_t column = 0; column < data.size(); ++column)
      matrix.push_back(coefficient(data.size(), row, column));
  std::vector<unsigned char*> in;
  std::vector<unsigned char*> results;
  for (const std::byte* shard : data) in.push_back(for_isa_l(shard));
  for (std::byte* shard : out) results.push_back(for_isa_l(shard));
  multiply(shard_bytes, matrix, in, results);
}

void restore_data_shards(std::span<std::byte* const> data, std::span<const std::uint8_t> missing,
                         std::size_t shard_bytes, std::span<const RepairShard> repairs) {
  const std::size_t unknowns = missing.size();
  if (unknowns == 0) return;
  demand(repairs.size() >= unknowns, "there are at least as many repair shards as missing data shards");
  const std::size_t k = data.size();

  // Each repair shard minus what the known data shards contribute; only the unknowns remain.
  for (const std::uint8_t shard : missing) std::fill_n(data[shard], shard_bytes, std::byte{0});
  std::vector<Bytes> remainders(unknowns, Bytes(shard_bytes));
  std::vector<unsigned char*> remainder_at;
  for (Bytes& remainder : remainders) remainder_at.push_back(remainder.data());
  std::vector<unsigned char*> known;
  for (std::byte* shard : data) known.push_back(for_isa_l(shard));
  Bytes matrix;
  for (std::size_t i = 0; i < unknowns; ++i)
    for (std::size_t column = 0; column < k; ++column) matrix.push_back(coefficient(k, repairs[i].row, column));
  multiply(shard_bytes, matrix, known, remainder_at);
  for (std::size_t i = 0; i < unknowns; ++i)
    for (std::size_t b = 0; b < shard_bytes; ++b)
      remainders[i][b] ^= std::to_integer<unsigned char>(repairs[i].bytes[b]);

  // The square matrix of the unknowns, which is small: its inverse gives them.
  Bytes square;
  for (std::size_t i = 0; i < unknowns; ++i)
    for (const std::uint8_t column : missing) square.push_back(coefficient(k, repairs[i].row, column));
  Bytes inverse(square.size());
  demand(gf_invert_matrix(square.data(), inverse.data(), static_cast<int>(unknowns)) == 0,
         "the Cauchy matrix of the missing shards is invertible");
  std::vector<unsigned char*> restored;
  for (const std::uint8_t shard : missing) restored.push_back(for_isa_l(data[shard]));
  multiply(shard_bytes, inverse, remainder_at, restored);
}

}  // namespace telepalp::link
