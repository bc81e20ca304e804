#include "codec/context/choosing_encoder.h"
#include "codec/context/interleaved_decoder.h"

namespace telepalp::codec {

extern const ContextKernel* const kV3ContextKernel;  // defined in kernel_v3.cpp; nullptr: not in this build

size_t scratch_bytes(int width, const ContextTables& tables) { return scratch_of_kernels(width, tables); }

const ContextKernel& portable_context_kernel() {
  static const ContextKernel kernel{"portable", encode_or_choose<Plain>, decode_interleaved<Plain>};
  return kernel;
}

const ContextKernel* v3_context_kernel() {
#if defined(__x86_64__)
  // The check is here because code in kernel_v3.cpp may already use these instructions.
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2"))
    return kV3ContextKernel;
#endif
  return nullptr;
}

}  // namespace telepalp::codec
