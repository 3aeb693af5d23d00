// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/typed_texts.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextDocument>

namespace placode::ui {
namespace {

/// Fields inside of number fields and lists have names of Qt's, the same for all.
bool is_ours(const QWidget& field) {
    return !field.objectName().isEmpty() && !field.objectName().startsWith("qt_");
}

}  // namespace

QVariantMap typed_texts(const QWidget& page) {
    QVariantMap texts;
    for (const auto* line : page.findChildren<QLineEdit*>())
        if (is_ours(*line) && line->isModified() && line->echoMode() == QLineEdit::Normal &&
            !line->text().isEmpty())
            texts.insert(line->objectName(), line->text());
    for (const auto* sheet : page.findChildren<QPlainTextEdit*>())
        if (is_ours(*sheet) && sheet->document()->isModified() && !sheet->isReadOnly())
            texts.insert(sheet->objectName(), sheet->toPlainText());
    return texts;
}

void type_again(const QWidget& page, const QVariantMap& texts) {
    for (auto* line : page.findChildren<QLineEdit*>()) {
        const QString text = texts.value(line->objectName()).toString();
        if (text.isEmpty() || !line->text().isEmpty() || line->isReadOnly() ||
            line->echoMode() != QLineEdit::Normal)
            continue;
        line->setText(text);
        line->setModified(true);  // or the next change of language would lose it
        Q_EMIT line->textEdited(text);
    }
    for (auto* sheet : page.findChildren<QPlainTextEdit*>()) {
        const QString text = texts.value(sheet->objectName()).toString();
        if (text.isEmpty() || !sheet->toPlainText().isEmpty() || sheet->isReadOnly()) continue;
        sheet->setPlainText(text);
        sheet->document()->setModified(true);
    }
}

}  // namespace placode::ui
