#include <cstdio>

#include "proto/words/counted.h"
#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "tools/codec_tool/commands.h"
#include "tools/codec_tool/depth_files.h"
#include "tools/codec_tool/pgm.h"
#include "tools/codec_tool/progress.h"

namespace telepalp::codec_tool {
namespace {

std::string file_name(std::size_t number, const std::string& kind) {
  char name[32];
  std::snprintf(name, sizeof name, "%06zu.%s", number, kind.c_str());
  return name;
}

}  // namespace

Result<void> decode_recording(const std::filesystem::path& input, const std::filesystem::path& folder,
                              const std::string& kind) {
  if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made) return made;
  Progress progress(0);
  std::size_t frames = 0;
  std::size_t unreadable = 0;
  const auto write = [&](NamedDepth named) -> Result<void> {
    const images::GrayImage16 image{named.depth.width, named.depth.height, std::move(named.depth.samples)};
    progress.step();
    return program::write_whole_file(folder / file_name(frames++, kind),
                                     kind == "png" ? images::encode_png(image) : encode_pgm(image),
                                     program::Readers::Group);
  };
  const auto pass_over = [&](const Error& error) {
    if (unreadable++ == 0)
      std::fprintf(stderr, "frame %zu, counted from 0, is left out: %s\n", frames, error.what.c_str());
    ++frames;
  };
  const Result<void> done = for_each_depth(input, 0.001, write, pass_over);
  if (!done) return done;
  std::printf("wrote %s to %s\n", counted(frames - unreadable, "frame", "frames").c_str(), folder.c_str());
  if (unreadable == 0) return {};
  return Error{.what = std::to_string(unreadable) + " of " + counted(frames, "frame", "frames") + " cannot be read",
               .where = input.string(),
               .fix =
                   "use the frames that are written, or record again; a predicted frame cannot be decoded without the "
                   "frame before it"};
}

}  // namespace telepalp::codec_tool
