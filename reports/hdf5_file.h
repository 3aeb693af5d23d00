// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// HDF5 files, as far as data sets of demonstrations need them. The library is seen by one source
// file only.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace placode::reports {

/// Row by row.
struct Matrix {
    size_t rows = 0, columns = 0;
    std::vector<double> values;

    friend bool operator==(const Matrix&, const Matrix&) = default;
};

/// Groups in a path are made when they are needed. Throws ReportError naming file and place.
class Hdf5File {
 public:
    enum class Open : uint8_t { kCreate, kRead };
    Hdf5File(const std::string& path, Open how);
    ~Hdf5File();
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    void write(const std::string& place, const Matrix& matrix);
    /// With one axis.
    void write(const std::string& place, const std::vector<double>& numbers);
    /// Of one length, as numpy's dtype "S": how robomimic keeps the names of a split.
    void write(const std::string& place, const std::vector<std::string>& words);
    void attribute(const std::string& place, const std::string& name, const std::string& text);
    void attribute(const std::string& place, const std::string& name, int64_t number);
    void attribute(const std::string& place, const std::string& name, double number);

    /// With one axis: one column.
    [[nodiscard]] Matrix matrix(const std::string& place) const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::reports
