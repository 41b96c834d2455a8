// A file of actions, and the same bytes as JSON Lines: actions that a solver takes, or an Error.
#include "input/actions.hpp"

#include <sstream>

#include "fuzz_file.hpp"
#include "support/small_profile.hpp"
#include "uhas/json/json_lines.hpp"

using namespace uhas;
using namespace uhas::test;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static CascadeSolver<double> solver(small_profile());
  std::vector<double> q(static_cast<std::size_t>(solver.joint_count()));
  const std::string text(as_text(data, size));

  tools::ActionsDocument document;
  if (accepted([&] { document = tools::read_actions(input_file("actions.json", text)); }))
    for (std::size_t i = 0; i < document.actions.size(); ++i) {
      const Status status = solver.solve(document.action(i), q);
      require(status == Status::ok || status == Status::invalid_driving_vectors);
    }

  std::istringstream in(text);
  std::ostringstream out;
  answer_json_lines(in, out, [&](const Json& value) -> Json {
    const std::vector<double> action = tools::action_of(value);
    require(solver.solve({.values = action}, q) == Status::ok);
    return q;
  });
  return 0;
}
