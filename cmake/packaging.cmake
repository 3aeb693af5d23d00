# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake --install, and packages: `cpack -G DEB` (Debian 12) and `cpack -G TZST` (runs from any folder on such a system).
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME application)

install(TARGETS placode placode-sim placodectl placode-web RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/placode)
install(DIRECTORY docs/manual DESTINATION ${CMAKE_INSTALL_DATADIR}/placode)
install(FILES packaging/org.placode.Placode.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES packaging/org.placode.Placode.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ui/shell/icons/placode.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
foreach(program placode placode-sim placodectl placode-web) # bash-completion looks for the name of the command
  install(FILES packaging/completion.bash RENAME ${program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endforeach()
install(PROGRAMS packaging/scheduled-backup packaging/scheduled-verify packaging/shared-station
        DESTINATION lib/placode)
install(FILES packaging/placode-backup.service packaging/placode-backup.timer DESTINATION lib/systemd/user)
install(FILES packaging/placode-server-backup.service packaging/placode-server-backup.timer
              packaging/placode-server-verify.service packaging/placode-server-verify.timer
              packaging/placode-web.service
        DESTINATION lib/systemd/system)
install(PROGRAMS examples/check_seal.py DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/placode/examples)
# What programs and manual point to, as it lies here, so that links from one page to the next lead there.
install(FILES README.md CHANGELOG.md SECURITY.md RELIABILITY.md packaging/copyright
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/placode)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/placode PATTERN manual EXCLUDE)
# Where they work: only a package for the whole system has them.
install(FILES packaging/70-placode.rules DESTINATION lib/udev/rules.d)

# Written by the programs themselves, so that they are never behind.
set(pages ${CMAKE_BINARY_DIR}/pages)
add_custom_command(OUTPUT ${pages}/made
  COMMAND ${CMAKE_COMMAND} -E env BIN=${CMAKE_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/packaging/make-pages ${pages}
  DEPENDS placode placode-sim placodectl placode-web packaging/make-pages VERBATIM)
add_custom_target(pages DEPENDS ${pages}/made)
install(DIRECTORY ${pages}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} OPTIONAL)
install(FILES ${pages}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/placode OPTIONAL)
install(FILES ${pages}/placode.conf DESTINATION ${CMAKE_INSTALL_DATADIR}/placode/limits.d OPTIONAL)

# What every package of Debian has to have.
foreach(package libplacode1/library libplacode-dev/development python3-placode/python)
  string(REGEX MATCH "([^/]*)/(.*)" _ ${package})
  set(package ${CMAKE_MATCH_1})
  set(component ${CMAKE_MATCH_2})
  install(FILES packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  install(FILES ${pages}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} OPTIONAL)
endforeach()
install(FILES packaging/placode.overrides RENAME placode DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides)
install(FILES packaging/libplacode1.overrides RENAME libplacode1
  DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT library)

set(CPACK_GENERATOR DEB TZST)
set(CPACK_PACKAGE_NAME placode)
set(CPACK_PACKAGE_VENDOR "The Placode authors")
set(CPACK_PACKAGE_CONTACT "The Placode authors <placode@placode.org>")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_PACKAGE_FILE_NAME placode-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR})

# --- the programs: all that a training centre needs ------------------------------------------------
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL application library development)
set(CPACK_DEBIAN_APPLICATION_PACKAGE_NAME placode)
set(CPACK_DEBIAN_APPLICATION_PACKAGE_SECTION education)
set(CPACK_DEBIAN_APPLICATION_DESCRIPTION
"trainer for fetoscopic spina bifida repair
Placode lets surgeons practise fetoscopic spina bifida repair on simulated
tissue that is grasped, cut and burned in real time, with the mouse or with
two force-feedback arms. It manages accounts, courses, exams and studies,
records every attempt so that it can be replayed exactly, and scores it with
a reason for every point that was lost.")
# What no library names: SQLite and PostgreSQL drivers, OpenGL and its software renderer, plug-ins, fonts; certificates
# by which learning platforms are trusted.
set(CPACK_DEBIAN_APPLICATION_PACKAGE_DEPENDS
  "libqt6sql6-sqlite, libqt6svg6, qt6-qpa-plugins, libgl1-mesa-dri, libxcb-cursor0, qt6-translations-l10n, fonts-dejavu-core")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_RECOMMENDS "libqt6sql6-psql, fonts-noto-core, spacenavd, ca-certificates")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/packaging/postinst ${PROJECT_SOURCE_DIR}/packaging/prerm)

# --- for researchers: the tasks as environments for their programs ---------------------------------
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libplacode1)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
"tasks of fetoscopic spina bifida repair for programs (library)
Programs step the tasks of Placode, observe tissue and instruments, earn the
points that people earn, and save and restore states exactly.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "placode (= ${PROJECT_VERSION})")  # its tasks and meshes
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/triggers)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libplacode-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"tasks of fetoscopic spina bifida repair for programs (C header)
The header placode.h and what a compiler needs to use libplacode. The
interface is plain C with opaque handles and error codes.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libplacode1 (= ${PROJECT_VERSION})")

if(TARGET placode_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-placode)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"tasks of fetoscopic spina bifida repair as Gymnasium environments
The Python package placode: environments, vectors of environments, wrappers
and policies over libplacode. Gymnasium is used where it is installed.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libplacode1 (= ${PROJECT_VERSION}), python3-numpy, \
python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${next_minor})")
endif()
include(CPack)
