// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fields of one stage in the course editor, each with its own message beneath it.

#include <QFrame>
#include <functional>
#include <map>

#include "curriculum/course_editing.h"
#include "ui/shell/app_context.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QVBoxLayout;

namespace placode::ui {

/// Main thread. Does not own the course.
class StageForm : public QFrame {
 public:
    /// `changed` gets the stage as it is now, and which field was touched.
    using Changed = std::function<void(const curriculum::CourseStage&, const std::string& field)>;
    StageForm(AppContext& context, Changed changed);

    void show(const curriculum::Course& course, size_t index,
              const std::vector<curriculum::CourseProblem>& problems);

 private:
    void addWhatIsDone(QVBoxLayout* layout);
    void addMastery(QVBoxLayout* layout);
    void addLimits(QVBoxLayout* layout);
    void connectFields();
    void addExamFields(QVBoxLayout* layout);
    void addField(QLayout* layout, const QString& name, QWidget* field, const char* pointer);
    void addMessage(QVBoxLayout* layout, const char* pointer);
    void tell(const char* field);
    void showRequired(const curriculum::Course& course, size_t index);
    void readSeeds(const QString& text);

    AppContext& context_;
    Changed changed_;
    curriculum::CourseStage stage_;
    bool filling_ = false;
    QComboBox *task_ = nullptr, *mode_ = nullptr;
    QLineEdit *id_ = nullptr, *seeds_ = nullptr;
    QDoubleSpinBox* benchmark_ = nullptr;
    QSpinBox *consecutive_ = nullptr, *limit_ = nullptr, *remind_ = nullptr;
    QCheckBox *proctor_ = nullptr, *certificate_ = nullptr;
    QWidget* exam_ = nullptr;
    QVBoxLayout* required_ = nullptr;
    std::vector<QCheckBox*> required_boxes_;
    std::map<std::string, QLabel*> messages_;  ///< By end of the JSON pointer.
    QString seeds_problem_;
};

}  // namespace placode::ui
