// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A form over one JSON object: which key is asked for with which kind of field stands in a table,
// so that steps, items and whole definitions share one widget.

#include <QWidget>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

class QVBoxLayout;

namespace placode::ui {

using OrderedJson = nlohmann::ordered_json;

enum class FormFieldKind : uint8_t {
    kText,
    kLocal,       ///< {"en": .., "pl": ..}: two fields.
    kLocalLines,  ///< [{"en": .., "pl": ..}, ..]: a line each, "english | polish".
    kStatements,  ///< [{"id": .., "text": ..}, ..]: "id | english | polish".
    kNumber,
    kInteger,
    kFlag,
    kChoice,    ///< One of `options`.
    kSeveral,   ///< Any of `options`, as a list; absent = the program's own choice.
    kIntegers,  ///< [0, 1]
    kShowIf,    ///< {"item": .., "any_of": [..]}: "item = 1 2".
    kScales     ///< [{"id", "title", "items", "method"}, ..]: "id | mean A B C | english | polish".
};

/// A choice: what the definition holds, and what is read.
struct FormOption {
    QString value, words;
};

struct FormField {
    const char* key;
    QString label;
    FormFieldKind kind = FormFieldKind::kText;
    std::vector<FormOption> options = {};
    bool default_flag = false;  ///< kFlag: what an absent key means; that value is not written.
};

class DefinitionForm : public QWidget {
 public:
    /// Shows `object`, which outlives the form or the next showObject(). Every edit changes it at
    /// once and calls `changed`. An empty field takes its key away.
    void showObject(OrderedJson* object, const std::vector<FormField>& fields);
    std::function<void()> changed;

 private:
    void add(QVBoxLayout* column, const FormField& field);
    void addFlag(QVBoxLayout* column, const FormField& field);
    void addChoice(QVBoxLayout* column, const FormField& field);
    void addLocal(QVBoxLayout* column, const FormField& field);
    void addLine(QVBoxLayout* column, const FormField& field);
    void addSeveral(QVBoxLayout* column, const FormField& field);
    void addLines(QVBoxLayout* column, const FormField& field);
    [[nodiscard]] OrderedJson present(const char* key) const;
    void set(const char* key, const OrderedJson& value);

    OrderedJson* object_ = nullptr;
};

}  // namespace placode::ui
