// uhas-sphere-frame: where the canonical sphere stands in a hand.
#include <iostream>

#include "input/hand_input.hpp"
#include "json/stage_json.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"
#include "text/words.hpp"

using namespace uhas;
using namespace uhas::tools;

namespace {

std::string coordinates(Vector3d v, std::string (*format)(double)) {
  return "(" + format(v.x) + ", " + format(v.y) + ", " + format(v.z) + ")";
}

std::string component(double value) { return fixed(value, 3); }

void print(const BuildStages& stages) {
  const Anatomy& anatomy = stages.anatomy;
  const SphereFrame& frame = stages.sphere_frame;
  const RigidTransformd T_root_sphere = anatomy.T_root_palm * frame.T_palm_sphere;

  std::cout << "Hand    " << anatomy.hand;
  if (anatomy.handedness != Handedness::none) std::cout << ", a " << to_word(anatomy.handedness) << " hand";
  std::cout << "\nPalm    link " << anatomy.palm_link << ", centre "
            << coordinates(anatomy.T_root_palm * frame.palm_center_palm, millimetres) << " mm\nSphere  radius "
            << millimetres(frame.radius) << " mm, centre " << coordinates(T_root_sphere.translation, millimetres)
            << " mm\n        z = palm normal " << coordinates(T_root_sphere.rotation.column(2), component)
            << "\n        x " << coordinates(T_root_sphere.rotation.column(0), component) << "\nAll in the frame of "
            << anatomy.root_link << ".\n\n";

  Table table({{"finger"},
               {"slots"},
               {"tip link"},
               {"palm centre to tip, mm", Align::right},
               {"open azimuth, deg", Align::right}});
  for (const int i : fingers_by_slot(frame)) {
    std::vector<std::string> slots;
    for (const int slot : slot_numbers(frame.slots[i])) slots.push_back(std::to_string(slot));
    table.add_row({frame.names[i], join(slots, ","), anatomy.links[anatomy.fingers[i].tip_link].name,
                   millimetres(frame.tip_distance[i]), degrees(frame.open_azimuth[i])});
  }
  table.print(std::cout);
}

ExitCode run(Tool& tool) {
  HandInput input;
  tool.options().description("Shows the sphere frame of a robot hand: centre, radius, axes, and the fingers' slots.");
  add_hand_options(tool.options(), input);
  tool.parse();

  const BuildStages stages = run_stages(tool, input, BuildStage::sphere_frame);
  if (tool.json())
    std::cout << to_text(sphere_frame_json(stages));
  else
    print(stages);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) { return run_tool("uhas-sphere-frame", argc, argv, run); }
