// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/typed_texts.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDateEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTableWidget>
#include <QTextDocument>

namespace placode::ui {
namespace {

/// Fields inside of number fields and lists have names of Qt's, the same for all.
bool is_ours(const QWidget& field) {
    return !field.objectName().isEmpty() && !field.objectName().startsWith("qt_");
}

constexpr const char* kKept = "kept_choice";
bool is_kept(const QWidget& field) { return field.property(kKept).toBool(); }
constexpr QLatin1String kChoice("choice/");
QString choice_of(const QWidget& field) { return QString(kChoice) + field.objectName(); }

/// What is chosen in a field; not valid where it is none that has a choice.
QVariant chosen_in(const QWidget& field) {
    if (const auto* button = qobject_cast<const QAbstractButton*>(&field))
        return button->isChecked();
    if (const auto* spin = qobject_cast<const QSpinBox*>(&field)) return spin->value();
    if (const auto* day = qobject_cast<const QDateEdit*>(&field)) return day->date();
    if (const auto* table = qobject_cast<const QTableWidget*>(&field)) {
        const auto* first = table->item(table->currentRow(), 0);
        return first == nullptr
                   ? QVariant()
                   : QVariantMap{{"row", table->currentRow()}, {"text", first->text()}};
    }
    const auto* list = qobject_cast<const QComboBox*>(&field);
    if (list == nullptr) return {};
    // Words that were typed are no entry of the list, and its entries have other words in another
    // language.
    const bool entry = list->currentText() == list->itemText(list->currentIndex());
    return QVariantMap{{"data", entry ? list->currentData() : QVariant()},
                       {"text", list->currentText()}};
}

void choose_in(QWidget& field, const QVariant& choice) {
    if (auto* button = qobject_cast<QAbstractButton*>(&field)) button->setChecked(choice.toBool());
    if (auto* spin = qobject_cast<QSpinBox*>(&field)) spin->setValue(choice.toInt());
    if (auto* day = qobject_cast<QDateEdit*>(&field)) day->setDate(choice.toDate());
    const QVariantMap chosen = choice.toMap();
    if (auto* table = qobject_cast<QTableWidget*>(&field)) {
        const int row = chosen.value("row").toInt();
        const auto* first = table->item(row, 0);
        if (first != nullptr && first->text() == chosen.value("text").toString())
            table->selectRow(row);
    }
    auto* list = qobject_cast<QComboBox*>(&field);
    if (list == nullptr) return;
    const QVariant data = chosen.value("data");
    const QString text = chosen.value("text").toString();
    const int row = data.isValid() ? list->findData(data) : list->findText(text);
    if (row >= 0)
        list->setCurrentIndex(row);
    else if (list->isEditable())
        list->setEditText(text);
}

}  // namespace

void keep_choice(QWidget* field) { field->setProperty(kKept, true); }

QVariantMap typed_texts(const QWidget& page) {
    QVariantMap texts;
    for (const auto* line : page.findChildren<QLineEdit*>())
        if (is_ours(*line) && line->isModified() && line->echoMode() == QLineEdit::Normal &&
            !line->text().isEmpty())
            texts.insert(line->objectName(), line->text());
    for (const auto* sheet : page.findChildren<QPlainTextEdit*>())
        if (is_ours(*sheet) && sheet->document()->isModified() && !sheet->isReadOnly())
            texts.insert(sheet->objectName(), sheet->toPlainText());
    for (const auto* field : page.findChildren<QWidget*>())
        if (is_kept(*field))
            if (const QVariant choice = chosen_in(*field); choice.isValid())
                texts.insert(choice_of(*field), choice);
    return texts;
}

void type_again(const QWidget& page, const QVariantMap& texts) {
    for (auto* line : page.findChildren<QLineEdit*>()) {
        const QString text = texts.value(line->objectName()).toString();
        if (text.isEmpty() || text == line->text() ||
            (!line->text().isEmpty() && !is_kept(*line)) || line->isReadOnly() ||
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
    for (auto* field : page.findChildren<QWidget*>())
        if (is_kept(*field) && texts.contains(choice_of(*field)))
            choose_in(*field, texts.value(choice_of(*field)));
}

QVariantMap without_field(const QWidget& page, const QVariantMap& texts) {
    QVariantMap left;
    for (auto each = texts.begin(); each != texts.end(); ++each) {
        const QString& key = each.key();
        const QString name = key.startsWith(kChoice) ? key.mid(kChoice.size()) : key;
        if (page.findChild<QWidget*>(name) == nullptr) left.insert(key, each.value());
    }
    return left;
}

}  // namespace placode::ui
