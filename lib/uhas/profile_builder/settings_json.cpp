#include "uhas/profile_builder/settings_json.hpp"

#include "uhas/base/errors.hpp"
#include "uhas/json/json_text.hpp"

namespace uhas {

NLOHMANN_JSON_SERIALIZE_ENUM(GeometrySource, {{GeometrySource::visual, "visual"},
                                              {GeometrySource::collision, "collision"},
                                              {GeometrySource::both, "both"}})

std::string to_canonical_json(const BuildSettings& settings) {
  return to_canonical_text({{"config", parse_json(to_canonical_json(settings.config), "")},
                            {"geometry", settings.load.geometry},
                            {"lateral_steps", settings.lateral_tables.steps},
                            {"max_radius_deviation", settings.correspondences.max_radius_deviation},
                            {"merge_pinky", settings.sphere_frame.merge_pinky},
                            {"points_per_link", settings.correspondences.points_per_link},
                            {"radius_scale", settings.sphere_frame.radius_scale},
                            {"samples", settings.correspondences.samples}});
}

BuildSettings settings_from_json(const std::string& text, const std::string& file) {
  const Error unreadable(ErrorCode::invalid_profile, file, "its build settings cannot be read", "rebuild the profile");
  Json document;
  try {
    document = parse_json(text, file);
  } catch (const Error&) {
    throw unreadable;
  }
  BuildSettings settings;
  try {
    settings.config = parse_hand_config(document.at("config").dump(), file);
    document.at("geometry").get_to(settings.load.geometry);
    document.at("lateral_steps").get_to(settings.lateral_tables.steps);
    document.at("max_radius_deviation").get_to(settings.correspondences.max_radius_deviation);
    document.at("merge_pinky").get_to(settings.sphere_frame.merge_pinky);
    document.at("points_per_link").get_to(settings.correspondences.points_per_link);
    document.at("radius_scale").get_to(settings.sphere_frame.radius_scale);
    document.at("samples").get_to(settings.correspondences.samples);
  } catch (const Json::exception&) {
    throw unreadable;
  }
  return settings;
}

}  // namespace uhas
