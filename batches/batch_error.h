// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a batch refuses: the thing, what is wrong with it, and the way out.

#include <stdexcept>
#include <string>

namespace placode::batches {

class BatchError : public std::runtime_error {
 public:
    enum class Kind {
        kBadInput,  ///< An order or a file that cannot be used.
        kFailed,    ///< It could have been done, and was not.
        kBusy       ///< Another process is at this shard.
    };
    BatchError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
    Kind kind_;
};

}  // namespace placode::batches
