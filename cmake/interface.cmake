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
install(TARGETS placode_interface LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES interface/placode.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/placode)
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
install(FILES ${CMAKE_BINARY_DIR}/placode.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
