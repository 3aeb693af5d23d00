// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/diagnostics_dialog.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QDialog>
#include <QFile>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <utility>

#include "db/whole_file.h"
#include "ui/diagnostics/crash_report.h"
#include "ui/shell/dialog_frame.h"
#include "ui/shell/notices.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr const char* kSeenSetting = "crash_report_seen";
constexpr QSize kDialog{760, 520};

QString when(const CrashReport& report) {
    return QLocale().toString(QDateTime::fromSecsSinceEpoch(report.time), "d MMM yyyy, HH:mm:ss");
}

class DiagnosticsDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(DiagnosticsDialog)
 public:
    DiagnosticsDialog(AppContext& context, QWidget* parent) : QDialog(parent), context_(context) {
        setObjectName("diagnostics");
        setWindowTitle(tr("Log and crash reports"));
        resize(kDialog.boundedTo(parent->size()));
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(kSpace24, kSpace24, kSpace24, kSpace24);
        column->setSpacing(kSpace12);
        column->addWidget(make_label(tr("Log and crash reports"), "title"));
        column->addWidget(make_label(
            tr("They lie on this computer only, and nobody gets them unless you send them. They "
               "hold no names, log-ins or results: which program started, ended or failed, and "
               "where in the program."),
            "muted"));
        which_ = new QComboBox;
        which_->setObjectName("diagnostics_which");
        connect(which_, &QComboBox::currentIndexChanged, this, [this] { show_text(); });
        column->addLayout(make_field(tr("Show"), which_));
        text_ = new QPlainTextEdit;
        text_->setObjectName("diagnostics_text");
        text_->setProperty("role", "details");
        text_->setAccessibleName(tr("What was written"));
        text_->setReadOnly(true);
        text_->setTabChangesFocus(true);
        column->addWidget(text_, 1);
        column->addLayout(buttons());
        fill();
        frame_dialog(this);
    }

 private:
    QHBoxLayout* buttons() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        remove_ = make_button(context_, tr("Delete this report"), "quiet", "close");
        remove_->setObjectName("diagnostics_delete");
        remove_->setAutoDefault(false);
        connect(remove_, &QPushButton::clicked, this, [this] { remove(); });
        QPushButton* save = make_button(context_, tr("Save a copy"), "secondary", "download");
        save->setObjectName("diagnostics_save");
        save->setAutoDefault(false);
        connect(save, &QPushButton::clicked, this, [this] { this->save(); });
        QPushButton* close = make_button(context_, tr("Close"), "primary");
        close->setObjectName("diagnostics_close");
        close->setDefault(true);
        connect(close, &QPushButton::clicked, this, &QDialog::accept);
        row->addWidget(remove_);
        row->addStretch();
        row->addWidget(save);
        row->addWidget(close);
        return row;
    }

    void fill() {
        reports_ = crash_reports(diagnostics_folder());
        which_->clear();
        for (const CrashReport& report : reports_)
            which_->addItem(tr("Crash of %1, %2").arg(qstr(report.program), when(report)));
        which_->addItem(tr("Log of the programs"));
        show_text();
    }

    [[nodiscard]] bool is_report() const {
        return which_->currentIndex() >= 0 &&
               which_->currentIndex() < static_cast<int>(reports_.size());
    }

    void show_text() {
        remove_->setEnabled(is_report());
        const std::string text = is_report()
                                     ? reports_[static_cast<size_t>(which_->currentIndex())].text
                                     : read_log(diagnostics_folder());
        text_->setPlainText(text.empty() ? tr("Nothing was written yet.") : qstr(text));
        // What happened last stands at the end of the log.
        if (!is_report())
            text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->maximum());
    }

    void remove() {
        if (!is_report() ||
            !confirm(this, tr("Delete this report?"),
                     tr("It is the only copy. Save one before, if somebody is to look into it."),
                     tr("Delete")))
            return;
        QFile::remove(qstr(reports_[static_cast<size_t>(which_->currentIndex())].file.string()));
        fill();
    }

    void save() {
        const QString name = is_report() ? "placode-crash.txt" : "placode-log.txt";
        const QString path =
            context_.askSaveFile(this, tr("Save a copy"), name, tr("Text (*.txt)"));
        if (path.isEmpty()) return;
        db::WholeFile file(path);
        const bool written = file.open(QIODevice::WriteOnly) &&
                             file.write(text_->toPlainText().toUtf8()) >= 0 && file.commit();
        if (!written)
            context_.report({tr("The copy could not be written."),
                             tr("Choose another folder, or make room on the disk."),
                             path + ": " + file.errorString()});
    }

    AppContext& context_;
    std::vector<CrashReport> reports_;
    QComboBox* which_ = nullptr;
    QPlainTextEdit* text_ = nullptr;
    QPushButton* remove_ = nullptr;
};

}  // namespace

void show_diagnostics(AppContext& context, QWidget* parent) {
    DiagnosticsDialog dialog(context, parent);
    dialog.exec();
}

void offer_crash_report(AppContext& context, Notices& notices, QWidget* window) {
    const std::vector<CrashReport> reports = crash_reports(diagnostics_folder());
    if (reports.empty()) return;
    const QString newest = qstr(reports.front().file.filename().string()) + " " +
                           QString::number(reports.front().time);
    if (context.settings().value(kSeenSetting).toString() == newest) return;
    context.settings().setValue(kSeenSetting, newest);
    notices.showNotice(
        DiagnosticsDialog::tr("%1 crashed on %2. What it wrote about that is on this computer.")
            .arg(qstr(reports.front().program), when(reports.front())),
        {DiagnosticsDialog::tr("Read the report"),
         [&context, window] { show_diagnostics(context, window); }});
}

}  // namespace placode::ui
