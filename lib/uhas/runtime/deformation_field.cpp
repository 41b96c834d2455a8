#include "uhas/runtime/deformation_field.hpp"

#include "uhas/runtime/cascade/plane_groups.hpp"
#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {

struct DeformationField::State {
  std::shared_ptr<const SolverModel<double>> model;
  std::vector<PlaneDeformation<double>> finger_planes;  // [finger]
  std::vector<PlaneDeformation<double>> planes;         // [group of planes]
};

DeformationField::DeformationField(const HandProfile& profile, const ActionConvention& convention)
    : state_(std::make_unique<State>()) {
  state_->model = compile_solver_model<double>(profile, {.convention = convention});
  state_->finger_planes.resize(profile.fingers.size());
  state_->planes.resize(state_->model->plane_groups.fingers.size());
}

DeformationField::DeformationField(DeformationField&&) noexcept = default;
DeformationField& DeformationField::operator=(DeformationField&&) noexcept = default;
DeformationField::~DeformationField() = default;

Status DeformationField::deform(const Action<double>& action, std::span<Spherical<double>> points) noexcept {
  const SolverModel<double>& model = *state_->model;
  const PlaneGroups& groups = model.plane_groups;
  std::vector<PlaneDeformation<double>>& planes = state_->planes;
  if (const Status status = model.decoder.check(action); status != Status::ok) return status;
  model.decoder.decode(model.decoder.numbers_of(action), state_->finger_planes.data());
  for (std::size_t g = 0; g < planes.size(); ++g)
    planes[g] = mean_plane(state_->finger_planes, groups.fingers[g], model.options.convention.held_toward_pole);

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
