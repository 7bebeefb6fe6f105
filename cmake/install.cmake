include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY CSGSIM_ROOMS)
install(TARGETS ${rooms} EXPORT csgsimTargets)
install(TARGETS csgsim)
set(module_dir ${CMAKE_INSTALL_LIBDIR}/csgsim)
install(TARGETS csgsim_pictures_module csgsim_text_module LIBRARY DESTINATION ${module_dir})
file(RELATIVE_PATH module_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${module_dir})
# The build's run path is the longer one: it is not filled up with empty folders, which mean the current one.
set_target_properties(csgsim PROPERTIES INSTALL_RPATH $ORIGIN/${module_from_program}
  BUILD_RPATH "$ORIGIN;$ORIGIN/${module_from_program}")
foreach(folder hw host sim)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/csgsim FILES_MATCHING PATTERN "*.h"
    PATTERN "sim/app" EXCLUDE)
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/csgsim)
install(EXPORT csgsimTargets NAMESPACE csgsim:: DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/csgsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_package_config_file(cmake/csgsimConfig.cmake.in ${PROJECT_BINARY_DIR}/csgsimConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS module_dir NO_CHECK_REQUIRED_COMPONENTS_MACRO)
install(FILES ${PROJECT_BINARY_DIR}/csgsimConfig.cmake ${PROJECT_BINARY_DIR}/csgsimConfigVersion.cmake
  DESTINATION ${package_dir})
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
