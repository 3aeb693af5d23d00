// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One message: what happened and what to do, with one thing to press where there is one, and the
// exact text behind "Details". `Notices` floats them over the page.

#include <QFrame>
#include <QTimer>
#include <functional>

#include "ui/shell/details.h"

class QLabel;
class QVBoxLayout;
class QPushButton;

namespace placode::ui {

class Banner : public QFrame {
    Q_OBJECT
 public:
    /// What the button of a banner does.
    struct Offer {
        QString text;
        std::function<void()> act;
    };
    enum class Tone : uint8_t { kProblem, kGood, kOffer };

    explicit Banner(AppContext& context, QWidget* parent = nullptr);

    /// Stays until it is closed.
    void setProblem(const Problem& problem);
    /// Good news goes by itself after a time to read it; a question (with an offer) stays.
    void setNotice(const QString& text, const Offer& offer = {});
    /// A file or folder was written: good news with the ways to it; goes by itself, later.
    void setWritten(const QString& text, const QString& path);
    [[nodiscard]] Tone tone() const { return tone_; }
    /// What stands in it, then the details.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString title() const;
    /// A screen reader says it without the focus moving.
    void announce();
    void restyle();  ///< In the colours of the theme of now.
    /// Goes on counting, or waits: while the pointer or the focus is in it nobody takes it away.
    void tick();
    static constexpr int kTickMs = 250;

 Q_SIGNALS:
    void closed();
    void resized();

 private:
    [[nodiscard]] QPushButton* makeClose();
    void addOffers(QVBoxLayout* column);

    AppContext& context_;
    QLabel *icon_ = nullptr, *title_ = nullptr, *advice_ = nullptr;
    Details* details_ = nullptr;
    QPushButton *offer_button_ = nullptr, *folder_button_ = nullptr;
    Offer offer_;
    QString path_;  ///< Of what was written.
    Tone tone_ = Tone::kGood;
    int left_ms_ = -1;  ///< Until it goes by itself; -1 = it stays.
};

/// So that assistive programs know it as an alert. Called once.
void announce_banners_as_alerts();

}  // namespace placode::ui
