// Self-collision of a posed hand (docs/method.md#self-collision): whether links touch that should not, and how near the
// nearest come.
//
//   const SelfCollision collision(profile, hand_geometry(profile, model, "hand.urdf"));
//   if (collision.collides(q)) ...
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "uhas/geometry/hand_geometry.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// What is asked of a pair of links.
enum class LinkPairUse : int {
  checked = 0,   ///< contact, and distance
  apart = 1,     ///< contact only: it never touched in the sample, so its distance would hide those that matter
  touching = 2,  ///< nothing: it touched in at least `SelfCollisionOptions::touching_share` of the sample, as built
  adjacent = 3,  ///< nothing: the links hold together, rigidly or by joints without geometry between them
};

/// Two links with geometry.
struct LinkPair {
  int first = -1, second = -1;  ///< indices into `HandProfile::links`, first < second
  LinkPairUse use = LinkPairUse::checked;

  friend bool operator==(const LinkPair&, const LinkPair&) = default;
};

struct SelfCollisionOptions {
  int samples = 1000;      ///< poses drawn, besides q_open, q_sphere and q_closed, to tell the uses of pairs
  std::uint64_t seed = 1;  ///< of those poses
  /// In (0, 1]. On the hands known to us what overlaps by design touches in 95 % of the poses and more, all else
  /// in under half.
  double touching_share = 0.9;
  /// Of the whole hand; one with more is simplified to that. FCL takes half a kilobyte a triangle.
  std::size_t max_triangles = 500'000;
};

/// The two links that come nearest to each other.
struct NearestLinks {
  /// m; 0 in contact: how deep is not told. Infinite when no pair is checked.
  double distance = std::numeric_limits<double>::infinity();
  int first = -1, second = -1;  ///< indices into `HandProfile::links`, first < second; -1 when no pair is checked
  bool colliding = false;
};

/// The surfaces of a hand, ready to be posed. Immutable: one serves any number of threads.
///
/// Two links are in contact when their surfaces meet, or when one holds a whole piece of the other inside. Distances
/// are those of the meshes, not of convex hulls, which fill the hollow of a palm.
class SelfCollision {
 public:
  /// `geometry`: one mesh a link of `profile`. Throws Error(invalid_option) for options out of range.
  SelfCollision(const HandProfile& profile, const HandGeometry& geometry, const SelfCollisionOptions& options = {});
  SelfCollision(SelfCollision&&) noexcept;
  SelfCollision& operator=(SelfCollision&&) noexcept;
  ~SelfCollision();

  /// Every pair of links with geometry, ordered by `first`, then `second`.
  std::span<const LinkPair> pairs() const noexcept;

  /// Length of `q` below: every joint of the profile, in its order, mimic followers included (rad; m
  /// for prismatic joints).
  int joint_count() const noexcept;

  /// Whether any pair that is checked or apart is in contact at `q`.
  bool collides(std::span<const double> q) const;

  /// Indices into `pairs()` of all of those that are in contact at `q`, increasing.
  std::vector<int> colliding_pairs(std::span<const double> q) const;

  /// The first pair in contact if there is one, else the checked pair of least distance.
  NearestLinks nearest(std::span<const double> q) const;

 private:
  struct Hand;
  std::unique_ptr<const Hand> hand_;
};

}  // namespace uhas
