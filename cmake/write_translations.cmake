# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The texts of some contexts of the translation files as a C++ table, for folders without Qt (sim/core/translation.h).
#   cmake -DPOLISH=FILE.ts -DENGLISH=FILE.ts -DCONTEXTS="A;B" -DOUT=FILE.cpp -P write_translations.cmake
# Texts are replaced in place and never made lists: CMake's lists end at ; and mind [ and ].
cmake_minimum_required(VERSION 3.25)

function(read_context file context out)
  file(READ ${file} text)
  string(FIND "${text}" "<name>${context}</name>" begin)
  if(begin EQUAL -1)
    set(${out} "" PARENT_SCOPE)
    return()
  endif()
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "</context>" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  string(REPLACE "<name>${context}</name>" "" text "${text}")
  string(REGEX REPLACE ">[ \n]+<" "><" text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

set(form "<numerusform>([^<]*)</numerusform>")
set(body)
foreach(context IN LISTS CONTEXTS)
  read_context(${POLISH} ${context} text)
  read_context(${ENGLISH} ${context} english)
  # One form, as most have it.
  string(REGEX REPLACE "<message><source>([^<]*)</source><translation>([^<]*)</translation></message>"
    "{\"${context}\", R\"ts(\\1)ts\", {R\"ts(\\2)ts\"}, {}},\n" text "${text}")
  # With a number: three forms in Polish, two in English.
  string(REGEX REPLACE
    "<message numerus=\"yes\"><source>([^<]*)</source><translation>${form}${form}${form}</translation></message>"
    "{\"${context}\", R\"ts(\\1)ts\", {R\"ts(\\2)ts\", R\"ts(\\3)ts\", R\"ts(\\4)ts\"}, english_of(R\"ts(\\1)ts\")},\n"
    text "${text}")
  string(REGEX REPLACE
    "<message numerus=\"yes\"><source>([^<]*)</source><translation>${form}${form}</translation></message>"
    "{R\"ts(\\1)ts\", {R\"ts(\\2)ts\", R\"ts(\\3)ts\"}},\n" english "${english}")
  string(APPEND body "${text}")
  string(APPEND counted "${english}")
endforeach()
foreach(left IN ITEMS "${body}" "${counted}")
  if(left MATCHES "(<message.*)")
    string(SUBSTRING "${CMAKE_MATCH_1}" 0 300 left)
    message(FATAL_ERROR "${POLISH}, ${ENGLISH}: a text without its translation, or of another shape:\n${left}")
  endif()
endforeach()
foreach(text IN ITEMS body counted)
  string(REPLACE "&lt;" "<" ${text} "${${text}}")
  string(REPLACE "&gt;" ">" ${text} "${${text}}")
  string(REPLACE "&quot;" "\"" ${text} "${${text}}")
  string(REPLACE "&apos;" "'" ${text} "${${text}}")
  string(REPLACE "&amp;" "&" ${text} "${${text}}")
endforeach()
file(WRITE ${OUT}.new
"// Generated from ${POLISH} by cmake/write_translations.cmake.
#include <algorithm>
#include <utility>

#include \"sim/core/translation.h\"
namespace placode::sim {
namespace {
struct Counted {
    std::string_view english;
    std::array<std::string_view, 2> forms;
};
constexpr Counted kCounted[]{
${counted}};
consteval std::array<std::string_view, 2> english_of(std::string_view english) {
    for (const Counted& each : kCounted)
        if (each.english == english) return each.forms;
    throw \"the English file has no forms of a text with a number\";
}
consteval auto sorted(auto all) {
    std::sort(all.begin(), all.end(), [](const Translation& a, const Translation& b) {
        return std::pair(a.context, a.english) < std::pair(b.context, b.english);
    });
    return all;
}
constexpr auto kAll = sorted(std::to_array<Translation>({
${body}}));
}
std::span<const Translation> embedded_translations() noexcept { return kAll; }
}
")
# Untouched where nothing changed: everything is linked again otherwise.
file(COPY_FILE ${OUT}.new ${OUT} ONLY_IF_DIFFERENT)
