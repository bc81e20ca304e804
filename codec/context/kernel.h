#pragma once

#include <stddef.h>
#include <stdint.h>

#include "codec/model/contexts.h"

namespace telepalp::codec {

/// How many slices a kernel works on at once: what one waits for, another does meanwhile.
inline constexpr int kLanes = 4;

/// A band of whole rows, coded apart from the others.
struct EncodeSlice {
  uint16_t* ranks = nullptr;         ///< rows x width; 0 is "not measured"
  const uint16_t* most = nullptr;    ///< none; or each pixel may be from `ranks` to this, and `ranks` become the choice
  const uint16_t* before = nullptr;  ///< the same band of the frame before, in ranks of this one; or none
  int rows = 0;
  uint8_t* bytes = nullptr;  ///< written here
  size_t room = 0;
  size_t size = 0;  ///< bytes written; 0 when there was no room
};

struct DecodeSlice {
  const uint8_t* bytes = nullptr;
  size_t size = 0;
  uint16_t* ranks = nullptr;         ///< rows x width, written here; any number when the bytes are damaged
  const uint16_t* before = nullptr;  ///< as for the encoder
  int rows = 0;
};

/// One implementation of the coder. All give the same bytes for the same ranks. At most kLanes slices at once, of
/// equal `rows` but for the last, which may have fewer; all with a frame before them, or none. `scratch` has
/// scratch_bytes(), aligned to 32.
struct ContextKernel {
  const char* name;
  void (*encode)(EncodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch);
  void (*decode)(DecodeSlice* slices, int count, int width, const ContextTables& tables, void* scratch);
};

[[nodiscard]] size_t scratch_bytes(int width, const ContextTables& tables);

[[nodiscard]] const ContextKernel& portable_context_kernel();

/// nullptr where the build or the processor has none.
[[nodiscard]] const ContextKernel* v3_context_kernel();

}  // namespace telepalp::codec
