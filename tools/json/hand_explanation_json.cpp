#include "json/hand_explanation_json.hpp"

#include "uhas/profile_builder/complete_config.hpp"

namespace uhas::tools {
namespace {

/// Every item as the hand config states it.
Json stated_items(const BuildStages& stages, const BuildSettings& settings) {
  return Json::parse(to_canonical_json(complete_config(stages, settings)));
}

}  // namespace

Json hand_explanation_json(const BuildStages& stages, const BuildSettings& settings) {
  const Json values = stated_items(stages, settings);
  Json items = Json::array();
  for (const HandFinding& finding : stage_findings(stages))
    items.push_back({{"item", finding.item},
                     {"value", values.at(finding.item)},
                     {"summary", finding.value},
                     {"confidence", finding.confidence},
                     {"reason", finding.reason}});
  Json document = new_document("uhas-hand-explanation");
  document["hand"] = stages.anatomy.hand;
  document["items"] = items;
  document["other_joints"] = stages.anatomy.other_joints;
  document["warnings"] = stage_warnings(stages);
  return document;
}

Json hand_config_json(const BuildStages& stages, const BuildSettings& settings) {
  Json document = new_document("uhas-hand-config");
  document.update(stated_items(stages, settings));
  return document;
}

}  // namespace uhas::tools
