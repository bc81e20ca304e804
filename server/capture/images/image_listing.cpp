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

bool is_jpeg(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".jpg" || extension == ".jpeg";
}

bool is_image(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".png" || extension == ".tif" || extension == ".tiff" || is_jpeg(file);
}

template <class Words>
bool has_word(const Words& words, const std::string& text) {
  const std::string small = lower(text);
  return std::any_of(std::begin(words), std::end(words),
                     [&](std::string_view word) { return small.find(word) != std::string::npos; });
}

/// Removes each occurrence of `words` from `key`, with one separator: both images of a frame then have one key.
template <class Words>
void remove_words(const Words& words, std::string& key) {
  for (const std::string_view word : words)
    for (std::size_t at = lower(key).find(word); at != std::string::npos; at = lower(key).find(word)) {
      key.erase(at, word.size());
      const std::size_t separator = at > 0 ? at - 1 : 0;
      if (separator < key.size() && std::string_view{"_-./"}.find(key[separator]) != std::string_view::npos)
        key.erase(separator, 1);
    }
}

enum class Kind { Depth, Color, Unmarked };

/// A word in the file's name decides, else one in the folder's name. A JPEG cannot hold depth, so it is colour.
Kind kind_of(const fs::path& file) {
  if (is_jpeg(file)) return Kind::Color;
  for (const std::string& name : {file.stem().string(), file.parent_path().string()}) {
    if (has_word(kDepthWords, name)) return Kind::Depth;
    if (has_word(kColorWords, name)) return Kind::Color;
  }
  return Kind::Unmarked;
}

struct Image {
  fs::path file;
  std::string key;                      // the name without the words for depth or colour
  std::string digits;                   // the last number in the name; empty if the name has a time of day
  std::optional<std::uint64_t> number;  // its value
};

Image image_of(const fs::path& file, Kind kind) {
  static const std::regex kTime{R"(\d{8}T\d{6})"};
  static const std::regex kLastDigits{R"((\d{1,18})\D*$)"};
  Image image{file, (file.parent_path() / file.stem()).string(), "", std::nullopt};
  if (kind == Kind::Depth) remove_words(kDepthWords, image.key);
  if (kind == Kind::Color) remove_words(kColorWords, image.key);
  std::smatch match;
  if (std::regex_search(image.key, kTime) || !std::regex_search(image.key, match, kLastDigits)) return image;
  image.digits = match[1].str();
  image.number = std::stoull(image.digits);
  return image;
}

Error bad(const std::string& where, std::string what, std::string fix) {
  return {.what = std::move(what), .where = where, .fix = std::move(fix)};
}

std::string with_number(const Image& like, std::uint64_t number) {
  std::string name = like.file.filename().string();
  std::string digits = std::to_string(number);
  if (like.digits.size() > digits.size()) digits.insert(0, like.digits.size() - digits.size(), '0');
  if (const std::size_t at = name.rfind(like.digits); at != std::string::npos)
    name.replace(at, like.digits.size(), digits);
  return name;
}

/// Numbers with leading zeros have one width; only numbers too large for it have more digits. 5.png among 0004.png and
/// 0006.png is of another recording, or its copy lost its name.
Result<void> check_digits(const std::vector<Image>& images, const std::string& where) {
  const Image* padded = nullptr;
  for (const Image& image : images)
    if (image.digits.size() > 1 && image.digits.front() == '0' &&
        (padded == nullptr || image.digits.size() > padded->digits.size()))
      padded = &image;
  if (padded == nullptr) return {};
  for (const Image& image : images)
    if (!image.digits.empty() && image.digits.size() < padded->digits.size())
      return bad(
          where, image.file.string() + " has fewer digits than " + padded->file.string(),
          "rename it to " + with_number(*padded, *image.number) + " if it belongs to this recording, else remove it");
  return {};
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

/// The images of a folder, by what they show.
struct Listing {
  std::vector<Image> depth, color;
};

Listing listing_of(const std::vector<fs::path>& files) {
  Listing listing;
  std::vector<Image> unmarked;
  for (const fs::path& file : files) {
    if (!is_image(file)) continue;
    const Kind kind = kind_of(file);
    (kind == Kind::Depth   ? listing.depth
     : kind == Kind::Color ? listing.color
                           : unmarked)
        .push_back(image_of(file, kind));
  }
  if (listing.depth.empty()) listing.depth = std::move(unmarked);
  return listing;
}

/// Finds the colour image of a depth image: by equal names, or else by equal numbers.
class ColorFinder {
 public:
  explicit ColorFinder(const std::vector<Image>& color) {
    for (const Image& image : color) {
      by_key_[image.key] = image.file;
      if (image.number) by_number_[*image.number].push_back(image.file);
    }
  }
  [[nodiscard]] std::optional<fs::path> of(const Image& depth) const {
    if (const auto named = by_key_.find(depth.key); named != by_key_.end()) return named->second;
    if (!depth.number) return std::nullopt;
    const auto numbered = by_number_.find(*depth.number);
    if (numbered == by_number_.end() || numbered->second.size() != 1) return std::nullopt;
    return numbered->second.front();
  }

 private:
  std::map<std::string, fs::path> by_key_;
  std::map<std::uint64_t, std::vector<fs::path>> by_number_;
};

}  // namespace

Result<std::vector<ImagePair>> order_images(const std::vector<fs::path>& files, const std::string& where) {
  auto [depth, color] = listing_of(files);
  if (depth.empty())
    return bad(where, "holds no depth images",
               "give a folder of 16-bit grey PNG or TIFF images, or a folder that holds the folders depth and rgb");
  std::sort(depth.begin(), depth.end(),
            [](const Image& a, const Image& b) { return a.number != b.number ? a.number < b.number : a.key < b.key; });
  if (const Result<void> checked = check_numbers(depth, where); !checked) return checked.error();
  for (const std::vector<Image>* images : {&depth, &color})
    if (const Result<void> checked = check_digits(*images, where); !checked) return checked.error();
  const ColorFinder finder(color);
  std::vector<ImagePair> pairs;
  for (const Image& image : depth) {
    pairs.push_back({image.file, finder.of(image)});
    if (!color.empty() && !pairs.back().color)
      return bad(where,
                 image.file.string() + " has no colour image of its name or number, such as " +
                     color.front().file.string() + " has",
                 "add the colour image, or remove all colour images");
  }
  return pairs;
}

}  // namespace telepalp::capture
