#include "tools/study/designer/live_design.h"

#include "haptic_station/mechanism/four_bar.h"
#include "tools/study/designer/answers.h"
#include "tools/study/task/tools.h"

namespace telepalp::study {

Result<LiveDesign> LiveDesign::make() {
  auto tissue = tissue::make_tissue(tissue_of(Plant{}));
  if (!tissue) return tissue.error();
  const Configuration first = amniocentesis_design().configurations.front();
  Result<LiveTool> tool = LiveTool::make(first, Plant{}, *tissue);
  if (!tool) return tool.error();
  return LiveDesign(first, std::move(*tool), std::move(*tissue));
}

LiveDesign::LiveDesign(Configuration design, LiveTool tool, LiveTool::Model tissue)
    : design_(std::move(design)),
      tool_(std::move(tool)),
      tissue_(std::move(tissue)),
      reach_(reach_of(tool_.outside())) {}

std::string LiveDesign::choose(const Configuration& wanted) {
  Result<LiveTool> next = LiveTool::make(wanted, Plant{}, tissue_);
  if (!next) return refused_json("design", next.error());
  design_ = wanted;
  use(std::move(*next));
  return answer(put_in_m_ > 0.0 ? tool_.insert(put_in_m_) : std::vector<TracePoint>{});
}

void LiveDesign::use(LiveTool tool) {
  tool_ = std::move(tool);
  next_.reset();
  reach_ = reach_of(tool_.outside());
}

std::string LiveDesign::change(const Configuration& wanted, const LiveFrame& now) {
  const mechanism::FourBar bar = bar_of(wanted, Plant{});
  if (const auto good = mechanism::checked_at(bar, now.link3_rad); !good) return refused_json("design", good.error());
  Result<LiveTool> next = LiveTool::make(wanted, Plant{}, tissue_);
  if (!next) return refused_json("design", next.error());
  design_ = wanted;
  next_ = std::move(*next);
  const auto branch = now.open ? mechanism::Branch::Open : mechanism::Branch::Crossed;
  reach_ = reach_of({bar, tool_.outside().plane(), now.link3_rad, branch});
  return design_json(now, bar, reach_, {});
}

std::string LiveDesign::renew() {
  if (next_)
    use(LiveTool(*next_));
  else
    tool_.renew();
  put_in_m_ = 0.0;
  return answer({});
}

std::optional<std::string> LiveDesign::step(double seconds) {
  if (tool_.at_rest()) return std::nullopt;
  const std::vector<TracePoint> trace = tool_.step(seconds);
  put_in_m_ = tool_.depth_m();
  return frame_json(tool_.frame(), trace);
}

std::string LiveDesign::answer(const std::vector<TracePoint>& trace) const {
  return design_json(tool_.frame(), tool_.linkage().bar(), reach_, trace);
}

}  // namespace telepalp::study
