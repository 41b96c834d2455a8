#include "tables/hand_explanation.hpp"

#include "output/output.hpp"
#include "tables/findings.hpp"
#include "tables/table.hpp"
#include "uhas/profile_builder/complete_config.hpp"

namespace uhas::tools {
namespace {

/// Every item as the hand config states it.
Json stated_items(const BuildStages& stages, const BuildSettings& settings) {
  return Json::parse(to_canonical_json(complete_config(stages, settings)));
}

std::string role_of(const Anatomy& anatomy, int finger) {
  if (finger == anatomy.thumb) return "thumb";
  return finger == anatomy.middle ? "middle finger" : "";
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

void print_hand_explanation(std::ostream& out, const BuildStages& stages) {
  print_findings(out, stage_findings(stages));

  const Anatomy& anatomy = stages.anatomy;
  Table table({{"finger"}, {"joints"}, {"tip link"}, {"point, mm", Align::right}, {"remark"}});
  for (const int i : fingers_by_slot(stages.sphere_frame)) {
    const FingerAnatomy& finger = anatomy.fingers[i];
    std::vector<std::string> joints;
    for (const int joint : finger.joints) joints.push_back(anatomy.tree.joints[joint].name);
    const Vector3d p = finger.p_tip_link;
    table.add_row({stages.sphere_frame.names[i], join(joints, " "), anatomy.links[finger.tip_link].name,
                   join({millimetres(p.x), millimetres(p.y), millimetres(p.z)}, " "), role_of(anatomy, i)});
  }
  out << '\n';
  table.print(out);
  if (!anatomy.other_joints.empty()) out << "Not of a finger: " << join(anatomy.other_joints, ", ") << '\n';
}

void add_write_config_option(CLI::App& app, std::string& path) {
  app.add_option("--write-config", path,
                 "Also write what was found as a hand config, to be corrected and given to --config")
      ->type_name("FILE");
}

void write_hand_config(const std::string& path, const BuildStages& stages, const BuildSettings& settings) {
  if (path.empty()) return;
  Json document = new_document("uhas-hand-config");
  document.update(stated_items(stages, settings));
  write_result(path, to_text(document));
}

}  // namespace uhas::tools
