// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_exports.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <memory>
#include <tuple>

#include "reports/export.h"
#include "reports/study_report.h"
#include "reports/words.h"
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
        button(row, tr("Export"), "secondary", "download", "study_export", [this, format] {
            exportAs(format->currentData().toString());
        })->setEnabled(may);
        button(row, tr("Report"), "secondary", "report", "study_report", [this] {
            report();
        })->setEnabled(may);
    }

 private:
    QPushButton* button(QHBoxLayout* row, const QString& text, const char* role, const char* icon,
                        const char* name, const std::function<void()>& work) {
        QPushButton* made = make_action(context_, this, text, role, icon, name, work);
        row->addWidget(made);
        return made;
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
        auto count = std::make_shared<size_t>(0);
        context_.background(
            this, tr("Exporting the study"),
            [study = study_, language = context_.language().toStdString(),
             format = format.toStdString(), folder = folder.toStdString(),
             reason = reason.toStdString(), login = context_.user().login,
             count](db::Store& store) {
                const reports::ExportSource source{
                    reports::study_dataset(store, study, {!reason.empty(), language}),
                    reports::recordings_of(store)};
                // Before the first file: nothing leaves without its entry, whatever becomes of the
                // page.
                store.audit().write(
                    login, "export." + format, "study " + study,
                    folder + (reason.empty() ? "" : "; WITH IDENTIFYING FIELDS: " + reason));
                *count = reports::export_dataset(source, format, folder).size();
            },
            [this, folder, count](bool done) {
                if (!done) return;
                Q_EMIT page_.written(tr("%n file(s), read back and compared with the store: %1",
                                        nullptr, static_cast<int>(*count))
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
        context_.background(
            this, tr("Making the report"),
            [study = study_, language = context_.language().toStdString(),
             path = path.toStdString(), login = context_.user().login,
             context = &context_](db::Store& store) {
                const auto report = reports::read_study_report(store, study, language);
                store.audit().write(login, "report.study", "study " + study, path);
                reports::write_study_pdf(report, path, [context](const std::string& what) {
                    Q_EMIT context->busyChanged(tr("Making the report: %1").arg(qstr(what)));
                });
            },
            [this, path](bool done) {
                if (done) Q_EMIT page_.written(tr("Report written: %1").arg(path), path);
            });
    }

    AppContext& context_;
    Page& page_;
    std::string study_;
    QLineEdit* identifying_ = nullptr;  ///< Why names may leave; empty = they do not.
};

}  // namespace

QWidget* make_study_exports(AppContext& context, Page& page, const std::string& study) {
    return new StudyExports(context, page, study);
}

}  // namespace placode::ui
