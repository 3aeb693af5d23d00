// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Course editor: an educator builds a course, sees at each field what is wrong and at the end what
// a trainee will see, and publishes it as a version that is never changed again.

#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <memory>

#include "db/course_conduct.h"
#include "reports/export.h"
#include "ui/shell/course_preview.h"
#include "ui/shell/course_words.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/stage_form.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

using curriculum::Course;
using curriculum::CourseDraft;

class CourseEditorPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(CourseEditorPage)
 public:
    CourseEditorPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kManageCourses, db::Scope::kOther);
        tasks_ = curriculum::list_definitions("tasks");
        begin(place);
        QVBoxLayout* column = make_column(this, 1280);
        column->addLayout(head());
        column->addWidget(courseCard());
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        row->addWidget(stagesCard(), 2);
        form_ = new StageForm(context, [this](const curriculum::CourseStage& stage,
                                              const std::string& field) { take(stage, field); });
        row->addWidget(form_, 3);
        column->addLayout(row);
        preview_ = new CoursePreview(context);
        column->addWidget(preview_);
        column->addWidget(publishCard(place));
        column->addStretch();
        for (const auto& [keys, step] : {std::pair{QKeySequence::Undo, &CourseDraft::undo},
                                         {QKeySequence::Redo, &CourseDraft::redo}}) {
            auto* shortcut = new QShortcut(QKeySequence(keys), this);
            connect(shortcut, &QShortcut::activated, this, [this, step = step] { move(step); });
        }
        refresh();
    }

    [[nodiscard]] QString title() const override { return tr("Course editor"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"draft", QVariant::fromValue(draft_)},
                {"stage", list_->currentRow()},
                {"saved", qstr(saved_)},
                {"reason", reason_->text()}};
    }
    [[nodiscard]] bool mayLeave() override {
        return curriculum::course_json(draft_->course()) == saved_ ||
               confirm(this, tr("Leave the course unpublished?"),
                       tr("What you changed since it was opened or exported is lost."), tr("Leave"),
                       tr("Stay here"));
    }

 private:
    /// A draft that was handed on, a copy of a course under its next version, or a new one.
    void begin(const Place& place) {
        draft_ = place.state.value("draft").value<std::shared_ptr<CourseDraft>>();
        if (!draft_) {
            Course course;
            if (place.text.isEmpty()) {
                course.id = "my_course";
                for (int n = 2; known(course.id); ++n) course.id = "my_course_" + std::to_string(n);
                course.title = {"New course", {}};  // The English title, whoever sits here.
            } else {
                course = db::find_course(context_.store(), place.text.toStdString());
                ++course.version;
            }
            draft_ = std::make_shared<CourseDraft>(std::move(course));
        }
        saved_ = place.state.contains("saved") ? place.state.value("saved").toString().toStdString()
                 : place.state.contains("draft") ? std::string()  // Of a file: not published yet.
                                                 : curriculum::course_json(draft_->course());
        first_stage_ = std::max(0, place.state.value("stage", 0).toInt());
    }

    [[nodiscard]] bool known(const std::string& id) const {
        const auto ids = db::course_ids(context_.store());
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    }

    QHBoxLayout* head() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        row->addWidget(make_label(tr("Course editor"), "display"), 1);
        undo_ = make_button(context_, tr("Undo"), "quiet", "back");
        undo_->setObjectName("undo");
        redo_ = make_button(context_, tr("Redo"), "quiet", "next");
        redo_->setObjectName("redo");
        QPushButton* save = make_button(context_, tr("Export as a file"), "secondary", "download");
        save->setObjectName("export_course");
        row->addWidget(undo_);
        row->addWidget(redo_);
        row->addWidget(save);
        connect(undo_, &QPushButton::clicked, this, [this] { move(&CourseDraft::undo); });
        connect(redo_, &QPushButton::clicked, this, [this] { move(&CourseDraft::redo); });
        connect(save, &QPushButton::clicked, this, [this] { exportFile(); });
        return row;
    }

    QWidget* courseCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        const auto line = [&](const char* object, const QString& name, QHBoxLayout* row,
                              std::string& (*part)(Course&)) {
            auto* field = new QLineEdit;
            field->setObjectName(object);
            row->addLayout(make_field(name, field), 1);
            texts_.emplace_back(field, part);
            connect(field, &QLineEdit::textEdited, this, [this, part, object](const QString& text) {
                Course course = draft_->course();
                part(course) = text.toStdString();
                change(std::move(course), object);
            });
        };
        auto* titles = new QHBoxLayout;
        titles->setSpacing(kSpace16);
        line("title_en", tr("Title, English"), titles,
             [](Course& c) -> std::string& { return c.title.en; });
        line("title_pl", tr("Title, Polish"), titles,
             [](Course& c) -> std::string& { return c.title.pl; });
        line("course_id", tr("Id"), titles, [](Course& c) -> std::string& { return c.id; });
        layout->addLayout(titles);
        auto* descriptions = new QHBoxLayout;
        descriptions->setSpacing(kSpace16);
        line("description_en", tr("Description, English"), descriptions,
             [](Course& c) -> std::string& { return c.description.en; });
        line("description_pl", tr("Description, Polish"), descriptions,
             [](Course& c) -> std::string& { return c.description.pl; });
        layout->addLayout(descriptions);
        course_problem_ = make_label({}, "critical");
        course_problem_->setObjectName("problem_course");
        layout->addWidget(course_problem_);
        return make_card(layout);
    }

    QWidget* stagesCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Stages in order"), "heading"));
        list_ = new QListWidget;
        list_->setObjectName("stage_list");
        list_->setAccessibleName(tr("Stages in order"));
        list_->setTextElideMode(Qt::ElideRight);
        list_->setMinimumWidth(200);
        list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        none_ = make_label(tr("There are no stages yet. Press Add: a stage is one task, with what "
                              "counts as mastered. Trainees go from the first to the last."),
                           "muted");
        none_->setObjectName("no_stages");
        layout->addWidget(none_);
        layout->addWidget(list_, 1);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        const auto button = [&](const QString& text, const char* role, const char* object,
                                const QString& icon, auto work) {
            QPushButton* made = make_button(context_, text, role, icon);
            made->setObjectName(object);
            connect(made, &QPushButton::clicked, this, work);
            row->addWidget(made);
            return made;
        };
        button(tr("Add"), "secondary", "add_stage", "plus", [this] {
            Course course = draft_->course();
            curriculum::add_stage(course, tasks_.empty() ? std::string() : tasks_.front());
            change(std::move(course));
            list_->setCurrentRow(list_->count() - 1);
        });
        up_ = button(tr("Up"), "quiet", "stage_up", {}, [this] { shift(-1); });
        down_ = button(tr("Down"), "quiet", "stage_down", {}, [this] { shift(1); });
        remove_ = press_once(button(tr("Remove"), "quiet", "remove_stage", {}, [this] {
            Course course = draft_->course();
            curriculum::remove_stage(course, static_cast<size_t>(list_->currentRow()));
            change(std::move(course));
        }));
        layout->addLayout(row);
        connect(list_, &QListWidget::currentRowChanged, this, [this] { showStage(); });
        return make_card(layout);
    }

    QWidget* publishCard(const Place& place) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        reason_ = new QLineEdit(place.state.value("reason").toString());
        reason_->setObjectName("publish_reason");
        reason_->setPlaceholderText(tr("What changed, and why"));
        layout->addLayout(make_field(tr("Reason (needed from version 2 on)"), reason_));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        publish_ = make_button(context_, {}, "primary", "check");
        publish_->setObjectName("publish_course");
        row->addWidget(publish_);
        standing_ = make_label({}, "muted");
        standing_->setObjectName("draft_standing");
        row->addWidget(standing_, 1);
        layout->addLayout(row);
        connect(publish_, &QPushButton::clicked, this, [this] { publish(); });
        connect(reason_, &QLineEdit::textEdited, this, [this] { showStanding(); });
        return make_card(layout);
    }

    // --- changes

    void change(Course course, const std::string& key = {}) {
        draft_->change(std::move(course), key);
        refresh();
    }
    void move(void (CourseDraft::*step)()) {
        (*draft_.*step)();
        refresh();
    }
    void take(const curriculum::CourseStage& stage, const std::string& field) {
        Course course = draft_->course();
        const auto index = static_cast<size_t>(std::max(0, list_->currentRow()));
        if (index >= course.stages.size()) return;
        if (stage.task_id != course.stages[index].task_id) {
            curriculum::set_task(course, index, stage.task_id);
        } else {
            if (stage.id != course.stages[index].id)
                curriculum::rename_stage(course, index, stage.id);
            course.stages[index] = stage;
        }
        change(std::move(course), field.empty() ? field : field + std::to_string(index));
    }
    void shift(int by) {
        const int from = list_->currentRow(), to = from + by;
        if (from < 0 || to < 0 || to >= list_->count()) return;
        Course course = draft_->course();
        curriculum::move_stage(course, static_cast<size_t>(from), static_cast<size_t>(to));
        change(std::move(course));
        list_->setCurrentRow(to);
    }

    // --- what is shown

    void refresh() {
        Course shown = draft_->course();
        problems_ = curriculum::check_course(shown, tasks_);
        for (const auto& [field, part] : texts_)
            if (field->text() != qstr(part(shown))) field->setText(qstr(part(shown)));
        auto* id = findChild<QLineEdit*>("course_id");
        id->setReadOnly(shown.version > 1);
        QStringList own;
        for (const auto& problem : problems_)
            if (problem.stage < 0) own << problem_words(problem);
        course_problem_->setText(own.join(" "));
        course_problem_->setVisible(!own.isEmpty());
        const int kept = list_->count() == 0 ? first_stage_ : list_->currentRow();
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (size_t i = 0; i < shown.stages.size(); ++i) {
            const bool wrong = std::any_of(problems_.begin(), problems_.end(), [&](const auto& p) {
                return p.stage == static_cast<int>(i);
            });
            auto* item = new QListWidgetItem(
                QString("%1. %2").arg(i + 1).arg(task_title(context_, shown.stages[i].task_id)) +
                (wrong ? "  ⚠" : ""));
            item->setSizeHint(QSize(0, kTouchTarget));
            item->setToolTip(item->text());
            if (wrong) item->setForeground(context_.colors().critical);
            list_->addItem(item);
        }
        list_->setCurrentRow(std::clamp(kept, -1, list_->count() - 1));
        if (list_->currentRow() < 0 && list_->count() > 0) list_->setCurrentRow(0);
        undo_->setEnabled(draft_->can_undo());
        redo_->setEnabled(draft_->can_redo());
        showStage();
        preview_->follow(draft_->course());
        showStanding();
    }

    void showStage() {
        const int row = list_->currentRow();
        form_->setVisible(row >= 0);
        none_->setVisible(list_->count() == 0);
        remove_->setEnabled(row >= 0);
        up_->setEnabled(row > 0);
        down_->setEnabled(row >= 0 && row + 1 < list_->count());
        if (row >= 0) form_->show(draft_->course(), static_cast<size_t>(row), problems_);
    }

    void showStanding() {
        const int version = draft_->course().version;
        publish_->setText(tr("Publish version %1").arg(version));
        const bool reason = version == 1 || !reason_->text().trimmed().isEmpty();
        publish_->setEnabled(problems_.empty() && reason);
        standing_->setText(!problems_.empty() ? tr("Not yet: %1").arg(problemsInWords())
                           : !reason          ? tr("Not yet: give the reason of the change.")
                                     : tr("No problems found. A published version is never "
                                          "changed; a change is the next one."));
    }

    [[nodiscard]] QString problemsInWords() const {
        QStringList words;
        for (const auto& problem : problems_)
            words << (problem.stage < 0
                          ? problem_words(problem)
                          : tr("stage %1: %2").arg(problem.stage + 1).arg(problem_words(problem)));
        return words.mid(0, 3).join(" ") + (words.size() > 3 ? " …" : "");
    }

    // --- out

    void publish() {
        if (!confirm(window(), tr("Publish version %1?").arg(draft_->course().version),
                     tr("A published version is never changed; a change is the next one."),
                     publish_->text()))
            return;
        context_.guard(tr("Publishing the course"), [this] {
            context_.require(db::Action::kManageCourses, db::Scope::kOther);
            const std::string text = curriculum::course_json(draft_->course());
            db::DefinitionRecord definition;
            definition.kind = "course";
            definition.id = draft_->course().id;
            definition.version = draft_->course().version;
            definition.json = text;
            definition.reason = reason_->text().trimmed().toStdString();
            context_.store().definitions().publish(definition);
            saved_ = text;
            Q_EMIT notice(tr("%1, version %2, is published. Assign it to people or groups.")
                              .arg(context_.in(draft_->course().title))
                              .arg(definition.version));
            Q_EMIT go({PageId::kCourses, 0, qstr(definition.id), {}});
        });
    }

    void exportFile() {
        const Course& course = draft_->course();
        const QString path = context_.askSaveFile(this, tr("Export the course"),
                                                  qstr(course.id) + ".json", "JSON (*.json)");
        if (path.isEmpty()) return;
        context_.guard(tr("Exporting the course"), [&] {
            reports::save_file(path.toStdString(), curriculum::course_json(course));
            saved_ = curriculum::course_json(course);
            Q_EMIT written(tr("Course written: %1").arg(path), path);
        });
    }

    std::shared_ptr<CourseDraft> draft_;
    std::string saved_;  ///< What is published or in a file.
    std::vector<std::string> tasks_;
    std::vector<curriculum::CourseProblem> problems_;
    std::vector<std::pair<QLineEdit*, std::string& (*)(Course&)>> texts_;
    int first_stage_ = 0;
    QListWidget* list_ = nullptr;
    StageForm* form_ = nullptr;
    CoursePreview* preview_ = nullptr;
    QLineEdit* reason_ = nullptr;
    QLabel *course_problem_ = nullptr, *standing_ = nullptr, *none_ = nullptr;
    QPushButton *undo_ = nullptr, *redo_ = nullptr, *up_ = nullptr, *down_ = nullptr,
                *remove_ = nullptr, *publish_ = nullptr;
};

}  // namespace

Page* make_course_editor_page(AppContext& context, const Place& place) {
    return new CourseEditorPage(context, place);
}

}  // namespace placode::ui
