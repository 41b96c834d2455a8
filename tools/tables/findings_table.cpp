#include "tables/findings_table.hpp"

#include "text/numbers.hpp"
#include "text/table.hpp"

namespace uhas::tools {

void print_findings(std::ostream& out, std::span<const HandFinding> findings) {
  Table table({{"item"}, {"value"}, {"confidence", Align::right}, {"reason"}});
  for (const HandFinding& finding : findings)
    table.add_row({finding.item, finding.value, fixed(finding.confidence, 2), finding.reason});
  table.print(out);
}

}  // namespace uhas::tools
