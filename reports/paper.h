// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A4 pages that fill from the top: paragraphs, tables that go on with their head on the next page,
// figures that stay whole. Private to reports.

#include <QPainter>
#include <QPdfWriter>
#include <QString>
#include <QStringList>
#include <memory>

#include "db/private_file.h"
#include "reports/figure.h"

namespace placode::reports {

/// Text of people, as HTML.
[[nodiscard]] inline QString safe(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped();
}

class Paper {
 public:
    /// The file is for its owner alone. Throws ReportError when it cannot be written.
    Paper(const std::string& path, const QString& title, const QString& creator,
          const QString& footer);
    Paper(const Paper&) = delete;
    Paper& operator=(const Paper&) = delete;

    void heading(const QString& text);
    void html(const QString& html);  ///< One block, not broken across pages.
    /// @param align one letter a column: 'l' or 'r'. Cells are HTML.
    void table(const QString& caption, const QStringList& head, const QString& align,
               const std::vector<QStringList>& rows);
    void figure(const Figure& figure);
    /// Closes and puts the file in its place. Throws ReportError.
    void finish();

 private:
    void need(double height);
    void new_page();
    void footer();

    db::PrivateFile file_;
    std::string path_;
    QString footer_;
    std::unique_ptr<QPdfWriter> writer_;
    std::unique_ptr<QPainter> painter_;
    double y_ = 0;
    int page_ = 1, figures_ = 0, tables_ = 0;
};

}  // namespace placode::reports
