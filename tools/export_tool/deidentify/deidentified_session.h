#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "proto/words/result.h"
#include "tools/export_tool/deidentify/message_cleaner.h"

namespace telepalp::export_tool {

/// What becomes of the colour images.
enum class ColorRule { Remove, Blur };

/// Counts of what a de-identified copy keeps and lacks. Holds no text of the session, so it may be passed on with the
/// copy.
struct Deidentified {
  struct Messages {
    std::uint64_t kept = 0;
    std::uint64_t blurred = 0;  ///< part of `kept`
    std::uint64_t removed = 0;
    std::uint64_t unreadable = 0;  ///< not of the topic's type, or colour that cannot be decoded: removed
  };
  std::map<std::string, Messages> topics;  ///< by name; the topics of other programs are counted together
  CleanedTexts texts;
  std::uint64_t attachments = 0;          ///< removed
  std::uint64_t records_of_metadata = 0;  ///< removed, such as the names of the files that were merged
  bool scene_removed = false;             ///< the session had a scene that cannot be read
  std::uint64_t notes = 0;                ///< beside the session: not copied
  std::uint64_t damaged = 0;              ///< parts of the session that cannot be read
};

/// The key of Deidentified::topics for messages that are not telepalp's.
inline constexpr const char* kOtherTopics = "other programs' topics";

/// Writes a copy of the session `file` to `out`, without speech, and without the texts and colours by which the
/// patient, the doctor or the site could be identified. Depth, forces and all times are as recorded. Error: `file`
/// cannot be read, or `out` exists or cannot be written.
[[nodiscard]] Result<Deidentified> write_deidentified(const std::filesystem::path& file,
                                                      const std::filesystem::path& out, ColorRule color);

}  // namespace telepalp::export_tool
