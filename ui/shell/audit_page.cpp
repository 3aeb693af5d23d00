// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Audit: who did what and when. Read only.

#include <QHBoxLayout>
#include <QLineEdit>
#include <QRegularExpression>

#include "ui/shell/audit_words.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

constexpr int kShownEntries = 1000;

/// The words, and behind them the code that a log or the command line names.
bool found_in(const QTableWidgetItem& cell, const QString& wanted) {
    return cell.text().contains(wanted, Qt::CaseInsensitive) ||
           cell.toolTip().contains(wanted, Qt::CaseInsensitive);
}

class AuditPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(AuditPage)
 public:
    AuditPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAudit, db::Scope::kOther);
        const std::vector<db::AuditRecord> trail = context.store().audit().trail(kShownEntries);
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace32, kSpace24, kSpace32, kSpace24);
        layout->setSpacing(kSpace16);
        layout->addWidget(make_label(tr("Audit"), "display"));
        search_ = new QLineEdit(place.state.value("search").toString());
        search_->setObjectName("audit_search");
        search_->setMaximumWidth(320);
        layout->addLayout(make_field(tr("Find in the list"), search_));
        count_ = make_label({}, "muted");
        layout->addWidget(count_);
        table_ =
            make_table({tr("When"), tr("Who"), tr("What"), tr("On"), tr("Detail")}, tr("Audit"));
        table_->setObjectName("audit_table");
        table_->setSortingEnabled(false);
        table_->setRowCount(static_cast<int>(trail.size()));
        const AuditNames names = knownNames();
        int row = 0;
        for (const db::AuditRecord& entry : trail) {
            QTableWidgetItem* when =
                make_number_cell(format_when(entry.at_utc), static_cast<double>(entry.id));
            when->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
            table_->setItem(row, 0, when);
            table_->setItem(row, 1, make_cell(actorWords(entry.actor)));
            const QString object = qstr(entry.object), detail = qstr(entry.detail);
            table_->setItem(row, 2, cellOf(audit_words(entry.action), qstr(entry.action)));
            table_->setItem(row, 3, cellOf(audit_thing(object, names), object));
            table_->setItem(row, 4, cellOf(audit_thing(detail, names), detail));
            ++row;
        }
        fit_columns(table_, 4);
        keep_within(table_, {.stretch = 4, .keep_px = 150});
        table_->setSortingEnabled(true);
        table_->sortByColumn(0, Qt::DescendingOrder);
        layout->addWidget(table_, 1);
        connect(search_, &QLineEdit::textChanged, this, [this] { filter(); });
        filter();
    }

    [[nodiscard]] QString title() const override { return tr("Audit"); }
    [[nodiscard]] QVariantMap state() const override { return {{"search", search_->text()}}; }

 private:
    [[nodiscard]] AuditNames knownNames() {
        AuditNames names;
        db::Store& store = context_.store();
        for (const db::UserRecord& each : store.accounts().list())
            if (!each.display_name.empty()) names.people[each.id] = qstr(each.display_name);
        for (const db::GroupRecord& each : store.groups().list())
            names.groups[each.id] = qstr(each.name);
        for (const std::string& id : curriculum::list_definitions("tasks"))
            names.titles[qstr(id)] = task_title(context_, id);
        for (const std::string& id : store.studies().ids())
            names.titles[qstr(id)] = study_title(context_, id);
        return names;
    }

    /// Behind the words stands what the store wrote, where it says it otherwise.
    static QTableWidgetItem* cellOf(const QString& words, const QString& written) {
        QTableWidgetItem* cell = make_cell(words);
        // Long ones are cut in the list.
        cell->setToolTip(words != written ? words + '\n' + written : words);
        return cell;
    }

    /// Who worked by the command line was nobody of the program's people.
    static QString actorWords(const std::string& actor) {
        if (actor == "unknown") return tr("nobody signed in");
        static const QRegularExpression kLocal("^local administrator \\((.*)\\)$");
        const QRegularExpressionMatch local = kLocal.match(qstr(actor));
        return local.hasMatch() ? tr("command line (%1)").arg(local.captured(1)) : qstr(actor);
    }

    void filter() {
        const QString wanted = search_->text().trimmed();
        int shown = 0;
        for (int row = 0; row < table_->rowCount(); ++row) {
            bool fits = wanted.isEmpty();
            for (int column = 0; column < table_->columnCount() && !fits; ++column)
                fits = found_in(*table_->item(row, column), wanted);
            table_->setRowHidden(row, !fits);
            shown += fits ? 1 : 0;
        }
        count_->setText(tr("Shown: %1 of %2").arg(shown).arg(table_->rowCount()));
    }

    QLineEdit* search_ = nullptr;
    QLabel* count_ = nullptr;
    QTableWidget* table_ = nullptr;
};

}  // namespace

Page* make_audit_page(AppContext& context, const Place& place) {
    return new AuditPage(context, place);
}

}  // namespace placode::ui
