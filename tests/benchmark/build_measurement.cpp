#include "build_measurement.hpp"

#include <assimp/postprocess.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <assimp/Importer.hpp>
#include <stdexcept>

#include "uhas/model/meshes/mesh_path.hpp"
#include "uhas/profile_builder/build_profile.hpp"
#include "uhas/profile_io/image/profile_image.hpp"

namespace uhas::benchmark {
namespace {

/// URDF to the bytes of the profile's file; `listener` hears of the stages, writing included.
std::size_t build(const std::filesystem::path& urdf, const BuildListener& listener) {
  const HandProfile profile = build_profile(urdf.string(), {}, listener);
  listener("writing the profile");
  const std::size_t bytes = image_of_profile(profile, "").size();
  listener("");
  return bytes;
}

void load_with_assimp(const std::vector<std::filesystem::path>& meshes) {
  Assimp::Importer importer;
  for (const std::filesystem::path& mesh : meshes)
    if (!importer.ReadFile(mesh.string(), aiProcess_Triangulate)) throw std::runtime_error(importer.GetErrorString());
}

/// Largest resident set of a child that builds the profile of `urdf`, bytes.
std::size_t peak_memory(const std::filesystem::path& urdf) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    try {
      build(urdf, [](const char*) {});
      _exit(0);
    } catch (const std::exception&) {
      _exit(1);
    }
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || status != 0)
    throw std::runtime_error(urdf.string() + ": the build failed");
  return std::size_t(usage.ru_maxrss) * 1024;
}

std::size_t mesh_memory(const HandModel& model) {
  std::size_t bytes = 0;
  for (const ModelLink& link : model.links)
    bytes += link.mesh.vertices.size() * sizeof(link.mesh.vertices[0]) +
             link.mesh.triangles.size() * sizeof(link.mesh.triangles[0]);
  return bytes;
}

/// The samples of one hand.
struct Samples {
  std::vector<std::filesystem::path> meshes;
  std::vector<double> assimp, build;
  std::vector<std::string> stage_names;
  std::vector<std::vector<double>> stages;

  void take(const std::filesystem::path& urdf) {
    const double start = processor_nanoseconds();
    load_with_assimp(meshes);
    const double build_start = processor_nanoseconds();
    assimp.push_back(build_start - start);
    double stage_start = build_start;
    std::size_t stage = 0;
    benchmark::build(urdf, [&](const char* name) {
      if (stage > 0) stages[stage - 1].push_back(processor_nanoseconds() - stage_start);
      if (*name && stage == stage_names.size()) stage_names.push_back(name), stages.emplace_back();
      ++stage;
      stage_start = processor_nanoseconds();
    });
    build.push_back(processor_nanoseconds() - build_start);
  }
};

}  // namespace

std::vector<BuildMeasurement> measure_builds(const std::vector<std::filesystem::path>& urdfs, int rounds) {
  std::vector<BuildMeasurement> measurements(urdfs.size());
  for (std::size_t i = 0; i < urdfs.size(); ++i) measurements[i].peak_memory = peak_memory(urdfs[i]);

  std::vector<Samples> samples(urdfs.size());
  for (std::size_t i = 0; i < urdfs.size(); ++i) {
    const HandModel model = load_hand_model(urdfs[i].string());
    measurements[i].hand = urdfs[i].stem();
    measurements[i].mesh_memory = mesh_memory(model);
    for (const SourceFile& source : model.sources) {
      if (&source == &model.sources.front()) continue;  // the URDF
      const auto file = find_mesh(source.name, urdfs[i].parent_path(), {}, urdfs[i]);
      samples[i].meshes.push_back(file);
      measurements[i].mesh_file_bytes += file_size(file);
    }
    measurements[i].mesh_files = samples[i].meshes.size();
  }

  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < urdfs.size(); ++i) samples[i].take(urdfs[i]);
  for (std::size_t i = 0; i < urdfs.size(); ++i) {
    measurements[i].assimp = summarise(samples[i].assimp);
    measurements[i].build = summarise(samples[i].build);
    for (std::size_t k = 0; k < samples[i].stages.size(); ++k)
      measurements[i].stages.push_back({samples[i].stage_names[k], summarise(samples[i].stages[k])});
  }
  return measurements;
}

}  // namespace uhas::benchmark
