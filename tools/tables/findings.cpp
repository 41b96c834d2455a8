#include "tables/findings.hpp"

#include "tables/table.hpp"

namespace uhas::tools {

void print_findings(std::ostream& out, std::span<const Finding> findings) {
  Table table({{"item"}, {"value"}, {"confidence", Align::right}, {"reason"}});
  for (const Finding& finding : findings)
    table.add_row({finding.item, finding.value, fixed(finding.confidence, 2), finding.reason});
  table.print(out);
}

}  // namespace uhas::tools
