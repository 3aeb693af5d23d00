// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file for people that says who somebody is or what they did: nobody else who has a log-in on
// this computer reads it.

#include <string>

#include "db/whole_file.h"

namespace placode::db {

/// Written beside its place and put there whole by commit(); for its owner alone (mode 0600) before
/// the first byte, also where the file that was there was open to others. Whoever uses it names the
/// path and errorString() when open() or commit() fails.
class PrivateFile : public WholeFile {
 public:
    explicit PrivateFile(const std::string& path) : WholeFile(QString::fromStdString(path)) {}
    bool open(OpenMode mode) override {
        return WholeFile::open(mode) && setPermissions(ReadOwner | WriteOwner);
    }
};

}  // namespace placode::db
