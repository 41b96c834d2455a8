// The hand a test runs on: UHAS_HANDS_DIR holds one folder a hand, UHAS_HAND names the folder (ctest sets it).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace uhas::test {

struct RealHand {
  std::string name;
  std::filesystem::path folder;
  std::filesystem::path urdf;
  nlohmann::json truth;  ///< the hand's truth.json; null for a hand of the project's own
};

/// The hand of this run. Throws std::runtime_error when it has neither a truth.json nor `<name>.urdf`.
const RealHand& real_hand();

}  // namespace uhas::test
