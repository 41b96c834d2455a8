// In place of the page, in a build without it.
#include "uhas/base/errors.hpp"
#include "uhas/report/html_report.hpp"

namespace uhas {

void require_html_report() {
  throw Error(
      ErrorCode::invalid_option, "", "this build of uhas has no HTML reports",
      "install the packages that packages/debian.sh lists for web pages and configure with -DUHAS_BUILD_REPORT=ON");
}

std::string html_report(const std::string&, const std::vector<ReportHand>&) {
  require_html_report();
  return {};
}

}  // namespace uhas
