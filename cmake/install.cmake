include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY CSGSIM_ROOMS)
install(TARGETS ${rooms} EXPORT csgsimTargets)
install(TARGETS csgsim)
foreach(folder hw host sim)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/csgsim FILES_MATCHING PATTERN "*.h"
    PATTERN "sim/app" EXCLUDE)
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/csgsim)
install(EXPORT csgsimTargets NAMESPACE csgsim:: DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/csgsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/csgsimConfig.cmake ${PROJECT_BINARY_DIR}/csgsimConfigVersion.cmake
  DESTINATION ${package_dir})
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
