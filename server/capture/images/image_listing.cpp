#include "server/capture/images/image_listing.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <regex>
#include <string_view>

namespace telepalp::capture {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kColorWords[] = {"rgb", "color", "colour"};
constexpr std::string_view kDepthWords[] = {"depth"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool is_image(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".png" || extension == ".tif" || extension == ".tiff";
}

/// Removes the first of `words` that occurs in `key`, with one separator; false when none occurs.
template <class Words>
bool take_word(const Words& words, std::string& key) {
  for (const std::string_view word : words) {
    const std::size_t at = lower(key).find(word);
    if (at == std::string::npos) continue;
    key.erase(at, word.size());
    const std::size_t separator = at > 0 ? at - 1 : 0;
    if (separator < key.size() && std::string_view{"_-./"}.find(key[separator]) != std::string_view::npos)
      key.erase(separator, 1);
    return true;
  }
  return false;
}

struct Image {
  fs::path file;
  std::string key;  // the name without the word for depth or colour; equal for both images of a frame
  std::optional<std::uint64_t> number;
};

/// The last number in the name; nullopt if the name has a time of day.
std::optional<std::uint64_t> number_of(const std::string& key) {
  static const std::regex kTime{R"(\d{8}T\d{6})"};
  static const std::regex kLastDigits{R"((\d{1,18})\D*$)"};
  std::smatch match;
  if (std::regex_search(key, kTime) || !std::regex_search(key, match, kLastDigits)) return std::nullopt;
  return std::stoull(match[1].str());
}

Error bad(const std::string& where, std::string what, std::string fix) {
  return {.what = std::move(what), .where = where, .fix = std::move(fix)};
}

std::string with_number(const Image& like, std::uint64_t number) {
  std::string name = like.file.filename().string();
  const std::string digits = std::to_string(*like.number);
  if (const std::size_t at = name.rfind(digits); at != std::string::npos)
    name.replace(at, digits.size(), std::to_string(number));
  return name;
}

Result<void> check_numbers(const std::vector<Image>& depth, const std::string& where) {
  const auto numbered = [](const Image& image) { return image.number.has_value(); };
  if (!std::all_of(depth.begin(), depth.end(), numbered)) return {};
  std::uint64_t step = UINT64_MAX;
  for (std::size_t i = 1; i < depth.size(); ++i) {
    if (*depth[i].number == *depth[i - 1].number)
      return bad(where, depth[i - 1].file.string() + " and " + depth[i].file.string() + " have the same number",
                 "remove one of the two files, or give one of them another number");
    step = std::min(step, *depth[i].number - *depth[i - 1].number);
  }
  for (std::size_t i = 1; i < depth.size(); ++i)
    if (*depth[i].number - *depth[i - 1].number != step)
      return bad(where,
                 with_number(depth[i - 1], *depth[i - 1].number + step) + " is missing between " +
                     depth[i - 1].file.string() + " and " + depth[i].file.string(),
                 "put the missing image back, or number the images without a gap");
  return {};
}

}  // namespace

Result<std::vector<ImagePair>> order_images(const std::vector<fs::path>& files, const std::string& where) {
  std::vector<Image> depth;
  std::vector<Image> unmarked;
  std::map<std::string, fs::path> color_of;
  for (const fs::path& file : files) {
    if (!is_image(file)) continue;
    std::string key = (file.parent_path() / file.stem()).string();
    if (take_word(kDepthWords, key))
      depth.push_back({file, key, number_of(key)});
    else if (take_word(kColorWords, key))
      color_of[key] = file;
    else
      unmarked.push_back({file, key, number_of(key)});
  }
  if (depth.empty()) depth = std::move(unmarked);
  if (depth.empty())
    return bad(where, "holds no depth images",
               "give a folder of 16-bit grey PNG or TIFF images, or a folder that holds the folders depth and rgb");
  std::sort(depth.begin(), depth.end(),
            [](const Image& a, const Image& b) { return a.number != b.number ? a.number < b.number : a.key < b.key; });
  if (const Result<void> checked = check_numbers(depth, where); !checked) return checked.error();
  std::vector<ImagePair> pairs;
  for (const Image& image : depth) {
    const auto color = color_of.find(image.key);
    if (!color_of.empty() && color == color_of.end())
      return bad(where, image.file.string() + " has no colour image of the same name",
                 "add the colour image, or remove all colour images");
    pairs.push_back({image.file, color_of.empty() ? std::nullopt : std::optional{color->second}});
  }
  return pairs;
}

}  // namespace telepalp::capture
