// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Angoff: judges estimate, for every line of the rubric, how many of 100 trainees who are just good
// enough would lose nothing there. The mean over the judges is the pass mark.

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSpinBox>
#include <algorithm>

#include "curriculum/task.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/parts.h"
#include "ui/shell/standard_cards.h"

namespace placode::ui {
namespace {

constexpr int kLeastJudges = 2, kMostJudges = 12, kFewJudges = 8;
constexpr int kFirstJudge = 2;  ///< Column; before it the line and its points.

class AngoffCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(AngoffCard)
 public:
    using Told = std::function<void(const QVariantMap&)>;
    using Save = std::function<void(const assessment::Angoff&, const QString&)>;

    AngoffCard(AppContext& context, const curriculum::Task& task, const QVariantMap& typed,
               Told told, Save save)
        : context_(context),
          items_(task.rubric.items),
          told_(std::move(told)),
          save_(std::move(save)) {
        setProperty("role", "card");
        setObjectName("angoff_card");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Judges' estimates (Angoff)"), "heading"));
        layout->addWidget(make_label(
            tr("Of 100 trainees who are just good enough: how many lose nothing at this line? "
               "Every judge fills a column alone; a line counts by the most points it can take."),
            "muted"));
        auto* row = new QHBoxLayout;
        judges_ = new QSpinBox;
        judges_->setObjectName("angoff_judges");
        judges_->setRange(kLeastJudges, kMostJudges);
        judges_->setMinimumWidth(120);
        row->addLayout(make_field(tr("Judges"), judges_));
        row->addStretch();
        layout->addLayout(row);
        table_ = make_table({tr("Line of the rubric"), tr("At most")},
                            tr("Estimates of the judges, 0 to 100"));
        table_->setObjectName("angoff_table");
        table_->setSortingEnabled(false);
        table_->setSelectionBehavior(QAbstractItemView::SelectItems);
        table_->setEditTriggers(QAbstractItemView::AllEditTriggers);
        fillItems();
        layout->addWidget(table_);
        mark_ = make_label({}, "title");
        mark_->setObjectName("angoff_mark");
        layout->addWidget(mark_);
        said_ = make_label({}, "small");
        said_->setObjectName("angoff_said");
        layout->addWidget(said_);
        if (save_) addSaving(layout);
        typeAgain(typed);
        setJudges();
        connect(judges_, &QSpinBox::valueChanged, this, [this] {
            setJudges();
            tell();
        });
        connect(table_, &QTableWidget::cellChanged, this,
                [this](int row, int column) { take(row, column); });
    }

 private:
    void typeAgain(const QVariantMap& typed) {
        judges_->setValue(typed.value("judges", kLeastJudges).toInt());
        const QVariantMap cells = typed.value("cells").toMap();
        for (const assessment::RubricItem& item : items_)
            typed_.push_back(cells.value(qstr(item.id)).toStringList());
    }

    void tell() const {
        QVariantMap cells;
        for (size_t i = 0; i < items_.size(); ++i)
            if (!typed_[i].join(QString()).trimmed().isEmpty())
                cells[qstr(items_[i].id)] = typed_[i];
        told_({{"judges", judges_->value()}, {"cells", cells}});
    }

    void take(int row, int column) {
        if (const int judge = column - kFirstJudge; judge >= 0) {
            QStringList& line = typed_[static_cast<size_t>(row)];
            while (line.size() <= judge) line.append(QString());
            line[judge] = table_->item(row, column)->text();
            tell();
        }
        compute();
    }

    void fillItems() {
        table_->setRowCount(static_cast<int>(items_.size()));
        for (int row = 0; row < table_->rowCount(); ++row) {
            const assessment::RubricItem& item = items_[static_cast<size_t>(row)];
            const auto* known = assessment::metric_definition(item.metric);
            auto* name = make_cell(known == nullptr ? qstr(item.id) : metric_name(known->name));
            auto* most = make_number_cell(format_points(weight(item)), weight(item));
            for (auto* cell : {name, static_cast<QTableWidgetItem*>(most)})
                cell->setFlags(cell->flags() & ~Qt::ItemIsEditable);
            table_->setItem(row, 0, name);
            table_->setItem(row, 1, most);
        }
        table_->setFixedHeight(std::clamp(table_->rowCount(), 2, 9) * kTouchTarget + 50);
    }

    [[nodiscard]] static double weight(const assessment::RubricItem& item) {
        return std::min(item.max_points, 100.0);
    }

    void addSaving(QVBoxLayout* layout) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        reason_ = new QLineEdit;
        reason_->setObjectName("angoff_reason");
        row->addLayout(make_field(tr("Reason (needed from the second one on)"), reason_), 1);
        set_ = make_button(context_, tr("Set as the standard"), "secondary", "check");
        set_->setObjectName("set_angoff");
        connect(set_, &QPushButton::clicked, this, [this] { save_(result_, reason_->text()); });
        row->addWidget(set_, 0, Qt::AlignBottom);
        layout->addLayout(row);
    }

    void setJudges() {
        const int judges = judges_->value();
        {
            const QSignalBlocker quiet(table_);
            table_->setColumnCount(kFirstJudge + judges);
            for (int j = 0; j < judges; ++j) {
                const int column = kFirstJudge + j;
                table_->setHorizontalHeaderItem(column,
                                                new QTableWidgetItem(tr("Judge %1").arg(j + 1)));
                for (int row = 0; row < table_->rowCount(); ++row)
                    if (table_->item(row, column) == nullptr)
                        table_->setItem(row, column,
                                        make_cell(typed_[static_cast<size_t>(row)].value(j)));
            }
        }
        fit_columns(table_, 0);
        for (int c = kFirstJudge; c < table_->columnCount(); ++c) table_->setColumnWidth(c, 96);
        compute();
    }

    /// The estimates, or what is wrong with one.
    [[nodiscard]] QString readEstimates(std::vector<std::vector<double>>& estimates) const {
        int missing = 0;
        for (int c = kFirstJudge; c < table_->columnCount(); ++c) {
            estimates.emplace_back();
            for (int row = 0; row < table_->rowCount(); ++row) {
                const QString text = table_->item(row, c)->text().trimmed();
                bool number = false;
                const double value = QLocale().toDouble(text, &number);
                if (text.isEmpty()) {
                    ++missing;
                } else if (!number || value < 0 || value > 100) {
                    return tr("Judge %1, \"%2\": %3 is no number from 0 to 100.")
                        .arg(c - 1)
                        .arg(table_->item(row, 0)->text(), text);
                }
                estimates.back().push_back(value / 100);
            }
        }
        return missing == 0 ? QString() : tr("Estimates that are missing: %1").arg(missing);
    }

    void compute() {
        std::vector<std::vector<double>> estimates;
        const QString problem =
            items_.empty() ? tr("This task's rubric has no lines.") : readEstimates(estimates);
        if (set_ != nullptr) set_->setEnabled(problem.isEmpty());
        mark_->setVisible(problem.isEmpty());
        if (!problem.isEmpty()) return said_->setText(problem);
        std::vector<double> weights;
        for (const assessment::RubricItem& item : items_) weights.push_back(weight(item));
        result_ = assessment::angoff(estimates, weights);
        mark_->setText(tr("Pass mark: %1 points").arg(format_number(result_.cut_percent, 1)));
        QString said =
            tr("Judges: %1, standard deviation between them %2, standard error %3 points.")
                .arg(result_.judges)
                .arg(format_number(result_.sd_percent, 1), format_number(result_.se_percent, 1));
        if (result_.judges < kFewJudges)
            said += " " + tr("Fewer than %1 judges: a first orientation.").arg(kFewJudges);
        said_->setText(said);
    }

    AppContext& context_;
    std::vector<assessment::RubricItem> items_;
    /// Of every line what each judge has typed. A judge's column that is taken away, perhaps by one
    /// key too many in the number of judges, is filled again when it comes back.
    std::vector<QStringList> typed_;
    Told told_;
    Save save_;
    assessment::Angoff result_;
    QSpinBox* judges_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel *mark_ = nullptr, *said_ = nullptr;
    QLineEdit* reason_ = nullptr;
    QPushButton* set_ = nullptr;
};

}  // namespace

QWidget* make_angoff_card(
    AppContext& context, const std::string& task_id, const QVariantMap& typed,
    const std::function<void(const QVariantMap&)>& told,
    const std::function<void(const assessment::Angoff&, const QString&)>& save) {
    return new AngoffCard(context, curriculum::load_task(task_id), typed, told, save);
}

}  // namespace placode::ui
