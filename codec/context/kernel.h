#pragma once

#include <stddef.h>
#include <stdint.h>

#include "codec/model/contexts.h"

namespace telepalp::codec {

/// The number of slices that a kernel codes in lockstep, one per SIMD lane. Within a slice each pixel depends on the
/// pixel before it, so parallelism must come from several slices.
inline constexpr int kLanes = 4;

/// One slice for the encoder: a band of whole rows, coded independently. A pixel's rank is the index of its depth in
/// the frame's palette.
struct EncodeSlice {
  uint16_t* ranks = nullptr;       ///< rows x width; 0 is "not measured"
  const uint16_t* most = nullptr;  ///< nullptr: lossless; else each pixel may take a rank from `ranks` to `most`, and
                                   ///< `ranks` gets the choice
  const uint16_t* before =
      nullptr;  ///< the same band of the reference frame, in ranks of this frame; nullptr: key frame
  int rows = 0;
  uint8_t* bytes = nullptr;  ///< output buffer
  size_t room = 0;           ///< capacity of the buffer [bytes]
  size_t size = 0;           ///< bytes written; 0: the buffer was too small
};

struct DecodeSlice {
  const uint8_t* bytes = nullptr;
  size_t size = 0;
  uint16_t* ranks = nullptr;         ///< rows x width, output; arbitrary if the bytes are damaged
  const uint16_t* before = nullptr;  ///< as in EncodeSlice
  int rows = 0;
};

/// One implementation of the coder, for one instruction set. All implementations produce the same bytes. `count` is at
/// most kLanes; all slices have equal `rows`, except that the last may have fewer; all or none have a reference frame.
/// `scratch` has scratch_bytes() bytes, aligned to 32.
struct ContextKernel {
  const char* name;
  void (*encode)(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch);
  void (*decode)(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch);
};

[[nodiscard]] size_t scratch_bytes(int width, const ContextTables& tables);

[[nodiscard]] const ContextKernel& portable_context_kernel();

/// nullptr: the build or the processor does not support x86-64-v3.
[[nodiscard]] const ContextKernel* v3_context_kernel();

}  // namespace telepalp::codec
