// The drawing is read with another program's eyes: as XML.
#include "uhas/report/lateral_tables_svg.hpp"

#include <doctest/doctest.h>
#include <tinyxml.h>

#include <map>
#include <sstream>

#include "support/small_profile.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// Elements below `parent` by their names.
std::multimap<std::string, const TiXmlElement*> elements(const TiXmlElement& parent) {
  std::multimap<std::string, const TiXmlElement*> found;
  for (const TiXmlElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement())
    found.emplace(e->ValueStr(), e);
  return found;
}

}  // namespace

TEST_CASE("each table is a curve of its samples, with names that XML would trip over") {
  HandProfile profile = small_profile();
  profile.tree.joints[profile.lateral_tables[0].joint].name = "<side & \"way\">";
  TiXmlDocument document;
  document.Parse(lateral_tables_svg(profile).c_str(), nullptr, TIXML_ENCODING_UTF8);
  REQUIRE_MESSAGE(!document.Error(), document.ErrorDesc());
  const auto parts = elements(*document.RootElement());

  REQUIRE(parts.count("polyline") == profile.lateral_tables.size());
  std::istringstream points(parts.find("polyline")->second->Attribute("points"));
  std::vector<double> x, y;
  for (double u = 0, v = 0; points >> u && points.ignore(1) && points >> v;) x.push_back(u), y.push_back(v);
  const LateralTable& table = profile.lateral_tables[0];
  REQUIRE(x.size() == table.q.size());
  // an affine map of (q, theta), theta upward
  const double scale_x = (x.back() - x.front()) / (table.q.back() - table.q.front());
  const double scale_y = (y.back() - y.front()) / (table.theta.back() - table.theta.front());
  CHECK(scale_x > 0);
  CHECK(scale_y < 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(x[i] - x[0] == doctest::Approx(scale_x * (table.q[i] - table.q[0])).epsilon(0.01));
    CHECK(y[i] - y[0] == doctest::Approx(scale_y * (table.theta[i] - table.theta[0])).epsilon(0.01));
  }

  bool named = false;
  for (auto [text, end] = parts.equal_range("text"); text != end; ++text)
    named |= std::string(text->second->GetText()).find("<side & \"way\">") != std::string::npos;
  CHECK(named);
}

TEST_CASE("a hand without lateral joints says so") {
  HandProfile profile = small_profile();
  profile.lateral_tables.clear();
  for (ProfileFinger& finger : profile.fingers) finger.lateral_table = -1;
  CHECK(lateral_tables_svg(profile).find("no lateral joint") != std::string::npos);
}
