// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Search (Ctrl+K): pages, tasks, people, attempts that this user may see, and the manual; found by
// any part of any word, without accents.

#include <QDialog>
#include <vector>

#include "ui/shell/pages.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace placode::ui {

/// Something that can be opened.
struct Findable {
    enum class Kind : uint8_t { kPage, kTask, kPerson, kManual, kAttempt } kind = Kind::kPage;
    QString title, detail;
    Place place;
    QString key;     ///< Title and detail, folded.
    QString manual;  ///< A page of the manual, instead of a place.
};

/// Lower case without accents: letters with strokes and tails are found without them.
[[nodiscard]] QString folded(const QString& text);

/// Those whose key holds every word that was typed: titles that begin with it first, then pages,
/// tasks, people, the manual, attempts. At most `limit`.
[[nodiscard]] std::vector<const Findable*> find_in(const std::vector<Findable>& all,
                                                   const QString& typed, size_t limit);

/// Main thread. Closes itself when something was chosen.
class SearchBox : public QDialog {
    Q_OBJECT
 public:
    /// @param pages those of the rail, in order.
    SearchBox(AppContext& context, std::vector<Findable> pages, QWidget* parent);

 Q_SIGNALS:
    void chosen(const placode::ui::Place& place);
    void manualChosen(const QString& page);

 protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

 private:
    void addTasks();
    void addPeople();
    void addManual();
    void readAttempts();
    void refill();
    void openCurrent();

    AppContext& context_;
    std::vector<Findable> all_;
    std::vector<const Findable*> shown_;
    QLineEdit* typed_ = nullptr;
    QListWidget* list_ = nullptr;
    QLabel* said_ = nullptr;
    bool reading_ = true;
};

}  // namespace placode::ui
