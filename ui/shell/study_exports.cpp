// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_exports.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <memory>
#include <optional>
#include <tuple>

#include "reports/export.h"
#include "reports/study_report.h"
#include "reports/words.h"
#include "ui/shell/export_buttons.h"
#include "ui/shell/export_folder.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

constexpr int kShortestReason = 10;  ///< Characters, for names to leave.

class StudyExports : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ProtocolCard)
 public:
    StudyExports(AppContext& context, Page& page, std::string study)
        : context_(context), page_(page), study_(std::move(study)) {
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(kSpace8);
        for (const auto& [page, text, icon, name] :
             {std::tuple{PageId::kStudyData, tr("Data"), "data", "open_data"},
              {PageId::kStudyResults, tr("Results"), "results", "open_results"}})
            button(row, text, "secondary", icon, name, [this, page = page] {
                Q_EMIT page_.go({page, 0, {}, {{"study", qstr(study_)}}});
            });
        row->addStretch();
        auto* format = new QComboBox;
        format->setObjectName("study_export_format");
        format->setAccessibleName(tr("Export format"));
        for (const auto& each : reports::export_formats())
            format->addItem(QCoreApplication::translate("ExportFormat", each.title),
                            QString(each.name));
        row->addWidget(format);
        const bool may = context_.may(db::Action::kExportStudy);
        identifying_ = new QLineEdit;
        identifying_->setObjectName("identifying_reason");
        identifying_->setAccessibleName(tr("Reason to include what names a person"));
        identifying_->setPlaceholderText(tr("Reason to include names; audited"));
        identifying_->setToolTip(
            tr("Left empty, questions that name a person stay in the store. For who may see names "
               "only."));
        // Most have no right to it: the field is there for who has.
        identifying_->setVisible(context_.may(db::Action::kViewPersonalData, db::Scope::kOther));
        row->addWidget(identifying_);
        buttons_.emplace(context, page_, row);
        for (QPushButton* each :
             {button(row, tr("Export"), "secondary", "download", "study_export",
                     [this, format] { exportAs(format->currentData().toString()); }),
              button(row, tr("Report"), "secondary", "report", "study_report",
                     [this] { report(); })}) {
            each->setEnabled(may);
            buttons_->add(each);
        }
    }

 private:
    QPushButton* button(QHBoxLayout* row, const QString& text, const char* role, const char* icon,
                        const char* name, const std::function<void()>& work) {
        QPushButton* made = make_action(context_, this, text, role, icon, name, work);
        row->addWidget(made);
        return made;
    }

    static QString exportWords(const reports::ExportPart& part) {
        const QString name = QCoreApplication::translate("ExportFormat", part.name.c_str());
        return part.all == 0 ? tr("Exporting the study: %1").arg(name)
                             : tr("Exporting the study: %1, recording %2 of %3")
                                   .arg(name)
                                   .arg(part.done + 1)
                                   .arg(part.all);
    }

    void exportAs(const QString& format) {
        const QString parent = context_.askFolder(this, tr("Export into this folder"));
        if (parent.isEmpty()) return;
        const QString folder = export_folder(parent, qstr(study_));
        const QString reason = identifying_->text().trimmed();
        if (!context_.guard(tr("Exporting the study"), [&] {
                context_.require(db::Action::kExportStudy);
                if (reason.isEmpty()) return;
                context_.require(db::Action::kViewPersonalData, db::Scope::kOther);
                if (reason.size() < kShortestReason)
                    throw Refusal(
                        tr("An export with names needs a reason of at least %1 characters.")
                            .arg(kShortestReason));
            }))
            return;
        const auto run = buttons_->begin();
        context_.background(
            this, tr("Exporting the study"),
            [run, pace = buttons_->paceOf(run, exportWords), study = study_,
             language = context_.language().toStdString(), format = format.toStdString(),
             folder = folder.toStdString(), reason = reason.toStdString(),
             login = context_.user().login](db::Store& store) {
                run->run([&] {
                    pace.next({format});
                    const reports::ExportSource source{
                        reports::study_dataset(store, study, {!reason.empty(), language}),
                        reports::recordings_of(store), pace};
                    // Before the first file: nothing leaves without its entry, whatever becomes of
                    // the page.
                    store.audit().write(
                        login, "export." + format, "study " + study,
                        folder + (reason.empty() ? "" : "; WITH IDENTIFYING FIELDS: " + reason));
                    run->files = reports::export_dataset(source, format, folder).size();
                });
            },
            [this, folder, run](bool done) {
                if (!buttons_->ended(*run) || !done) return;
                Q_EMIT page_.written(tr("%n file(s), read back and compared with the store: %1",
                                        nullptr, static_cast<int>(run->files))
                                         .arg(folder),
                                     folder);
            });
    }

    void report() {
        const QString path = context_.askSaveFile(this, tr("Save the report"),
                                                  qstr(study_) + ".pdf", tr("PDF (*.pdf)"));
        if (path.isEmpty()) return;
        if (!context_.guard(tr("Making the report"),
                            [&] { context_.require(db::Action::kExportStudy); }))
            return;
        const auto run = buttons_->begin();
        const auto words = [](const reports::ExportPart& part) {
            return tr("Making the report: %1").arg(qstr(part.name));
        };
        context_.background(
            this, tr("Making the report"),
            [run, pace = buttons_->paceOf(run, words), study = study_,
             language = context_.language().toStdString(), path = path.toStdString(),
             login = context_.user().login](db::Store& store) {
                run->run([&] {
                    pace.next({"data"});
                    const auto report = reports::read_study_report(store, study, language);
                    store.audit().write(login, "report.study", "study " + study, path);
                    reports::write_study_pdf(report, path, pace);
                });
            },
            [this, path, run](bool done) {
                if (buttons_->ended(*run) && done)
                    Q_EMIT page_.written(tr("Report written: %1").arg(path), path);
            });
    }

    AppContext& context_;
    Page& page_;
    std::string study_;
    std::optional<ExportButtons> buttons_;
    QLineEdit* identifying_ = nullptr;  ///< Why names may leave; empty = they do not.
};

}  // namespace

QWidget* make_study_exports(AppContext& context, Page& page, const std::string& study) {
    return new StudyExports(context, page, study);
}

}  // namespace placode::ui
