#include "uhas/collision/self_collision.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "uhas/base/errors.hpp"
#include "uhas/collision/surfaces/link_pairs.hpp"
#include "uhas/collision/surfaces/link_surface.hpp"
#include "uhas/geometry/simplified_geometry.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

using Poses = std::vector<RigidTransformd>;  // T_palm_link[link]

void check(const HandProfile& profile, const HandGeometry& geometry, const SelfCollisionOptions& options) {
  const auto require = [](bool holds, const char* problem) {
    if (!holds) throw Error(ErrorCode::invalid_option, "", problem, "");
  };
  require(geometry.links.size() == profile.links.size(), "the geometry is not that of the profile: it has other links");
  require(options.samples >= 0, "samples must not be negative");
  require(options.touching_share > 0 && options.touching_share <= 1, "touching_share must lie in (0, 1]");
}

/// Poses that tell the uses of pairs: those of the profile, then random ones, every other one with a third of its
/// joints at each end of its range, where most contacts are.
class PoseSample {
 public:
  PoseSample(const HandProfile& profile, const SelfCollisionOptions& options)
      : profile_(profile), random_(options.seed), size_(kNamedPoses + options.samples) {}

  int size() const { return size_; }

  /// The pose of index `i`, asked for in order.
  std::vector<double> pose(int i) {
    std::vector<double> q;
    for (std::size_t j = 0; j < profile_.tree.joints.size(); ++j) {
      const JointTraits& traits = profile_.joint_traits[j];
      const Joint& joint = profile_.tree.joints[j];
      const double named[kNamedPoses] = {traits.q_open, traits.q_sphere, traits.q_closed};
      q.push_back(i < kNamedPoses ? named[i] : joint.lower + place_in_range(i % 2 == 0) * (joint.upper - joint.lower));
    }
    apply_mimics(profile_.tree, q);
    return q;
  }

 private:
  static constexpr int kNamedPoses = 3;

  double place_in_range(bool often_at_ends) {
    const double uniform = static_cast<double>(random_() >> 11) * 0x1p-53;  // [0, 1), the same with every compiler
    return often_at_ends ? std::clamp(3 * uniform - 1, 0.0, 1.0) : uniform;
  }

  const HandProfile& profile_;
  std::mt19937_64 random_;
  int size_;
};

}  // namespace

struct SelfCollision::Hand {
  KinematicTree tree;
  std::vector<ProfileLink> links;
  std::vector<std::optional<LinkSurface>> surfaces;  // [link]
  std::vector<LinkPair> pairs;

  Poses place_links(std::span<const double> q) const { return link_poses(tree, links, q); }

  /// The second link's frame in that of the first.
  static RigidTransformd relative_pose(const LinkPair& pair, const Poses& T_palm_link) {
    return T_palm_link[pair.first].inverse() * T_palm_link[pair.second];
  }

  bool in_contact(const LinkPair& pair, const Poses& T_palm_link) const {
    return surfaces[pair.first]->in_contact(*surfaces[pair.second], relative_pose(pair, T_palm_link));
  }

  static bool matters(const LinkPair& pair) {
    return pair.use == LinkPairUse::checked || pair.use == LinkPairUse::apart;
  }

  /// Index of the first pair from `begin` on that matters and is in contact; that past the last when there is none.
  std::size_t next_contact(const Poses& T_palm_link, std::size_t begin = 0) const {
    while (begin < pairs.size() && !(matters(pairs[begin]) && in_contact(pairs[begin], T_palm_link))) ++begin;
    return begin;
  }

  void find_uses(PoseSample sample, double touching_share) {
    std::vector<int> contacts(pairs.size()), asked(pairs.size());
    const int most_apart = static_cast<int>((1 - touching_share) * sample.size());  // of a pair that is still touching
    for (int i = 0; i < sample.size(); ++i) {
      const Poses T_palm_link = place_links(sample.pose(i));
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs[k].use == LinkPairUse::adjacent) continue;
        if (contacts[k] > 0 && asked[k] - contacts[k] > most_apart) continue;  // known to be checked
        ++asked[k];
        contacts[k] += in_contact(pairs[k], T_palm_link);
      }
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (pairs[k].use == LinkPairUse::adjacent) continue;
      if (contacts[k] == 0)
        pairs[k].use = LinkPairUse::apart;
      else if (asked[k] - contacts[k] <= most_apart)
        pairs[k].use = LinkPairUse::touching;
    }
  }
};

SelfCollision::SelfCollision(const HandProfile& profile, const HandGeometry& geometry,
                             const SelfCollisionOptions& options) {
  check(profile, geometry, options);
  auto hand = std::make_unique<Hand>();
  hand->tree = profile.tree;
  hand->links = profile.links;

  std::vector<bool> has_geometry;
  for (const TriangleMesh& mesh : geometry.links) has_geometry.push_back(!mesh.triangles.empty());
  HandGeometry coarse;
  if (triangle_count(geometry) > options.max_triangles) coarse = simplified_geometry(geometry, options.max_triangles);
  hand->surfaces.resize(geometry.links.size());
  for (std::size_t i = 0; i < geometry.links.size(); ++i) {
    if (!has_geometry[i]) continue;
    const bool simplified = i < coarse.links.size() && !coarse.links[i].triangles.empty();  // no link is lost
    hand->surfaces[i].emplace(simplified ? coarse.links[i] : geometry.links[i]);
  }

  const LinkAdjacency adjacency(profile, has_geometry);
  const int count = static_cast<int>(profile.links.size());
  for (int first = 0; first < count; ++first)
    for (int second = first + 1; second < count; ++second)
      if (has_geometry[first] && has_geometry[second])
        hand->pairs.push_back(
            {first, second, adjacency.adjacent(first, second) ? LinkPairUse::adjacent : LinkPairUse::checked});
  hand->find_uses(PoseSample(profile, options), options.touching_share);
  hand_ = std::move(hand);
}

SelfCollision::SelfCollision(SelfCollision&&) noexcept = default;
SelfCollision& SelfCollision::operator=(SelfCollision&&) noexcept = default;
SelfCollision::~SelfCollision() = default;

std::span<const LinkPair> SelfCollision::pairs() const noexcept { return hand_->pairs; }

int SelfCollision::joint_count() const noexcept { return static_cast<int>(hand_->tree.joints.size()); }

bool SelfCollision::collides(std::span<const double> q) const {
  return hand_->next_contact(hand_->place_links(q)) < hand_->pairs.size();
}

std::vector<int> SelfCollision::colliding_pairs(std::span<const double> q) const {
  const Poses T_palm_link = hand_->place_links(q);
  std::vector<int> found;
  for (std::size_t k = hand_->next_contact(T_palm_link); k < hand_->pairs.size();
       k = hand_->next_contact(T_palm_link, k + 1))
    found.push_back(static_cast<int>(k));
  return found;
}

NearestLinks SelfCollision::nearest(std::span<const double> q) const {
  const Poses T_palm_link = hand_->place_links(q);
  if (const std::size_t k = hand_->next_contact(T_palm_link); k < hand_->pairs.size())
    return {0, hand_->pairs[k].first, hand_->pairs[k].second, true};

  // nearest bounding volumes first: once they are farther than the nearest surfaces, so is all that follows
  struct Candidate {
    double least_distance;
    const LinkPair* pair;
    RigidTransformd T;
  };
  std::vector<Candidate> candidates;
  for (const LinkPair& pair : hand_->pairs) {
    if (pair.use != LinkPairUse::checked) continue;
    const RigidTransformd T = Hand::relative_pose(pair, T_palm_link);
    candidates.push_back(
        {hand_->surfaces[pair.first]->least_possible_distance(*hand_->surfaces[pair.second], T), &pair, T});
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::least_distance);

  NearestLinks nearest;
  for (const auto& [least_distance, pair, T] : candidates) {
    if (least_distance >= nearest.distance) break;
    const double distance = hand_->surfaces[pair->first]->distance(*hand_->surfaces[pair->second], T, nearest.distance);
    if (distance < nearest.distance) nearest = {distance, pair->first, pair->second, false};
  }
  return nearest;
}

}  // namespace uhas
