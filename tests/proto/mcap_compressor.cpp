// mcap_compressor zstd|lz4: compresses stdin to stdout, for a script whose Node has neither.

#include <lz4frame.h>

#include <iostream>
#include <iterator>
#include <string_view>

#include "proto/wire/mcap/format/compression.h"

namespace {

std::string lz4_frame(const std::string& bytes) {
  std::string out(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr);
  out.resize(LZ4F_isError(size) != 0 ? 0 : size);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view name = argc == 2 ? argv[1] : "";
  if (name != "zstd" && name != "lz4") return 2;
  const std::string bytes(std::istreambuf_iterator<char>(std::cin), {});
  std::cout << (name == "zstd" ? telepalp::wire::mcap::zstd_compress(bytes) : lz4_frame(bytes));
  return std::cout.good() ? 0 : 1;
}
