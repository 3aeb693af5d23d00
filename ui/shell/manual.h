// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The manual's pages as they lie on the disk (docs/manual, or share/placode/manual): which there
// are, in what order, what stands in them, and which one belongs to a page of the shell.

#include <QString>
#include <vector>

#include "ui/shell/pages.h"

namespace placode::ui {

/// What stands under one heading, without marks.
struct ManualSection {
    QString heading;
    QString anchor;  ///< Empty for the title of the page.
    QString text;
    QString key;  ///< Page, heading and text, folded.
};

struct ManualPage {
    QString part;   ///< The heading of index.md that it stands under: "Trainees".
    QString title;  ///< Its first heading.
    QString file;   ///< "trainee-today.md"
    std::vector<ManualSection> sections;
};

/// One language. Reads files; a page that cannot be read has no sections.
struct Manual {
    QString folder;  ///< With / at the end.
    std::vector<ManualPage> pages;
};
[[nodiscard]] Manual load_manual(const QString& language);

/// Where the pages of a language lie, with / at the end; they may be missing.
[[nodiscard]] QString manual_folder(const QString& language);

/// "What is scored?" -> "what-is-scored", as web sites of Markdown pages do it.
[[nodiscard]] QString heading_anchor(const QString& heading);

/// The chapter on a page of the shell.
[[nodiscard]] QString manual_chapter(PageId page);

struct ManualHit {
    const ManualPage* page = nullptr;
    const ManualSection* section = nullptr;
};
/// Sections that hold every word that was typed, without accents: titles first, then headings, then
/// texts. At most `limit`.
[[nodiscard]] std::vector<ManualHit> find_in_manual(const Manual& manual, const QString& typed,
                                                    size_t limit);

}  // namespace placode::ui
