#!/bin/sh
# Rebuilds the browser's depth decoder: codec/wasm/build.sh [OUT.wasm]
# Needs Debian's clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32, libc++abi-14-dev-wasm32 and libzstd-dev. The result
# is committed, so that building the viewer needs none of them.
set -eu
cd "$(dirname "$0")/../.."
out=${1:-clients/viewer/src/depth/depth_decoder.wasm}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
mkdir "$work/zstd"
cp /usr/include/zstd.h "$work/zstd"  # alone: the host's other headers are not for this target
clang++-14 --target=wasm32-wasi --sysroot=/usr -isystem /usr/include/wasm32-wasi/c++/v1 \
  -isystem /usr/include/wasm32-wasi -Icodec/wasm/include -I"$work/zstd" -I. \
  -std=c++20 -Os -msimd128 -mbulk-memory -fno-exceptions -fno-rtti -ffunction-sections -fdata-sections \
  -Wno-ignored-attributes -ffile-prefix-map="$PWD"=. -nostdlib \
  codec/wasm/depth_decoder_wasm.cpp codec/wasm/decoding_kernel.cpp codec/bounded/reconstruction.cpp \
  codec/bytes/crc32c.cpp codec/bytes/zstd_stream.cpp codec/context/context_coding.cpp \
  codec/entropy/palette_coding.cpp codec/fast/fast_coding.cpp codec/fast/rank_wavefront.cpp \
  codec/fast/token_reader.cpp codec/fast/token_writer.cpp codec/levels/disparity_law.cpp \
  codec/levels/level_palette.cpp codec/model/depth_tables.cpp codec/packet/depth_packet.cpp \
  codec/stream/depth.cpp codec/stream/depth_stream.cpp codec/stream/frame_coding.cpp \
  codec/stream/packet_decoder.cpp codec/stream/window_coding.cpp \
  proto/words/depth/depth_window.cpp proto/words/rgbd_frame.cpp \
  /usr/lib/wasm32-wasi/crt1-reactor.o -L/usr/lib/wasm32-wasi -L/usr/lib/llvm-14/lib/wasm32-wasi -lc++ -lc++abi -lc \
  -Wl,--no-entry -Wl,--export=_initialize -Wl,--gc-sections -Wl,--strip-all -Wl,--allow-undefined \
  -o "$work/depth_decoder.wasm"
cp "$work/depth_decoder.wasm" "$out"
