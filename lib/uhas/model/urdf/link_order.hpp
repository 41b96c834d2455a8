// How the links and joints of a URDF hang together: one tree, and mimic couplings that end at independent joints.
#pragma once

#include <string>
#include <vector>

#include "uhas/model/urdf/urdf_reader.hpp"

namespace uhas {

struct OrderedLink {
  int link = -1;    ///< index into `Urdf::links`
  int parent = -1;  ///< position of the parent in this order; -1 = the root
  int joint = -1;   ///< index into `Urdf::joints` of the joint above; -1 = the root
};

/// The links depth first from the root, siblings by name: an order the order of elements in the file does not change.
/// Throws Error(invalid_model) unless the joints make the links one tree.
std::vector<OrderedLink> order_links(const Urdf& urdf, const std::string& file);

/// What a joint follows in the end: q = multiplier * q(master) + offset.
struct FlatMimic {
  int master = -1;  ///< index into `Urdf::joints` of an independent joint; -1 = the joint is independent itself
  double multiplier = 1, offset = 0;
};

/// One element a joint of `urdf`; a chain of mimics becomes one coupling to its last joint.
/// Throws Error(invalid_model) when a joint mimics itself, in a cycle, an unknown joint or a fixed one.
std::vector<FlatMimic> flatten_mimics(const Urdf& urdf, const std::string& file);

}  // namespace uhas
