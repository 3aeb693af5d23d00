// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/definition_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/shell/definition_form_text.h"
#include "ui/shell/parts.h"

namespace placode::ui {

void DefinitionForm::set(const char* key, const OrderedJson& value) {
    if (value.is_null())
        object_->erase(key);
    else
        (*object_)[key] = value;
    if (changed) changed();
}

void DefinitionForm::showObject(OrderedJson* object, const std::vector<FormField>& fields) {
    object_ = object;
    if (QLayout* old = layout()) {
        QWidget().setLayout(old);  // Takes the layout away...
        for (QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
            child->hide();
            child->deleteLater();  // ...and its fields, one of which may be speaking just now.
        }
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace8);
    for (const FormField& field : fields) add(column, field);
    column->addStretch();
}

OrderedJson DefinitionForm::present(const char* key) const {
    return object_->contains(key) ? (*object_)[key] : OrderedJson();
}

void DefinitionForm::add(QVBoxLayout* column, const FormField& field) {
    switch (field.kind) {
        case FormFieldKind::kFlag:
            return addFlag(column, field);
        case FormFieldKind::kChoice:
            return addChoice(column, field);
        case FormFieldKind::kSeveral:
            return addSeveral(column, field);
        case FormFieldKind::kLocal:
            return addLocal(column, field);
        case FormFieldKind::kLocalLines:
        case FormFieldKind::kStatements:
        case FormFieldKind::kScales:
            return addLines(column, field);
        default:
            return addLine(column, field);
    }
}

void DefinitionForm::addFlag(QVBoxLayout* column, const FormField& field) {
    const char* key = field.key;
    const OrderedJson value = present(key);
    const QString name = QString("form_") + key;
    auto* box = new QCheckBox(field.label);
    box->setObjectName(name);
    box->setMinimumHeight(kTouchTarget);
    box->setChecked(value.is_boolean() ? value.get<bool>() : field.default_flag);
    connect(box, &QCheckBox::toggled, this, [this, key, plain = field.default_flag](bool on) {
        set(key, on == plain ? OrderedJson() : OrderedJson(on));
    });
    column->addWidget(box);
}

void DefinitionForm::addChoice(QVBoxLayout* column, const FormField& field) {
    const char* key = field.key;
    const OrderedJson value = present(key);
    const QString name = QString("form_") + key;
    auto* box = new QComboBox;
    box->setObjectName(name);
    for (const FormOption& option : field.options) box->addItem(option.words, option.value);
    const QString now = form_text::text_of(value);
    // What this program does not know stays as it is until another is chosen.
    if (box->findData(now) < 0) box->addItem(now, now);
    box->setCurrentIndex(box->findData(now));
    connect(box, &QComboBox::currentIndexChanged, this, [this, key, box] {
        set(key, form_text::read(box->currentData().toString(), FormFieldKind::kText));
    });
    column->addLayout(make_field(field.label, box));
}

void DefinitionForm::addLocal(QVBoxLayout* column, const FormField& field) {
    const char* key = field.key;
    const OrderedJson value = present(key);
    const QString name = QString("form_") + key;
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace8);
    auto* english = new QLineEdit(form_text::local_of(value, "en"));
    auto* polish = new QLineEdit(form_text::local_of(value, "pl"));
    english->setObjectName(name + "_en");
    polish->setObjectName(name + "_pl");
    row->addLayout(make_field(field.label + " (EN)", english));
    row->addLayout(make_field(field.label + " (PL)", polish));
    for (QLineEdit* edit : {english, polish}) edit->setCursorPosition(0);
    for (QLineEdit* edit : {english, polish})
        connect(edit, &QLineEdit::textEdited, this, [this, key, english, polish] {
            set(key, form_text::local(english->text(), polish->text()));
        });
    column->addLayout(row);
}

void DefinitionForm::addLine(QVBoxLayout* column, const FormField& field) {
    const char* key = field.key;
    const OrderedJson value = present(key);
    const QString name = QString("form_") + key;
    auto* edit = new QLineEdit(form_text::shown(value, field.kind));
    edit->setCursorPosition(0);  // The beginning of a long text, not its end.
    edit->setObjectName(name);
    connect(edit, &QLineEdit::textEdited, this, [this, key, kind = field.kind, edit] {
        set(key, form_text::read(edit->text(), kind));
    });
    column->addLayout(make_field(field.label, edit));
}

/// A box for "as usual", which takes the key away, and a box for each option.
void DefinitionForm::addSeveral(QVBoxLayout* column, const FormField& field) {
    const std::string key = field.key;
    const QString name = QString("form_") + field.key;
    const auto there = object_->find(key);
    const bool listed = there != object_->end() && there->is_array();
    auto* row = new QVBoxLayout;
    row->setSpacing(kSpace4);
    auto* usual = new QCheckBox(QCoreApplication::translate("DefinitionFields", "as usual"));
    usual->setObjectName(name + "_usual");
    usual->setChecked(!listed);
    row->addWidget(usual);
    std::vector<std::pair<QCheckBox*, std::string>> boxes;
    for (const FormOption& option : field.options) {
        auto* box = new QCheckBox(option.words);
        box->setObjectName(name + "_" + option.value);
        const std::string value = option.value.toStdString();
        box->setChecked(listed && std::find(there->begin(), there->end(), value) != there->end());
        box->setEnabled(listed);
        row->addWidget(box);
        boxes.emplace_back(box, value);
    }
    const auto take = [this, field, usual, boxes] {
        OrderedJson list = OrderedJson::array();
        for (const auto& [box, value] : boxes) {
            box->setEnabled(!usual->isChecked());
            if (box->isChecked()) list.push_back(value);
        }
        if (usual->isChecked())
            object_->erase(field.key);
        else
            (*object_)[field.key] = list;
        if (changed) changed();
    };
    connect(usual, &QCheckBox::toggled, this, take);
    for (const auto& [box, value] : boxes) connect(box, &QCheckBox::toggled, this, take);
    auto* holder = new QWidget;
    holder->setLayout(row);
    row->setContentsMargins(0, 0, 0, 0);
    column->addLayout(make_field(field.label, holder));
}

void DefinitionForm::addLines(QVBoxLayout* column, const FormField& field) {
    const char* key = field.key;
    QStringList lines;
    if (object_->contains(key) && (*object_)[key].is_array())
        for (const auto& each : (*object_)[key]) lines << form_text::line_of(each, field.kind);
    auto* edit = new QPlainTextEdit(lines.join('\n'));
    edit->setObjectName(QString("form_") + key);
    edit->setTabChangesFocus(true);
    edit->setMinimumHeight(96);
    connect(edit, &QPlainTextEdit::textChanged, this, [this, key, kind = field.kind, edit] {
        const OrderedJson before = object_->contains(key) ? (*object_)[key] : OrderedJson::array();
        OrderedJson list = OrderedJson::array();
        for (const QString& line : edit->toPlainText().split('\n')) {
            if (line.trimmed().isEmpty()) continue;
            const size_t at = list.size();
            list.push_back(form_text::element_of(
                line, kind, before.is_array() && at < before.size() ? before[at] : OrderedJson()));
        }
        set(key, list.empty() ? OrderedJson() : list);
    });
    column->addLayout(make_field(field.label, edit));
}

}  // namespace placode::ui
