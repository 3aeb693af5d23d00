// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a study: the figures of the report, construct validity, test-retest, learning curves
// and agreement of raters. The same drawings and numbers as on paper.

#include <QComboBox>
#include <QHBoxLayout>
#include <array>
#include <memory>
#include <optional>

#include "reports/attempt_counts.h"
#include "reports/staged_folder.h"
#include "reports/study_analysis.h"
#include "ui/shell/analysis_table.h"
#include "ui/shell/export_buttons.h"
#include "ui/shell/export_folder.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

constexpr const char* kRatersForm = "osats";

struct View {
    const char *id, *title;
};
constexpr std::array kViews{
    View{"figures", QT_TRANSLATE_NOOP("StudyResultsPage", "Figures")},
    View{"construct_validity", QT_TRANSLATE_NOOP("StudyResultsPage", "Construct validity")},
    View{"test_retest", QT_TRANSLATE_NOOP("StudyResultsPage", "Test-retest")},
    View{"learning_curves", QT_TRANSLATE_NOOP("StudyResultsPage", "Learning curves")},
    View{"rater_agreement", QT_TRANSLATE_NOOP("StudyResultsPage", "Raters")}};

class StudyResultsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(StudyResultsPage)
 public:
    StudyResultsPage(AppContext& context, const Place& place)
        : Page(context),
          view_(place.state.value("view", "figures").toString()),
          by_(place.state.value("by").toString()) {
        context.require(db::Action::kExportStudy);
        ids_ = context.store().studies().with_participants();
        study_ = chosen_study(context, ids_, place.state.value("study").toString());
        QVBoxLayout* column = make_column(this);
        column->addLayout(head());
        if (study_.empty()) {
            column->addWidget(make_label(
                tr("No study has participants yet. Enrol the first one on the page Studies."),
                "muted"));
            QPushButton* open = make_action(context, this, tr("Open the studies"), "primary",
                                            "next", "open_studies", [this] {
                                                Q_EMIT go({PageId::kStudies, 0, {}, {}});
                                            });
            column->addWidget(open, 0, Qt::AlignLeft);
            column->addStretch();
            return;
        }
        column->addWidget(make_label(study_title(context, study_), "heading"));
        body_ = new QVBoxLayout;
        body_->setSpacing(column->spacing());
        column->addLayout(body_);
        column->addStretch();
        read();
    }

    [[nodiscard]] QString title() const override { return tr("Results"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"study", qstr(study_)}, {"view", view_}, {"by", by_}};
    }

 private:
    /// A large study on a server elsewhere takes a while.
    void read() {
        save_->setEnabled(false);
        QLabel* outcome = make_label(tr("Reading the study …"), "muted");
        outcome->setObjectName("results_outcome");
        body_->addWidget(outcome);
        auto read = std::make_shared<reports::StudyReport>();
        context_.background(
            this, tr("Reading the study"),
            [read, study = study_, language = context_.language().toStdString()](db::Store& store) {
                *read = reports::read_study_report(store, study, language);
            },
            [this, read, outcome](bool done) {
                if (!done) return outcome->setText(tr("The study could not be read."));
                delete outcome;
                report_ = std::move(*read);
                save_->setEnabled(true);
                showReport();
            });
    }

    void showReport() {
        if (report_.data.demonstration) body_->addWidget(make_demonstration_badge());
        const auto counts = reports::attempt_counts(report_.data);
        if (counts.all > 0) {
            const QString said = reports::uncounted_words(counts);
            QLabel* uncounted =
                make_label(said.isEmpty() ? tr("All attempts count: %1.").arg(counts.all) : said,
                           said.isEmpty() ? "muted" : "warn");
            uncounted->setObjectName("uncounted");
            body_->addWidget(uncounted);
        }
        body_->addLayout(views());
        if (view_ == "figures")
            addFigures(body_);
        else
            addAnalysis(body_);
    }

    QLayout* head() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        row->addWidget(make_label(tr("Results"), "display"), 1);
        if (QComboBox* chooser = make_study_chooser(context_, ids_, study_)) {
            connect(chooser, &QComboBox::activated, this, [this, chooser] {
                study_ = chooser->currentData().toString().toStdString();
                by_.clear();
                open(view_);
            });
            row->addWidget(chooser);
        }
        if (study_.empty()) return row;
        save_ = make_button(context_, tr("Save figures and tables"), "secondary", "download");
        save_->setObjectName("save_results");
        connect(save_, &QPushButton::clicked, this, [this] { save(); });
        row->addWidget(save_);
        saving_.emplace(context_, *this, row);
        saving_->add(save_);
        return row;
    }

    QLayout* views() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        for (const View& view : kViews) {
            QPushButton* button =
                make_button(context_, tr(view.title), view_ == view.id ? "primary" : "quiet");
            button->setObjectName(QString("view_") + view.id);
            connect(button, &QPushButton::clicked, this, [this, id = view.id] { open(id); });
            row->addWidget(button);
        }
        row->addStretch();
        return row;
    }

    void open(const QString& view) {
        Q_EMIT go(
            {PageId::kStudyResults, 0, {}, {{"study", qstr(study_)}, {"view", view}, {"by", by_}}});
    }

    [[nodiscard]] reports::ChartStyle style() const { return chart_style(context_.theme(), 12); }

    void addFigure(QVBoxLayout* column, const reports::Figure& figure) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(qstr(figure.title), "heading"));
        // The drawing has a fixed size in pixels; a wider window leaves air at its right.
        const QSize size(static_cast<int>(figure.width) + 60, static_cast<int>(figure.height) + 8);
        const double width = figure.width + 60, height = figure.height;
        QWidget* picture = make_picture(
            [draw = figure.draw, width, height](QPainter& painter, const QRectF& where) {
                draw(painter, QRectF(where.left(), where.top(),
                                     std::min(where.width(), width + 240), height));
            },
            size, qstr(figure.title), qstr(figure.caption));
        picture->setObjectName("figure_" + qstr(figure.id));
        picture->setFixedHeight(size.height());
        layout->addWidget(picture);
        layout->addWidget(make_label(qstr(figure.caption), "small"));
        column->addWidget(make_card(layout));
    }

    void addFigures(QVBoxLayout* column) {
        const auto numbers = reports::study_numbers(report_.data, report_.instruments);
        for (const auto& figure : reports::study_figures(report_, numbers, style()))
            addFigure(column, figure);
        if (numbers.cautions.empty()) return;
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("What this sample can carry"), "heading"));
        for (const std::string& each : numbers.cautions)
            layout->addWidget(make_label("• " + qstr(each), "small"));
        column->addWidget(make_card(layout));
    }

    [[nodiscard]] reports::Analysis analysis(const QString& view) const {
        if (view == "construct_validity")
            return reports::construct_validity(report_, by_.toStdString(), style());
        if (view == "test_retest") return reports::test_retest(report_, style());
        if (view == "learning_curves") return reports::learning_curves(report_, style());
        return reports::rater_agreement(report_, report_.ratings,
                                        curriculum::load_questionnaire(kRatersForm), style());
    }

    void addAnalysis(QVBoxLayout* column) {
        if (view_ == "construct_validity") addGrouping(column);
        const reports::Analysis found = analysis(view_);
        if (!found.problem.empty()) {
            QLabel* label =
                make_label(QCoreApplication::translate("Analysis", found.problem.c_str()), "muted");
            label->setObjectName("analysis_problem");
            column->addWidget(label);
            return;
        }
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(
            make_label(QCoreApplication::translate("Analysis", found.title.c_str()), "heading"));
        layout->addWidget(make_analysis_table(found));
        layout->addWidget(make_label(qstr(found.method), "small"));
        if (!found.caution.empty()) layout->addWidget(make_label(qstr(found.caution), "warn"));
        column->addWidget(make_card(layout));
        for (const auto& figure : found.figures) addFigure(column, figure);
    }

    void addGrouping(QVBoxLayout* column) {
        const auto groupings = reports::possible_groupings(report_.data);
        if (groupings.size() < 2) return;
        auto* chooser = new QComboBox;
        chooser->setObjectName("grouping");
        for (const auto& each : groupings) chooser->addItem(qstr(each.label), qstr(each.id));
        chooser->setCurrentIndex(std::max(0, chooser->findData(by_)));
        connect(chooser, &QComboBox::activated, this, [this, chooser] {
            by_ = chooser->currentData().toString();
            open(view_);
        });
        column->addLayout(make_field(tr("Levels by"), chooser));
    }

    /// Figures as SVG, PNG and data, numbers.csv, and every analysis that has a table.
    void save() {
        const QString parent = context_.askFolder(this, tr("Save into this folder"));
        if (parent.isEmpty()) return;
        const QString folder = export_folder(parent, qstr(study_) + "-results");
        const auto run = saving_->begin();
        const auto words = [](const reports::ExportPart& part) {
            return tr("Saving: %1").arg(qstr(part.name));
        };
        context_.background(
            this, tr("Saving figures and tables"),
            [run, pace = saving_->paceOf(run, words), folder = folder.toStdString(),
             report = report_, by = by_.toStdString(), study = study_,
             login = context_.user().login](db::Store& store) {
                run->run([&] {
                    pace.next({"figures"});
                    // Before the first file: nothing leaves without its entry, whatever becomes of
                    // the page.
                    store.audit().write(login, "report.figures", "study " + study, folder);
                    reports::write_staged(folder, [&](const std::string& staged) {
                        run->files = writeAll(store, report, by, staged, pace);
                    });
                });
            },
            [this, folder, run](bool done) {
                if (!saving_->ended(*run) || !done) return;
                Q_EMIT written(
                    tr("%n file(s) written: %1", nullptr, static_cast<int>(run->files)).arg(folder),
                    folder);
            });
    }

    /// Returns how many files. Throws ExportStopped.
    static size_t writeAll(db::Store& store, const reports::StudyReport& report,
                           const std::string& by, const std::string& folder,
                           const reports::ExportPace& pace) {
        size_t files = reports::write_study_figures(report, folder, pace).size();
        for (const reports::Analysis& each :
             {reports::construct_validity(report, by), reports::test_retest(report),
              reports::learning_curves(report),
              reports::rater_agreement(report, store.reviews().ratings(kRatersForm),
                                       curriculum::load_questionnaire(kRatersForm))}) {
            if (!each.problem.empty()) continue;
            pace.next({each.title});
            files += reports::write_analysis(each, folder, report.data.demonstration).size();
        }
        return files;
    }

    std::vector<std::string> ids_;
    std::string study_;
    QString view_, by_;
    QVBoxLayout* body_ = nullptr;
    QPushButton* save_ = nullptr;
    std::optional<ExportButtons> saving_;
    reports::StudyReport report_;
};

}  // namespace

Page* make_study_results_page(AppContext& context, const Place& place) {
    return new StudyResultsPage(context, place);
}

}  // namespace placode::ui
