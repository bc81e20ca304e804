#include "clients/ar/png.h"

#include <png.h>

#include "proto/words/demand.h"

namespace telepalp::ar {

std::string encode_png(const ColorImage& image) {
  demand(is_well_formed(image) && !image.rgb.empty(), "encode_png is given a picture");
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = 0;
  demand(png_image_write_get_memory_size(header, bytes, 0, image.rgb.data(), 0, nullptr) != 0, "PNG can size itself");
  std::string file(bytes, '\0');
  demand(png_image_write_to_memory(&header, file.data(), &bytes, 0, image.rgb.data(), 0, nullptr) != 0,
         "PNG fits into the size it asked for");
  file.resize(bytes);
  return file;
}

}  // namespace telepalp::ar
