// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Courses of the centre, for educators: build, import, change, and give to people and groups.

#include <QFile>
#include <QHBoxLayout>

#include "curriculum/course_editing.h"
#include "db/course_conduct.h"
#include "ui/shell/assign_card.h"
#include "ui/shell/course_words.h"
#include "ui/shell/grants_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

using curriculum::Course;

class CoursesPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(CoursesPage)
 public:
    CoursesPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kManageCourses, db::Scope::kOther);
        QVBoxLayout* column = make_column(this, 1200);
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace8);
        head->addWidget(make_label(tr("Courses of the centre"), "display"), 1);
        QPushButton* load = make_button(context, tr("Import a file"), "secondary", "download");
        load->setObjectName("import_course");
        connect(load, &QPushButton::clicked, this, [this] { importFile(); });
        head->addWidget(load);
        QPushButton* fresh = make_button(context, tr("New course"), "primary", "plus");
        fresh->setObjectName("new_course");
        connect(fresh, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kCourseEditor, 0, {}, {}});
        });
        head->addWidget(fresh);
        column->addLayout(head);
        table_ = make_table({tr("Course"), tr("Id"), tr("Version"), tr("Stages"), tr("Published")},
                            tr("Courses of the centre"));
        table_->setObjectName("courses_table");
        column->addWidget(table_);
        body_ = new QVBoxLayout;
        body_->setSpacing(kSpace16);
        column->addLayout(body_);
        column->addStretch(1);
        fill();
        connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { showCourse(); });
        const QString wanted = place.state.value("course", place.text).toString();
        int row = 0;
        for (int r = 0; r < table_->rowCount(); ++r)
            if (table_->item(r, 1)->text() == wanted) row = r;
        if (table_->rowCount() > 0) table_->selectRow(row);
    }

    [[nodiscard]] QString title() const override { return tr("Courses"); }
    [[nodiscard]] QVariantMap state() const override { return {{"course", selected()}}; }

 private:
    void fill() {
        db::Store& store = context_.store();
        table_->setSortingEnabled(false);
        for (const std::string& id : db::course_ids(store)) {
            const int row = table_->rowCount();
            table_->setRowCount(row + 1);
            table_->setItem(row, 1, make_cell(qstr(id)));
            Course course;
            const auto problem = context_.problemOf([&] { course = db::find_course(store, id); });
            const auto published = store.definitions().find("course", id);
            table_->setItem(row, 0,
                            make_cell(problem ? problem->title : context_.in(course.title)));
            table_->item(row, 0)->setToolTip(table_->item(row, 0)->text());
            table_->setItem(row, 2,
                            make_number_cell(QString::number(course.version), course.version));
            const auto stages = static_cast<int>(course.stages.size());
            table_->setItem(row, 3, make_number_cell(QString::number(stages), stages));
            table_->setItem(row, 4,
                            make_cell(published ? format_when(published->published_utc) + ", " +
                                                      qstr(published->published_by)
                                                : tr("came with the program")));
        }
        fit_columns(table_, 0);
        table_->setColumnWidth(1, 160);
        table_->setColumnWidth(4, 230);
        keep_within(table_, {.stretch = 0, .least_px = 400, .drop = {1, 3}});
        table_->setFixedHeight(std::clamp(table_->rowCount(), 1, 6) * kTouchTarget + 50);
        table_->setSortingEnabled(true);
        table_->sortByColumn(0, Qt::AscendingOrder);
    }

    [[nodiscard]] QString selected() const {
        const auto rows = table_->selectionModel()->selectedRows();
        return rows.isEmpty() ? QString() : table_->item(rows.front().row(), 1)->text();
    }

    void showCourse() {
        while (QLayoutItem* item = body_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        const QString id = selected();
        if (id.isEmpty()) return;
        context_.guard(tr("Reading the course"), [&] {
            const Course course = db::find_course(context_.store(), id.toStdString());
            const auto say = [this](const QString& what) { Q_EMIT notice(what); };
            body_->addWidget(courseCard(course));
            body_->addWidget(make_assign_card(context_, course.id, say));
            if (QWidget* grants = make_grants_card(context_, course, say)) body_->addWidget(grants);
        });
    }

    QWidget* courseCard(const Course& course) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(context_.in(course.title), "heading"), 1);
        QPushButton* edit = make_button(context_, tr("Change into the next version"), "secondary");
        edit->setObjectName("edit_course");
        connect(edit, &QPushButton::clicked, this, [this, id = qstr(course.id)] {
            Q_EMIT go({PageId::kCourseEditor, 0, id, {}});
        });
        head->addWidget(edit);
        layout->addLayout(head);
        if (!course.description.en.empty())
            layout->addWidget(make_label(context_.in(course.description), "muted"));
        for (size_t i = 0; i < course.stages.size(); ++i) {
            const curriculum::CourseStage& stage = course.stages[i];
            layout->addWidget(make_label(QString("%1. %2 · %3 · %4")
                                             .arg(i + 1)
                                             .arg(task_title(context_, stage.task_id),
                                                  mode_word(stage.mode), stage_rule_words(stage))));
        }
        return make_card(layout);
    }

    void importFile() {
        const QString path = context_.askOpenFile(this, tr("Import a course"), "JSON (*.json)");
        if (path.isEmpty()) return;
        context_.guard(tr("Importing the course"), [&] {
            QFile file(path);
            if (!file.open(QIODevice::ReadOnly))
                throw curriculum::DefinitionError(path.toStdString(), "",
                                                  file.errorString().toStdString());
            Course course =
                curriculum::load_course_text(file.readAll().toStdString(), path.toStdString());
            // A version that is there already is never replaced: the file becomes the next one.
            if (context_.store().definitions().find("course", course.id) ||
                QFile::exists(QString::fromStdString(
                    (curriculum::data_folder() / "courses" / (course.id + ".json")).string())))
                course.version = std::max(course.version,
                                          db::find_course(context_.store(), course.id).version + 1);
            const auto draft = std::make_shared<curriculum::CourseDraft>(std::move(course));
            Q_EMIT go({PageId::kCourseEditor, 0, {}, {{"draft", QVariant::fromValue(draft)}}});
        });
    }

    QTableWidget* table_ = nullptr;
    QVBoxLayout* body_ = nullptr;
};

}  // namespace

Page* make_courses_page(AppContext& context, const Place& place) {
    return new CoursesPage(context, place);
}

}  // namespace placode::ui
