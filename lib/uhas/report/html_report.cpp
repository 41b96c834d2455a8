#include "uhas/report/html_report.hpp"

#include <string_view>

#include "uhas/report/html/embedded_files.hpp"
#include "uhas/report/html/report_document.hpp"

namespace uhas {
namespace {

/// `json` for the inside of a script element: no tag can begin or end in it.
std::string for_script(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

}  // namespace

void require_html_report() {}  // it is here; html/left_out.cpp is what stands in for this file

std::string html_report(const std::string& title, const std::vector<ReportHand>& hands) {
  constexpr std::string_view place = R"(<script type="application/json" id="uhas-report">)";
  const std::string_view page = embedded_page();
  const std::size_t split = page.find(place) + place.size();
  std::string html(page.substr(0, split));
  html += for_script(report_document(title, hands));
  html += page.substr(split);
  return html;
}

}  // namespace uhas
