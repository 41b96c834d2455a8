#include "uhas/runtime/deformation_field.hpp"

#include "uhas/runtime/cascade/action_decoder.hpp"
#include "uhas/runtime/cascade/plane_groups.hpp"

namespace uhas {

struct DeformationField::State {
  ActionDecoder<double> decoder;
  bool held_toward_pole;
  PlaneGroups groups;
  std::vector<PlaneDeformation<double>> finger_planes;  // [finger]
  std::vector<PlaneDeformation<double>> planes;         // [group of planes]
};

DeformationField::DeformationField(const HandProfile& profile, const ActionConvention& convention) {
  check_convention(convention);
  validate_profile(profile, "");
  const PlaneGroups groups = group_planes(profile);
  state_ = std::make_unique<State>(State{.decoder = ActionDecoder<double>(profile, convention),
                                         .held_toward_pole = convention.held_toward_pole,
                                         .groups = groups,
                                         .finger_planes = std::vector<PlaneDeformation<double>>(profile.fingers.size()),
                                         .planes = std::vector<PlaneDeformation<double>>(groups.fingers.size())});
}

DeformationField::DeformationField(DeformationField&&) noexcept = default;
DeformationField& DeformationField::operator=(DeformationField&&) noexcept = default;
DeformationField::~DeformationField() = default;

Status DeformationField::deform(const Action<double>& action, std::span<Spherical<double>> points) noexcept {
  auto& [decoder, held_toward_pole, groups, finger_planes, planes] = *state_;
  // the deformation of each finger's plane, and its mean over fingers that stand in one plane
  if (const Status status = decoder.check(action); status != Status::ok) return status;
  decoder.decode(decoder.numbers_of(action), finger_planes.data());
  for (std::size_t g = 0; g < planes.size(); ++g)
    planes[g] = mean_plane(finger_planes, groups.fingers[g], held_toward_pole);

  // each point is moved by what is between the planes on either side of it
  for (Spherical<double>& point : points) {
    const BetweenPlanes place = locate_between_planes(point.azimuth, groups.azimuths);
    const Displacement<double> moved =
        displacement_between(planes[place.before], planes[place.after], place.blend, point.polar);
    point.azimuth += moved.delta_theta;
    point.radius += moved.radial.delta_r;
  }
  return Status::ok;
}

}  // namespace uhas
