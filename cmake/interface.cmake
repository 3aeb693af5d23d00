# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# libplacode.so, the C interface in interface/placode.h, and the Python package over it.
file(GLOB interface_sources CONFIGURE_DEPENDS interface/*.cpp interface/*.h)
add_library(placode_interface SHARED ${interface_sources})
target_link_libraries(placode_interface PRIVATE placode_environment placode_db placode_view nlohmann_json::nlohmann_json)
target_include_directories(placode_interface PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(placode_interface PRIVATE PLACODE_VERSION="${PROJECT_VERSION}")
placode_precompile(placode_interface <Eigen/Dense> <nlohmann/json.hpp>)
# Only what placode.h declares is seen from outside; libraries that nothing of it needs are left out.
set_target_properties(placode_interface PROPERTIES OUTPUT_NAME placode VERSION 1.0.0 SOVERSION 1
  CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
target_link_options(placode_interface PRIVATE -Wl,--exclude-libs,ALL -Wl,--as-needed -Wl,--no-undefined)

# --- installed: library, header, pkg-config file ---------------------------------------------------
include(GNUInstallDirs)
# lib/MACHINE as in Debian, so that compilers for other machines do not find it.
if(CMAKE_LIBRARY_ARCHITECTURE AND CMAKE_INSTALL_LIBDIR STREQUAL "lib")
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE})
endif()
install(TARGETS placode_interface
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(FILES interface/placode.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/placode COMPONENT development)
# The prefix is found from where the file lies: the folder may be moved.
file(RELATIVE_PATH placode_pc_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/placode.pc @ONLY CONTENT
"prefix=\${pcfiledir}/@placode_pc_up@
libdir=\${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=\${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: placode
Description: tasks of fetoscopic spina bifida repair as environments for programs
Version: @PROJECT_VERSION@
Libs: -L\${libdir} -lplacode
Cflags: -I\${includedir}/placode
")
install(FILES ${CMAKE_BINARY_DIR}/placode.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# --- python: the package placode, where Python, numpy and pybind11 are installed ---------------------
# Debian's Python, to which its numpy and pybind11 belong, and not one that happens to come first in the path.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
find_path(PYBIND11_INCLUDE_DIR pybind11/pybind11.h)
if(Python3_Development.Module_FOUND AND Python3_NumPy_FOUND AND PYBIND11_INCLUDE_DIR)
  set(python_build ${CMAKE_BINARY_DIR}/python)
  Python3_add_library(placode_python MODULE WITH_SOABI python/placode_module.cpp)
  target_include_directories(placode_python PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(placode_python SYSTEM PRIVATE ${PYBIND11_INCLUDE_DIR})
  target_link_libraries(placode_python PRIVATE placode_interface)
  # To the library: from prefix/lib/python3/dist-packages/placode, and in a wheel (scripts/make_wheel.py).
  set_target_properties(placode_python PROPERTIES OUTPUT_NAME _placode CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${python_build}/placode INSTALL_RPATH "$ORIGIN/../../../../${CMAKE_INSTALL_LIBDIR};$ORIGIN/lib")
  # The rest of the package lies beside it as links, so that an edited file needs no build.
  file(GLOB python_files CONFIGURE_DEPENDS python/placode/*.py python/placode/*.pyi python/placode/py.typed)
  foreach(file IN LISTS python_files)
    get_filename_component(name ${file} NAME)
    file(MAKE_DIRECTORY ${python_build}/placode)
    file(CREATE_LINK ${file} ${python_build}/placode/${name} SYMBOLIC)
  endforeach()
  set(python_packages lib/python3/dist-packages)
  install(TARGETS placode_python LIBRARY DESTINATION ${python_packages}/placode COMPONENT python)
  install(FILES ${python_files} DESTINATION ${python_packages}/placode COMPONENT python)
else()
  message(STATUS "No Python package: install python3-dev, python3-numpy and pybind11-dev for it")
endif()
