#include "command_line/library_versions.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <assimp/version.h>
#include <fcl/config.h>
#include <hdf5.h>
#include <meshoptimizer.h>
#include <nlopt.h>
#include <tinyxml.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace uhas::tools {
namespace {

template <class... Numbers>
std::string dotted(Numbers... numbers) {
  std::string text;
  ((text += (text.empty() ? "" : ".") + std::to_string(numbers)), ...);
  return text;
}

std::string hdf5() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return dotted(major, minor, release);
}

std::string nlopt() {
  int major = 0, minor = 0, bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  return dotted(major, minor, bugfix);
}

std::string embree() {
  const RTCDevice device = rtcNewDevice("threads=1");
  if (device == nullptr) return RTC_VERSION_STRING;
  const ssize_t version = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION);  // 31305 is 3.13.5
  rtcReleaseDevice(device);
  return dotted(version / 10'000, version / 100 % 100, version % 100);
}

}  // namespace

std::vector<std::string> library_versions() {
  const std::string json =
      dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH);
  return {"assimp " + dotted(aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch()),
          "CLI11 " CLI11_VERSION,
          "console_bridge " UHAS_CONSOLE_BRIDGE_VERSION,
          "Eigen " + dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
          "Embree " + embree(),
          "FCL " FCL_VERSION,
          "HDF5 " + hdf5(),
          "meshoptimizer " + dotted(MESHOPTIMIZER_VERSION / 1000, MESHOPTIMIZER_VERSION % 1000 / 10),
          "nlohmann_json " + json,
          "NLopt " + nlopt(),
          "tinyxml " + dotted(TIXML_MAJOR_VERSION, TIXML_MINOR_VERSION, TIXML_PATCH_VERSION),
          "urdfdom " UHAS_URDFDOM_VERSION};
}

}  // namespace uhas::tools
