// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Exceptions become status codes here and nowhere else.

#include <new>

#include "curriculum/definitions.h"
#include "db/store_error.h"
#include "interface/handles.h"
#include "sim/mesh/mesh.h"
#include "ui/view/gl_program.h"

namespace placode::interface {

namespace {

using environment::EnvironmentError;

placode_status status_of(EnvironmentError::Kind kind) {
    switch (kind) {
        case EnvironmentError::Kind::kBadArgument:
            return PLACODE_BAD_ARGUMENT;
        case EnvironmentError::Kind::kNotReset:
            return PLACODE_NOT_RESET;
        case EnvironmentError::Kind::kEnded:
            return PLACODE_ENDED;
        case EnvironmentError::Kind::kRunning:
            return PLACODE_RUNNING;
        case EnvironmentError::Kind::kOtherTask:
            return PLACODE_OTHER_TASK;
    }
    return PLACODE_INTERNAL;
}

/// Without memory for the words the status has to do.
void say(std::string& error, const char* words) noexcept {
    try {
        error = words;
    } catch (...) {
        error.clear();
    }
}

}  // namespace

placode_status status_of_current(std::string& error) noexcept {
    try {
        throw;
    } catch (const EnvironmentError& e) {
        say(error, e.what());
        return status_of(e.kind());
    } catch (const curriculum::DefinitionError& e) {
        say(error, e.what());
        return PLACODE_BAD_DEFINITION;
    } catch (const sim::MeshError& e) {
        say(error, e.what());
        return PLACODE_BAD_DEFINITION;
    } catch (const view::ViewError& e) {
        say(error, e.what());
        return PLACODE_NO_PICTURE;
    } catch (const db::StoreError& e) {
        say(error, e.what());
        return PLACODE_FILE;
    } catch (const std::bad_alloc&) {
        say(error, "there is not enough memory");
        return PLACODE_NO_MEMORY;
    } catch (const std::exception& e) {
        say(error, e.what());
    } catch (...) {
        say(error, "an unknown problem");
    }
    return PLACODE_INTERNAL;
}

void refuse(const std::string& what) {
    throw EnvironmentError(EnvironmentError::Kind::kBadArgument, what);
}

}  // namespace placode::interface

extern "C" {

int placode_api_version(void) { return PLACODE_API_VERSION; }

const char* placode_version(void) { return PLACODE_VERSION; }

const char* placode_status_name(placode_status status) {
    static constexpr const char* kNames[] = {
        "ok",         "bad argument", "bad definition", "not reset", "ended",   "running",
        "other task", "no picture",   "file",           "no memory", "internal"};
    const auto i = static_cast<size_t>(status);
    return i < std::size(kNames) ? kNames[i] : "unknown";
}
}
