#include "tools/export_tool/deidentify/text_rules.h"

#include <algorithm>
#include <array>
#include <string>

#include "proto/wire/topics.h"

namespace telepalp::export_tool {
namespace {

struct Ruled {
  std::string_view field;  ///< full name of the Protobuf field
  TextRule rule;
};

/// The fields whose text may stay. A new field is removed until somebody adds it here.
constexpr std::array kRules{
    Ruled{"foxglove.CameraCalibration.distortion_model", TextRule::Word},
    Ruled{"foxglove.CameraCalibration.frame_id", TextRule::Word},
    Ruled{"foxglove.CompressedImage.data", TextRule::Data},
    Ruled{"foxglove.CompressedImage.format", TextRule::Word},
    Ruled{"foxglove.CompressedImage.frame_id", TextRule::Word},
    Ruled{"foxglove.CompressedVideo.data", TextRule::Data},
    Ruled{"foxglove.CompressedVideo.format", TextRule::Word},
    Ruled{"foxglove.CompressedVideo.frame_id", TextRule::Word},
    Ruled{"telepalp.msg.DepthImage.data", TextRule::Data},
    Ruled{"telepalp.msg.DepthImage.format", TextRule::Word},
    Ruled{"telepalp.msg.DepthImage.frame_id", TextRule::Word},
    Ruled{"telepalp.msg.EffectCost.name", TextRule::Word},  // the kind of the effect, as the program calls it
    Ruled{"telepalp.msg.FemPrismEffect.name", TextRule::Number},
    Ruled{"telepalp.msg.InnerStructure.name", TextRule::Number},
    Ruled{"telepalp.msg.InnerStructure.points", TextRule::Data},
    Ruled{"telepalp.msg.InnerStructure.triangles", TextRule::Data},
    Ruled{"telepalp.msg.LayeredTissueEffect.Layer.name", TextRule::Number},
    Ruled{"telepalp.msg.ObjectPlacement.name", TextRule::Number},
    Ruled{"telepalp.msg.RegionsEffect.Region.name", TextRule::Number},
    Ruled{"telepalp.msg.ServerStats.PerSubscriber.name", TextRule::Number},
    Ruled{"telepalp.msg.ServerStats.PerTopic.topic", TextRule::Topic},
    Ruled{"telepalp.msg.ServerStats.software", TextRule::Software},
    Ruled{"telepalp.msg.SkinEffect.tissue", TextRule::Word},
    Ruled{"telepalp.msg.SolidEffect.name", TextRule::Number},
    Ruled{"telepalp.msg.StationStats.software", TextRule::Software},
    Ruled{"telepalp.msg.SurfaceReport.depth_mode", TextRule::Word},
    Ruled{"telepalp.msg.SurfaceReport.index", TextRule::Word},
    Ruled{"telepalp.msg.SurfaceReport.setting", TextRule::Word},
    Ruled{"telepalp.msg.SurfaceSetting.name", TextRule::Word},
    Ruled{"telepalp.msg.UltrasoundImage.jpeg", TextRule::Picture},
};

constexpr std::size_t kLongestText = 100;

}  // namespace

bool has_form(std::string_view text, const std::regex& pattern) {
  return text.size() <= kLongestText && std::regex_match(text.begin(), text.end(), pattern);
}

TextRule rule_of(const google::protobuf::FieldDescriptor& field) {
  const auto found = std::ranges::find(kRules, std::string_view(field.full_name()), &Ruled::field);
  return found == kRules.end() ? TextRule::Remove : found->rule;
}

bool may_stay(TextRule rule, std::string_view text) {
  static const std::regex kWord("(PCL )?[a-z][a-z0-9_]*([ -](KD-tree|[a-z0-9_]+)){0,2}|PCL KD-tree");
  static const std::regex kSoftware("telepalp-[a-z]+ [0-9]+(\\.[0-9]+)*(, commit [0-9a-f]+)?");
  switch (rule) {
    case TextRule::Remove:
    case TextRule::Number:
      return false;
    case TextRule::Word:
      return has_form(text, kWord);
    case TextRule::Topic:
      return wire::find_topic(text).has_value();
    case TextRule::Software:
      return has_form(text, kSoftware);
    case TextRule::Data:
    case TextRule::Picture:
      return true;
  }
  return false;
}

}  // namespace telepalp::export_tool
