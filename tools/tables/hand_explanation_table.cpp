#include "tables/hand_explanation_table.hpp"

#include <ostream>

#include "tables/findings_table.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"
#include "text/words.hpp"

namespace uhas::tools {
namespace {

std::string role_of(const Anatomy& anatomy, int finger) {
  if (finger == anatomy.thumb) return "thumb";
  return finger == anatomy.middle ? "middle finger" : "";
}

}  // namespace

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

}  // namespace uhas::tools
