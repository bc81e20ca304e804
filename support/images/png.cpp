#include <png.h>

#include <csetjmp>
#include <cstring>

#include "support/images/image_file.h"
#include "support/models/png_bounds.h"

namespace telepalp::images {
namespace {

/// libpng reports an error by longjmp. Everything with a destructor therefore lives in the callers of the functions
/// that call setjmp, and those hold plain values only.
struct PngState {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::span<const std::byte> rest;  // bytes that are not read yet
  std::string* out = nullptr;       // written so far
  models::PngBounds bounds;
  char message[160] = "the file is damaged";
};

void on_error(png_structp png, png_const_charp message) {
  auto* state = static_cast<PngState*>(png_get_error_ptr(png));
  std::strncpy(state->message, message, sizeof state->message - 1);
  png_longjmp(png, 1);
}
void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

void take_bytes(png_structp png, png_bytep to, size_t count) {
  auto* state = static_cast<PngState*>(png_get_io_ptr(png));
  models::check_png_bytes(png, state->info, state->bounds, count);
  if (count > state->rest.size()) png_error(png, "the file ends too early");
  std::memcpy(to, state->rest.data(), count);
  state->rest = state->rest.subspan(count);
}
void give_bytes(png_structp png, png_bytep from, size_t count) {
  static_cast<PngState*>(png_get_io_ptr(png))->out->append(reinterpret_cast<const char*>(from), count);
}
void flush(png_structp /*png*/) {}

struct PngHeader {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  bool depth = false;
};

bool read_header(PngState& state, PngHeader& header) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;
  models::bound_png(state.png, kMaxImageSide);
  png_set_read_fn(state.png, &state, take_bytes);
  png_read_info(state.png, state.info);
  int bits = 0;
  int kind = 0;
  png_get_IHDR(state.png, state.info, &header.width, &header.height, &bits, &kind, nullptr, nullptr, nullptr);
  header.depth = bits == 16 && kind == PNG_COLOR_TYPE_GRAY;
  if (header.depth) {
    png_set_swap(state.png);  // PNG is big-endian
  } else {
    if (bits == 16) png_set_strip_16(state.png);
    png_set_expand(state.png);
    png_set_strip_alpha(state.png);
    png_set_gray_to_rgb(state.png);
  }
  png_set_interlace_handling(state.png);
  png_read_update_info(state.png, state.info);
  return png_get_rowbytes(state.png, state.info) == std::size_t{header.width} * (header.depth ? 2U : 3U);
}

bool read_rows(PngState& state, png_bytepp rows) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;
  png_read_image(state.png, rows);
  png_read_end(state.png, nullptr);
  return true;
}

bool write_rows(PngState& state, png_uint_32 width, png_uint_32 height, bool depth, png_bytepp rows) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;
  png_set_write_fn(state.png, &state, give_bytes, flush);
  png_set_compression_level(state.png, 3);
  png_set_IHDR(state.png, state.info, width, height, depth ? 16 : 8, depth ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(state.png, state.info);
  if (depth) png_set_swap(state.png);
  png_write_image(state.png, rows);
  png_write_end(state.png, nullptr);
  return true;
}

std::vector<png_bytep> row_pointers(void* data, std::size_t bytes_per_row, std::size_t height) {
  std::vector<png_bytep> rows(height);
  for (std::size_t row = 0; row < height; ++row) rows[row] = static_cast<png_bytep>(data) + row * bytes_per_row;
  return rows;
}

std::string encode(const void* data, int width, int height, bool depth) {
  std::string out;
  PngState state;
  state.out = &out;
  state.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, on_error, on_warning);
  demand(state.png != nullptr, "libpng creates a writer");
  state.info = png_create_info_struct(state.png);
  const std::size_t bytes_per_row = static_cast<std::size_t>(width) * (depth ? 2 : 3);
  // libpng's type is not const, but it only reads.
  std::vector<png_bytep> rows = row_pointers(const_cast<void*>(data), bytes_per_row, static_cast<std::size_t>(height));
  const bool written =
      write_rows(state, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth, rows.data());
  png_destroy_write_struct(&state.png, &state.info);
  demand(written, "a well-formed image can be written to memory");
  return out;
}

}  // namespace

Result<AnyImage> decode_png(std::span<const std::byte> bytes, const std::string& name) {
  const std::string fix = "give a whole PNG of at most " + std::to_string(kMaxImageSide) + " pixels a side";
  if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0)
    return Error{.what = "is not a PNG file", .where = name, .fix = fix};
  PngState state;
  state.rest = bytes;
  state.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, on_error, on_warning);
  demand(state.png != nullptr, "libpng creates a reader");
  state.info = png_create_info_struct(state.png);
  PngHeader header;
  bool read = read_header(state, header);
  AnyImage image;
  if (read) {
    const auto width = static_cast<int>(header.width);
    const auto height = static_cast<int>(header.height);
    const std::size_t pixels = std::size_t{header.width} * header.height;
    std::vector<png_bytep> rows;
    if (header.depth) {
      auto& gray = image.emplace<GrayImage16>(GrayImage16{width, height, std::vector<std::uint16_t>(pixels)});
      rows = row_pointers(gray.samples.data(), std::size_t{header.width} * 2, header.height);
    } else {
      auto& color = image.emplace<ColorImage>(ColorImage{width, height, std::vector<std::uint8_t>(3 * pixels)});
      rows = row_pointers(color.rgb.data(), std::size_t{header.width} * 3, header.height);
    }
    read = read_rows(state, rows.data());
  }
  png_destroy_read_struct(&state.png, &state.info, nullptr);
  if (!read) return Error{.what = std::string("cannot be decoded: ") + state.message, .where = name, .fix = fix};
  return image;
}

std::string encode_png(const GrayImage16& image) {
  return encode(image.samples.data(), image.width, image.height, true);
}
std::string encode_png(const ColorImage& image) { return encode(image.rgb.data(), image.width, image.height, false); }

}  // namespace telepalp::images
