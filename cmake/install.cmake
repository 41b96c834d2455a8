# What `cmake --install` puts where. Everything finds its neighbours by relative paths: the folder may be moved afterwards.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(UHAS_CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/uhas)
set(UHAS_DATA_FOLDER ${CMAKE_INSTALL_DATADIR}/uhas)
# Debian's zsh reads this folder below /usr; below /usr/local it reads share/zsh/site-functions
set(UHAS_ZSH_FOLDER ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions CACHE STRING "Where completions for zsh are installed")

# What is installed is of one of three components, which become packages (cmake/packages.cmake): runtime, what a robot needs;
# dev, what compiling against the libraries needs; tools, the rest.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME tools)

# uhas_install_library(<library> <target>): the target, as uhas::<library>, and its public headers (lib/public_headers.txt).
function(uhas_install_library library target)
  if(library STREQUAL runtime)
    set(component runtime)
  else()
    set(component tools)
  endif()
  set_target_properties(${target} PROPERTIES INSTALL_RPATH $ORIGIN)
  install(TARGETS ${target} EXPORT uhas-${library}
    LIBRARY COMPONENT ${component} NAMELINK_COMPONENT dev ARCHIVE COMPONENT dev INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT uhas-${library} NAMESPACE uhas:: DESTINATION ${UHAS_CONFIG_FOLDER} COMPONENT dev)
  file(STRINGS ${PROJECT_SOURCE_DIR}/lib/public_headers.txt headers REGEX "^${library} ")
  foreach(header ${headers})
    string(REPLACE "${library} " "uhas/" header ${header})
    cmake_path(GET header PARENT_PATH room)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${room} COMPONENT dev)
  endforeach()
endfunction()

# for find_package(uhas) and pkg-config
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/uhas-config.cmake.in ${PROJECT_BINARY_DIR}/uhas-config.cmake
  INSTALL_DESTINATION ${UHAS_CONFIG_FOLDER} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/uhas-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/uhas-config.cmake ${PROJECT_BINARY_DIR}/uhas-config-version.cmake
  DESTINATION ${UHAS_CONFIG_FOLDER} COMPONENT dev)

string(REGEX REPLACE "[^/]+" ".." prefix_from_pc ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(NOT BUILD_SHARED_LIBS)
  set(pc_static "Requires.private: hdf5\nLibs.private: -lstdc++ -lm -pthread\n")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/uhas.pc.in ${PROJECT_BINARY_DIR}/uhas.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/uhas.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime FILES_MATCHING REGEX "\\.(md|svg|png)$"
  PATTERN figures EXCLUDE)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT dev PATTERN quickstart.sh EXCLUDE)
install(DIRECTORY schemas DESTINATION ${UHAS_DATA_FOLDER})
if(UHAS_BUILD_PREPROCESS)
  foreach(section 1 5 7)
    install(DIRECTORY man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} FILES_MATCHING PATTERN "*.${section}")
  endforeach()
  install(DIRECTORY hands DESTINATION ${UHAS_DATA_FOLDER} PATTERN tools EXCLUDE)
endif()
