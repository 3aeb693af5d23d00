// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/stage_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "ui/shell/course_words.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct StageWords {
    Q_DECLARE_TR_FUNCTIONS(StageWords)
};

QSpinBox* make_spin(int least, int most, const char* object) {
    auto* spin = new QSpinBox;
    spin->setRange(least, most);
    spin->setObjectName(object);
    spin->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return spin;
}

/// A text that cannot be read says that there are none.
bool says(const QString& text, const std::vector<uint64_t>& seeds) {
    try {
        return curriculum::seeds_of_text(text.toStdString()) == seeds;
    } catch (const std::invalid_argument&) {
        return seeds.empty();
    }
}

}  // namespace

StageForm::StageForm(AppContext& context, Changed changed)
    : context_(context), changed_(std::move(changed)) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(StageWords::tr("Stage"), "heading"));
    addWhatIsDone(layout);
    addMastery(layout);
    addLimits(layout);
    layout->addWidget(make_label(StageWords::tr("Opens when these are mastered"), "muted"));
    required_ = new QVBoxLayout;
    required_->setSpacing(0);
    layout->addLayout(required_);
    addMessage(layout, "/requires_stages");
    addExamFields(layout);
    layout->addStretch();
    setProperty("role", "card");
    layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
    setLayout(layout);
    connectFields();
}

/// Task and id.
void StageForm::addWhatIsDone(QVBoxLayout* layout) {
    auto* first = new QHBoxLayout;
    first->setSpacing(kSpace16);
    task_ = new QComboBox;
    task_->setObjectName("stage_task");
    for (const std::string& id : curriculum::list_definitions("tasks"))
        task_->addItem(task_title(context_, id), qstr(id));
    addField(first, StageWords::tr("Task"), task_, "/task_id");
    id_ = new QLineEdit;
    id_->setObjectName("stage_id");
    addField(first, StageWords::tr("Id of the stage"), id_, "/id");
    layout->addLayout(first);
}

/// Mode, and what counts as mastered.
void StageForm::addMastery(QVBoxLayout* layout) {
    auto* second = new QHBoxLayout;
    second->setSpacing(kSpace16);
    mode_ = new QComboBox;
    mode_->setObjectName("stage_mode");
    using curriculum::StageMode;
    for (const StageMode mode :
         {StageMode::kFamiliarisation, StageMode::kPractice, StageMode::kExam})
        mode_->addItem(mode_word(mode), static_cast<int>(mode));
    // Long titles end in dots instead of pushing the page aside.
    for (QComboBox* box : {task_, mode_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(8);
    }
    addField(second, StageWords::tr("Mode"), mode_, "/mode");
    benchmark_ = new QDoubleSpinBox;
    benchmark_->setObjectName("stage_benchmark");
    benchmark_->setRange(0, 100);
    benchmark_->setDecimals(1);
    benchmark_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    addField(second, StageWords::tr("Benchmark [points]"), benchmark_, "/benchmark_points");
    consecutive_ = make_spin(1, 20, "stage_consecutive");
    addField(second, StageWords::tr("Times in a row"), consecutive_, "/consecutive");
    layout->addLayout(second);
}

void StageForm::addLimits(QVBoxLayout* layout) {
    auto* third = new QHBoxLayout;
    third->setSpacing(kSpace16);
    limit_ = make_spin(0, 1000, "stage_limit");
    limit_->setSpecialValueText(StageWords::tr("no limit"));
    addField(third, StageWords::tr("Attempts at most"), limit_, "/max_attempts");
    remind_ = make_spin(0, 3650, "stage_remind");
    remind_->setSpecialValueText(StageWords::tr("never"));
    addField(third, StageWords::tr("Refresh after [days]"), remind_, "/remind_after_days");
    layout->addLayout(third);
}

void StageForm::connectFields() {
    connect(task_, &QComboBox::currentIndexChanged, this, [this] { tell("task"); });
    connect(mode_, &QComboBox::currentIndexChanged, this, [this] { tell("mode"); });
    connect(id_, &QLineEdit::textEdited, this, [this] { tell("id"); });
    connect(benchmark_, &QDoubleSpinBox::valueChanged, this, [this] { tell("benchmark"); });
    for (QSpinBox* spin : {consecutive_, limit_, remind_})
        connect(spin, &QSpinBox::valueChanged, this,
                [this, spin] { tell(spin->objectName().toLatin1()); });
    connect(seeds_, &QLineEdit::textEdited, this, [this](const QString& text) { readSeeds(text); });
    for (QCheckBox* box : {proctor_, certificate_})
        connect(box, &QCheckBox::toggled, this, [this] { tell(""); });
}

void StageForm::addExamFields(QVBoxLayout* layout) {
    exam_ = new QWidget;
    auto* inside = new QVBoxLayout(exam_);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->setSpacing(kSpace4);
    seeds_ = new QLineEdit;
    seeds_->setObjectName("stage_seeds");
    seeds_->setPlaceholderText("11, 12, 13");
    addField(inside, StageWords::tr("Cases of the exam (seeds, used in this order)"), seeds_,
             "/exam/seeds");
    proctor_ = new QCheckBox(StageWords::tr("A proctor confirms that it may begin"));
    proctor_->setObjectName("stage_proctor");
    certificate_ = new QCheckBox(StageWords::tr("Only on a certified haptic device"));
    certificate_->setObjectName("stage_certificate");
    inside->addWidget(proctor_);
    inside->addWidget(certificate_);
    layout->addWidget(exam_);
}

void StageForm::addField(QLayout* layout, const QString& name, QWidget* field,
                         const char* pointer) {
    QVBoxLayout* box = make_field(name, field);
    addMessage(box, pointer);
    box->addStretch();
    if (auto* row = qobject_cast<QHBoxLayout*>(layout)) {
        row->addLayout(box, 1);
    } else {
        static_cast<QVBoxLayout*>(layout)->addLayout(box);
    }
}

void StageForm::addMessage(QVBoxLayout* layout, const char* pointer) {
    QLabel* message = make_label({}, "critical");
    message->setObjectName(QString("problem_stage%1").arg(pointer).replace('/', '_'));
    message->hide();
    messages_[pointer] = message;
    layout->addWidget(message);
}

void StageForm::readSeeds(const QString& text) {
    seeds_problem_.clear();
    try {
        stage_.exam.seeds = curriculum::seeds_of_text(text.toStdString());
    } catch (const std::invalid_argument& error) {
        seeds_problem_ = StageWords::tr("\"%1\" is no whole number; write them with commas.")
                             .arg(QString::fromUtf8(error.what()));
        stage_.exam.seeds.clear();  // Nothing half-read is published.
    }
    tell("seeds");
}

void StageForm::tell(const char* field) {
    if (filling_) return;
    stage_.task_id = task_->currentData().toString().toStdString();
    stage_.id = id_->text().toStdString();
    stage_.mode = static_cast<curriculum::StageMode>(mode_->currentData().toInt());
    stage_.benchmark_points = benchmark_->value();
    stage_.consecutive = consecutive_->value();
    stage_.max_attempts = limit_->value();
    stage_.remind_after_days = remind_->value();
    stage_.exam.proctor = proctor_->isChecked();
    stage_.exam.haptic_certificate = certificate_->isChecked();
    stage_.requires_stages.clear();
    for (const QCheckBox* box : required_boxes_)
        if (box->isChecked())
            stage_.requires_stages.push_back(box->property("stage").toString().toStdString());
    changed_(stage_, field);
}

void StageForm::showRequired(const curriculum::Course& course, size_t index) {
    // Rebuilt only when the stages before this one differ: the keyboard's focus stays.
    bool same = required_boxes_.size() == index && required_->count() == std::max(1, int(index));
    for (size_t i = 0; same && i < index; ++i)
        same = required_boxes_[i]->property("stage").toString() == qstr(course.stages[i].id);
    if (!same) {
        while (QLayoutItem* item = required_->takeAt(0)) {
            item->widget()->deleteLater();
            delete item;
        }
        required_boxes_.clear();
        for (size_t i = 0; i < index; ++i) {
            const curriculum::CourseStage& stage = course.stages[i];
            auto* box = new QCheckBox(
                QString("%1. %2").arg(i + 1).arg(task_title(context_, stage.task_id)));
            box->setObjectName(QString("requires_%1").arg(i));
            box->setProperty("stage", qstr(stage.id));
            connect(box, &QCheckBox::toggled, this, [this] { tell(""); });
            required_->addWidget(box);
            required_boxes_.push_back(box);
        }
        if (index == 0)
            required_->addWidget(
                make_label(StageWords::tr("The first stage is open from the start."), "small"));
    }
    for (QCheckBox* box : required_boxes_) {
        const auto& wanted = course.stages[index].requires_stages;
        box->setChecked(std::find(wanted.begin(), wanted.end(),
                                  box->property("stage").toString().toStdString()) != wanted.end());
    }
}

void StageForm::show(const curriculum::Course& course, size_t index,
                     const std::vector<curriculum::CourseProblem>& problems) {
    filling_ = true;
    const bool other = stage_.id != course.stages[index].id;
    stage_ = course.stages[index];
    if (task_->findData(qstr(stage_.task_id)) < 0)
        task_->addItem(qstr(stage_.task_id), qstr(stage_.task_id));
    task_->setCurrentIndex(task_->findData(qstr(stage_.task_id)));
    if (id_->text() != qstr(stage_.id)) id_->setText(qstr(stage_.id));
    mode_->setCurrentIndex(mode_->findData(static_cast<int>(stage_.mode)));
    benchmark_->setValue(stage_.benchmark_points);
    consecutive_->setValue(stage_.consecutive);
    limit_->setValue(stage_.max_attempts);
    remind_->setValue(stage_.remind_after_days);
    proctor_->setChecked(stage_.exam.proctor);
    certificate_->setChecked(stage_.exam.haptic_certificate);
    exam_->setVisible(stage_.mode == curriculum::StageMode::kExam);
    // What is typed stays as it is typed as long as it says the same, or nothing yet.
    if (other || !says(seeds_->text(), stage_.exam.seeds)) {
        seeds_problem_.clear();
        seeds_->setText(qstr(curriculum::seeds_text(stage_.exam.seeds)));
    }
    showRequired(course, index);
    for (const auto& [pointer, label] : messages_) label->hide();
    for (const curriculum::CourseProblem& problem : problems) {
        if (problem.stage != static_cast<int>(index)) continue;
        const std::string at = "/stages/" + std::to_string(index);
        const auto found = messages_.find(problem.pointer.substr(at.size()));
        if (found == messages_.end()) continue;
        found->second->setText(problem_words(problem));
        found->second->show();
    }
    if (!seeds_problem_.isEmpty()) {
        messages_["/exam/seeds"]->setText(seeds_problem_);
        messages_["/exam/seeds"]->show();
    }
    filling_ = false;
}

}  // namespace placode::ui
