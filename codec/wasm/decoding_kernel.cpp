#include "codec/context/interleaved_decoder.h"

// The browser's kernel replaces codec/context/kernel_portable.cpp and kernel_v3.cpp. It only decodes, which makes the
// module a quarter smaller.

namespace telepalp::codec {

size_t scratch_bytes(int width, const ContextTables& tables) { return scratch_of_kernels(width, tables); }

const ContextKernel& portable_context_kernel() {
  static const ContextKernel kernel{"browser", nullptr, decode_interleaved<Plain>};
  return kernel;
}

const ContextKernel* v3_context_kernel() { return nullptr; }

}  // namespace telepalp::codec
