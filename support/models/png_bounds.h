#pragma once

#include <png.h>

#include <cstddef>

namespace telepalp::models {

/// Counts the compressed bytes after the last row of an image; check_png_bytes() limits them. libpng decompresses the
/// whole stream even when the last row is complete, so a file of 400 KB can inflate to 400 MB behind a small image.
struct PngBounds {
  std::size_t bytes_after_last_row = 0;
};

/// Limits width and height to `most_pixels_a_side`. libpng skips ancillary chunks (text, profiles, …), and reports data
/// after the last row as an error instead of a warning. Call this before png_read_info.
inline void bound_png(png_structp png, png_uint_32 most_pixels_a_side) {
  png_set_user_limits(png, most_pixels_a_side, most_pixels_a_side);
  png_set_chunk_malloc_max(png, 1U << 22U);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_benign_errors(png, 0);
}

/// The read callback calls check_png_bytes() before it delivers `count` bytes. More than 1 KiB of compressed data after
/// the last row ends in png_error. libpng requests at most 8 KiB at once, which inflate to at most 8 MiB.
inline void check_png_bytes(png_structp png, png_infop info, PngBounds& bounds, std::size_t count) {
  constexpr png_uint_32 kImageData = 0x49444154;  // "IDAT"
  constexpr std::size_t kMostBytes = 1024;        // the end of a zlib stream takes about ten bytes
  constexpr int kPassesOfInterlacing = 7;
  const bool in_image_data =
      (png_get_io_state(png) & PNG_IO_MASK_LOC) == PNG_IO_CHUNK_DATA && png_get_io_chunk_type(png) == kImageData;
  if (!in_image_data) return;
  const bool interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
  const bool after_last_row = interlaced ? png_get_current_pass_number(png) >= kPassesOfInterlacing
                                         : png_get_current_row_number(png) >= png_get_image_height(png, info);
  if (!after_last_row) return;
  bounds.bytes_after_last_row += count;
  if (bounds.bytes_after_last_row > kMostBytes)
    png_error(png, "the file holds more data than the rows that its header declares");
}

}  // namespace telepalp::models
