// The choice and the weights of the points that the solver sees.
#pragma once

#include <span>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Chooses at most `points_per_link` well-spread points of each link that a joint carries, and weighs each by the share
/// of the surface it stands for; every other point gets weight 0. The weights of a hand sum to 1.
///
/// Spread: farthest-point sampling in the link frame, begun at the point nearest to the mean of the link's points, so
/// that the choice follows the link wherever it is, however large, and mirrored too. Ties go to the earlier point.
/// Share: the number of the link's points that are nearest to the chosen one. The points stem from uniform directions,
/// so the count is an area as it is seen from the sphere's centre.
///
/// @param points  sorted by link
/// @param links   `Correspondence::link` indexes them; the palm's links (joint = -1) never move, so none of their
/// points is chosen
void assign_point_weights(std::span<Correspondence> points, std::span<const ProfileLink> links, int points_per_link);

}  // namespace uhas
