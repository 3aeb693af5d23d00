// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who asks to be erased, for an administrator: the list, the erasure and its certificate.

#include <QFrame>

#include "ui/shell/pages.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace placode::ui {

class ErasureRequestsCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(AdmissionsPage)
 public:
    /// @param page speaks for the card.
    ErasureRequestsCard(AppContext& context, Page& page);

 private:
    void showRequests();
    void erase(int64_t id, const QString& name);
    void erased(const QString& name, bool done);
    void showLast();
    void saveCertificate();

    AppContext& context_;
    Page& page_;
    QTableWidget* requests_ = nullptr;
    QCheckBox* with_attempts_ = nullptr;
    QLabel *left_ = nullptr, *none_ = nullptr;
    QPushButton* certificate_ = nullptr;
};

}  // namespace placode::ui
