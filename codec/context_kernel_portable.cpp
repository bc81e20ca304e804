#include "codec/context_together.h"

namespace telepalp::codec {
namespace {

/// Plain loops, which a compiler turns into whatever vectors its target has.
struct Plain {
  static int decode(RangeDecoder& coder, const Model& model) { return coder.decode(model); }
  template <int kRate>
  static void learn(Model& model, int symbol) {
    codec::learn<kRate>(model, symbol);
  }
};

}  // namespace

extern const ContextKernel* const kV3ContextKernel;  // context_kernel_v3.cpp; nullptr where the build has none

size_t scratch_bytes(int width, const ContextTables& tables) {
  return kLanes * (static_cast<size_t>(tables.count) * sizeof(Model) + 12 * row_bytes(width));
}

const ContextKernel& portable_context_kernel() {
  static const ContextKernel kernel{"portable", encode<Plain>, decode_together<Plain>};
  return kernel;
}

const ContextKernel* v3_context_kernel() {
#if defined(__x86_64__)
  // Asked here, not there: that file's own code may already need what is asked about.
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2"))
    return kV3ContextKernel;
#endif
  return nullptr;
}

}  // namespace telepalp::codec
