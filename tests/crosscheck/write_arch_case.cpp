// Writes a hand with a joint that two fingers share, random actions, and the solver's answers, whose residuals the
// second reader must arrive at: they tell whose points are whose.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "support/arch_profile.hpp"
#include "support/random_action.hpp"
#include "uhas/profile_io/write_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;
using nlohmann::json;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_arch_case FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  const HandProfile profile = test::arch_profile();
  write_profile(profile, folder + "/profile.h5");

  CascadeSolver<double> solver(profile);
  std::vector<double> q(solver.joint_count());
  json joint_names, solutions = json::array(), actions = json::array();
  for (const Joint& joint : profile.tree.joints) joint_names.push_back(joint.name);
  std::mt19937_64 random(3);
  for (int n = 0; n < 40; ++n) {
    const std::vector<double> action = test::random_action(random, 0.3, n < 20 ? 0.4 : 1.5);
    SolveReport report;
    if (solver.solve({.values = action, .driving_vectors_phi = {}}, q, report) != Status::ok) return 1;
    actions.push_back(action);
    solutions.push_back({{"q", q}, {"residual_rms", report.residual_rms}});
  }
  std::ofstream(folder + "/actions.json") << json{{"format", "uhas-actions"}, {"version", 1}, {"actions", actions}};
  std::ofstream(folder + "/solution.json")
      << json{{"format", "uhas-solution"}, {"version", 1}, {"joint_names", joint_names}, {"solutions", solutions}};
}
