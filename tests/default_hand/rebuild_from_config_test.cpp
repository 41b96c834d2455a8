#include "support/rebuild_from_config.hpp"

TEST_CASE("a config of all that was inferred of the project's own hand rebuilds its profile") {
  uhas::test::check_rebuild_from_config(UHAS_DEFAULT_HAND);
}
