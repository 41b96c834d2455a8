// What the single stages found, as JSON documents (schemas/).
#pragma once

#include "uhas/json/json_text.hpp"
#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::tools {

Json sphere_frame_json(const BuildStages& stages);    ///< schemas/sphere-frame.schema.json
Json joint_classes_json(const BuildStages& stages);   ///< schemas/joint-classes.schema.json
Json lateral_tables_json(const BuildStages& stages);  ///< schemas/lateral-tables.schema.json
Json surface_hits_json(const BuildStages& stages);    ///< schemas/surface-hits.schema.json
Json surface_points_json(const BuildStages& stages);  ///< schemas/surface-points.schema.json

/// Name of the joint's master; null when it is independent.
Json mimic_json(const KinematicTree& tree, int joint);

}  // namespace uhas::tools
