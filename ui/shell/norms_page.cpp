// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Norms: bands of a task, own and of other centres. Signed files in and out, and which band is
// shown behind the attempts of a task.

#include <QFile>
#include <QHBoxLayout>

#include "db/norm_bands.h"
#include "db/signature.h"
#include "reports/export.h"
#include "ui/shell/day_text.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// A level of another centre may be any word.
QString level_word(const std::string& level) {
    if (level == "expert") return QCoreApplication::translate("NormsPage", "experts");
    if (level == "novice") return QCoreApplication::translate("NormsPage", "novices");
    return qstr(level);
}

class NormsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(NormsPage)
 public:
    explicit NormsPage(AppContext& context) : Page(context) {
        context.require(db::Action::kSetStandards, db::Scope::kOther);
        QVBoxLayout* column = make_column(this, 1200);
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace8);
        head->addWidget(make_label(tr("Norms"), "display"), 1);
        QPushButton* load = make_button(context, tr("Import a pack"), "primary", "download");
        load->setObjectName("import_norms");
        connect(load, &QPushButton::clicked, this, [this] { importPack(); });
        head->addWidget(load);
        column->addLayout(head);
        column->addWidget(make_label(
            tr("A pack holds bands of a task (means and spreads of people, never of fewer than %1 "
               "and never a single attempt), signed by its centre. The pack in use is shown behind "
               "every attempt of the task. Packs of this centre are made on the page Standards.")
                .arg(curriculum::kLeastNormGroup),
            "muted"));
        table_ =
            make_table({tr("Task"), tr("Centre"), tr("Made"), tr("Groups"), tr("Key"), tr("Use")},
                       tr("Norms"));
        table_->setObjectName("norms_table");
        column->addWidget(table_);
        empty_ = make_label(tr("There are no packs yet. Import one of another centre, or make one "
                               "from two groups on the page Standards."),
                            "muted");
        column->addWidget(empty_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        use_ = make_button(context, tr("Use for its task"), "secondary", "check");
        use_->setObjectName("use_norms");
        save_ = make_button(context, tr("Export the pack"), "secondary", "download");
        save_->setObjectName("export_norms");
        row->addWidget(use_);
        row->addWidget(save_);
        row->addStretch();
        column->addLayout(row);
        column->addStretch();
        connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { showButtons(); });
        connect(use_, &QPushButton::clicked, this, [this] { usePack(); });
        connect(save_, &QPushButton::clicked, this, [this] { exportPack(); });
        fill();
    }

    [[nodiscard]] QString title() const override { return tr("Norms"); }

 private:
    /// The same pack stays selected: a second press must not be about another one.
    void fill() {
        const int64_t kept = selected() != nullptr ? selected()->id : 0;
        packs_ = context_.store().norms().list({});
        table_->setSortingEnabled(false);
        table_->setRowCount(static_cast<int>(packs_.size()));
        for (int row = 0; row < table_->rowCount(); ++row) {
            const db::NormPackRecord& each = packs_[static_cast<size_t>(row)];
            QStringList groups;
            for (const curriculum::NormGroup& group : each.pack.groups)
                groups << tr("%1 (people: %2)").arg(level_word(group.level)).arg(group.persons);
            auto* task = make_cell(task_title(context_, each.pack.task_id));
            task->setData(Qt::UserRole, row);
            task->setToolTip(task->text());
            table_->setItem(row, 0, task);
            table_->setItem(
                row, 1,
                make_cell(qstr(each.pack.centre) +
                          (each.pack.demonstration ? " · " + tr("DEMONSTRATION") : QString())));
            table_->setItem(row, 2, make_cell(day_text(each.pack.made_utc)));
            table_->setItem(row, 3, make_cell(groups.join(", ")));
            table_->item(row, 3)->setToolTip(groups.join(", "));
            table_->setItem(row, 4, make_cell(qstr(db::fingerprint(each.norms.public_key))));
            table_->setItem(row, 5, make_cell(each.in_use ? tr("in use") : QString()));
            table_->item(row, 5)->setForeground(context_.colors().good);
        }
        fit_columns(table_, 0);
        table_->setColumnWidth(3, std::min(300, table_->columnWidth(3)));
        keep_within(table_, {.stretch = 0, .least_px = 320, .drop = {4, 2}});
        table_->setFixedHeight(std::clamp<int>(table_->rowCount(), 1, 8) * kTouchTarget + 50);
        table_->setSortingEnabled(true);
        table_->setVisible(!packs_.empty());
        empty_->setVisible(packs_.empty());
        if (!packs_.empty()) table_->selectRow(rowOf(kept));
        showButtons();
    }

    [[nodiscard]] const db::NormPackRecord* selected() const {
        const auto rows = table_->selectionModel()->selectedRows();
        if (rows.isEmpty()) return nullptr;
        return &packs_[static_cast<size_t>(
            table_->item(rows.front().row(), 0)->data(Qt::UserRole).toInt())];
    }

    /// 0 where it is not there.
    [[nodiscard]] int rowOf(int64_t pack) const {
        for (int row = 0; row < table_->rowCount(); ++row)
            if (packs_[static_cast<size_t>(table_->item(row, 0)->data(Qt::UserRole).toInt())].id ==
                pack)
                return row;
        return 0;
    }

    void showButtons() {
        const db::NormPackRecord* pack = selected();
        use_->setEnabled(pack != nullptr && !pack->in_use);
        save_->setEnabled(pack != nullptr);
    }

    void usePack() {
        const db::NormPackRecord* pack = selected();
        if (pack == nullptr) return;
        context_.guard(tr("Using the pack"), [&] {
            context_.store().norms().use(pack->id);
            fill();
        });
    }

    void exportPack() {
        const db::NormPackRecord* pack = selected();
        if (pack == nullptr) return;
        const QString path =
            context_.askSaveFile(this, tr("Export the pack"),
                                 "norms-" + qstr(pack->pack.task_id) + ".json", "JSON (*.json)");
        if (path.isEmpty()) return;
        context_.guard(tr("Exporting the pack"), [&] {
            // Before the file: nothing leaves without its entry.
            context_.audit("norms.export", QString("norm pack %1").arg(pack->id), path);
            reports::save_private_file(path.toStdString(),
                                       curriculum::signed_norms_text(pack->norms));
            Q_EMIT written(tr("Pack written: %1").arg(path), path);
        });
    }

    void importPack() {
        const QString path = context_.askOpenFile(this, tr("Import a pack"), "JSON (*.json)");
        if (path.isEmpty()) return;
        context_.guard(tr("Importing the pack"), [&] {
            const std::string file = path.toStdString();
            const auto norms =
                curriculum::load_signed_norms(curriculum::read_norm_file(file), file);
            const auto pack = curriculum::load_norm_pack(norms.content, file);
            if (!db::signature_is_right(norms.content, norms.signature, norms.public_key))
                throw Refusal(tr("%1: the signature is wrong: the pack was changed after it was "
                                 "signed. Ask the centre for it again.")
                                  .arg(path));
            if (!context_.store().norms().trusted_centres().contains(norms.public_key)) {
                if (!confirm(this, tr("Trust %1?").arg(qstr(pack.centre)),
                             tr("Its key is %1. Compare it with the centre by telephone before "
                                "you trust it.")
                                 .arg(qstr(db::fingerprint(norms.public_key))),
                             tr("Trust this key")))
                    return;
                context_.store().norms().trust_centre(norms.public_key, pack.centre);
            }
            context_.store().norms().save(norms);
            fill();
            Q_EMIT notice(tr("The pack of %1 was imported.").arg(qstr(pack.centre)));
        });
    }

    std::vector<db::NormPackRecord> packs_;
    QTableWidget* table_ = nullptr;
    QLabel* empty_ = nullptr;
    QPushButton *use_ = nullptr, *save_ = nullptr;
};

}  // namespace

Page* make_norms_page(AppContext& context, const Place&) { return new NormsPage(context); }

}  // namespace placode::ui
