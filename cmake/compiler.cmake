# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compiler settings and the helper functions that the root CMakeLists.txt uses.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Sloppiness: without it ccache passes by everything that uses a precompiled header.
  set(ccache ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    ${CCACHE_PROGRAM})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ccache})
  set(CMAKE_C_COMPILER_LAUNCHER ${ccache})
endif()

# No contraction: the same input must give the same bits whatever the optimiser does.
add_compile_options(-Wall -Wextra -Wpedantic -ffp-contract=off)
if(PLACODE_WERROR)
  add_compile_options(-Werror)
endif()
# Qt's `emit` and `signals` macros break other headers; Q_EMIT and Q_SIGNALS are used instead.
add_compile_definitions(QT_NO_KEYWORDS)
if(PLACODE_SANITIZER)
  # CMake's RelWithDebInfo defines NDEBUG; preconditions are to be checked here.
  # -O2: with -O1 Eigen's functions are not inlined, and tests take twice as long. What checks every
  # single access for null, its place and size is left out: the address sanitizer stops where that leads to.
  # Between the checks g++ 12 no longer sees that an empty std::optional is not read.
  add_compile_options(-fsanitize=${PLACODE_SANITIZER} -fno-sanitize-recover=all -Wno-maybe-uninitialized
    -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr -fno-omit-frame-pointer -O2 -g1 -UNDEBUG)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(-fsanitize=${PLACODE_SANITIZER})
endif()

# What stops a fault in memory from becoming somebody's way in, as Debian builds its own packages, and
# the bounds that the standard library can check.
option(PLACODE_HARDENING "Stack protector, fortified functions, checked bounds, read-only relocations" ON)
if(PLACODE_HARDENING AND NOT PLACODE_SANITIZER)
  add_compile_options(-fstack-protector-strong -fstack-clash-protection -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(-Wl,-z,relro,-z,now)
endif()

# mold links the 220 tests in a fraction of the time that GNU ld takes.
find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM)
  add_link_options(-fuse-ld=mold)
endif()

# Without any optimisation the solver takes some 30 times longer, and the suite hours.
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -D_GLIBCXX_ASSERTIONS")

# What nearly every file of a library includes is parsed once. Half of the time to compile goes
# into it otherwise; every file still names what it uses (the preset tsan builds without).
option(PLACODE_PRECOMPILED_HEADERS "Parse the common headers once for a library" ON)
set(standard_headers <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string>
  <string_view> <vector>)
# g++ 12 sees overlaps and bounds in `"text" + std::string` that are not there (GCC 105651), and
# with a precompiled header says so. The presets without one keep these warnings.
set(placode_false_warnings -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
function(placode_precompile target)
  if(PLACODE_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${standard_headers} ${ARGN})
    target_compile_options(${target} PRIVATE ${placode_false_warnings})
  endif()
endfunction()

# For what arranges, parses and prints: half of the time to compile it went into optimising it.
function(placode_optimise_little)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
endfunction()

# Several files at once: most of the time to compile one goes into headers and templates, which are then
# compiled once for all of them. Every file still names what it uses, and -DPLACODE_UNITY=OFF compiles each
# alone (the presets debug and tsan do). Neighbours in a folder must not define the same name for themselves.
option(PLACODE_UNITY "Compile the files of a library several at a time" ON)

# placode_group_by_folder(TARGET SIZE): neighbours of one folder, so that a new file moves only those
# of its own folder into another group.
function(placode_group_by_folder target size)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${folder}" name)
    math(EXPR count_${name} "${count_${name}} + 1")
    math(EXPR number "(${count_${name}} - 1) / ${size}")
    cmake_path(GET folder FILENAME folder)
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP
                                                                              "${folder}_${number}")
  endforeach()
endfunction()

function(placode_several_at_once)
  if(PLACODE_UNITY)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    foreach(target IN LISTS ARGN)
      placode_group_by_folder(${target} 6)
      # g++ warns of members with private types in what is included; here that is the .cpp itself.
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endforeach()
  endif()
endfunction()

# placode_library(NAME FOLDERS f... LINK l... PRECOMPILE h...): one static library from every .cpp
# of the folders.
function(placode_library name)
  cmake_parse_arguments(arg "" "" "FOLDERS;LINK;PRECOMPILE" ${ARGN})
  set(sources)
  foreach(folder IN LISTS arg_FOLDERS)
    file(GLOB found CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.h)
    list(APPEND sources ${found})
  endforeach()
  add_library(placode_${name} STATIC ${sources})
  set_target_properties(placode_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(placode_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(placode_${name} PUBLIC ${arg_LINK})
  placode_precompile(placode_${name} ${arg_PRECOMPILE})
  placode_several_at_once(placode_${name})
endfunction()

# placode_embed_sql(TARGET FOLDER): the numbered .sql files become one generated source that defines
# placode::db::embedded_migrations() (declared in db/migrations.h).
function(placode_embed_sql target folder)
  file(GLOB sql_files CONFIGURE_DEPENDS ${folder}/*.sql)
  set(body)
  foreach(file IN LISTS sql_files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(stem ${file} NAME)
    file(READ ${file} text)
    string(APPEND body "        {\"${stem}\", R\"~sql~(${text})~sql~\"},\n")
  endforeach()
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded_migrations.cpp)
  file(CONFIGURE OUTPUT ${out} @ONLY CONTENT
"// Generated from ${folder} by cmake/compiler.cmake.
#include \"db/migrations.h\"
namespace placode::db {
std::vector<EmbeddedSql> embedded_migrations() {
    return {
@body@    };
}
}  // namespace placode::db
")
  target_sources(${target} PRIVATE ${out})
endfunction()

# placode_embed_definitions(TARGET FOLDER): the texts of FOLDER/{tasks,scenes,courses,questionnaires} become one
# generated source that defines placode::curriculum::embedded_definitions() (declared in
# curriculum/shipped_definitions.h): what the program vouches for, whatever folder it is told to read.
function(placode_embed_definitions target folder)
  set(body)
  foreach(kind tasks scenes courses questionnaires)
    file(GLOB definitions CONFIGURE_DEPENDS ${folder}/${kind}/*.json)
    foreach(file IN LISTS definitions)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
      get_filename_component(id ${file} NAME_WE)
      file(READ ${file} text)
      string(APPEND body "        {\"${kind}\", \"${id}\", R\"~json~(${text})~json~\"},\n")
    endforeach()
  endforeach()
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded_definitions.cpp)
  file(CONFIGURE OUTPUT ${out} @ONLY CONTENT
"// Generated from ${folder} by cmake/compiler.cmake.
#include \"curriculum/shipped_definitions.h\"
namespace placode::curriculum {
std::span<const EmbeddedDefinition> embedded_definitions() noexcept {
    static constexpr EmbeddedDefinition kAll[]{
@body@    };
    return kAll;
}
}  // namespace placode::curriculum
")
  target_sources(${target} PRIVATE ${out})
endfunction()

# placode_embed_shaders(TARGET FOLDER): every .glsl becomes text of one generated source that defines
# placode::view::shader_text(name) (declared in ui/view/gl_program.h).
function(placode_embed_shaders target folder)
  file(GLOB shader_files CONFIGURE_DEPENDS ${folder}/*.glsl)
  set(body)
  foreach(file IN LISTS shader_files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(stem ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND body "    if (name == \"${stem}\") return R\"~glsl~(${text})~glsl~\";\n")
  endforeach()
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded_shaders.cpp)
  file(CONFIGURE OUTPUT ${out} @ONLY CONTENT
"// Generated from ${folder} by cmake/compiler.cmake.
#include \"ui/view/gl_program.h\"
namespace placode::view {
std::string_view shader_text(std::string_view name) {
@body@    return {};
}
}  // namespace placode::view
")
  target_sources(${target} PRIVATE ${out})
endfunction()

# placode_embed_translations(TARGET): what the folders without Qt say in Polish, out of the translation files, becomes
# one generated source that defines placode::sim::embedded_translations() (declared in sim/core/translation.h).
function(placode_embed_translations target)
  set(folder ${PROJECT_SOURCE_DIR}/ui/shell/translations)
  set(script ${PROJECT_SOURCE_DIR}/cmake/write_translations.cmake)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded_translations.cpp)
  add_custom_command(OUTPUT ${out} COMMAND ${CMAKE_COMMAND} -DPOLISH=${folder}/placode_pl.ts
    -DENGLISH=${folder}/placode_en.ts "-DCONTEXTS=Attempt;Bilingual;Key" -DOUT=${out} -P ${script}
    DEPENDS ${folder}/placode_pl.ts ${folder}/placode_en.ts ${script} VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()

# placode_for_shared_library(TARGET...): static libraries that libplacode.so is made of as well. Their functions are
# bound as in a program, so that the code stays as fast.
function(placode_for_shared_library)
  foreach(target IN LISTS ARGN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  endforeach()
endfunction()

function(placode_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${arg_SOURCES})
  if(sources)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${arg_LINK})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
  endif()
endfunction()

# version_text() of the programs, with the commit that they were built from.
function(placode_version)
  set(source ${CMAKE_BINARY_DIR}/version.cpp)
  set(write ${CMAKE_COMMAND} -DVERSION=${PROJECT_VERSION} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUT=${source}
    -P ${PROJECT_SOURCE_DIR}/cmake/version.cmake)
  execute_process(COMMAND ${write})
  add_custom_target(version BYPRODUCTS ${source} COMMAND ${write} VERBATIM)
  add_library(placode_version STATIC ${source})
  add_dependencies(placode_version version)
  target_include_directories(placode_version PUBLIC ${PROJECT_SOURCE_DIR})
endfunction()

# The four programs. ui/shell is a library as well, so that tests can drive the real windows.
function(placode_ui_programs)
  placode_version()
  placode_library(diagnostics FOLDERS ui/diagnostics LINK placode_sim placode_version)
  file(GLOB shell_sources CONFIGURE_DEPENDS ui/shell/*.cpp ui/shell/*.h)
  list(FILTER shell_sources EXCLUDE REGEX "ui/shell/main\\.cpp$")
  add_library(placode_shell STATIC ${shell_sources})
  set_target_properties(placode_shell PROPERTIES AUTOMOC ON AUTORCC ON LINKER_LANGUAGE CXX
    AUTOGEN_ORIGIN_DEPENDS OFF)
  target_link_libraries(placode_shell PUBLIC placode_reports placode_diagnostics Qt6::Widgets Qt6::PrintSupport
    Qt6::DBus)
  placode_precompile(placode_shell <QApplication> <QCheckBox> <QComboBox> <QDateTime> <QFile> <QGridLayout> <QHBoxLayout>
    <QHeaderView> <QLabel> <QLineEdit> <QMainWindow> <QMessageBox> <QPainter> <QPlainTextEdit> <QPointer> <QProcess>
    <QPushButton> <QRegularExpression> <QScrollArea> <QTableWidget> <QTimer> <QToolButton> <QVBoxLayout>)
  if(EXISTS ${PROJECT_SOURCE_DIR}/ui/shell/shell.qrc)
    target_sources(placode_shell PRIVATE ui/shell/shell.qrc)
  endif()
  # The .ts must exist at configure time: otherwise Qt 6.4 makes an empty one and everything stays
  # English. It is committed; `ninja placode_shell_lupdate` brings it up to date.
  # Without line numbers, or every change of a page would touch thousands of its lines.
  # What recordings, devices, store and portal say stands in their sources: `Said::that("...")`, `Web::phrase("...")`, and with a number
  # `Web::count_phrase("%n attempt(s)", n)`; so do sentences that are needed in both languages at once
  # (`Bilingual::phrase`).
  # Of the other folders' words there are lists (translatable_strings.cpp, translatable_attempt.cpp).
  file(GLOB texts CONFIGURE_DEPENDS ui/shell/*.cpp ui/shell/*.h haptics/*.cpp assessment/*.cpp curriculum/*.cpp db/*.cpp
    db/*.h reports/certificate_pdf.cpp ui/web/*.cpp ui/web/*.h)
  set(markers tr+=that,tr+=phrase,tr+=plain_phrase,QT_TR_N_NOOP+=count_phrase,QT_TR_N_NOOP+=plain_count_phrase)
  qt_add_translations(placode_shell TS_FILES ui/shell/translations/placode_pl.ts RESOURCE_PREFIX /i18n
    SOURCES ${texts} INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR}
    LUPDATE_OPTIONS -locations none -no-obsolete -tr-function-alias ${markers})
  add_test(NAME translations_test COMMAND ${CMAKE_COMMAND} -DLUPDATE=$<TARGET_FILE:Qt6::lupdate>
    -DTS=${PROJECT_SOURCE_DIR}/ui/shell/translations/placode_pl.ts -DCOPY=${CMAKE_CURRENT_BINARY_DIR}/placode_pl_found.ts
    -DROOT=${PROJECT_SOURCE_DIR} "-DTEXTS=${texts}" -DMARKERS=${markers} -P ${PROJECT_SOURCE_DIR}/cmake/check_translations.cmake)
  # English is the source language: its file holds singular and plural of counted nouns (%n) only.
  # Apart from the other: lupdate would fill it with every string.
  set(english_ts ${PROJECT_SOURCE_DIR}/ui/shell/translations/placode_en.ts)
  set(english ${CMAKE_CURRENT_BINARY_DIR}/placode_en.qm)
  add_custom_command(OUTPUT ${english} COMMAND Qt6::lrelease -silent ${english_ts} -qm ${english}
    DEPENDS ${english_ts} VERBATIM)
  qt_add_resources(placode_shell placode_english PREFIX /i18n BASE ${CMAKE_CURRENT_BINARY_DIR} FILES ${english})
  placode_program(placode SOURCES ui/shell/main.cpp LINK placode_shell placode_version)
  # All but main stands in a library, so that tests can link it.
  file(GLOB attempt_sources CONFIGURE_DEPENDS ui/attempt/*.cpp ui/attempt/*.h)
  list(FILTER attempt_sources EXCLUDE REGEX "ui/attempt/main\\.cpp$")
  add_library(placode_attempt STATIC ${attempt_sources})
  target_link_libraries(placode_attempt PUBLIC placode_view placode_db placode_version CLI11::CLI11 PRIVATE PkgConfig::OPENAL)
  placode_precompile(placode_attempt <CLI/CLI.hpp> <nlohmann/json.hpp> <Eigen/Dense>)
  placode_program(placode-sim SOURCES ui/attempt/main.cpp LINK placode_attempt placode_diagnostics placode_version)
  # Learning platforms, for the portal and the command line.
  placode_library(lti FOLDERS ui/lti LINK placode_db nlohmann_json::nlohmann_json PkgConfig::HTTPLIB OpenSSL::Crypto
    PRECOMPILE <QString> <nlohmann/json.hpp>)
  placode_program(placodectl SOURCES ui/cli/*.cpp LINK placode_lti placode_view placode_batches placode_version
    CLI11::CLI11)
  # The portal without main is a library as well: tests ask it over a socket of their own.
  file(GLOB web_sources CONFIGURE_DEPENDS ui/web/*.cpp ui/web/*.h)
  list(FILTER web_sources EXCLUDE REGEX "ui/web/main\\.cpp$")
  add_library(placode_web STATIC ${web_sources})
  target_link_libraries(placode_web PUBLIC placode_reports placode_lti PkgConfig::HTTPLIB)
  placode_precompile(placode_web <QPainter> <QString>)
  # The portal's words and the reports' stand in the shell's files; under names of their own, because one file has one rule.
  set(words)
  foreach(language en pl)
    set(ts ${PROJECT_SOURCE_DIR}/ui/shell/translations/placode_${language}.ts)
    set(qm ${CMAKE_CURRENT_BINARY_DIR}/web/placode_${language}.qm)
    add_custom_command(OUTPUT ${qm} COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/web
      COMMAND Qt6::lrelease -silent ${ts} -qm ${qm} DEPENDS ${ts} VERBATIM)
    list(APPEND words ${qm})
  endforeach()
  file(GLOB review_scripts CONFIGURE_DEPENDS ui/web/review/*.js)
  qt_add_resources(placode_web placode_web_review PREFIX /web BASE ${PROJECT_SOURCE_DIR}/ui/web FILES ${review_scripts})
  qt_add_resources(placode_web placode_web_words PREFIX /i18n BASE ${CMAKE_CURRENT_BINARY_DIR}/web FILES ${words})
  placode_program(placode-web SOURCES ui/web/main.cpp LINK placode_web placode_diagnostics placode_version CLI11::CLI11)
  placode_optimise_little(placode_shell placodectl placode_lti placode_web)
  placode_several_at_once(placode_shell placode_attempt placode_web placodectl)
  placode_precompile(placodectl <CLI/CLI.hpp> <nlohmann/json.hpp> <iostream>)
endfunction()
