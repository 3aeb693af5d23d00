# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by every build: writes OUT with version and commit, and leaves it alone where neither has changed.
#   cmake -DVERSION=... -DSOURCE=... -DOUT=... -P version.cmake
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
set(text "${VERSION}")
if(NOT failed AND commit)
  set(text "${VERSION} (${commit})")
endif()
set(source "// Written by cmake/version.cmake.\n#include \"ui/version.h\"\n
namespace placode::ui {\nconst char* version_text() noexcept { return \"${text}\"; }\n}  // namespace placode::ui\n")
set(before "")
if(EXISTS ${OUT})
  file(READ ${OUT} before)
endif()
if(NOT before STREQUAL source)
  file(WRITE ${OUT} "${source}")
endif()
