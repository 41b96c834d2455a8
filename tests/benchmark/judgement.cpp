#include "judgement.hpp"

#include <ostream>

#include "text/numbers.hpp"
#include "text/table.hpp"

namespace uhas::benchmark {
namespace {

using tools::Align;
using tools::fixed;

const char* to_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::aim: return "PASS, aim too";
    case Verdict::must: return "PASS";
    case Verdict::missed: break;
  }
  return "FAIL";
}

std::string bound(const Judgement& judgement, double value) {
  return (judgement.at_most ? "<= " : ">= ") + fixed(value, value < 10 ? 1 : 0);
}

std::vector<std::string> cells(const Judgement& judgement) {
  const double value = judgement.value;
  return {judgement.requirement,
          bound(judgement, judgement.must),
          bound(judgement, judgement.aim),
          fixed(value, value < 10    ? 2
                       : value < 100 ? 1
                                     : 0),
          judgement.hand,
          to_word(judgement.verdict())};
}

}  // namespace

Verdict Judgement::verdict() const {
  const auto meets = [&](double limit) { return at_most ? value <= limit : value >= limit; };
  return meets(aim) ? Verdict::aim : meets(must) ? Verdict::must : Verdict::missed;
}

Json to_json(const std::vector<Judgement>& judgements) {
  constexpr const char* words[] = {"aim", "must", "missed"};
  Json list = Json::array();
  for (const Judgement& judgement : judgements)
    list.push_back({{"requirement", judgement.requirement},
                    {"bound", judgement.at_most ? "at most" : "at least"},
                    {"must", judgement.must},
                    {"aim", judgement.aim},
                    {"value", judgement.value},
                    {"hand", judgement.hand},
                    {"meets", words[int(judgement.verdict())]}});
  return list;
}

void print_table(const std::vector<Judgement>& judgements, std::ostream& out) {
  tools::Table table(
      {{"requirement"}, {"must", Align::right}, {"aim", Align::right}, {"measured", Align::right}, {"on"}, {"result"}});
  for (const Judgement& judgement : judgements) {
    const std::vector<std::string> row = cells(judgement);
    table.add_row({row.begin(), row.end()});
  }
  table.print(out);
}

void print_markdown(const std::vector<Judgement>& judgements, std::ostream& out) {
  print_markdown_header({"requirement", "must", "aim", "measured", "on", "result"}, out);
  for (const Judgement& judgement : judgements) print_markdown_row(cells(judgement), out);
}

void print_markdown_row(const std::vector<std::string>& row, std::ostream& out) {
  for (const std::string& cell : row) out << "| " << cell << ' ';
  out << "|\n";
}

void print_markdown_header(const std::vector<std::string>& columns, std::ostream& out) {
  print_markdown_row(columns, out);
  out << "|---|";
  for (std::size_t i = 1; i < columns.size(); ++i) out << "---:|";
  out << '\n';
}

}  // namespace uhas::benchmark
