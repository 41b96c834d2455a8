// Checks that a call throws uhas::Error with a code and with words in its message.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "uhas/base/errors.hpp"

namespace uhas::test {

template <class Call>
void check_error(ErrorCode code, const std::string& words, Call&& call) {
  try {
    call();
    FAIL_CHECK("no error; expected: " << words);
  } catch (const Error& error) {
    const std::string what = error.what();
    CHECK_MESSAGE(error.code() == code, what);
    CHECK_MESSAGE(what.find(words) != std::string::npos, what);
  }
}

}  // namespace uhas::test
