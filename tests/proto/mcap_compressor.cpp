// Compresses stdin to stdout with zstd, for a script whose Node has none.

#include <iostream>
#include <iterator>

#include "proto/wire/mcap/format/compression.h"

int main() {
  const std::string bytes(std::istreambuf_iterator<char>(std::cin), {});
  std::cout << telepalp::wire::mcap::zstd_compress(bytes);
  return std::cout.good() ? 0 : 1;
}
