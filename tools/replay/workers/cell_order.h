#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::replay {

/// The content of a recording, cut into chunks.
struct Recording {
  enum class Kind : std::uint8_t { Mcap = 1, Oni = 2, Pcd = 3 };
  Kind kind = Kind::Mcap;
  std::string sha256;  ///< of all bytes, 64 hexadecimal digits
  std::uint64_t size_B = 0;
  std::uint32_t chunk_B = 0;  ///< of each chunk but the last one

  [[nodiscard]] std::uint64_t chunks() const noexcept { return (size_B + chunk_B - 1) / chunk_B; }
  /// Size of the chunk of this number, from 0 [B].
  [[nodiscard]] std::uint64_t size_of_chunk(std::uint64_t number) const noexcept {
    return std::min<std::uint64_t>(chunk_B, size_B - number * chunk_B);
  }
  bool operator==(const Recording&) const = default;
};

inline constexpr std::uint64_t kMostRecording_B = std::uint64_t{16} << 30U;
inline constexpr std::uint32_t kLeastChunk_B = 1024;
inline constexpr std::uint32_t kMostChunk_B = std::uint32_t{4} << 20U;
inline constexpr std::size_t kMostOrder_B = std::size_t{512} << 10U;

/// One cell of a sweep, for a worker to make.
struct CellOrder {
  std::string build{};   ///< version and commit of the program that ordered it
  std::string sweep{};   ///< identity of the sweep's unimpaired scenario, 16 hexadecimal digits
  std::string cell{};    ///< identity of the cell's result, 16 hexadecimal digits
  std::string source{};  ///< as the user named it, for reports; a worker opens it only if it is synthetic
  std::string source_digest{};
  std::optional<Recording> recording{};  ///< nullopt: a synthetic source
  std::string scene_text{};
  std::map<std::string, std::string> options{};      ///< of the sweep's command line, by name without dashes
  std::string assertions{};                          ///< of --assert; empty: none
  std::vector<std::pair<std::string, double>> at{};  ///< name of each axis, and the cell's value on it

  bool operator==(const CellOrder&) const = default;
};

[[nodiscard]] std::string encode(const CellOrder& order);

/// The orders that a worker accepts.
struct OrderRules {
  std::string build;                      ///< of the worker; orders of another build are refused
  std::vector<std::string_view> options;  ///< names_of_run_options() of request.h; orders with another are refused
};

/// Reads an order that anybody may have sent. Error: `bytes` are not an order, the order is of another build, a digest
/// is malformed, the recording is above kMostRecording_B, an option is not of `rules.options`, a text has a control
/// character, or the source names a file of the worker.
[[nodiscard]] Result<CellOrder> parse_order(std::string_view bytes, const OrderRules& rules);

/// The command line of telepalp-replay that describes the order's sweep, without its axes. `source`: the local file of
/// the recording, or the name of the synthetic source. `scene`: a local file with the order's scene.
[[nodiscard]] std::vector<std::string> command_of(const CellOrder& order, const std::string& source,
                                                  const std::string& scene);

/// The order's cell as axes of one value each, in words of a command line: {"delay=50", "loss=0.5"}. The numbers have
/// enough digits to be read back to the last bit.
[[nodiscard]] std::vector<std::string> axes_of(const CellOrder& order);

/// True if `source` is a synthetic patient whose shape comes from no file.
[[nodiscard]] bool is_plain_synthetic(std::string_view source) noexcept;

/// True if `scene_text`, the text of a scene, names a file, such as a mesh, or cannot be parsed.
[[nodiscard]] bool names_a_file(const std::string& scene_text);

/// True if `text` is `digits` lower-case hexadecimal digits.
[[nodiscard]] bool is_digest(std::string_view text, std::size_t digits) noexcept;

}  // namespace telepalp::replay
