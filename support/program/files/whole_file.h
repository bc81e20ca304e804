#pragma once

#include <filesystem>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::program {

/// Who may read what a program writes. Never more than the process's umask allows.
enum class Readers {
  Group,   ///< files 0640 in folders 0750: all that shows a patient
  Anyone,  ///< files 0644 in folders 0755: figures and settings without a patient
};

/// Makes `folder` and each missing folder above it. The mode of a folder that exists already is left as it is.
[[nodiscard]] Result<void> make_folder(const std::filesystem::path& folder, Readers readers);

/// Writes `bytes` to a new file beside `file`, puts it on the disk and renames it to `file`. Nobody ever sees half a
/// file: after an error `file` is what it was before. A symbolic link at `file` is replaced, not followed; a folder, a
/// device or a pipe is refused.
[[nodiscard]] Result<void> write_whole_file(const std::filesystem::path& file, std::string_view bytes, Readers readers);

}  // namespace telepalp::program
