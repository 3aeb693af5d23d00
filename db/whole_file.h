// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file that is there whole, or as it was before.

#include <QFileInfo>
#include <QSaveFile>

namespace placode::db {

/// QSaveFile that sees a full disk. The one of Qt 6.4 takes it for written what the disk took in
/// part, and what failed only as the last buffer left: commit() then said true, and put an empty or
/// cut file in the place of a good one.
class WholeFile : public QSaveFile {
 public:
    using QSaveFile::QSaveFile;
    /// False also for a device or pipe: what is put in its place takes it away from everybody.
    bool open(OpenMode mode) override {
        const QFileInfo there(fileName());
        if (!there.exists() || there.isFile() || there.isDir()) return QSaveFile::open(mode);
        setErrorString(QStringLiteral("it is no file but a device or pipe"));
        return false;
    }
    /// False, and what was there stays, unless every byte is on its way to the disk; errorString()
    /// says why.
    bool commit() {
        if (isOpen() && !flush()) cancelWriting();
        return QSaveFile::commit();
    }

 protected:
    qint64 writeData(const char* data, qint64 size) override {
        qint64 done = 0;
        while (done < size) {
            const qint64 part = QSaveFile::writeData(data + done, size - done);
            if (part <= 0) return -1;
            done += part;
        }
        return done;
    }
};

}  // namespace placode::db
