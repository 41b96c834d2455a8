#include "tables/profile_check_table.hpp"

#include "text/table.hpp"
#include "text/terminal.hpp"

namespace uhas::tools {

void print_checks(std::ostream& out, std::span<const Check> checks) {
  Table table({{"check"}, {"result"}, {"found"}});
  for (const Check& check : checks)
    table.add_row({check.item, check.passed ? "ok" : Table::Cell("FAILED", Tone::error), check.detail});
  table.print(out);
}

}  // namespace uhas::tools
