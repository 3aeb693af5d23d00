// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The parts of a study or questionnaire in order, and the form over the one that is chosen: the
// definition itself, consent and arms, then every step or question.

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

#include "ui/shell/definition_form.h"

class QLabel;
class QListWidget;

namespace placode::ui {

class AppContext;

class DefinitionElements : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ProtocolsPage)
 public:
    /// @param study a study; else a questionnaire.
    DefinitionElements(AppContext& context, bool study);

    /// Follows a text that was read; the row stays.
    void follow(const OrderedJson& definition);
    /// As list and form have made it; null before the first follow().
    [[nodiscard]] const OrderedJson& definition() const { return definition_; }
    void chooseConsent();
    [[nodiscard]] int row() const;
    void choose(int row);  ///< Where there is such a row.
    /// Another definition is shown: what was removed from the last one does not belong into it.
    void forgetRemoved();
    /// Is called after every change by hand.
    std::function<void()> changed;
    /// Is asked before a button changes anything; false = nothing may be changed now.
    std::function<bool()> ready;

 private:
    QWidget* listCard();
    QWidget* formCard();
    /// The form leads.
    void formChanged();
    /// Consent and arms are edited apart: an empty one must not stand in the text.
    void takePart(const char* key, const OrderedJson& part);
    /// Rows of the list above the first element.
    [[nodiscard]] int firstRow() const;
    [[nodiscard]] OrderedJson& elements();
    /// First row: the definition itself.
    void fillList(int row);
    void showForm();
    void listChanged(int row);
    void add();
    void moveBy(int by);
    void removeElement();
    void putBack();
    QWidget* removedRow();
    void showRemoved();
    /// The second click of two that were meant as one.
    [[nodiscard]] bool clickedTwice() const;

    AppContext& context_;
    bool study_;
    OrderedJson definition_, consent_, arms_;
    QListWidget* list_ = nullptr;
    DefinitionForm* form_ = nullptr;
    /// What was removed and where it stood, the last one at the end.
    std::vector<std::pair<size_t, OrderedJson>> removed_;
    QElapsedTimer since_removal_;
    QWidget* removed_row_ = nullptr;
    QLabel* removed_name_ = nullptr;
};

}  // namespace placode::ui
