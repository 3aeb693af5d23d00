// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/definition_elements.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <algorithm>

#include "ui/shell/definition_fields.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

constexpr int kConsentRow = 1;

/// Empty where something else stands: a form can only be filled into an object.
OrderedJson object_at(const OrderedJson& definition, const char* key) {
    const auto found = definition.find(key);
    return found != definition.end() && found->is_object() ? *found : OrderedJson::object();
}

}  // namespace

DefinitionElements::DefinitionElements(AppContext& context, bool study)
    : context_(context), study_(study) {
    auto* body = new QHBoxLayout(this);
    body->setContentsMargins(0, 0, 0, 0);
    body->setSpacing(kSpace16);
    body->addWidget(listCard(), 2);
    body->addWidget(formCard(), 3);
}

void DefinitionElements::follow(const OrderedJson& definition) {
    definition_ = definition;
    consent_ = object_at(definition, "consent");
    arms_ = object_at(definition, "arms");
    fillList(std::max(0, list_->currentRow()));
}

void DefinitionElements::chooseConsent() { list_->setCurrentRow(kConsentRow); }

int DefinitionElements::row() const { return list_->currentRow(); }

void DefinitionElements::choose(int row) {
    if (row >= 0 && row < list_->count()) list_->setCurrentRow(row);
}

QWidget* DefinitionElements::listCard() {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    layout->addWidget(make_label(study_ ? tr("Steps") : tr("Questions"), "heading"));
    list_ = new QListWidget;
    list_->setObjectName("elements");
    list_->setAccessibleName(study_ ? tr("Steps") : tr("Questions"));
    list_->setMinimumHeight(320);
    list_->setStyleSheet("QListWidget::item { min-height: 40px; }");  // for a finger
    connect(list_, &QListWidget::currentRowChanged, this, [this] { showForm(); });
    layout->addWidget(list_);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    row->addWidget(make_action(context_, this, tr("Add"), "secondary", "plus", "element_add",
                               [this] { add(); }));
    row->addWidget(
        make_action(context_, this, tr("Up"), "quiet", {}, "element_up", [this] { moveBy(-1); }));
    row->addWidget(make_action(context_, this, tr("Down"), "quiet", {}, "element_down",
                               [this] { moveBy(1); }));
    row->addWidget(make_action(context_, this, tr("Remove"), "quiet", "close", "element_remove",
                               [this] { removeElement(); }));
    layout->addLayout(row);
    layout->addWidget(removedRow());
    return make_card(layout);
}

QWidget* DefinitionElements::removedRow() {
    removed_row_ = new QWidget;
    auto* row = new QHBoxLayout(removed_row_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace8);
    removed_name_ = make_label({}, "small");
    removed_name_->setObjectName("element_removed");
    row->addWidget(removed_name_, 1);
    row->addWidget(make_action(context_, this, tr("Put it back"), "secondary", "again",
                               "element_put_back", [this] { putBack(); }));
    removed_row_->hide();
    return removed_row_;
}

QWidget* DefinitionElements::formCard() {
    auto* layout = new QVBoxLayout;
    form_ = new DefinitionForm;
    form_->changed = [this] { formChanged(); };
    layout->addWidget(form_);
    return make_card(layout);
}

void DefinitionElements::formChanged() {
    takePart("consent", consent_);
    takePart("arms", arms_);
    if (const int row = list_->currentRow(); row >= firstRow())
        list_->currentItem()->setText(
            element_name(elements()[static_cast<size_t>(row - firstRow())]));
    changed();
}

void DefinitionElements::takePart(const char* key, const OrderedJson& part) {
    if (!study_) return;
    if (part.empty())
        definition_.erase(key);
    else
        definition_[key] = part;
}

int DefinitionElements::firstRow() const { return study_ ? 3 : 1; }

OrderedJson& DefinitionElements::elements() {
    OrderedJson& list = definition_[study_ ? "steps" : "items"];
    if (!list.is_array()) list = OrderedJson::array();
    return list;
}

void DefinitionElements::fillList(int row) {
    const QSignalBlocker quiet(list_);
    list_->clear();
    list_->addItem(study_ ? tr("The study itself") : tr("The questionnaire itself"));
    if (study_) list_->addItems({tr("Information and consent"), tr("Arms")});
    for (const auto& each : elements()) list_->addItem(element_name(each));
    list_->setCurrentRow(std::min(row, list_->count() - 1));
    showForm();
}

void DefinitionElements::showForm() {
    const int row = list_->currentRow();
    if (row < 0) return;
    if (row == 0)
        form_->showObject(&definition_, study_ ? study_fields() : questionnaire_fields());
    else if (row < firstRow())
        form_->showObject(row == kConsentRow ? &consent_ : &arms_,
                          row == kConsentRow ? consent_fields() : arms_fields());
    else {
        OrderedJson& element = elements()[static_cast<size_t>(row - firstRow())];
        if (!element.is_object()) element = OrderedJson::object();
        form_->showObject(&element, study_ ? step_fields(context_) : item_fields());
    }
}

void DefinitionElements::listChanged(int row) {
    fillList(row);
    formChanged();
}

void DefinitionElements::add() {
    if (!ready()) return;
    elements().push_back(new_element(study_, elements().size() + 1));
    listChanged(static_cast<int>(elements().size()) + firstRow() - 1);
}

void DefinitionElements::moveBy(int by) {
    if (!ready()) return;
    const int row = list_->currentRow(), to = row + by;
    if (row < firstRow() || to < firstRow() || to >= list_->count()) return;
    std::swap(elements()[static_cast<size_t>(row - firstRow())],
              elements()[static_cast<size_t>(to - firstRow())]);
    listChanged(to);
}

void DefinitionElements::removeElement() {
    if (clickedTwice() || !ready()) return;
    const int row = list_->currentRow();
    if (row < firstRow()) return;
    const auto at = static_cast<size_t>(row - firstRow());
    removed_.emplace_back(at, elements()[at]);
    since_removal_.start();
    elements().erase(at);
    listChanged(row - 1);
    showRemoved();
}

void DefinitionElements::putBack() {
    // The row of this button has just moved the others: a double click may end here.
    if (clickedTwice() || !ready() || removed_.empty()) return;
    OrderedJson& list = elements();
    const size_t at = std::min(removed_.back().first, list.size());
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), removed_.back().second);
    removed_.pop_back();
    listChanged(firstRow() + static_cast<int>(at));
    showRemoved();
}

bool DefinitionElements::clickedTwice() const {
    return since_removal_.isValid() &&
           since_removal_.elapsed() < QApplication::doubleClickInterval();
}

void DefinitionElements::showRemoved() {
    removed_row_->setVisible(!removed_.empty());
    if (!removed_.empty())
        removed_name_->setText(tr("Removed: %1").arg(element_name(removed_.back().second)));
}

void DefinitionElements::forgetRemoved() {
    removed_.clear();
    showRemoved();
}

}  // namespace placode::ui
