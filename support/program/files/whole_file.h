#pragma once

#include <filesystem>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::program {

/// Permissions of written files and folders, further restricted by the umask.
enum class Readers {
  Group,   ///< files 0640 in folders 0750: for data of a patient
  Anyone,  ///< files 0644 in folders 0755: for figures and settings without patient data
};

/// Creates `folder` and its missing parents. The mode of an existing folder is not changed.
[[nodiscard]] Result<void> make_folder(const std::filesystem::path& folder, Readers readers);

/// Writes `bytes` to a temporary file in the same folder, calls fsync and renames it to `file`, so that `file` is never
/// partially written and is unchanged after an error. A symbolic link at `file` is replaced, not followed. Error:
/// `file` is a folder, a device or a pipe.
[[nodiscard]] Result<void> write_whole_file(const std::filesystem::path& file, std::string_view bytes, Readers readers);

/// True if both names are equal, or lead to one file.
[[nodiscard]] bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

}  // namespace telepalp::program
