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
  std::string build{};  ///< version and commit of the program that ordered it
  std::string sweep{};  ///< identity of the sweep's unimpaired scenario, 16 hexadecimal digits
  std::string cell{};   ///< identity of the cell's result, 16 hexadecimal digits
  std::string source{};
  std::string source_digest{};
  std::optional<Recording> recording{};  ///< nullopt: a synthetic source
  std::string scene_text{};
  std::map<std::string, std::string> options{};      ///< of the sweep, by name without dashes
  std::string assertions{};                          ///< of --assert; empty: none
  std::vector<std::pair<std::string, double>> at{};  ///< a value on each axis

  bool operator==(const CellOrder&) const = default;
};

[[nodiscard]] std::string encode(const CellOrder& order);

/// What a worker takes.
struct OrderRules {
  std::string build;                      ///< of the worker
  std::vector<std::string_view> options;  ///< names of the options on which a run's result depends
};

/// Reads an order, of which nothing is trusted. Error: not an order, one of another build, or one with a value out of
/// its bounds: a digest that is none, a recording above kMostRecording_B, an option that does not describe a run, a
/// control character, or a source that names a file of the worker.
[[nodiscard]] Result<CellOrder> parse_order(std::string_view bytes, const OrderRules& rules);

/// The command line of telepalp-replay for the order's sweep, without its axes. `source`: the local file of the
/// recording, or the name of the synthetic source. `scene`: a local file with the order's scene.
[[nodiscard]] std::vector<std::string> command_of(const CellOrder& order, const std::string& source,
                                                  const std::string& scene);

/// The axes of a sweep that has only the order's cell, as words of a command line: {"delay=50", "loss=0.5"}. Each
/// number is the order's, to the last bit.
[[nodiscard]] std::vector<std::string> axes_of(const CellOrder& order);

/// True if `source` is a synthetic patient that no file describes.
[[nodiscard]] bool is_plain_synthetic(std::string_view source) noexcept;

/// True if `scene_text`, the text of a scene, names a file, such as a mesh.
[[nodiscard]] bool names_a_file(const std::string& scene_text);

/// True if `text` is `digits` lower-case hexadecimal digits.
[[nodiscard]] bool is_digest(std::string_view text, std::size_t digits) noexcept;

}  // namespace telepalp::replay
