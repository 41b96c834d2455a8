// The real hand a test runs on: UHAS_HANDS_DIR holds one folder a hand, UHAS_HAND names the folder (ctest sets it).
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace uhas::test {

struct RealHand {
  std::string name;
  std::filesystem::path folder;
  std::filesystem::path urdf;
  nlohmann::json truth;  ///< the hand's truth.json
};

/// The hand of this run. Throws std::runtime_error when the folder or its truth.json is missing.
const RealHand& real_hand();

}  // namespace uhas::test
