// What a user chooses of the lateral tables.
#pragma once

namespace uhas {

struct LateralTableOptions {
  int steps = 201;  ///< samples of the sweep, at least 11
};

}  // namespace uhas
