// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/erasure_requests_card.h"

#include <QCheckBox>
#include <algorithm>
#include <memory>

#include "reports/export.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {

ErasureRequestsCard::ErasureRequestsCard(AppContext& context, Page& page)
    : context_(context), page_(page) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(tr("Who asks to be erased"), "heading"));
    requests_ = make_table({tr("Person"), tr("Asked"), tr("Reason"), tr("State"), {}},
                           tr("Who asks to be erased"));
    requests_->setObjectName("erasure_table");
    requests_->setSortingEnabled(false);
    layout->addWidget(requests_);
    with_attempts_ = new QCheckBox(tr("The attempts go as well (else they stay, nameless)"));
    with_attempts_->setObjectName("erase_attempts");
    keep_choice(with_attempts_);
    layout->addWidget(with_attempts_);
    none_ = make_label(tr("Nobody has asked."), "muted");
    layout->addWidget(none_);
    left_ = make_label({}, "warn");
    left_->setObjectName("erasure_left");
    left_->hide();
    layout->addWidget(left_);
    certificate_ =
        make_button(context_, tr("Save the certificate of erasure"), "secondary", "download");
    certificate_->setObjectName("erasure_certificate");
    certificate_->hide();
    connect(certificate_, &QPushButton::clicked, this, [this] { saveCertificate(); });
    layout->addWidget(certificate_, 0, Qt::AlignLeft);
    connect(&context_, &AppContext::erasureEnded, this,
            [this](const QString& name, bool done) { erased(name, done); });
    showRequests();
    showLast();
}

void ErasureRequestsCard::showRequests() {
    const auto all = context_.store().accounts().erasure_requests();
    requests_->setRowCount(static_cast<int>(all.size()));
    bool waits = false;
    for (int row = 0; row < requests_->rowCount(); ++row) {
        const db::ErasureRecord& each = all[static_cast<size_t>(row)];
        const auto user = context_.store().accounts().find(each.user_id);
        const bool open = each.done_utc.empty();
        waits = waits || open;
        const QString name =
            open && user ? qstr(user->display_name) : tr("number %1").arg(each.user_id);
        requests_->setItem(row, 0, make_cell(name));
        requests_->setItem(row, 1, make_cell(format_when(each.asked_utc)));
        requests_->setItem(row, 2, make_cell(qstr(each.reason)));
        requests_->setItem(
            row, 3,
            make_cell(open ? tr("waits") : tr("erased %1").arg(format_when(each.done_utc))));
        requests_->setItem(row, 4, make_cell({}));
        requests_->removeCellWidget(row, 4);
        if (!open) continue;
        QPushButton* erase = make_button(context_, tr("Erase"), "danger");
        erase->setObjectName(QString("erase_%1").arg(row));
        erase->setAccessibleName(tr("Erase %1").arg(name));
        connect(
            erase, &QPushButton::clicked, this,
            [this, id = each.user_id, name] { this->erase(id, name); }, Qt::QueuedConnection);
        requests_->setCellWidget(row, 4, erase);
    }
    fit_columns(requests_, 2);
    requests_->setColumnWidth(0, std::max(200, requests_->columnWidth(0)));
    requests_->setColumnWidth(3, std::max(170, requests_->columnWidth(3)));
    requests_->setColumnWidth(4, 120);
    requests_->setFixedHeight(std::clamp<int>(requests_->rowCount(), 1, 5) * kTouchTarget + 50);
    requests_->setVisible(!all.empty());
    with_attempts_->setVisible(waits);
    none_->setVisible(all.empty());
}

void ErasureRequestsCard::erase(int64_t id, const QString& name) {
    const bool attempts = with_attempts_->isChecked();
    if (!confirm(&page_, tr("Erase %1 for good?").arg(name),
                 attempts ? tr("Name, log-in, groups, certificates and all attempts go. This "
                               "cannot be undone.")
                          : tr("Name, log-in, groups and certificates go; attempts stay "
                               "without a name. This cannot be undone."),
                 tr("Erase")))
        return;
    const bool may = context_.guard(tr("Erasing the person"), [&] {
        context_.require(db::Action::kErase,
                         db::scope_between(context_.store(), context_.user().id, id));
    });
    if (!may) return;
    const auto erasure = std::make_shared<db::Erasure>();
    // The context hears of the end: this page may have been left, and nothing can tell it again.
    context_.background(
        &context_, tr("Erasing the person"),
        [erasure, id, attempts, url = context_.storeUrl()](db::Store& store) {
            *erasure = db::erase_person(store, url, id, attempts);
        },
        [context = &context_, erasure, name, url = context_.storeUrl()](bool done) {
            if (done) context->keepErasure(url, *erasure);
            Q_EMIT context->erasureEnded(name, done);
        });
}

void ErasureRequestsCard::erased(const QString& name, bool done) {
    // Where the session ended meanwhile there is no list, and the next page says why.
    (void)context_.problemOf([this] { showRequests(); });
    showLast();
    const db::Erasure* last = context_.lastErasure();
    if (!done || last == nullptr) return;
    QString said = tr("%1 was erased.").arg(name);
    if (!last->cleaned.empty())
        said += ' ' + tr("Backups and other copies cleaned as well: %1.").arg(last->cleaned.size());
    Q_EMIT page_.notice(said);
}

void ErasureRequestsCard::showLast() {
    const db::Erasure* last = context_.lastErasure();
    QStringList left;
    if (last != nullptr)
        for (const db::LeftCopy& each : last->left) left << qstr(each.path);
    left_->setText(tr("These copies may still hold the person; delete them:") + '\n' +
                   left.join('\n'));
    left_->setVisible(!left.isEmpty());
    certificate_->setVisible(last != nullptr);
}

void ErasureRequestsCard::saveCertificate() {
    if (context_.lastErasure() == nullptr) return;
    const db::Erasure erasure = *context_.lastErasure();
    const QString path = context_.askSaveFile(
        &page_, tr("Save the certificate of erasure"),
        QString("placode-erasure-%1.txt").arg(erasure.user_id), tr("Text (*.txt)"));
    if (path.isEmpty()) return;
    context_.guard(tr("Writing the certificate"), [&] {
        reports::save_private_file(path.toStdString(), db::erasure_certificate(erasure));
        Q_EMIT page_.written(tr("Certificate written: %1").arg(path), path);
    });
}

}  // namespace placode::ui
