// What errors and statuses say.
#include "uhas/base/errors.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace uhas;

TEST_CASE("an error names file, problem and remedy, as far as they are given") {
  CHECK(std::string(Error(ErrorCode::syntax, "a.json:3", "not JSON", "correct it").what()) ==
        "a.json:3: not JSON; correct it");
  CHECK(std::string(Error(ErrorCode::syntax, "", "not JSON", "correct it").what()) == "not JSON; correct it");
  CHECK(std::string(Error(ErrorCode::syntax, "a.json", "not JSON", "").what()) == "a.json: not JSON");
  CHECK(Error(ErrorCode::limit_exceeded, "", "", "").code() == ErrorCode::limit_exceeded);
}

TEST_CASE("every status has words of its own") {
  std::set<std::string> words;
  int count = 0;
  for (const Status status : {Status::ok, Status::non_finite_input, Status::wrong_size, Status::invalid_driving_vectors,
                              Status::unknown_hand, Status::invalid_period, Status::invalid_radial_bounds}) {
    words.insert(to_string(status));
    ++count;
  }
  CHECK(static_cast<int>(words.size()) == count);
  CHECK(!words.contains(to_string(static_cast<Status>(1000))));
}
