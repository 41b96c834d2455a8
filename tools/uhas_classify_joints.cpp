// uhas-classify-joints: which joints move a fingertip sideways, which curl it.
#include <iostream>

#include "input/hand_input.hpp"
#include "json/stage_json.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"
#include "text/words.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

void print(const BuildStages& stages) {
  Table table({{"finger"},
               {"joint"},
               {"class"},
               {"sideways, mm", Align::right},
               {"curling, mm", Align::right},
               {"margin", Align::right},
               {"remark"}});
  for (const int i : fingers_by_slot(stages.sphere_frame)) {
    const std::vector<int>& joints = stages.anatomy.fingers[i].joints;
    for (const int index : joints) {
      const Joint& joint = stages.anatomy.tree.joints[index];
      const JointClassification& found = stages.joint_classes[index];
      std::string remark;
      if (joint.mimic_master >= 0)
        remark = "follows " + stages.anatomy.tree.joints[joint.mimic_master].name;
      else if (found.flexed_probe)
        remark = "measured with the joints further out flexed";
      table.add_row({index == joints.front() ? stages.sphere_frame.names[i] : "", joint.name,
                     to_word(found.joint_class), millimetres(found.lateral_motion),
                     millimetres(found.encompassing_motion), fixed(found.margin, 2), remark});
    }
  }
  table.print(std::cout);
  if (!stages.anatomy.other_joints.empty())
    std::cout << "Not of a finger: " << join(stages.anatomy.other_joints, ", ") << '\n';
}

ExitCode run(Tool& tool) {
  HandInput input;
  tool.options().description(
      "Tells the lateral joints of a robot hand, which move a fingertip across the sphere, from the encompassing "
      "ones.");
  add_hand_options(tool.options(), input);
  tool.parse();

  const BuildStages stages = run_stages(tool, input, BuildStage::classification);
  if (tool.json())
    std::cout << to_text(joint_classes_json(stages));
  else
    print(stages);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-classify-joints", argc, argv, run); }
