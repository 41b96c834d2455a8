# Debian packages, one for each component of cmake/install.cmake: `cpack --preset release` after a build of `release`.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "uhas contributors <uhas@localhost>" CACHE STRING "Maintainer that the packages name")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime dev tools)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# the libraries of this build, which no installed package owns; CPACK_COMPONENT_<NAME>_DEPENDS stands for them
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libuhas${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "The runtime library, which turns actions, deformations of a sphere, into joint angles.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libuhas-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DEPENDS runtime tools)
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers and examples: what programs need to be compiled against uhas, by find_package or pkg-config.")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME uhas-tools)
set(CPACK_COMPONENT_TOOLS_DEPENDS runtime)
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "Command-line tools that build hand profiles from URDF, show them, solve actions and carry motions from hand to hand.")

include(CPack)
