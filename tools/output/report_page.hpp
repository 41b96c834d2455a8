// The page that --html asks for, of one hand or several.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "input/model_input.hpp"
#include "uhas/report/html_report.hpp"

namespace uhas::tools {

/// --html, which `description` explains; an Error in a build without the page.
void add_html_option(Tool& tool, std::string& file, const std::string& description);

/// The hands of a page. `geometries`: one a profile.
std::vector<ReportHand> report_hands(std::span<const ProfileFile> profiles,
                                     const std::vector<HandGeometry>& geometries);

/// The page of `hands`, under their names.
std::string report_page(const std::vector<ReportHand>& hands);

}  // namespace uhas::tools
