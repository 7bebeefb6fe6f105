# Debian packages, by cpack in the build folder: csgsim, libcsgsim-dev with the libraries, python3-csgsim with the module.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "the csgsim authors")
# As for other Debian tools, DEBFULLNAME and DEBEMAIL name who builds the package; .invalid is never an address.
set(maintainer ${CPACK_PACKAGE_VENDOR})
set(address csgsim@csgsim.invalid)
if(DEFINED ENV{DEBEMAIL})
  set(address $ENV{DEBEMAIL})
endif()
if(DEFINED ENV{DEBFULLNAME})
  set(maintainer $ENV{DEBFULLNAME})
endif()
set(CPACK_PACKAGE_CONTACT "${maintainer} <${address}>")
set(CPACK_COMPONENTS_ALL csgsim development)
if(CSGSIM_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of the logic-enhanced frame buffers of the 1980s")
set(CPACK_COMPONENT_CSGSIM_DESCRIPTION "Compiles Constructive Solid Geometry, OpenSCAD's models,
into the instructions that the host of Pixel-planes or a machine of its kind
would have broadcast, and runs them on a model of the hardware, word-parallel
or clock by clock. It counts the clocks of each part of the machine.")
set(CPACK_DEBIAN_CSGSIM_PACKAGE_NAME csgsim)
set(CPACK_DEBIAN_CSGSIM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CSGSIM_PACKAGE_SHLIBDEPS ON)
# gnuplot draws plots in PNG; OpenSCAD evaluates its source (.scad) and is not needed for .csg; the font is the default
# of text().
set(CPACK_DEBIAN_CSGSIM_PACKAGE_RECOMMENDS "gnuplot-nox, openscad, fonts-liberation")

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, static libraries, the CMake package and the pkg-config file of csgsim.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcsgsim-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "csgsim (= ${PROJECT_VERSION})" libboost-dev libfmt-dev libglm-dev
  libhwy-dev libminizip-dev libpng-dev libpolyclipping-dev libpugixml-dev libsystemc-dev libtomlplusplus-dev nlohmann-json3-dev
  tao-pegtl-dev zlib1g-dev)

set(CPACK_COMPONENT_PYTHON_DESCRIPTION "csgsim in Python: pictures as numpy arrays, counts and studies as dictionaries.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-csgsim)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# These scripts byte-compile the module for Python, and remove the result.
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/python3-csgsim/postinst
  ${PROJECT_SOURCE_DIR}/cmake/python3-csgsim/prerm)
# The module is compiled for one minor version of Python.
if(CSGSIM_PYTHON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  string(JOIN ", " CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "csgsim (= ${PROJECT_VERSION})" "python3 (>= 3.${Python_VERSION_MINOR})"
    "python3 (<< 3.${next_minor})" python3-numpy)
endif()

# Debian requires a changelog and a copyright file in each package; `cmake --install` without a component omits these.
# The changelog has the date of the commit, not of the build.
find_program(CSGSIM_GZIP gzip)
if(CSGSIM_GZIP)
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%cD OUTPUT_VARIABLE changed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT changed)
    file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CMakeLists.txt changed "%a, %d %b %Y %H:%M:%S +0000" UTC)
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/debian/changelog @ONLY CONTENT "csgsim (@PROJECT_VERSION@) unstable; urgency=medium

  * Version @PROJECT_VERSION@; /usr/share/doc/csgsim/CHANGELOG.md lists the changes.

 -- @CPACK_PACKAGE_CONTACT@  @changed@
")
  execute_process(COMMAND ${CSGSIM_GZIP} -9nkf ${PROJECT_BINARY_DIR}/debian/changelog COMMAND_ERROR_IS_FATAL ANY)
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz cmake/debian/copyright DESTINATION ${folder}
      COMPONENT ${component} EXCLUDE_FROM_ALL)
    set(overrides ${PROJECT_SOURCE_DIR}/cmake/debian/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    if(EXISTS ${overrides})
      install(FILES ${overrides} DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component}
        EXCLUDE_FROM_ALL)
    endif()
  endforeach()
endif()
include(CPack)
