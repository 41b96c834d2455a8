// The stages of the preprocessing, one after the other. A tool for one stage runs the stages before it.
#pragma once

#include <string>
#include <vector>

#include "uhas/classification/closed_pose.hpp"
#include "uhas/correspondences/correspondences.hpp"
#include "uhas/lateral_tables/lateral_tables.hpp"
#include "uhas/profile_builder/build_profile.hpp"

namespace uhas {

/// Everything the stages found. A field is filled when its stage has run.
struct BuildStages {
  HandModel model;
  Anatomy anatomy;
  SphereFrame sphere_frame;
  std::vector<double> q_closed;
  std::vector<JointClassification> joint_classes;
  HandFinding closed_pose;  ///< how far `q_closed` can be trusted
  LateralTables lateral_tables;
  Correspondences correspondences;
};

enum class BuildStage : int { model, anatomy, sphere_frame, classification, lateral_tables, correspondences };

/// Runs every stage up to and including `last`.
BuildStages run_stages(const std::string& urdf_path, const BuildSettings& settings, BuildStage last,
                       const BuildListener& listener = {});

/// The same on a model that has been read already.
BuildStages run_stages(HandModel model, const BuildSettings& settings, BuildStage last,
                       const BuildListener& listener = {});

/// The warnings of every stage that has run, in the order of the stages.
std::vector<std::string> stage_warnings(const BuildStages& stages);

/// What was inferred or stated, an element an item of the hand config. Needs the stages up to BuildStage::classification.
std::vector<HandFinding> stage_findings(const BuildStages& stages);

/// Indices into `Anatomy::fingers`, ordered by the first slot a finger owns: the order of `HandProfile::fingers`.
std::vector<int> fingers_by_slot(const SphereFrame& frame);

/// All that the stages found as one profile: `build_profile` is `run_stages` to the end, then this.
HandProfile make_profile(const BuildStages& stages, const BuildSettings& settings);

}  // namespace uhas
