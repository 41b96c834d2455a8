// Writes the page that --html asks for.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/model_input.hpp"
#include "uhas/report/html_report.hpp"

namespace uhas::tools {

/// --html FILE.
CLI::Option* add_html_option(CLI::App& app, std::string& path, const std::string& description);

/// The hands of a page, with the meshes of their models as `find_models` finds them; warns of each without.
std::vector<ReportHand> report_hands(const Tool& tool, std::span<const ProfileFile> files, const ModelInput& input);

/// Writes the page of `hands` to `path`, whole or not at all. Throws Error as html_report and write_result.
void write_report(const std::string& path, const std::vector<ReportHand>& hands);

}  // namespace uhas::tools
