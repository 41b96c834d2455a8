// The data of the page (schemas/report.schema.json).
#pragma once

#include <string>
#include <vector>

#include "uhas/report/html_report.hpp"

namespace uhas {

/// A JSON document in one line. Throws as `html_report`.
std::string report_document(const std::string& title, const std::vector<ReportHand>& hands);

}  // namespace uhas
