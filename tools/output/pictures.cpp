#include "output/pictures.hpp"

#include <iostream>

#include "output/report_page.hpp"
#include "uhas/files/file_bytes.hpp"
#include "uhas/report/correspondences_ply.hpp"
#include "uhas/report/hand_glb.hpp"
#include "uhas/report/lateral_tables_svg.hpp"
#include "uhas/runtime/joint_groups.hpp"

namespace uhas::tools {

void add_picture_options(Tool& tool, PictureFiles& files) {
  add_html_option(tool, files.html, "Draw the hands, which move by sliders, as a page for any browser, offline");
  tool.add_output("--gltf", files.glb, FileKind::glb,
                  "Draw the wrapped hand, its sphere and its surface points as binary glTF")
      ->type_name("hand.glb");
  tool.add_output("--ply", files.ply, FileKind::ply, "Write the surface points with their sphere coordinates as PLY")
      ->type_name("points.ply");
  tool.add_output("--svg", files.svg, FileKind::svg, "Draw the lateral tables as SVG")->type_name("tables.svg");
}

void write_pictures(Tool& tool, const PictureFiles& files, std::span<const ProfileFile> profiles,
                    const ModelInput& input) {
  const auto write = [&](const std::string& path, const auto& content) {
    replace_file(path, std::as_bytes(std::span(content)));
    if (!tool.quiet()) std::cout << "Wrote " << path << '\n';
  };
  const HandProfile& profile = profiles.front().profile;
  if (!files.html.empty() || !files.glb.empty()) {
    const std::vector<HandGeometry> geometries = find_geometries(tool, profiles, input, "the picture lacks the meshes");
    if (!files.html.empty()) write(files.html, report_page(report_hands(profiles, geometries)));
    if (!files.glb.empty()) write(files.glb, hand_glb(profile, geometries.front(), reference_posture(profile)));
  }
  if (!files.ply.empty()) write(files.ply, correspondences_ply(profile));
  if (!files.svg.empty()) write(files.svg, lateral_tables_svg(profile));
}

}  // namespace uhas::tools
