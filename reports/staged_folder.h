// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several files that come into a folder together, or not at all.

#include <functional>
#include <string>

namespace placode::reports {

/// Lets `write` fill a folder that lies hidden in `folder`, then moves everything to where it was
/// asked for: files of the same name are replaced, all are for their owner alone (mode 0600,
/// folders 0700). Where `write` throws, as on a full disk or when somebody does not want it any
/// more, `folder` is as it was; one that was made here is gone again. Throws ReportError, in which
/// a file has the name that it would have got, and what `write` throws.
void write_staged(const std::string& folder,
                  const std::function<void(const std::string& staged)>& write);

}  // namespace placode::reports
