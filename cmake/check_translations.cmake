# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Test: the translation tool finds in the sources what the translation file holds, no more and no less. A text that is
# used and in no list would be lost when the file is brought up to date; one that nobody uses would stay for ever.
#   cmake -DLUPDATE=... -DTS=FILE.ts -DCOPY=FILE.ts -DROOT=FOLDER -DTEXTS="a.cpp;b.h" -DMARKERS=... -P check_translations.cmake
configure_file(${TS} ${COPY} COPYONLY)
execute_process(COMMAND ${LUPDATE} -silent -locations none -disable-heuristic sametext -disable-heuristic similartext
  -tr-function-alias ${MARKERS} ${TEXTS} -I ${ROOT} -ts ${COPY} WORKING_DIRECTORY ${ROOT} RESULT_VARIABLE failed
  OUTPUT_QUIET ERROR_QUIET)
if(failed)
  message(FATAL_ERROR "${LUPDATE} failed: ${failed}")
endif()
file(READ ${COPY} text)
string(REPLACE ";" "," text "${text}")
string(REGEX MATCHALL "<source>[^<]*</source>[^<]*<translation type=\"[a-z]+\"" found "${text}")
if(found)
  list(TRANSFORM found REPLACE "<source>(.*)</source>.*type=\"([a-z]+)\"" "\\2: \\1")
  list(JOIN found "\n  " found)
  message(FATAL_ERROR "vanished: no source or list has it; unfinished: it has no translation\n  ${found}")
endif()
string(REGEX MATCHALL "<message" all "${text}")
list(LENGTH all count)
if(count LESS 2000)
  message(FATAL_ERROR "${COPY} has ${count} texts: the tool found hardly any")
endif()
message("${count} texts")
