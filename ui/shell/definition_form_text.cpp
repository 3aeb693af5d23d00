// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/definition_form_text.h"

#include <QLocale>
#include <QStringList>

#include "ui/shell/parts.h"

namespace placode::ui::form_text {

namespace {

OrderedJson strings(const QString& words) {
    OrderedJson list = OrderedJson::array();
    for (const QString& each : words.split(' ', Qt::SkipEmptyParts))
        list.push_back(each.toStdString());
    return list;
}

/// The words of a list, as they are typed.
QString joined(const OrderedJson& list) {
    QStringList words;
    for (const auto& each : list)
        words << (each.is_string() ? form_text::text_of(each) : qstr(each.dump()));
    return words.join(' ');
}

QStringList parts_of(const QString& line, int at_least) {
    QStringList parts = line.split('|');
    while (parts.size() < at_least) parts << QString();
    for (QString& part : parts) part = part.trimmed();
    return parts;
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

}  // namespace

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

}  // namespace placode::ui::form_text
