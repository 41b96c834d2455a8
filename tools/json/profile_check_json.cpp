#include "json/profile_check_json.hpp"

#include <algorithm>

namespace uhas::tools {

Json profile_check_json(const HandProfile& profile, const std::vector<Check>& checks) {
  Json list = Json::array();
  for (const Check& check : checks)
    list.push_back({{"item", check.item}, {"passed", check.passed}, {"detail", check.detail}});
  Json document = new_document("uhas-profile-check");
  document["hand"] = profile.hand;
  document["passed"] = std::ranges::all_of(checks, &Check::passed);
  document["checks"] = list;
  return document;
}

}  // namespace uhas::tools
