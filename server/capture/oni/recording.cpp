#include "server/capture/oni/recording.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <span>

#include "proto/words/counted.h"
#include "proto/words/little_endian.h"
#include "server/capture/oni/depth_16z.h"
#include "server/capture/oni/record_walk.h"
#include "server/capture/oni/stream_property.h"

namespace telepalp::capture {
namespace {

constexpr std::uint32_t kDepthNode = 2;
constexpr std::uint32_t kImageNode = 3;
constexpr std::size_t kMostImages = 10'000'000;

/// Data of a stream, collected while the file is read.
struct Gathering {
  std::uint32_t type = 0;
  std::uint32_t declared_frames = 0;
  OniStream stream;
};

using Nodes = std::map<std::uint32_t, Gathering>;

OniCodec codec_of(std::string_view letters) {
  if (letters == "NONE") return OniCodec::Uncompressed;
  if (letters == "JPEG") return OniCodec::Jpeg;
  if (letters == "16zP") return OniCodec::Depth16z;
  if (letters == "16zT") return OniCodec::Depth16zTable;
  return OniCodec::Unknown;
}

void add_node(const OniRecord& record, Nodes& nodes) {
  const std::optional<OniNode> node = node_in(record);
  if (!node || (node->type != kDepthNode && node->type != kImageNode)) return;
  Gathering& gathering = nodes[record.node];
  gathering.type = node->type;
  gathering.declared_frames = node->frames.value_or(0);
  gathering.stream.codec = codec_of(node->codec);
}

/// Sets the pixel format from OpenNI 1's number.
void set_format1(OniStream& stream, std::uint64_t format) {
  constexpr std::uint64_t kRgb24 = 1;
  constexpr std::uint64_t kMotionJpeg = 5;
  stream.is_jpeg_or_rgb = format == kRgb24 || format == kMotionJpeg;
  if (format == kMotionJpeg) stream.codec = OniCodec::Jpeg;
}

/// Sets the pixel format from OpenNI 2's number.
void set_format2(OniStream& stream, std::uint64_t format) {
  constexpr std::uint64_t kDepth100um = 101;
  constexpr std::uint64_t kRgb888 = 200;
  constexpr std::uint64_t kJpeg = 204;
  stream.is_jpeg_or_rgb = format == kRgb888 || format == kJpeg;
  if (format == kDepth100um) stream.depth_unit_m = 0.0001;
  if (format == kJpeg) stream.codec = OniCodec::Jpeg;
}

int side(std::string_view value, std::size_t at) {
  return static_cast<int>(
      std::min<std::uint32_t>(get_little_endian<std::uint32_t>(value.data() + at), kMaxImageSide + 1));
}

void take_property(const OniProperty& property, OniStream& stream) {
  const auto& [name, value] = property;
  if (name == "xnMapOutputMode" && value.size() == 12) {
    stream.width = side(value, 0);
    stream.height = side(value, 4);
  } else if (name == "xnFOV" && value.size() == 16) {
    stream.horizontal_view_rad = get_little_endian<double>(value.data());
    stream.vertical_view_rad = get_little_endian<double>(value.data() + 8);
  } else if (name == "xnCropping" && value.size() == 12) {
    stream.cropped = get_little_endian<std::uint32_t>(value.data()) != 0;
  } else if (name == "xnPixelFormat" && value.size() == 8) {
    set_format1(stream, get_little_endian<std::uint64_t>(value.data()));
  } else if (name == "oniPixelFormat" && value.size() == 8) {
    set_format2(stream, get_little_endian<std::uint64_t>(value.data()));
  }
}

/// The image in a data record; nullopt when the record is incomplete.
std::optional<OniImage> image_in(const OniRecord& record) {
  constexpr std::uint64_t kLongest_us = std::uint64_t{365} * 24 * 3600 * 1'000'000;
  constexpr std::uint32_t kMostBytes = 64U << 20U;  // a raw colour image of the largest accepted size has 48 MiB
  if (record.fields.size() < 12 || record.payload_bytes == 0 || record.payload_bytes > kMostBytes) return std::nullopt;
  const auto time_us = get_little_endian<std::uint64_t>(record.fields.data());
  if (time_us > kLongest_us) return std::nullopt;
  return OniImage{std::chrono::microseconds{time_us}, record.payload_at, record.payload_bytes};
}

/// Reads one record into `nodes`; false for an invalid record of a stream.
bool take(const OniRecord& record, Nodes& nodes) {
  if (record.kind == OniRecordKind::NodeAdded || record.kind == OniRecordKind::NodeAdded5 ||
      record.kind == OniRecordKind::NodeAdded4)
    add_node(record, nodes);
  const auto node = nodes.find(record.node);
  if (node == nodes.end()) return true;
  OniStream& stream = node->second.stream;
  if (record.kind == OniRecordKind::IntProperty || record.kind == OniRecordKind::GeneralProperty) {
    const std::optional<OniProperty> property = property_in(record);
    if (property) take_property(*property, stream);
    return property.has_value();
  }
  if (record.kind != OniRecordKind::NewData) return true;
  const std::optional<OniImage> image = image_in(record);
  if (image && stream.images.size() < kMostImages) stream.images.push_back(*image);
  return image.has_value();
}

/// The first node of a type with images, or else the first node of that type.
const Gathering* first_of(const Nodes& nodes, std::uint32_t type) {
  const Gathering* first = nullptr;
  for (const auto& [id, node] : nodes)
    if (node.type == type && (first == nullptr || (first->stream.images.empty() && !node.stream.images.empty())))
      first = &node;
  return first;
}

bool has_size(const OniStream& stream) {
  return stream.width > 0 && stream.height > 0 && stream.width <= kMaxImageSide && stream.height <= kMaxImageSide;
}

/// Why no depth can be decoded; empty when it can.
std::string reason_against(const OniStream& depth) {
  if (!has_size(depth))
    return "the size of its depth images is not 1 to " + std::to_string(kMaxImageSide) + " pixels a side";
  if (depth.cropped) return "its depth images are cropped";
  if (depth.codec == OniCodec::Jpeg || depth.codec == OniCodec::Unknown)
    return "its depth is compressed by an unknown method";
  return {};
}

void say(std::string& complaint, const std::string& more) { complaint += (complaint.empty() ? "" : "; ") + more; }

/// Text about the damage of the file.
std::string complaint_of(const OniRecordWalk& walk, std::uint64_t senseless, const Gathering& depth) {
  std::string complaint;
  if (walk.damaged() > 0)
    say(complaint, counted(walk.damaged(), "part", "parts") + " damaged, the first at byte " +
                       std::to_string(walk.first_damage_at()) + " of " + std::to_string(walk.file_bytes()));
  if (senseless > 0)
    say(complaint, counted(senseless, "record is invalid and is left out", "records are invalid and are left out"));
  if (!walk.reached_end_record())
    say(complaint,
        "the recording is cut off at byte " + std::to_string(walk.file_bytes()) + ", without its end record");
  const std::size_t images = depth.stream.images.size();
  if (depth.declared_frames > 0 && images != depth.declared_frames)
    say(complaint, "the recording holds " + counted(images, "depth image", "depth images") + ", but its header says " +
                       std::to_string(depth.declared_frames));
  return complaint;
}

void sort_by_time(OniStream& stream) {
  std::stable_sort(stream.images.begin(), stream.images.end(),
                   [](const OniImage& a, const OniImage& b) { return a.time < b.time; });
}

}  // namespace

Result<OniRecording> read_oni_recording(std::istream& file, const std::string& name) {
  Result<OniRecordWalk> walk = OniRecordWalk::open(file, name);
  if (!walk) return walk.error();
  Nodes nodes;
  std::uint64_t senseless = 0;
  while (const std::optional<OniRecord> record = walk->next())
    if (!take(*record, nodes)) ++senseless;
  const Gathering* depth = first_of(nodes, kDepthNode);
  const Gathering nothing;
  OniRecording recording{.depth = {}, .color = {}, .complaint = {}};
  recording.complaint = complaint_of(*walk, senseless, depth == nullptr ? nothing : *depth);
  const std::string reason = depth == nullptr               ? "it has no depth stream"
                             : depth->stream.images.empty() ? "it has no depth image"
                                                            : reason_against(depth->stream);
  if (!reason.empty())
    return Error{
        .what = "cannot be played: " + reason + (recording.complaint.empty() ? "" : "; ") + recording.complaint,
        .where = name,
        .fix = "copy the whole recording again, or record again with OpenNI's recorder (NiViewer), without cropping"};
  recording.depth = depth->stream;
  sort_by_time(recording.depth);
  const Gathering* color = first_of(nodes, kImageNode);
  if (color == nullptr || color->stream.images.empty()) return recording;
  const OniCodec codec = color->stream.codec;
  const bool readable = (codec == OniCodec::Jpeg || codec == OniCodec::Uncompressed) && color->stream.is_jpeg_or_rgb;
  if (!readable || color->stream.cropped || !has_size(color->stream)) {
    say(recording.complaint,
        "its colour images are cropped, or have a format or size that is not supported: only depth is played");
    return recording;
  }
  recording.color = color->stream;
  sort_by_time(recording.color);
  return recording;
}

Result<DepthImage> read_oni_depth(std::istream& file, const OniStream& depth, const OniImage& image,
                                  const std::string& name) {
  const auto failed = [&](const std::string& what) {
    return Error{
        .what = what, .where = name + ": byte " + std::to_string(image.at), .fix = "copy the whole recording again"};
  };
  const std::optional<std::string> packet = read_at(file, image.at, image.bytes);
  if (!packet) return failed("a depth image cannot be read: the file has become shorter");
  const auto bytes = std::as_bytes(std::span(*packet));
  const std::size_t count = static_cast<std::size_t>(depth.width) * static_cast<std::size_t>(depth.height);
  std::optional<std::vector<std::uint16_t>> samples;
  if (depth.codec == OniCodec::Depth16z) samples = decode_16z(bytes, count);
  if (depth.codec == OniCodec::Depth16zTable) samples = decode_16z_table(bytes, count);
  if (depth.codec == OniCodec::Uncompressed && bytes.size() == 2 * count) {
    samples.emplace(count);
    std::memcpy(samples->data(), bytes.data(), bytes.size());
  }
  if (!samples) return failed("a depth image is damaged");
  return DepthImage{depth.width, depth.height, depth.depth_unit_m, std::move(*samples)};
}

}  // namespace telepalp::capture
