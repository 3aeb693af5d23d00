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

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

QString text_of(const OrderedJson& json) {
    return json.is_string() ? qstr(json.get<std::string>()) : QString();
}

QString local_of(const OrderedJson& json, const char* language) {
    return json.is_object() && json.contains(language) ? text_of(json[language]) : QString();
}

OrderedJson local(const QString& english, const QString& polish) {
    OrderedJson json = OrderedJson::object();
    if (!english.trimmed().isEmpty()) json["en"] = english.trimmed().toStdString();
    if (!polish.trimmed().isEmpty()) json["pl"] = polish.trimmed().toStdString();
    return json.empty() ? OrderedJson() : json;
}

OrderedJson strings(const QString& words) {
    OrderedJson list = OrderedJson::array();
    for (const QString& each : words.split(' ', Qt::SkipEmptyParts))
        list.push_back(each.toStdString());
    return list;
}

/// The words of a list, as they are typed.
QString joined(const OrderedJson& list) {
    QStringList words;
    for (const auto& each : list) words << (each.is_string() ? text_of(each) : qstr(each.dump()));
    return words.join(' ');
}

QStringList parts_of(const QString& line, int at_least) {
    QStringList parts = line.split('|');
    while (parts.size() < at_least) parts << QString();
    for (QString& part : parts) part = part.trimmed();
    return parts;
}

/// A line of a list of objects, and back.
QString line_of(const OrderedJson& element, FormFieldKind kind) {
    if (!element.is_object()) return {};
    const auto at = [&](const char* key) {
        return element.contains(key) ? element[key] : OrderedJson();
    };
    const auto both = [](const OrderedJson& text) {
        const QString polish = local_of(text, "pl");
        return local_of(text, "en") + (polish.isEmpty() ? "" : " | " + polish);
    };
    if (kind == FormFieldKind::kStatements) return text_of(at("id")) + " | " + both(at("text"));
    if (kind == FormFieldKind::kScales)
        return text_of(at("id")) + " | " +
               (text_of(at("method")).isEmpty() ? "mean" : text_of(at("method"))) + " " +
               joined(at("items")) + " | " + both(at("title"));
    return both(element);
}

OrderedJson element_of(const QString& line, FormFieldKind kind, const OrderedJson& before) {
    if (kind == FormFieldKind::kLocalLines) {
        const QStringList parts = parts_of(line, 2);
        return local(parts[0], parts[1]);
    }
    // Keys that the line does not show (required, factor, ...) stay as they were.
    OrderedJson element = before.is_object() ? before : OrderedJson::object();
    if (kind == FormFieldKind::kStatements) {
        const QStringList parts = parts_of(line, 3);
        element["id"] = parts[0].toStdString();
        element["text"] = local(parts[1], parts[2]);
        return element;
    }
    const QStringList parts = parts_of(line, 4);
    element["id"] = parts[0].toStdString();
    element["title"] = local(parts[2], parts[3]);
    element["method"] = parts[1].section(' ', 0, 0).toStdString();
    element["items"] = strings(parts[1].section(' ', 1));
    return element;
}

OrderedJson show_if_of(const QString& text) {
    if (text.trimmed().isEmpty()) return {};
    return {{"item", text.section('=', 0, 0).trimmed().toStdString()},
            {"any_of", strings(text.section('=', 1))}};
}

/// A number as it is typed; what is none stays a text, and the check says so.
OrderedJson number_of(const QString& text, bool whole) {
    if (text.trimmed().isEmpty()) return {};
    bool ok = false;
    if (whole) {
        const int value = text.trimmed().toInt(&ok);
        return ok ? OrderedJson(value) : OrderedJson(text.trimmed().toStdString());
    }
    const double value = QLocale::c().toDouble(text.trimmed().replace(',', '.'), &ok);
    return ok ? OrderedJson(value) : OrderedJson(text.trimmed().toStdString());
}

QString shown(const OrderedJson& value, FormFieldKind kind) {
    if (value.is_null()) return {};
    if (kind == FormFieldKind::kIntegers) return joined(value);
    if (kind == FormFieldKind::kShowIf)
        return value.is_object() ? text_of(value.value("item", OrderedJson())) + " = " +
                                       joined(value.value("any_of", OrderedJson::array()))
                                 : QString();
    return value.is_string() ? text_of(value) : qstr(value.dump());
}

OrderedJson read(const QString& text, FormFieldKind kind) {
    switch (kind) {
        case FormFieldKind::kNumber:
        case FormFieldKind::kInteger:
            return number_of(text, kind == FormFieldKind::kInteger);
        case FormFieldKind::kShowIf:
            return show_if_of(text);
        case FormFieldKind::kIntegers: {
            if (text.trimmed().isEmpty()) return {};
            OrderedJson list = OrderedJson::array();
            for (const QString& each : text.split(' ', Qt::SkipEmptyParts))
                list.push_back(number_of(each, true));
            return list;
        }
        default:
            return text.trimmed().isEmpty() ? OrderedJson()
                                            : OrderedJson(text.trimmed().toStdString());
    }
}

}  // namespace

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

void DefinitionForm::add(QVBoxLayout* column, const FormField& field) {
    const char* key = field.key;
    const OrderedJson value = object_->contains(key) ? (*object_)[key] : OrderedJson();
    const QString name = QString("form_") + key;
    switch (field.kind) {
        case FormFieldKind::kFlag: {
            auto* box = new QCheckBox(field.label);
            box->setObjectName(name);
            box->setMinimumHeight(kTouchTarget);
            box->setChecked(value.is_boolean() ? value.get<bool>() : field.default_flag);
            connect(box, &QCheckBox::toggled, this,
                    [this, key, plain = field.default_flag](bool on) {
                        set(key, on == plain ? OrderedJson() : OrderedJson(on));
                    });
            column->addWidget(box);
            return;
        }
        case FormFieldKind::kChoice: {
            auto* box = new QComboBox;
            box->setObjectName(name);
            for (const FormOption& option : field.options) box->addItem(option.words, option.value);
            const QString now = text_of(value);
            // What this program does not know stays as it is until another is chosen.
            if (box->findData(now) < 0) box->addItem(now, now);
            box->setCurrentIndex(box->findData(now));
            connect(box, &QComboBox::currentIndexChanged, this, [this, key, box] {
                set(key, read(box->currentData().toString(), FormFieldKind::kText));
            });
            column->addLayout(make_field(field.label, box));
            return;
        }
        case FormFieldKind::kSeveral:
            return addSeveral(column, field);
        case FormFieldKind::kLocal: {
            auto* row = new QHBoxLayout;
            row->setSpacing(kSpace8);
            auto* english = new QLineEdit(local_of(value, "en"));
            auto* polish = new QLineEdit(local_of(value, "pl"));
            english->setObjectName(name + "_en");
            polish->setObjectName(name + "_pl");
            row->addLayout(make_field(field.label + " (EN)", english));
            row->addLayout(make_field(field.label + " (PL)", polish));
            for (QLineEdit* edit : {english, polish}) edit->setCursorPosition(0);
            for (QLineEdit* edit : {english, polish})
                connect(edit, &QLineEdit::textEdited, this, [this, key, english, polish] {
                    set(key, local(english->text(), polish->text()));
                });
            column->addLayout(row);
            return;
        }
        case FormFieldKind::kLocalLines:
        case FormFieldKind::kStatements:
        case FormFieldKind::kScales:
            addLines(column, field);
            return;
        default: {
            auto* edit = new QLineEdit(shown(value, field.kind));
            edit->setCursorPosition(0);  // The beginning of a long text, not its end.
            edit->setObjectName(name);
            connect(edit, &QLineEdit::textEdited, this,
                    [this, key, kind = field.kind, edit] { set(key, read(edit->text(), kind)); });
            column->addLayout(make_field(field.label, edit));
        }
    }
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
        for (const auto& each : (*object_)[key]) lines << line_of(each, field.kind);
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
            list.push_back(element_of(
                line, kind, before.is_array() && at < before.size() ? before[at] : OrderedJson()));
        }
        set(key, list.empty() ? OrderedJson() : list);
    });
    column->addLayout(make_field(field.label, edit));
}

}  // namespace placode::ui
