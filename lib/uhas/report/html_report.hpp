// A hand's action space as a page that anyone can open: one HTML file with the hand's meshes, the sphere and the
// runtime itself, which solves in the page. It needs no network and no server.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "uhas/geometry/hand_geometry.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// Actions to play in the page, in uhas' own convention.
struct ReportTimeline {
  std::vector<std::vector<double>> actions;  ///< [5 + 5 V] each, all of the same V; see Action
  std::vector<double> driving_vectors_phi;   ///< [V] or [5 V] polar angles; empty = the default ones
  bool normalized = false;                   ///< the actions are in [-1, 1]
  SolveOptions options;                      ///< of uhas' own convention
};

struct ReportHand {
  HandProfile profile;
  HandGeometry geometry;        ///< its meshes, simplified here; without links: points and skeleton are drawn alone
  std::string summary_json;     ///< what the tables say: a document of schemas/profile-summary.schema.json
  std::string evaluation_json;  ///< how well the hand does: a JSON document of tables; empty = nothing of this
  std::optional<ReportTimeline> timeline;
};

/// Throws Error(invalid_option) in a build without the page (UHAS_BUILD_REPORT), as `html_report` does there.
void require_html_report();

/// The page of these hands, side by side, moved by one set of inputs: the same bytes for the same input. With 40,000
/// triangles and 6,000 points a hand at most, one hand takes 2 to 3 MB. Throws Error: invalid_profile for a profile
/// that `validate_profile` refuses, invalid_action for actions that the solver refuses.
std::string html_report(const std::string& title, const std::vector<ReportHand>& hands);

}  // namespace uhas
