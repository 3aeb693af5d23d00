// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/definition_elements.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <algorithm>

#include "ui/shell/definition_fields.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

constexpr int kConsentRow = 1;

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
    consent_ = definition.value("consent", OrderedJson::object());
    arms_ = definition.value("arms", OrderedJson::object());
    fillList(std::max(0, list_->currentRow()));
}

void DefinitionElements::chooseConsent() { list_->setCurrentRow(kConsentRow); }

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
    return make_card(layout);
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
    elements().push_back(new_element(study_, elements().size() + 1));
    listChanged(static_cast<int>(elements().size()) + firstRow() - 1);
}

void DefinitionElements::moveBy(int by) {
    const int row = list_->currentRow(), to = row + by;
    if (row < firstRow() || to < firstRow() || to >= list_->count()) return;
    std::swap(elements()[static_cast<size_t>(row - firstRow())],
              elements()[static_cast<size_t>(to - firstRow())]);
    listChanged(to);
}

void DefinitionElements::removeElement() {
    const int row = list_->currentRow();
    if (row < firstRow()) return;
    elements().erase(static_cast<size_t>(row - firstRow()));
    listChanged(row - 1);
}

}  // namespace placode::ui
