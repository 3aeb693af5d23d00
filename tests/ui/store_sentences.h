// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sentences with which the store refuses, as they stand in its sources (db/said.h).

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>

namespace placode::ui {

inline QString text_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

inline QStringList store_sentences() {
    static const QRegularExpression kMarked(
        "Said::that\\(\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)\\)");
    static const QRegularExpression kBetweenParts("(?<!\\\\)\"\\s*\"");
    const QDir folder(PLACODE_SOURCE_DIR "/db");
    QStringList all;
    for (const QString& name : folder.entryList({"*.cpp", "*.h"})) {
        auto found = kMarked.globalMatch(text_of(folder.filePath(name)));
        while (found.hasNext()) {
            QString sentence = found.next().captured(1).trimmed();
            sentence = sentence.mid(1, sentence.size() - 2).remove(kBetweenParts);
            all << sentence.replace("\\\"", "\"");
        }
    }
    all.removeDuplicates();
    return all;
}

}  // namespace placode::ui
