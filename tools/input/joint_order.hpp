// From the joints that a file lists to those of a hand profile.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

/// Takes rows in the order of a file to the profile's order, by name. Mimic followers may be missing, joints of the
/// URDF that no finger has may be there.
class JointOrder {
 public:
  /// The profile's own order.
  explicit JointOrder(const HandProfile& profile);

  /// Throws Error(syntax) in the name of `place` for a name that is missing, there twice, or no joint of the hand.
  JointOrder(const HandProfile& profile, const std::vector<std::string>& names, const std::string& place);

  std::size_t row_size() const { return row_size_; }  ///< values of a row of the file

  /// `row` [row_size] to `q` [profile joints]; followers that the file lacks are 0.
  void reorder(std::span<const double> row, std::span<double> q) const;

 private:
  std::size_t row_size_;
  std::vector<int> column_;  // [profile joint] where it stands in a row; -1 = not there
};

}  // namespace uhas::tools
