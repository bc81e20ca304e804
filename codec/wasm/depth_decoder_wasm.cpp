// The depth decoder for browsers: the same C++ code with a few functions that JavaScript can call. zstd is not compiled
// in; ZSTD_decompress is imported from the page, which has a decoder in JavaScript.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "codec/depth_stream.h"

using telepalp::DepthImage;
using telepalp::Result;

namespace {

std::vector<std::byte> g_packet;  // one decoder per module; each worker has its own instance
telepalp::codec::DepthDecoder g_decoder;
DepthImage g_depth;
std::optional<telepalp::DepthWindow> g_window;
std::string g_problem;

}  // namespace

#define TELEPALP_EXPORT(name) extern "C" __attribute__((export_name(#name))) auto name

/// A buffer for a packet of `bytes` bytes, which the caller fills before decode().
TELEPALP_EXPORT(packet)(std::uint32_t bytes)->std::byte* {
  g_packet.resize(bytes);
  return g_packet.data();
}

/// Returns 1 if the packet was decoded, 0 if not; problem() then gives the reason.
TELEPALP_EXPORT(decode)()->std::int32_t {
  Result<DepthImage> depth = g_decoder.decode(g_packet);
  if (!depth) {
    g_problem = depth.error().what;
    return 0;
  }
  g_depth = *std::move(depth);
  g_window = telepalp::codec::inspect_depth(g_packet)->window;
  return 1;
}

TELEPALP_EXPORT(width)()->std::int32_t { return g_depth.width; }
TELEPALP_EXPORT(height)()->std::int32_t { return g_depth.height; }
TELEPALP_EXPORT(unit_m)()->double { return g_depth.unit_m; }
TELEPALP_EXPORT(samples)()->const std::uint16_t* { return g_depth.samples.data(); }
/// Number `index` of the decoded image's window, in the order of the packet: 0 to 3 column, row, width and height; 4
/// and 5 least_m and per_m of the bound beside the window; 6 and 7 those at the image's border. -1: the image has no
/// window.
TELEPALP_EXPORT(window)(std::int32_t index)->double {
  if (!g_window) return -1.0;
  const auto& [exact, near, border] = *g_window;
  const double numbers[] = {static_cast<double>(exact.column),
                            static_cast<double>(exact.row),
                            static_cast<double>(exact.width),
                            static_cast<double>(exact.height),
                            near.least_m,
                            near.per_m,
                            border.least_m,
                            border.per_m};
  return index >= 0 && index < 8 ? numbers[index] : -1.0;
}
TELEPALP_EXPORT(problem)()->const char* { return g_problem.c_str(); }

// A failed demand() cannot print here; its trap reaches JavaScript as an exception.
extern "C" int fprintf(FILE*, const char*, ...) { return 0; }
extern "C" void abort() { __builtin_trap(); }
